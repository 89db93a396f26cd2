//! A plan's trees on the GPU.

mod deciding;

use super::plan::Plan;
use super::trees::{SetKey, has_own_place};
use super::{Aim, Choice};
use crate::animate::Action;
use crate::gpu::{
    Builder, Bvh, Components, Download, Facing, Frame, Gpu, GpuError, Mesh, Parts, Renderer, Scene,
    Subset, Tree, Trees, Turn, Turns,
};
use crate::{BuildConfig, Picture, RenderReport, RenderSettings, Stages, ViewError};
use slimbvh_core::bounds::scene_exponent;
use std::time::Instant;

pub use deciding::{DecisionsDownload, DecisionsReport, LightSets};

/// The trees of a plan, whose memory the next plan's use again.
#[derive(Debug, Default)]
pub struct Hierarchies {
    whole: Bvh,
    /// Whether the whole tree is that of the mesh as it is.
    has_whole: bool,
    /// What each set is of the mesh as it is.
    built: Vec<Option<SetKey>>,
    /// As many as there are aims, or more.
    sets: Vec<(Bvh, Facing)>,
    /// The set whose turn it is.
    turn: Bvh,
    components: Option<Components>,
}

impl Hierarchies {
    /// None yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Uploads the component of each triangle: once for all plans with the same survey.
    ///
    /// # Errors
    /// For more triangles than the GPU takes.
    pub fn upload(&mut self, gpu: &Gpu, plan: &Plan) -> Result<(), GpuError> {
        self.components = match plan.topology {
            Some(_) => Some(Components::upload(gpu, plan.components())?),
            None => None,
        };
        Ok(())
    }

    /// Records the build of what a plan for this mesh asks for: one sort, and a tree for each of its sets.
    ///
    /// # Errors
    /// Those of [`Builder::build`].
    pub fn build(
        &mut self,
        frame: &mut Frame,
        builder: &mut Builder,
        mesh: &Mesh,
        plan: &Plan,
    ) -> Result<(), GpuError> {
        self.update(frame, builder, mesh, plan, Action::Rebuilt)
    }

    /// Records that the trees be brought up to date for the next frame of the same mesh: where no vertex moved, only those
    /// are built whose rays have moved or that are not there. The builder must have served these trees last.
    ///
    /// # Errors
    /// Those of [`Builder::build`].
    pub fn update(
        &mut self,
        frame: &mut Frame,
        builder: &mut Builder,
        mesh: &Mesh,
        plan: &Plan,
        action: Action,
    ) -> Result<(), GpuError> {
        if action != Action::Kept {
            self.forget();
            builder.sort(frame, mesh)?;
        }
        let recorded = self.build_sorted(frame, builder, mesh, plan, |frame, aim, facing, _| {
            facing.set(frame, &aim.target, &aim.frustum, &aim.sides)
        });
        recorded.inspect_err(|_| self.forget())
    }

    /// Whether the component of each triangle was uploaded.
    #[must_use]
    pub fn has_components(&self) -> bool {
        self.components.is_some()
    }

    /// Takes note that no tree is that of the mesh as it is.
    fn forget(&mut self) {
        self.has_whole = false;
        self.built.clear();
    }

