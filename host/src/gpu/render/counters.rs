//! Counts of rays, which the GPU keeps during a picture.

use crate::gpu::buffer::Download;
use crate::gpu::{Gpu, GpuError};
use crate::picture::RenderReport;

/// Offsets of the counts of each kind of rays: rays, hits, nodes, two words each.
pub const PRIMARY: u64 = 0;
pub const SHADOW: u64 = 256;
pub const MIRROR: u64 = 512;
pub const SLOT_BYTES: u64 = 24;
pub const BYTES: u64 = 768;

/// Counts being copied from the GPU.
#[derive(Debug)]
#[must_use]
pub struct Counters(pub(super) Download);

impl Counters {
    /// Waits for the counts, and reads them.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(self, gpu: &Gpu) -> Result<RenderReport, GpuError> {
        gpu.block_on(self.read_async(gpu))
    }

    /// [`Self::read`], without blocking.
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_async(self, gpu: &Gpu) -> Result<RenderReport, GpuError> {
        let words: Vec<u32> = self.0.read_async(gpu).await?;
        let pair = |slot: u64, i: usize| {
            let word = |i: usize| u64::from(words.get(i).copied().unwrap_or(0));
            let first = slot as usize / 4 + 2 * i;
            word(first) | word(first + 1) << 32
        };
        Ok(RenderReport {
            primary_ray_count: pair(PRIMARY, 0),
            primary_hit_count: pair(PRIMARY, 1),
            node_visit_count: pair(PRIMARY, 2),
            shadow_ray_count: pair(SHADOW, 0),
            mirror_ray_count: pair(MIRROR, 0),
            ..RenderReport::default()
        })
    }
}
