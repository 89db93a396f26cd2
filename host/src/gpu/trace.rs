//! Queries of rays in a buffer, with answers in a buffer.

pub(super) mod overflow;
pub(super) mod paths;

use super::buffer::{ALIGNMENT, Range};
use super::kernel::{Traces, traces};
use super::mesh::check_parts;
use super::program::{Recorder, Uniform, threads};
use super::{Bvh, Frame, GpuError, Kernel, Misfit};
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::{Hit, Ray};

/// The query for each ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Query {
    /// The closest [`Hit`]: 16 bytes a ray.
    Closest,
    /// Whether the ray hits any triangle, as 1 or 0: one `u32` a ray.
    Any,
    /// The eight nearest [`Hit`]s in order, misses at the end: 128 bytes a ray.
    Nearest,
    /// The numbers of nodes and triangles that the search for the closest hit reads: two `u32` a ray.
    Counted,
}

impl Query {
    /// Bytes of an answer.
    #[must_use]
    pub const fn answer_bytes(self) -> u64 {
        match self {
            Self::Closest => size_of::<Hit>() as u64,
            Self::Any => 4,
            Self::Nearest => (NEAREST_COUNT * size_of::<Hit>()) as u64,
            Self::Counted => 8,
        }
    }

    const fn kernel(self, traces: &Traces) -> Kernel {
        match self {
            Self::Closest => traces.closest,
            Self::Any => traces.any,
            Self::Nearest => traces.nearest,
            Self::Counted => traces.counted,
        }
    }

    /// Hits a ray, as the kernel of the second pass counts them; `None` for the one that has no second pass.
    const fn hit_count(self) -> Option<u32> {
        match self {
            Self::Closest => Some(1),
            Self::Any => Some(0),
            Self::Nearest => Some(NEAREST_COUNT as u32),
            Self::Counted => None,
        }
    }
}

impl Bvh {
    /// Records the trace of all rays of a buffer: 32 bytes each, in the layout of [`Ray`]. The answers go to the beginning
    /// of the other buffer. More rays than fit into a storage binding take several dispatches.
    ///
    /// # Errors
    /// If the hierarchy is not built, a buffer lacks the usage `STORAGE`, or not all answers fit.
    pub fn trace(
        &self,
        frame: &mut Frame,
        query: Query,
        rays: wgpu::BufferSlice,
        answers: wgpu::BufferSlice,
    ) -> Result<(), GpuError> {
        const RAY_BYTES: u64 = size_of::<Ray>() as u64;
        // A multiple of this many rays begins at an aligned offset in both buffers, for every query.
        const RAYS_PER_STEP: u64 = ALIGNMENT / 4;
        let built = self.built()?;
        let gpu = frame.gpu();
        let (rays, answers) = (Range::of_slice(rays), Range::of_slice(answers));
        let answer_bytes = query.answer_bytes();
        check_parts(gpu, "the buffer of rays", &rays, RAY_BYTES)?;
        check_parts(gpu, "the buffer of answers", &answers, answer_bytes)?;
        let ray_count = rays.size / RAY_BYTES;
        if answers.size < ray_count * answer_bytes {
            let fault = Misfit::TooFewAnswers {
                bytes: answers.size,
                ray_count,
                answer_bytes,
            };
            return Err(fault.of("the buffer of answers"));
        }
        let limit = gpu.limits().max_storage_buffer_binding_size;
        let most = limit / answer_bytes.max(RAY_BYTES) / RAYS_PER_STEP * RAYS_PER_STEP;
        let most = most.clamp(RAYS_PER_STEP, u64::from(u32::MAX) / 2);
        gpu.checked(|| {
            let mut recorder = Recorder::default();
            recorder.stage("trace");
            let kernels = traces(built.coding());
            let kernel = query.kernel(&kernels);
            let [nodes, triangles] = &built.traced();
            let mut uniforms: Vec<Uniform> = built.root().into_iter().collect();
            uniforms.push(Uniform::Stored(&built.exponent));
            let mut first = 0;
            while first < ray_count {
                let count = most.min(ray_count - first);
                let rays = &rays.part(first * RAY_BYTES, count * RAY_BYTES);
                let answers = &answers.part(first * answer_bytes, count * answer_bytes);
                let reads = [nodes, triangles, rays];
                let each = threads(count as u32);
                first += count;
                let Some(hit_count) = query.hit_count() else {
                    recorder.dispatch(kernel, &uniforms, &reads, &[answers], each);
                    continue;
                };
                let overflow = gpu.overflow(count);
                let list = &overflow.list;
                let to = [answers, &list.touching(0)];
                recorder.dispatch(kernel, &uniforms, &reads, &to, each);
                let groups = overflow.record(&mut recorder);
                let mut uniforms = uniforms.clone();
                uniforms.push(overflow.length());
                uniforms.push(Uniform::Params([hit_count, 0, 0, 0]));
                let untouched = [nodes, triangles, rays, list].map(|range| range.touching(0));
                recorder.dispatch(
                    kernels.rays_overflow,
                    &uniforms,
                    &untouched.each_ref(),
                    &[&answers.touching(0)],
                    groups,
                );
            }
            recorder.finish(gpu)?.encode(frame);
            Ok(())
        })
    }
}