    /// Records the trees over sorted triangles. `face` fills in the sides of an aim, and is shown those of the camera.
    fn build_sorted<'g>(
        &mut self,
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        mesh: &Mesh,
        plan: &Plan,
        face: impl Fn(&mut Frame<'g>, &Aim, &mut Facing, Option<&Facing>) -> Result<(), GpuError>,
    ) -> Result<(), GpuError> {
        if plan.needs_whole && !self.has_whole {
            builder.build_sorted(frame, mesh, Subset::All, &mut self.whole)?;
            self.has_whole = true;
        }
        let count = plan.aims.len().max(self.sets.len());
        self.sets.resize_with(count, || (Bvh::new(), Facing::new()));
        self.built.resize_with(count, || None);
        let Some(components) = &self.components else {
            return Ok(());
        };
        for (place, aim) in plan.aims.iter().enumerate() {
            let (before, rest) = self.sets.split_at_mut(place);
            let Some((bvh, facing)) = rest.first_mut() else {
                continue;
            };
            let key = SetKey::of(aim);
            if aim.choice == Choice::Unused || self.built[place].as_ref() == Some(&key) {
                continue;
            }
            let eye = before.first().map(|(_, facing)| facing);
            face(frame, aim, facing, eye)?;
            if has_own_place(plan, aim) {
                let subset = Subset::Facing { components, facing };
                builder.build_sorted(frame, mesh, subset, bvh)?;
                self.built[place] = Some(key);
            }
        }
        if plan.in_turn {
            builder.reserve(frame.gpu(), mesh, &mut self.turn)?;
        }
        Ok(())
    }

    /// What is built in turn, after [`Self::build`] with the same plan. It shares the buffers of the trees: take these first.
    #[must_use]
    pub fn in_turn<'a>(
        &'a self,
        builder: &'a mut Builder,
        mesh: &'a Mesh,
        plan: &'a Plan,
    ) -> InTurn<'a> {
        InTurn {
            plan,
            aims: plan.aim_of_light(),
            hierarchies: self,
            builder,
            mesh,
            built: None,
            counts: Vec::new(),
        }
    }

    /// What a renderer takes, after [`Self::build`] with the same plan.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> Trees<'a> {
        let tree = |(aim, (set, facing)): (&Aim, &'a (Bvh, Facing))| match aim.choice {
            Choice::Set if has_own_place(plan, aim) => Some(Tree::all(set)),
            Choice::Set => Some(Tree::all(&self.turn)),
            Choice::Whole => Some(Tree {
                bvh: &self.whole,
                rule: self
                    .components
                    .as_ref()
                    .map(|components| (components, facing)),
            }),
            Choice::Unused => None,
        };
        let trees: Vec<Option<Tree>> = plan.aims.iter().zip(&self.sets).map(tree).collect();
        let primary = trees.first().copied().flatten();
        let primary = primary.unwrap_or(Tree::all(&self.whole));
        // Where there are no rays, any tree will do.
        let lights = plan.aim_of_light().into_iter();
        let lights = lights.map(|place| trees[place].unwrap_or(Tree::all(primary.bvh)));
        Trees {
            primary,
            lights: lights.collect(),
            mirrors: plan.has_mirrors.then_some(&self.whole),
        }
    }

    /// The tree of each aim that has its own.
    pub fn sets<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = (&'a Aim, &'a Bvh)> {
        let sets = plan.aims.iter().zip(&self.sets);
        sets.filter(|(aim, _)| has_own_place(plan, aim))
            .map(|(aim, (bvh, _))| (aim, bvh))
    }

    /// All trees that a plan had built.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a Bvh> {
        let whole = plan.needs_whole.then_some(&self.whole);
        whole.into_iter().chain(self.sets(plan).map(|(_, set)| set))
    }
}

/// The sets of lights that a plan builds in turn.
#[derive(Debug)]
pub struct InTurn<'a> {
    plan: &'a Plan<'a>,
    /// The place among the aims of each light.
    aims: Vec<usize>,
    hierarchies: &'a Hierarchies,
    builder: &'a mut Builder,
    mesh: &'a Mesh,
    /// The aim whose set is there.
    built: Option<usize>,
    counts: Vec<(usize, Download)>,
}

impl InTurn<'_> {
    /// The place among the plan's aims of each set that is built in turn, and its triangle count on the way from the GPU.
    #[must_use]
    pub fn counts(self) -> Vec<(usize, Download)> {
        self.counts
    }
}

