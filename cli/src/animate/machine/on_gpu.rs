//! Frames on a GPU: one submission each, into which the moved vertices go before.

use super::{Done, Machine, Update};
use anyhow::Result;
use slimbvh::animate::Action;
use slimbvh::gpu::{self, Gpu, wgpu};
use slimbvh::reduce::gpu::{DecisionsReport, Hierarchies, LightSets};
use slimbvh::{BuildConfig, Picture, RenderSettings, Scene, Stages, ViewError};
use std::time::Instant;

/// A GPU, and all that stays on it.
pub struct OnGpu<'g> {
    gpu: &'g Gpu,
    scene: gpu::Scene,
    normals: Option<wgpu::Buffer>,
    builder: gpu::Builder,
    bvh: gpu::Bvh,
    hierarchies: Hierarchies,
    decisions: Option<gpu::Decisions>,
    decided: Option<DecisionsReport>,
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
            hierarchies: Hierarchies::new(),
            decisions: None,
            decided: None,
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

impl OnGpu<'_> {
    /// A frame with a tree for each kind of rays. Once vertices have moved, the GPU decides what counts.
    fn planned(
        &mut self,
        scene: &Scene,
        update: &Update,
        settings: &RenderSettings,
        picture: &mut Picture,
        begin: Instant,
    ) -> Result<Done> {
        let (gpu, plan) = (self.gpu, update.plan);
        let (builder, mesh) = (&mut self.builder, &self.scene.mesh);
        if let (true, None, Some(topology)) =
            (update.vertices_moved, &self.decisions, plan.topology)
        {
            self.decisions = Some(gpu::Decisions::new(gpu, topology)?);
        }
        let mut frame = gpu.frame();
        let hierarchies = &mut self.hierarchies;
        let mut decided = None;
        match &mut self.decisions {
            Some(decisions) => {
                let lights = if plan.may_turn_away() {
                    LightSets::Smaller
                } else {
                    LightSets::Facing
                };
                let decider = (&mut *decisions, lights);
                hierarchies.build_deciding(&mut frame, builder, mesh, plan, decider)?;
                decided = Some(hierarchies.read_decisions_later(&mut frame, plan, decisions)?);
            }
            None => {
                if !hierarchies.has_components() {
                    hierarchies.upload(gpu, plan)?;
                }
                hierarchies.update(&mut frame, builder, mesh, plan, update.action)?;
            }
        }
        let camera = scene.cameras.first().ok_or(ViewError::NoCamera)?;
        let trees = hierarchies.trees(plan);
        let mut turns = hierarchies.in_turn(builder, mesh, plan);
        let both: (_, &mut dyn gpu::Turns) = (&trees, &mut turns);
        let view = (camera, scene.lights.as_slice());
        let renderer = &mut self.renderer;
        renderer.render_in_turn(&mut frame, &self.scene, both, view, settings)?;
        let (build, report) = renderer.finish(frame, Stages::default(), begin, picture)?;
        if let Some(decided) = decided {
            self.decided = Some(decided.read(gpu)?);
        }
        Ok(Done {
            build,
            report,
            cost: None,
        })
    }
}

impl Machine for OnGpu<'_> {
    fn name(&self) -> (&'static str, Option<String>) {
        ("gpu", Some(self.gpu.name().into()))
    }

    fn follows_on_host(&self) -> bool {
        // The GPU decides where vertices have moved.
        false
    }

    fn decided(&self) -> Result<Vec<(String, String)>> {
        match &self.decided {
            Some(report) => Ok(report.explain()),
            None => Ok(Vec::new()),
        }
    }

    fn frame(
        &mut self,
        scene: &Scene,
        update: &Update,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done> {
        let begin = Instant::now();
        let action = update.action;
        if update.vertices_moved {
            self.upload(scene);
        }
        if !update.plan.is_plain() {
            return self.planned(scene, update, settings, picture, begin);
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
