//! Queries of rays in a buffer, with answers in a buffer.

pub(super) mod overflow;
pub(super) mod paths;
mod rays;

use super::buffer::{ALIGNMENT, Range};
use super::fit::Part;
use super::kernel::{Traces, traces};
use super::mesh::check_parts;
use super::program::{Recorder, Uniform};
use super::{Bvh, Frame, Gpu, GpuError, Kernel, Misfit, Tree};
pub use rays::Rays;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::{Hit, Ray, RayEnds};

/// The query for each ray.
///
/// ```no_run
/// use slimbvh::gpu::{Bvh, Frame, GpuError, Query, wgpu};
/// # fn run(
/// #     frame: &mut Frame, bvh: &Bvh, rays: &wgpu::Buffer, hits: &wgpu::Buffer,
/// #     is_blocked: &wgpu::Buffer,
/// # ) -> Result<(), GpuError> {
/// bvh.trace(frame, Query::Closest, rays.slice(..), hits.slice(..))?;
/// bvh.trace(frame, Query::Any, rays.slice(..), is_blocked.slice(..))?;
/// # Ok(())
/// # }
/// ```
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
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, Query, wgpu};
    /// # fn run(gpu: &Gpu, ray_count: u64) {
    /// let hits = gpu.device().create_buffer(&wgpu::BufferDescriptor {
    ///     label: None,
    ///     size: ray_count * Query::Closest.answer_bytes(),
    ///     usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
    ///     mapped_at_creation: false,
    /// });
    /// # }
    /// ```
    #[must_use]
    pub const fn answer_bytes(self) -> u64 {
        match self {
            Self::Closest => size_of::<Hit>() as u64,
            Self::Any => 4,
            Self::Nearest => (NEAREST_COUNT * size_of::<Hit>()) as u64,
            Self::Counted => 8,
        }
    }

    /// The kernel, and whether it has a filter.
    const fn kernel(self, traces: &Traces, needs_filter: bool) -> (Kernel, bool) {
        match (self, needs_filter) {
            (Self::Closest, false) => (traces.closest, false),
            (Self::Any, false) => (traces.any, false),
            (Self::Closest, true) => (traces.filtered_closest, true),
            (Self::Any, true) => (traces.filtered_any, true),
            (Self::Nearest, _) => (traces.nearest, true),
            (Self::Counted, _) => (traces.counted, true),
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

/// Bytes of a ray.
const RAY_BYTES: u64 = size_of::<Ray>() as u64;

/// Bytes of what a ray's ends lie on.
const ENDS_BYTES: u64 = size_of::<RayEnds>() as u64;

impl Bvh {
    /// [`Tree::trace`] with all triangles.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Gpu, GpuError, Query, wgpu};
    /// # fn run(gpu: &Gpu, bvh: &Bvh, rays: &wgpu::Buffer, hits: &wgpu::Buffer) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// bvh.trace(&mut frame, Query::Closest, rays.slice(..), hits.slice(..))?;
    /// let hits = frame.read_later(hits.slice(..))?;
    /// frame.submit()?;
    /// let hits: Vec<slimbvh::Hit> = hits.read(gpu)?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Those of [`Tree::trace`].
    pub fn trace<'a>(
        &self,
        frame: &mut Frame,
        query: Query,
        rays: impl Into<Rays<'a>>,
        answers: wgpu::BufferSlice,
    ) -> Result<(), GpuError> {
        Tree::all(self).trace(frame, query, rays, answers)
    }
}

impl Tree<'_> {
    /// Records the trace of rays in a buffer: 32 bytes each, in the layout of [`Ray`]. The answers go to the beginning of the other
    /// buffer. What the tree's rule rejects is no hit. More rays than fit into a storage binding take several dispatches.
    ///
    /// ```no_run
    /// use slimbvh::gpu::{Bvh, Frame, GpuError, Query, Rays, wgpu};
    /// # fn run(frame: &mut Frame, bvh: &Bvh, buffers: &[wgpu::Buffer; 4]) -> Result<(), GpuError> {
    /// let [rays, ends, count, hits] = buffers;
    /// bvh.trace(frame, Query::Closest, rays.slice(..), hits.slice(..))?;
    /// // Rays that leave surfaces, whose number an earlier pass has stored.
    /// let next = Rays::new(rays.slice(..)).with_ends(ends.slice(..)).counted_by(count.slice(..4));
    /// bvh.trace(frame, Query::Closest, next, hits.slice(..))?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the hierarchy is not built, or its rule's sides are not decided, or are those of other components; if a buffer lacks the
    /// usage `STORAGE`, or not all answers or ends fit.
    pub fn trace<'a>(
        &self,
        frame: &mut Frame,
        query: Query,
        rays: impl Into<Rays<'a>>,
        answers: wgpu::BufferSlice,
    ) -> Result<(), GpuError> {
        // A multiple of this many rays begins at an aligned offset in all buffers, for every query.
        const RAYS_PER_STEP: u64 = ALIGNMENT / 4;
        let tree = self.ranges()?;
        let gpu = frame.gpu();
        let rays = rays.into().ranges(gpu)?;
        let answers = Range::of_slice(answers);
        let answer_bytes = query.answer_bytes();
        check_parts(gpu, "the buffer of answers", &answers, answer_bytes)?;
        if answers.size < rays.count * answer_bytes {
            let fault = Misfit::TooFewAnswers {
                bytes: answers.size,
                ray_count: rays.count,
                answer_bytes,
            };
            return Err(fault.of("the buffer of answers"));
        }
        let limit = gpu.limits().max_storage_buffer_binding_size;
        let most = limit / answer_bytes.max(RAY_BYTES) / RAYS_PER_STEP * RAYS_PER_STEP;
        let most = most.clamp(RAYS_PER_STEP, u64::from(u32::MAX) / 2);
        gpu.checked(|| {
            let (no_ends, groups) = (Range::whole(&gpu.no_ends()), gpu.ray_groups());
            let mut recorder = Recorder::default();
            recorder.stage("trace");
            let mut first = 0;
            while first < rays.count {
                let count = most.min(rays.count - first);
                let ends = rays.ends.as_ref();
                let ends = ends.map(|ends| ends.part(first * ENDS_BYTES, count * ENDS_BYTES));
                let asked = Asked {
                    query,
                    rays: rays.rays.part(first * RAY_BYTES, count * RAY_BYTES),
                    has_ends: ends.is_some(),
                    ends: ends.unwrap_or_else(|| no_ends.clone()),
                    answers: answers.part(first * answer_bytes, count * answer_bytes),
                    count: count as u32,
                };
                let counted = rays.counted(first as u32);
                for part in tree.parts(&mut recorder, &groups, count as u32, counted.as_ref()) {
                    asked.record(gpu, &mut recorder, part);
                }
                first += count;
            }
            recorder.finish(gpu)?.encode(frame);
            Ok(())
        })
    }
}

