//! A scene in one method's codecs on a GPU.

use super::Machine;
use crate::reproduce::compressed::bench::Buffers;
use crate::reproduce::compressed::methods::Prepared;
use crate::reproduce::machine::timed;
use anyhow::{Context, Result};
use slimbvh::gpu::{Builder, Bvh, Gpu, Renderer, Scene};
use slimbvh::{Picture, RenderSettings, Stages};

/// What is on the GPU stays there from one round to the next.
pub struct OnGpu<'a> {
    gpu: &'a Gpu,
    prepared: &'a Prepared<'a>,
    uploaded: Scene,
    builder: Builder,
    pub bvh: Bvh,
    renderer: Renderer,
}

impl<'a> OnGpu<'a> {
    pub fn new(gpu: &'a Gpu, prepared: &'a Prepared) -> Result<Self> {
        Ok(Self {
            gpu,
            prepared,
            uploaded: Scene::upload(gpu, &prepared.scene)?,
            builder: Builder::new(prepared.config),
            bvh: Bvh::new(),
            renderer: Renderer::new(),
        })
    }

    pub fn gpu(&self) -> &'a Gpu {
        self.gpu
    }

    /// Whether it computes on the CPU.
    pub fn is_software(&self) -> bool {
        self.gpu.device().adapter_info().device_type == wgpu::DeviceType::Cpu
    }

    /// As they are now.
    pub fn buffers(&self) -> Buffers {
        Buffers {
            tree: self.bvh.bytes(),
            builder: self.builder.scratch_bytes(),
            renderer: self.renderer.scratch_bytes(),
            scene: self.uploaded.bytes(),
        }
    }

    /// The picture that was made last.
    pub fn picture(&mut self) -> Result<Picture> {
        let mut frame = self.gpu.frame();
        let texels = self.renderer.read_later(&mut frame)?;
        frame.submit()?.wait()?;
        let mut picture = Picture::default();
        texels.read(self.gpu, &mut picture)?;
        Ok(picture)
    }
}

impl Machine for OnGpu<'_> {
    fn build(&mut self) -> Result<Stages> {
        let mut frame = self.gpu.frame();
        let mesh = &self.uploaded.mesh;
        self.builder.build(&mut frame, mesh, &mut self.bvh)?;
        timed(frame)
    }

    fn render(&mut self, settings: &RenderSettings) -> Result<Stages> {
        let scene = &self.prepared.scene;
        let camera = scene.cameras.first().context("the scene has no camera")?;
        let (bvh, lights) = (&self.bvh, &scene.lights);
        let mut frame = self.gpu.frame();
        self.renderer
            .render(&mut frame, &self.uploaded, bvh, camera, lights, settings)?;
        timed(frame)
    }
}
