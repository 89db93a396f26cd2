//! What makes a frame.

use anyhow::Result;
use slimbvh::animate::{Action, sah_cost};
use slimbvh::{
    BuildConfig, Builder, Bvh, Picture, RenderReport, RenderSettings, Renderer, Scene, Stages,
};

#[cfg(feature = "gpu")]
mod on_gpu;
#[cfg(feature = "gpu")]
pub use on_gpu::OnGpu;

/// The CPU or a GPU, with a tree that it keeps from frame to frame.
pub trait Machine {
    /// The backend, and the GPU's name.
    fn name(&self) -> (&'static str, Option<String>);

    /// Brings the tree up to date and renders the scene as it is now.
    fn frame(
        &mut self,
        scene: &Scene,
        vertices_moved: bool,
        action: Action,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done>;
}

/// What a frame took.
#[derive(Debug)]
pub struct Done {
    pub build: Stages,
    pub report: RenderReport,
    /// The tree's cost, where it is known.
    pub cost: Option<f64>,
}

/// This machine's cores.
pub struct Cpu {
    builder: Builder,
    bvh: Bvh,
    renderer: Renderer,
    cost: Option<f64>,
}

impl Cpu {
    pub fn new(config: BuildConfig) -> Self {
        Self {
            builder: Builder::new(config),
            bvh: Bvh::default(),
            renderer: Renderer::new(),
            cost: None,
        }
    }
}

impl Machine for Cpu {
    fn name(&self) -> (&'static str, Option<String>) {
        ("cpu", None)
    }

    fn frame(
        &mut self,
        scene: &Scene,
        _: bool,
        action: Action,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done> {
        let bvh = &mut self.bvh;
        let mut build = match action {
            Action::Rebuilt => self.builder.build_into(&scene.mesh, bvh)?,
            Action::Refitted => self.builder.refit(&scene.mesh, bvh)?,
            Action::Kept => Stages::default(),
        };
        if action != Action::Kept {
            self.cost = Some(build.time("quality", || sah_cost(bvh.nodes())));
        }
        let report = self
            .renderer
            .render(scene, bvh, settings, picture, |_| ())?;
        Ok(Done {
            build,
            report,
            cost: self.cost,
        })
    }
}
