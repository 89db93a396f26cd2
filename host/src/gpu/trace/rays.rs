//! Rays in buffers of the caller's.

use super::{ENDS_BYTES, RAY_BYTES};
use crate::gpu::buffer::Range;
use crate::gpu::fit::Counted;
use crate::gpu::mesh::{check_parts, check_words};
use crate::gpu::{Gpu, GpuError, Misfit};
#[cfg(doc)]
use slimbvh_core::{Ray, RayEnds};
use wgpu::BufferSlice;

/// Rays for [`crate::gpu::Tree::trace`]. A slice of rays alone becomes this, too.
///
/// ```no_run
/// use slimbvh::gpu::{Bvh, Frame, GpuError, Query, Rays, wgpu};
/// # fn run(frame: &mut Frame, bvh: &Bvh, buffers: &[wgpu::Buffer; 4]) -> Result<(), GpuError> {
/// # let [rays, ends, hits, shadows] = buffers;
/// // The same rays for two queries.
/// let rays = Rays::new(rays.slice(..)).with_ends(ends.slice(..));
/// bvh.trace(frame, Query::Closest, rays, hits.slice(..))?;
/// bvh.trace(frame, Query::Any, rays, shadows.slice(..))?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Rays<'a> {
    rays: BufferSlice<'a>,
    ends: Option<BufferSlice<'a>>,
    count: Option<BufferSlice<'a>>,
}

impl<'a> Rays<'a> {
    /// Rays of 32 bytes each, in the layout of [`Ray`].
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Frame, GpuError, Query, Rays, wgpu};
    /// # fn run(
    /// #     frame: &mut Frame, bvh: &Bvh, rays: &wgpu::Buffer, hits: &wgpu::Buffer,
    /// # ) -> Result<(), GpuError> {
    /// // The first 1000 rays of the buffer.
    /// let rays = Rays::new(rays.slice(..32 * 1000));
    /// bvh.trace(frame, Query::Closest, rays, hits.slice(..))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn new(rays: BufferSlice<'a>) -> Self {
        Self {
            rays,
            ends: None,
            count: None,
        }
    }

    /// What the ends of each ray lie on: 16 bytes a ray, in the layout of [`RayEnds`]. Such triangles are no hits.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Frame, Gpu, GpuError, Query, Rays, wgpu};
    /// # use slimbvh::{Ray, RayEnds, SurfacePoint, SurfaceRay};
    /// # use wgpu::util::DeviceExt;
    /// # fn run(
    /// #     gpu: &Gpu, frame: &mut Frame, bvh: &Bvh, points: &[SurfacePoint], is_hidden: &wgpu::Buffer,
    /// # ) -> Result<(), GpuError> {
    /// # let usage = wgpu::BufferUsages::STORAGE;
    /// # let buffer = |contents: &[u8]| {
    /// #     let descriptor = wgpu::util::BufferInitDescriptor { label: None, contents, usage };
    /// #     gpu.device().create_buffer_init(&descriptor)
    /// # };
    /// let to_lamp = points.iter().map(|point| Ray::between(point, [0.0, 9.0, 0.0]));
    /// let (rays, ends): (Vec<_>, Vec<_>) = to_lamp.map(|to| (to.ray, to.ends)).unzip();
    /// // Buffers with these bytes.
    /// let rays = buffer(bytemuck::cast_slice(&rays));
    /// let ends = buffer(bytemuck::cast_slice(&ends));
    /// let rays = Rays::new(rays.slice(..)).with_ends(ends.slice(..));
    /// bvh.trace(frame, Query::Any, rays, is_hidden.slice(..))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_ends(mut self, ends: BufferSlice<'a>) -> Self {
        self.ends = Some(ends);
        self
    }

    /// How many of the rays there are: one `u32`, as the GPU finds it there when the trace runs. A larger number than that of all rays
    /// counts as that; answers of rays beyond the number stay as they are.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Frame, GpuError, Query, Rays, wgpu};
    /// # fn run(
    /// #     frame: &mut Frame, bvh: &Bvh, list: &wgpu::Buffer, count: &wgpu::Buffer, hits: &wgpu::Buffer,
    /// # ) -> Result<(), GpuError> {
    /// // An earlier pass has listed the rays that go on, and counted them.
    /// let rays = Rays::new(list.slice(..)).counted_by(count.slice(..4));
    /// bvh.trace(frame, Query::Closest, rays, hits.slice(..))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn counted_by(mut self, count: BufferSlice<'a>) -> Self {
        self.count = Some(count);
        self
    }

    /// Where all of it is.
    ///
    /// # Errors
    /// For what cannot be bound, and for ends that are not those of all rays.
    pub(super) fn ranges(&self, gpu: &Gpu) -> Result<RayRanges, GpuError> {
        let rays = Range::of_slice(self.rays);
        check_parts(gpu, "the buffer of rays", &rays, RAY_BYTES)?;
        let ray_count = rays.size / RAY_BYTES;
        let ends = self.ends.map(Range::of_slice);
        if let Some(ends) = &ends {
            const NAME: &str = "the buffer of ends";
            check_parts(gpu, NAME, ends, ENDS_BYTES)?;
            if ends.size < ray_count * ENDS_BYTES {
                let fault = Misfit::TooFewEnds {
                    bytes: ends.size,
                    ray_count,
                };
                return Err(fault.of(NAME));
            }
        }
        let count = match self.count {
            Some(slice) => {
                const NAME: &str = "the buffer of the number of rays";
                let range = Range::of_slice(slice);
                if range.size != 4 {
                    return Err(Misfit::NotOneWord { bytes: range.size }.of(NAME));
                }
                Some(check_words(gpu, NAME, &range, 4)?)
            }
            None => None,
        };
        Ok(RayRanges {
            rays,
            count: ray_count,
            ends,
            counter: count,
        })
    }
}

impl<'a> From<BufferSlice<'a>> for Rays<'a> {
    fn from(rays: BufferSlice<'a>) -> Self {
        Self::new(rays)
    }
}

/// Where rays are.
pub struct RayRanges {
    pub rays: Range,
    /// Rays that there is room for.
    pub count: u64,
    pub ends: Option<Range>,
    /// Words that hold the number of rays, and its byte among them.
    counter: Option<(Range, u64)>,
}

impl RayRanges {
    /// Where the number of rays is of the dispatch that begins at this ray; `None` where all rays count.
    pub fn counted(&self, first: u32) -> Option<Counted<'_>> {
        let (words, byte) = self.counter.as_ref()?;
        Some(Counted {
            words,
            word: (byte / 4) as u32,
            first,
        })
    }
}