impl Turns for InTurn<'_> {
    fn turn(&self, light: usize) -> Turn<'_> {
        let place = self.aims[light];
        let aim = &self.plan.aims[place];
        if aim.choice != Choice::Set || has_own_place(self.plan, aim) {
            return Turn::None;
        }
        // Where lights share a set, others may need it.
        if self.plan.builds_unseen || aim.lights.len() > 1 {
            return Turn::Always;
        }
        Turn::IfReached(&self.hierarchies.sets[place].1)
    }

    fn build(&mut self, frame: &mut Frame, light: usize) -> Result<(), GpuError> {
        let place = self.aims[light];
        let components = self.hierarchies.components.as_ref();
        let Some(components) = components.filter(|_| self.built != Some(place)) else {
            return Ok(());
        };
        let facing = &self.hierarchies.sets[place].1;
        let subset = Subset::Facing { components, facing };
        let bvh = &self.hierarchies.turn;
        self.builder.build_reserved(frame, self.mesh, subset, bvh)?;
        self.counts.push((place, bvh.count_later(frame)?));
        self.built = Some(place);
        Ok(())
    }
}

/// Renders whole pictures by plans, and keeps its buffers from one to the next.
#[derive(Debug)]
pub struct ImageRenderer {
    /// Builds the trees.
    pub builder: Builder,
    /// The trees of the latest picture.
    pub hierarchies: Hierarchies,
    /// Makes the picture.
    pub renderer: Renderer,
    /// For the latest picture: the place among the plan's aims of each set that was built in turn, and its triangles.
    pub built_in_turn: Vec<(usize, usize)>,
}

impl ImageRenderer {
    /// One without buffers yet.
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        Self {
            builder: Builder::new(config),
            hierarchies: Hierarchies::new(),
            renderer: Renderer::new(),
            built_in_turn: Vec::new(),
        }
    }

    /// Uploads a scene, builds a plan's trees, and waits for the picture. With a survey it is one submission; without,
    /// `progress` is told the share done, 0 to 1. Returns the times of the build and what the render did.
    ///
    /// # Errors
    /// Those of [`Scene::upload`], [`Builder::build`] and [`Renderer::render`].
    pub fn render(
        &mut self,
        gpu: &Gpu,
        (scene, plan): (&crate::Scene, &Plan),
        settings: &RenderSettings,
        picture: &mut Picture,
        mut progress: impl FnMut(f64),
    ) -> Result<(Stages, RenderReport), GpuError> {
        let begin = Instant::now();
        let (builder, hierarchies, renderer) =
            (&mut self.builder, &mut self.hierarchies, &mut self.renderer);
        if plan.is_plain() {
            hierarchies.forget();
            let parts = Parts {
                builder,
                bvh: &mut hierarchies.whole,
                renderer,
            };
            return parts.render(gpu, scene, settings, picture, progress);
        }
        let camera = scene.cameras.first().ok_or(ViewError::NoCamera)?;
        let bounds = scene.mesh.bounds().unwrap_or(slimbvh_core::Aabb::EMPTY);
        camera.check_reach(scene_exponent(&bounds))?;
        builder.check_mesh(&scene.mesh)?;
        let uploaded = Scene::upload(gpu, scene)?;
        hierarchies.upload(gpu, plan)?;

        let mut frame = gpu.frame();
        hierarchies.build(&mut frame, builder, &uploaded.mesh, plan)?;
        let trees = hierarchies.trees(plan);
        let view = (camera, scene.lights.as_slice());
        let mut turns = hierarchies.in_turn(builder, &uploaded.mesh, plan);
        let both: (_, &mut dyn Turns) = (&trees, &mut turns);
        renderer.render_in_turn(&mut frame, &uploaded, both, view, settings)?;
        let counts = turns.counts();
        let times = renderer.finish(frame, Stages::default(), begin, picture)?;
        progress(1.0);
        self.built_in_turn.clear();
        for (place, count) in counts {
            let words: Vec<u32> = count.read(gpu)?;
            let triangle_count = words.first().copied().unwrap_or(0);
            self.built_in_turn.push((place, triangle_count as usize));
        }
        Ok(times)
    }
}
