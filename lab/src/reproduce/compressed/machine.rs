//! What builds and renders while it is timed. Counts are the same on every machine, and are not taken here.

#[cfg(feature = "gpu")]
mod on_gpu;

#[cfg(feature = "gpu")]
pub use on_gpu::OnGpu;

use super::methods::Prepared;
use anyhow::Result;
use slimbvh::{Builder, Bvh, Picture, RenderSettings, Renderer, Stages};

/// A scene in one method's codecs on a machine.
pub trait Machine {
    /// Builds and codes the tree over all triangles.
    fn build(&mut self) -> Result<Stages>;

    /// Makes a picture with it.
    fn render(&mut self, settings: &RenderSettings) -> Result<Stages>;
}

/// This machine's cores.
pub struct Cpu<'a> {
    prepared: &'a Prepared<'a>,
    builder: Builder,
    pub bvh: Bvh,
    renderer: Renderer,
    pub picture: Picture,
}

impl<'a> Cpu<'a> {
    pub fn new(prepared: &'a Prepared) -> Self {
        Self {
            prepared,
            builder: Builder::new(prepared.config),
            bvh: Bvh::default(),
            renderer: Renderer::new(),
            picture: Picture::default(),
        }
    }

    /// Its vertices moved onto the lattice, where there is one.
    #[cfg(feature = "gpu")]
    pub fn scene(&self) -> &slimbvh::Scene {
        &self.prepared.scene
    }
}

impl Machine for Cpu<'_> {
    fn build(&mut self) -> Result<Stages> {
        let mesh = &self.prepared.scene.mesh;
        Ok(self.builder.build_into(mesh, &mut self.bvh)?)
    }

    fn render(&mut self, settings: &RenderSettings) -> Result<Stages> {
        let (scene, bvh) = (&*self.prepared.scene, &self.bvh);
        let (renderer, picture) = (&mut self.renderer, &mut self.picture);
        Ok(renderer
            .render(scene, bvh, settings, picture, |_| {})?
            .stages)
    }
}