/// The rays of one dispatch, and where their answers go.
struct Asked {
    query: Query,
    rays: Range,
    has_ends: bool,
    ends: Range,
    answers: Range,
    count: u32,
}

impl Asked {
    /// Records the trace of those that go through a tree.
    fn record(&self, gpu: &Gpu, recorder: &mut Recorder, part: Part) {
        let Self {
            query,
            rays,
            ends,
            answers,
            ..
        } = self;
        let Part {
            tree,
            groups,
            number,
        } = part;
        let number = match &number {
            Some(number) => Uniform::Stored(number),
            None => Uniform::Params([self.count, 0, 0, 0]),
        };
        let kernels = traces(tree.built.coding());
        let needs_filter = tree.rule.is_some() || self.has_ends;
        let (kernel, is_filtered) = query.kernel(&kernels, needs_filter);
        let [nodes, triangles] = &tree.built.traced();
        let root: Vec<Uniform> = tree.built.root().into_iter().collect();
        let (exponent, target) = (
            Uniform::Stored(&tree.built.exponent),
            Uniform::Stored(tree.target()),
        );
        let sides = tree.sides();
        let (uniforms, reads) = if is_filtered {
            (
                vec![exponent, target, number],
                vec![nodes, triangles, sides, rays, ends],
            )
        } else {
            (vec![exponent, number], vec![nodes, triangles, rays])
        };
        let uniforms = [root.clone(), uniforms].concat();
        let Some(hit_count) = query.hit_count() else {
            recorder.dispatch(kernel, &uniforms, &reads, &[answers], groups);
            return;
        };
        let overflow = gpu.overflow(self.count.into());
        let list = &overflow.list;
        let to = [answers, &list.touching(0)];
        recorder.dispatch(kernel, &uniforms, &reads, &to, groups);
        let groups = overflow.record(recorder);
        let hit_count = Uniform::Params([hit_count, 0, 0, 0]);
        let uniforms = [exponent, target, overflow.length(), hit_count];
        let uniforms = [root, uniforms.to_vec()].concat();
        let reads = [nodes, triangles, sides, rays, ends, list];
        let untouched = reads.map(|range| range.touching(0));
        recorder.dispatch(
            kernels.rays_overflow,
            &uniforms,
            &untouched.each_ref(),
            &[&answers.touching(0)],
            groups,
        );
    }
}
