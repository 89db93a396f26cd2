//! A plan's trees on the GPU.

mod deciding;

use super::plan::{Aim, Choice, Plan};
use crate::gpu::{
    Builder, Bvh, Components, Facing, Frame, Gpu, GpuError, Mesh, Parts, Renderer, Scene, Subset,
    Tree, Trees,
};
use crate::{BuildConfig, Picture, RenderReport, RenderSettings, Stages, ViewError};
use slimbvh_core::bounds::scene_exponent;
use std::time::Instant;

pub use deciding::{DecisionsDownload, DecisionsReport, LightSets};

/// The trees of a plan, whose memory the next plan's use again.
#[derive(Debug, Default)]
pub struct Hierarchies {
    whole: Bvh,
    /// As many as there are aims, or more.
    sets: Vec<(Bvh, Facing)>,
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
        builder.sort(frame, mesh)?;
        self.build_sorted(frame, builder, mesh, plan, |frame, aim, facing, _| {
            facing.set(frame, &aim.target, &aim.sides)
        })
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
        if plan.needs_whole {
            builder.build_sorted(frame, mesh, Subset::All, &mut self.whole)?;
        }
        let missing = plan.aims.len().saturating_sub(self.sets.len());
        let nothing = || (Bvh::new(), Facing::new());
        self.sets.extend((0..missing).map(|_| nothing()));
        let Some(components) = &self.components else {
            return Ok(());
        };
        for (place, aim) in plan.aims.iter().enumerate() {
            let (before, rest) = self.sets.split_at_mut(place);
            let Some((bvh, facing)) = rest.first_mut() else {
                continue;
            };
            if aim.choice == Choice::Unused {
                continue;
            }
            let eye = before.first().map(|(_, facing)| facing);
            face(frame, aim, facing, eye)?;
            if aim.choice == Choice::Set {
                let subset = Subset::Facing { components, facing };
                builder.build_sorted(frame, mesh, subset, bvh)?;
            }
        }
        Ok(())
    }

    /// What a renderer takes, after [`Self::build`] with the same plan.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> Trees<'a> {
        let tree = |aim: &Aim, (set, facing): &'a (Bvh, Facing)| match aim.choice {
            Choice::Set => Some(Tree::all(set)),
            Choice::Whole => Some(Tree {
                bvh: &self.whole,
                rule: self
                    .components
                    .as_ref()
                    .map(|components| (components, facing)),
            }),
            Choice::Unused => None,
        };
        let mut trees = plan.aims.iter().zip(&self.sets);
        let primary = trees.next().and_then(|(aim, set)| tree(aim, set));
        let primary = primary.unwrap_or(Tree::all(&self.whole));
        // Where there are no rays, any tree will do.
        let lights = trees.map(|(aim, set)| tree(aim, set).unwrap_or(Tree::all(primary.bvh)));
        Trees {
            primary,
            lights: lights.collect(),
            mirrors: plan.has_mirrors.then_some(&self.whole),
        }
    }

    /// The tree of each aim that has its own.
    pub fn sets<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = (&'a Aim, &'a Bvh)> {
        let sets = plan.aims.iter().zip(&self.sets);
        sets.filter(|(aim, _)| aim.choice == Choice::Set)
            .map(|(aim, (bvh, _))| (aim, bvh))
    }

    /// All trees that a plan had built.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a Bvh> {
        let whole = plan.needs_whole.then_some(&self.whole);
        whole.into_iter().chain(self.sets(plan).map(|(_, set)| set))
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
}

impl ImageRenderer {
    /// One without buffers yet.
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        Self {
            builder: Builder::new(config),
            hierarchies: Hierarchies::new(),
            renderer: Renderer::new(),
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
        let uploaded = Scene::upload(gpu, scene)?;
        hierarchies.upload(gpu, plan)?;

        let mut frame = gpu.frame();
        hierarchies.build(&mut frame, builder, &uploaded.mesh, plan)?;
        let trees = hierarchies.trees(plan);
        let view = (camera, scene.lights.as_slice());
        renderer.render_with(&mut frame, &uploaded, &trees, view, settings)?;
        let times = renderer.finish(frame, Stages::default(), begin, picture)?;
        progress(1.0);
        Ok(times)
    }
}
