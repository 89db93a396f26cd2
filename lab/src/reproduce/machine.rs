//! What builds and traces while it is measured: the CPU or a GPU.

#[cfg(feature = "gpu")]
mod on_gpu;

#[cfg(feature = "gpu")]
pub use on_gpu::timed;

use super::aim::Aim;
use anyhow::Result;
use slimbvh::topology::Topology;
use slimbvh::{
    BuildConfig, Builder, Bvh, Division, Picture, RenderSettings, Renderer, Scene, Stages, Tree,
    Trees,
};
use slimbvh_cli::backend::Chosen;

/// A scene on a machine, with room for any number of trees, by number.
pub trait Machine {
    /// Whether pictures can be made with sets that were sorted by themselves.
    fn sorts_sets_alone(&self) -> bool;

    /// Puts all triangles in order, for trees over all or some of them.
    fn sort(&mut self) -> Result<Stages>;

    /// Builds a tree over triangles that are in order: a set, or all.
    fn build(&mut self, place: usize, set: Option<&Aim>) -> Result<Stages>;

    /// Builds a tree over a set whose triangles are put in order by themselves.
    fn build_alone(&mut self, place: usize, set: &Aim) -> Result<Stages>;

    /// The division alone: stages `classify`, `scan` and `compact`.
    fn divide(&mut self, set: &Aim) -> Result<Stages>;

    /// Makes a picture with a tree for the camera's rays and one for each light's.
    fn render(
        &mut self,
        camera: usize,
        lights: &[usize],
        settings: &RenderSettings,
    ) -> Result<Stages>;
}

/// Brings a scene to what was chosen.
pub fn open<'a>(
    chosen: &'a Chosen,
    scene: &'a Scene,
    topology: &'a Topology,
) -> Result<Box<dyn Machine + 'a>> {
    Ok(match chosen {
        Chosen::Cpu => Box::new(Cpu::new(scene, topology)),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => {
            Box::new(on_gpu::OnGpu::new(gpu, scene, topology)?)
        }
    })
}

/// This machine's cores.
struct Cpu<'a> {
    scene: &'a Scene,
    topology: &'a Topology,
    builder: Builder,
    division: Division,
    trees: Vec<Bvh>,
    renderer: Renderer,
    picture: Picture,
}

impl<'a> Cpu<'a> {
    fn new(scene: &'a Scene, topology: &'a Topology) -> Self {
        Self {
            scene,
            topology,
            builder: Builder::new(BuildConfig::default()),
            division: Division::new(),
            trees: Vec::new(),
            renderer: Renderer::new(),
            picture: Picture::default(),
        }
    }

    fn make_place(&mut self, place: usize) {
        if self.trees.len() <= place {
            self.trees.resize_with(place + 1, Bvh::default);
        }
    }
}

impl Machine for Cpu<'_> {
    fn sorts_sets_alone(&self) -> bool {
        true
    }

    fn sort(&mut self) -> Result<Stages> {
        Ok(self.builder.sort(&self.scene.mesh)?)
    }

    fn build(&mut self, place: usize, set: Option<&Aim>) -> Result<Stages> {
        self.make_place(place);
        let subset = set.map_or(slimbvh::Subset::All, |aim| aim.subset(self.topology));
        let bvh = &mut self.trees[place];
        Ok(self.builder.build_sorted(&self.scene.mesh, subset, bvh))
    }

    fn build_alone(&mut self, place: usize, set: &Aim) -> Result<Stages> {
        self.make_place(place);
        let subset = set.subset(self.topology);
        let bvh = &mut self.trees[place];
        Ok(self.builder.build_subset(&self.scene.mesh, subset, bvh)?)
    }

    fn divide(&mut self, set: &Aim) -> Result<Stages> {
        let reach = set.reach(self.topology);
        Ok(self.division.divide(&self.scene.mesh, &reach))
    }

    fn render(
        &mut self,
        camera: usize,
        lights: &[usize],
        settings: &RenderSettings,
    ) -> Result<Stages> {
        let tree = |place: usize| Tree::all(&self.trees[place]);
        let trees = Trees {
            primary: tree(camera),
            lights: lights.iter().map(|&place| tree(place)).collect(),
            mirrors: None,
        };
        let (renderer, picture) = (&mut self.renderer, &mut self.picture);
        let report = renderer.render_with(self.scene, &trees, settings, picture, |_| {})?;
        Ok(report.stages)
    }
}
