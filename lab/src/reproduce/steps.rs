//! Builds and renders a scene on a backend in steps, each timed by itself.

use super::facing_target::FacingTarget;
use anyhow::{Result, bail};
use slimbvh::backend::{Load, Shot, Source, TargetSet, Tree, Trees};
use slimbvh::topology::Topology;
use slimbvh::{
    Backend, BuildConfig, Change, Division, Mesh, Output, Picture, RenderSettings, Scene, Stages,
    Stopwatch,
};
use std::time::Duration;

/// A GPU times pictures of up to this many samples in one submission, and larger pictures wave by wave.
const MOST_TIMED_SAMPLES: u64 = 1 << 26;

/// The stages of the division.
const DIVISION: [&str; 3] = ["classify", "scan", "compact"];

/// A scene on a backend, with any number of trees; a place in the list names a tree.
pub struct Steps<'a, B: Backend> {
    pub backend: B,
    pub scene: &'a Scene,
    /// `None` if all trees are over all triangles.
    topology: Option<&'a Topology>,
    pub held: B::Held,
    pub builder: B::Builder,
    /// The trees, each with the sides of its target if it has one.
    trees: Vec<(B::Bvh, B::TargetSides)>,
    /// The tree that a division without a build writes to.
    spare: (B::Bvh, B::TargetSides),
    /// Sets as meshes, if the backend cannot sort sets alone.
    alone: Vec<Alone<B>>,
    pub renderer: B::Renderer,
    /// The last picture.
    pub picture: Picture,
}

/// A set as a mesh, with the tree over it. The mesh is made once, and that is not timed.
struct Alone<B: Backend> {
    set: FacingTarget,
    mesh: Mesh,
    held: B::Held,
    bvh: B::Bvh,
}

impl<'a, B: Backend> Steps<'a, B> {
    /// Loads a scene to a backend.
    pub fn new(
        backend: B,
        config: BuildConfig,
        scene: &'a Scene,
        topology: Option<&'a Topology>,
    ) -> Result<Self> {
        let builder = backend.builder(config);
        let mut held = B::Held::default();
        backend.load(&mut held, &builder, (&scene.mesh).into(), &load(topology))?;
        backend.load_picture(&mut held, scene, Change::Scene)?;
        Ok(Self {
            backend,
            scene,
            topology,
            held,
            builder,
            trees: Vec::new(),
            spare: Default::default(),
            alone: Vec::new(),
            renderer: B::Renderer::default(),
            picture: Picture::default(),
        })
    }

    /// Whether the backend renders pictures with sets that were sorted alone.
    pub fn sorts_sets_alone(&self) -> bool {
        B::SORTS_SETS_ALONE
    }

    /// The tree with this number.
    pub fn tree(&self, place: usize) -> &B::Bvh {
        &self.trees[place].0
    }

    /// Sorts all triangles, for trees over all or some of them.
    pub fn sort(&mut self) -> Result<Stages> {
        let mut recording = self.backend.begin();
        let source = Source {
            held: &self.held,
            geometry: (&self.scene.mesh).into(),
        };
        B::sort(&mut recording, &mut self.builder, source)?;
        self.submit(recording)
    }

    /// Sorts all triangles, and builds and encodes the tree over them, as number 0.
    pub fn build_all(&mut self) -> Result<Stages> {
        let mut recording = self.backend.begin();
        self.make_place(0);
        let source = Source {
            held: &self.held,
            geometry: (&self.scene.mesh).into(),
        };
        let (bvh, _) = &mut self.trees[0];
        B::sort(&mut recording, &mut self.builder, source)?;
        B::build_sorted(&mut recording, &mut self.builder, source, None, bvh)?;
        self.submit(recording)
    }

    /// Builds a tree over sorted triangles: a set, or all.
    pub fn build(&mut self, place: usize, set: Option<&FacingTarget>) -> Result<Stages> {
        self.make_place(place);
        let mut recording = self.backend.begin();
        let source = Source {
            held: &self.held,
            geometry: (&self.scene.mesh).into(),
        };
        let (bvh, sides) = &mut self.trees[place];
        let builder = &mut self.builder;
        match (set, components::<B>(&self.held, self.topology)) {
            (Some(set), Some(components)) => {
                B::set_sides(&mut recording, &self.held, &set.target_sides(), None, sides)?;
                let set = TargetSet { components, sides };
                B::build_sorted(&mut recording, builder, source, Some(&set), bvh)?;
            }
            _ => B::build_sorted(&mut recording, builder, source, None, bvh)?,
        }
        self.submit(recording)
    }

    /// Builds a tree over a set whose triangles are sorted by themselves.
    pub fn build_alone(&mut self, place: usize, set: &FacingTarget) -> Result<Stages> {
        self.make_place(place);
        if !B::SORTS_SETS_ALONE {
            return self.build_mesh_of(set);
        }
        let mut recording = self.backend.begin();
        let source = Source {
            held: &self.held,
            geometry: (&self.scene.mesh).into(),
        };
        let (bvh, sides) = &mut self.trees[place];
        if let Some(components) = components::<B>(&self.held, self.topology) {
            B::set_sides(&mut recording, &self.held, &set.target_sides(), None, sides)?;
            let set = TargetSet { components, sides };
            B::build_alone(&mut recording, &mut self.builder, source, &set, bvh)?;
        }
        self.submit(recording)
    }

