//! slimbvh on a GPU.

use super::families::Case;
use super::judge::Answer;
use super::slim::{Facing, NAME, facts, storage, trees};
use super::tracer::{Failure, Outcome, Tracer, Tree};
use super::{BOUND_ULPS, Effort};
use slimbvh::Ray;
use slimbvh::gpu::{self, GpuError, Query, Subset, wgpu};
use slimbvh_core::Hit;
use slimbvh_core::frustum::Frustum;
use std::time::Instant;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// The GPU backend.
#[derive(Debug)]
pub struct Gpu {
    /// The GPU.
    pub gpu: gpu::Gpu,
    /// The number of codecs.
    pub effort: Effort,
}

impl Tracer for Gpu {
    fn name(&self) -> &str {
        NAME
    }

    fn backend(&self) -> &'static str {
        "gpu"
    }

    fn bound_ulps(&self) -> f64 {
        BOUND_ULPS
    }

    fn trees(&self, case: &Case) -> Vec<Tree> {
        trees(case, self.effort, true)
    }

    fn trace(&mut self, case: &Case, tree: &Tree, rays: &[Ray]) -> Result<Outcome, Failure> {
        let gpu = &self.gpu;
        let storage = storage(tree, self.effort)?;
        let prepared = storage.prepare(&case.mesh, case.code_bits);
        let facing = Facing::new(case, tree, &prepared.mesh)?;
        let mesh = gpu::Mesh::upload(gpu, &prepared.mesh)?;
        let set = Set::upload(gpu, &facing)?;
        let mut builder = gpu::Builder::new(prepared.config);
        let mut bvh = gpu::Bvh::new();

        let start = Instant::now();
        let mut frame = gpu.frame();
        builder.sort(&mut frame, &mesh)?;
        let mut sides = gpu::TargetSides::new();
        let subset = set.subset(&mut frame, &facing, &mut sides)?;
        builder.build_sorted(&mut frame, &mesh, subset, &mut bvh)?;
        let questions = Questions::new(gpu, rays);
        let [closest, any] = questions.ask(&mut frame, &bvh)?;
        frame.submit()?.wait()?;
        let answers = together(closest.read(gpu)?, &any.read(gpu)?);
        let time_ms = start.elapsed().as_secs_f64() * 1e3;
        Ok(Outcome {
            answers,
            time_ms,
            ..facts(&prepared, storage, &bvh.download(gpu)?)?.outcome
        })
    }
}

/// The components of a reduced tree.
struct Set(Option<gpu::Components>);

impl Set {
    fn upload(gpu: &gpu::Gpu, facing: &Facing) -> Result<Self, GpuError> {
        let components = facing
            .target
            .map(|_| gpu::Components::upload(gpu, &facing.components));
        Ok(Self(components.transpose()?))
    }

    fn subset<'a>(
        &'a self,
        frame: &mut gpu::Frame,
        facing: &Facing,
        to: &'a mut gpu::TargetSides,
    ) -> Result<Subset<'a>, GpuError> {
        let (Some(components), Some(target)) = (&self.0, &facing.target) else {
            return Ok(Subset::All);
        };
        to.set(
            frame,
            components,
            (target, &Frustum::EVERYWHERE),
            &facing.sides,
        )?;
        Ok(Subset::Of {
            components,
            sides: to,
        })
    }
}

/// Rays, and buffers for their answers.
struct Questions {
    rays: wgpu::Buffer,
    closest: wgpu::Buffer,
    any: wgpu::Buffer,
}

impl Questions {
    fn new(gpu: &gpu::Gpu, rays: &[Ray]) -> Self {
        let buffer = |contents: &[u8]| {
            gpu.device().create_buffer_init(&BufferInitDescriptor {
                label: Some("slimbvh-lab stress"),
                contents,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
            })
        };
        let room = |query: Query| buffer(&vec![0; rays.len() * query.answer_bytes() as usize]);
        Self {
            rays: buffer(bytemuck::cast_slice(rays)),
            closest: room(Query::Closest),
            any: room(Query::Any),
        }
    }

    fn ask(&self, frame: &mut gpu::Frame, bvh: &gpu::Bvh) -> Result<[gpu::Download; 2], GpuError> {
        let mut ask = |query: Query, to: &wgpu::Buffer| {
            bvh.trace(frame, query, self.rays.slice(..), to.slice(..))?;
            frame.read_later(to.slice(..))
        };
        Ok([
            ask(Query::Closest, &self.closest)?,
            ask(Query::Any, &self.any)?,
        ])
    }
}

fn together(closest: Vec<Hit>, any: &[u32]) -> Vec<Answer> {
    let answer = |(closest, &any): (Hit, &u32)| Answer {
        closest,
        any: any != 0,
    };
    closest.into_iter().zip(any).map(answer).collect()
}
