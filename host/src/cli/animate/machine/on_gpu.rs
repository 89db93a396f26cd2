//! Frames on a GPU: one submission each, into which the moved vertices go before.

use super::{Done, Machine};
use anyhow::Result;
use slimbvh::animate::Action;
use slimbvh::gpu::{self, Gpu, wgpu};
use slimbvh::{BuildConfig, Picture, RenderSettings, Scene, Stages, ViewError};
use std::time::Instant;

/// A GPU, and all that stays on it.
pub struct OnGpu<'g> {
    gpu: &'g Gpu,
    scene: gpu::Scene,
    normals: Option<wgpu::Buffer>,
    builder: gpu::Builder,
    bvh: gpu::Bvh,
    renderer: gpu::Renderer,
}

impl<'g> OnGpu<'g> {
    /// Copies the scene to the GPU, with its normals where they can be moved.
    pub fn new(gpu: &'g Gpu, scene: &Scene, config: BuildConfig) -> Result<Self> {
        let mesh = gpu::Mesh::upload(gpu, &scene.mesh)?;
        let upload = |label: &str, bytes: &[u8]| {
            (!bytes.is_empty()).then(|| {
                let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
                    label: Some(label),
                    size: bytes.len() as u64,
                    usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                gpu.queue().write_buffer(&buffer, 0, bytes);
                buffer
            })
        };
        let normals = upload("slimbvh normals", bytemuck::cast_slice(&scene.mesh.normals));
        let materials = upload(
            "slimbvh material indices",
            bytemuck::cast_slice(&scene.mesh.materials),
        );
        let scene = gpu::Scene::from_buffers(
            gpu,
            mesh,
            normals.as_ref().map(|buffer| buffer.slice(..)),
            materials.as_ref().map(|buffer| buffer.slice(..)),
            &scene.materials,
        )?;
        Ok(Self {
            gpu,
            scene,
            normals,
            builder: gpu::Builder::new(config),
            bvh: gpu::Bvh::new(),
            renderer: gpu::Renderer::new(),
        })
    }

    /// Moves the vertices, and the normals with them.
    fn upload(&self, scene: &Scene) {
        let queue = self.gpu.queue();
        let vertices = bytemuck::cast_slice(&scene.mesh.vertices);
        queue.write_buffer(self.scene.mesh.vertex_buffer(), 0, vertices);
        if let Some(normals) = &self.normals {
            queue.write_buffer(normals, 0, bytemuck::cast_slice(&scene.mesh.normals));
        }
    }
}

impl Machine for OnGpu<'_> {
    fn name(&self) -> (&'static str, Option<String>) {
        ("gpu", Some(self.gpu.name().into()))
    }

    fn frame(
        &mut self,
        scene: &Scene,
        vertices_moved: bool,
        action: Action,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done> {
        let begin = Instant::now();
        if vertices_moved {
            self.upload(scene);
        }
        let (gpu, bvh) = (self.gpu, &mut self.bvh);
        let mut frame = gpu.frame();
        match action {
            Action::Rebuilt => self.builder.build(&mut frame, &self.scene.mesh, bvh)?,
            Action::Refitted => self.builder.refit(&mut frame, &self.scene.mesh, bvh)?,
            Action::Kept => {}
        }
        let camera = scene.cameras.first().ok_or(ViewError::NoCamera)?;
        let (renderer, lights) = (&mut self.renderer, &scene.lights);
        renderer.render(&mut frame, &self.scene, bvh, camera, lights, settings)?;
        let (build, report) = renderer.finish(frame, Stages::default(), begin, picture)?;
        Ok(Done {
            build,
            report,
            cost: None,
        })
    }
}