    /// Builds a tree over the mesh of a set.
    fn build_mesh_of(&mut self, set: &FacingTarget) -> Result<Stages> {
        let place = self.place_of(set)?;
        let mut recording = self.backend.begin();
        let Alone {
            mesh, held, bvh, ..
        } = &mut self.alone[place];
        let source = Source {
            held,
            geometry: (&*mesh).into(),
        };
        B::sort(&mut recording, &mut self.builder, source)?;
        B::build_sorted(&mut recording, &mut self.builder, source, None, bvh)?;
        self.submit(recording)
    }

    /// The index of a set's mesh, which is made if it is missing.
    fn place_of(&mut self, set: &FacingTarget) -> Result<usize> {
        let same =
            |alone: &Alone<B>| alone.set.target == set.target && alone.set.sides == set.sides;
        if let Some(place) = self.alone.iter().position(same) {
            return Ok(place);
        }
        let mut division = Division::new();
        let mesh = &self.scene.mesh;
        if let Some(topology) = self.topology {
            division.divide(mesh, &set.visible_set(topology));
        }
        let primitives = division.primitives().iter();
        let triangles = primitives.map(|&i| mesh.indices[i as usize]);
        let mesh = Mesh {
            vertices: mesh.vertices.clone(),
            indices: triangles.collect(),
            ..Mesh::default()
        };
        let mut held = B::Held::default();
        self.backend
            .load(&mut held, &self.builder, (&mesh).into(), &load(None))?;
        self.alone.push(Alone {
            set: set.clone(),
            mesh,
            held,
            bvh: B::Bvh::default(),
        });
        Ok(self.alone.len() - 1)
    }

    /// The times of the division alone: stages `classify`, `scan` and `compact`.
    pub fn divide(&mut self, set: &FacingTarget) -> Result<Stages> {
        let mut recording = self.backend.begin();
        let source = Source {
            held: &self.held,
            geometry: (&self.scene.mesh).into(),
        };
        let (bvh, sides) = &mut self.spare;
        if let Some(components) = components::<B>(&self.held, self.topology) {
            B::set_sides(&mut recording, &self.held, &set.target_sides(), None, sides)?;
            let set = TargetSet { components, sides };
            B::divide(&mut recording, &mut self.builder, source, &set, bvh)?;
        }
        let all = self.submit(recording)?;
        let mut division = Stages::default();
        for (stage, time) in all.iter().filter(|(stage, _)| DIVISION.contains(stage)) {
            division.add(stage, time);
        }
        Ok(division)
    }

    /// Renders a picture with a tree for the camera's and the mirrors' rays, and a tree for each light's rays.
    pub fn render(
        &mut self,
        camera: usize,
        lights: &[usize],
        settings: &RenderSettings,
    ) -> Result<Stages> {
        let trees = &self.trees;
        let tree = |place: usize| Tree::all(&trees[place].0);
        let trees = Trees {
            primary: tree(camera),
            lights: lights.iter().map(|&place| tree(place)).collect(),
            mirrors: (settings.mirror_depth > 0).then_some(&trees[camera].0),
        };
        let shot = Shot {
            scene: self.scene,
            held: &self.held,
            trees: &trees,
            settings,
            begin: Stopwatch::start(),
        };
        let [width, height] = settings.size.map(u64::from);
        let sample_count = width * height * u64::from(settings.sample_count);
        let mut no_progress = |_| {};
        let mut output = Output::new(&mut self.picture);
        if sample_count > MOST_TIMED_SAMPLES {
            output.progress = Some(&mut no_progress);
        }
        let recording = self.backend.begin();
        let renderer = &mut self.renderer;
        let rendered = self
            .backend
            .render(recording, renderer, &shot, None, output);
        Ok(rendered?.1.stages)
    }

    /// [`Self::render`] with the tree over all triangles.
    pub fn render_all(&mut self, settings: &RenderSettings) -> Result<Stages> {
        let lights = vec![0; self.scene.lights.len()];
        self.render(0, &lights, settings)
    }

    fn make_place(&mut self, place: usize) {
        if self.trees.len() <= place {
            self.trees.resize_with(place + 1, Default::default);
        }
    }

    /// Submits a recording. Returns the time of each stage.
    fn submit(&self, recording: B::Recording) -> Result<Stages> {
        let stages = self.backend.submit(recording)?;
        if let Some(name) = self
            .backend
            .adapter()
            .filter(|_| stages.total() == Duration::ZERO)
        {
            bail!("the GPU {name:?} has no timestamps, which stage times need; use --backend cpu");
        }
        Ok(stages)
    }
}

const fn load(topology: Option<&Topology>) -> Load<'_> {
    Load {
        change: Change::Scene,
        topology,
        may_turn_away: false,
    }
}

fn components<'a, B: Backend>(
    held: &'a B::Held,
    topology: Option<&'a Topology>,
) -> Option<B::Components<'a>> {
    B::components(held, topology.map(Topology::components))
}
