//! Stage `scan`: exclusive prefix sums.

use super::buffer::{Range, Slot};
use super::mesh::check_storage;
use super::program::{Recorder, groups};
use super::{Frame, Gpu, GpuError, Kernel};
use slimbvh_core::launch::scan_block_count;

/// Bytes of `[sum, x, y, z]`.
pub const TOTAL_BYTES: u64 = 16;

/// Replaces values by their exclusive prefix sums. Keeps its buffers.
#[derive(Debug)]
pub struct Scan {
    blocks: Slot,
}

impl Default for Scan {
    fn default() -> Self {
        Self::new()
    }
}

impl Scan {
    /// A scan with empty buffers.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            blocks: Slot::storage("slimbvh scan blocks"),
        }
    }

    /// Records that the `u32` values of a buffer are replaced by their exclusive prefix sums modulo 2^32. `total` receives
    /// `[sum, x, y, z]`, with the dispatch of workgroups of 64 threads, `sum` threads in all.
    ///
    /// # Errors
    /// For ranges that cannot be bound.
    pub fn encode(
        &mut self,
        frame: &mut Frame,
        values: wgpu::BufferSlice,
        total: wgpu::BufferSlice,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let (values, total) = (Range::of_slice(values), Range::of_slice(total));
        check_storage(gpu, "the values", &values, 4)?;
        check_storage(gpu, "the total", &total, TOTAL_BYTES)?;
        gpu.checked(|| {
            let mut recorder = Recorder::default();
            recorder.stage("scan");
            self.record(gpu, &mut recorder, &values, &total);
            recorder.finish(gpu)?.encode(frame);
            Ok(())
        })
    }

    pub(super) fn record(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        values: &Range,
        total: &Range,
    ) {
        let block_count = scan_block_count((values.size / 4) as u32);
        let blocks = &self.blocks.range(gpu, 4 * u64::from(block_count));
        let each_block = || groups(block_count);
        if block_count > 1 {
            recorder.dispatch(Kernel::scan_sums, &[], &[values], &[blocks], each_block());
        }
        recorder.read(values);
        let to = &[values, total];
        recorder.dispatch(Kernel::scan_apply, &[], &[blocks], to, each_block());
    }

    pub(super) fn bytes(&self) -> u64 {
        self.blocks.bytes()
    }
}
