//! A scene on a GPU.

use super::{Aim, Machine};
use anyhow::{Context, Result, bail};
use slimbvh::gpu::{
    Builder, Bvh, Components, Facing, Frame, Gpu, Mesh, Renderer, Subset, Tree, Trees,
};
use slimbvh::topology::Topology;
use slimbvh::{BuildConfig, Division, RenderSettings, Scene, Stages};
use slimbvh_core::frustum::Frustum;
use std::time::{Duration, Instant};

/// Samples of pictures whose passes can be timed one by one. More are timed from outside.
const MOST_TIMED_SAMPLES: u64 = 1 << 26;

/// The steps of the division.
const DIVISION: [&str; 3] = ["classify", "scan", "compact"];

pub struct OnGpu<'a> {
    gpu: &'a Gpu,
    scene: &'a Scene,
    topology: &'a Topology,
    uploaded: slimbvh::gpu::Scene,
    components: Components,
    builder: Builder,
    /// Trees, and the target of each that has one.
    trees: Vec<(Bvh, Facing)>,
    /// Where trees go that nothing is traced through.
    spare: (Bvh, Facing),
    /// Meshes of sets alone, with the tree over each. They are made once, outside of all times.
    alone: Vec<(Aim, Mesh, Bvh)>,
    renderer: Renderer,
}

impl<'a> OnGpu<'a> {
    pub fn new(gpu: &'a Gpu, scene: &'a Scene, topology: &'a Topology) -> Result<Self> {
        Ok(Self {
            gpu,
            scene,
            topology,
            uploaded: slimbvh::gpu::Scene::upload(gpu, scene)?,
            components: Components::upload(gpu, topology.components())?,
            builder: Builder::new(BuildConfig::default()),
            trees: Vec::new(),
            spare: (Bvh::new(), Facing::new()),
            alone: Vec::new(),
            renderer: Renderer::new(),
        })
    }

    /// Finds a set's mesh, or makes it.
    fn place_of(&mut self, set: &Aim) -> Result<usize> {
        let same =
            |(aim, ..): &(Aim, Mesh, Bvh)| aim.target == set.target && aim.sides == set.sides;
        if let Some(place) = self.alone.iter().position(same) {
            return Ok(place);
        }
        let mut division = Division::new();
        let mesh = &self.scene.mesh;
        division.divide(mesh, &set.reach(self.topology));
        let triangles = division
            .primitives()
            .iter()
            .map(|&i| mesh.indices[i as usize]);
        let mesh = slimbvh::Mesh {
            vertices: mesh.vertices.clone(),
            indices: triangles.collect(),
            ..slimbvh::Mesh::default()
        };
        let uploaded = Mesh::upload(self.gpu, &mesh)?;
        self.alone.push((set.clone(), uploaded, Bvh::new()));
        Ok(self.alone.len() - 1)
    }
}

impl Machine for OnGpu<'_> {
    fn sorts_sets_alone(&self) -> bool {
        false
    }

    fn sort(&mut self) -> Result<Stages> {
        let mut frame = self.gpu.frame();
        self.builder.sort(&mut frame, &self.uploaded.mesh)?;
        timed(frame)
    }

    fn build(&mut self, place: usize, set: Option<&Aim>) -> Result<Stages> {
        if self.trees.len() <= place {
            self.trees
                .resize_with(place + 1, || (Bvh::new(), Facing::new()));
        }
        let mut frame = self.gpu.frame();
        let (bvh, facing) = &mut self.trees[place];
        let subset = match set {
            None => Subset::All,
            Some(set) => {
                facing.set(&mut frame, &set.target, &Frustum::EVERYWHERE, &set.sides)?;
                Subset::Facing {
                    components: &self.components,
                    facing,
                }
            }
        };
        self.builder
            .build_sorted(&mut frame, &self.uploaded.mesh, subset, bvh)?;
        timed(frame)
    }

    fn build_alone(&mut self, _: usize, set: &Aim) -> Result<Stages> {
        let place = self.place_of(set)?;
        let mut frame = self.gpu.frame();
        let (_, mesh, bvh) = &mut self.alone[place];
        self.builder.build(&mut frame, mesh, bvh)?;
        timed(frame)
    }

    fn divide(&mut self, set: &Aim) -> Result<Stages> {
        let mut frame = self.gpu.frame();
        let mesh = &self.uploaded.mesh;
        let (bvh, facing) = &mut self.spare;
        facing.set(&mut frame, &set.target, &Frustum::EVERYWHERE, &set.sides)?;
        let subset = Subset::Facing {
            components: &self.components,
            facing,
        };
        self.builder.sort(&mut frame, mesh)?;
        self.builder.build_sorted(&mut frame, mesh, subset, bvh)?;
        let all = timed(frame)?;
        let mut division = Stages::default();
        for (stage, time) in all.iter().filter(|(stage, _)| DIVISION.contains(stage)) {
            division.add(stage, time);
        }
        Ok(division)
    }

    fn render(
        &mut self,
        camera: usize,
        lights: &[usize],
        settings: &RenderSettings,
    ) -> Result<Stages> {
        let tree = |place: usize| Tree::all(&self.trees[place].0);
        let trees = Trees {
            primary: tree(camera),
            lights: lights.iter().map(|&place| tree(place)).collect(),
            mirrors: None,
        };
        let camera = self
            .scene
            .cameras
            .first()
            .context("the scene has no camera")?;
        let view = (camera, self.scene.lights.as_slice());
        let mut frame = self.gpu.frame();
        let begin = Instant::now();
        self.renderer
            .render_with(&mut frame, &self.uploaded, &trees, view, settings)?;
        let [width, height] = settings.size.map(u64::from);
        if width * height * u64::from(settings.sample_count) <= MOST_TIMED_SAMPLES {
            return timed(frame);
        }
        frame.submit()?.wait()?;
        let mut stages = Stages::default();
        stages.add("all", begin.elapsed());
        Ok(stages)
    }
}

/// Submits a frame and waits for it. Returns the time of each stage.
pub fn timed(frame: Frame) -> Result<Stages> {
    let name = frame.gpu().name().to_owned();
    let stages = frame.submit()?.wait()?;
    if stages.total() == Duration::ZERO {
        bail!(
            "the GPU {name:?} has no timestamps, so that nothing could be told apart; use --backend cpu"
        );
    }
    Ok(stages)
}
