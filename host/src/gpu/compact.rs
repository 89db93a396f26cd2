//! Stage `compact`: a list of indices from bits.

use super::buffer::{Range, Slot};
use super::mesh::check_storage;
use super::program::{Recorder, threads};
use super::scan::{Scan, TOTAL_BYTES};
use super::{Frame, Gpu, GpuError, Kernel, Misfit};

/// Item indices are `u32`, with one bit an item.
const MOST_BIT_BYTES: u64 = 1 << 29;

/// Lists the items whose bit is set. Keeps its buffers.
#[derive(Debug)]
pub struct Compact {
    before: Slot,
    scan: Scan,
}

impl Default for Compact {
    fn default() -> Self {
        Self::new()
    }
}

impl Compact {
    /// A compaction with empty buffers.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            before: Slot::storage("slimbvh compact counts"),
            scan: Scan::new(),
        }
    }

    /// Records that the indices of all items whose bit is set are stored in order, as `u32`. Item i is bit i % 32 of word i
    /// / 32. `total` receives `[count, x, y, z]`, with the dispatch of workgroups of 64 threads, one thread an index.
    /// Indices beyond the room in `indices` are dropped.
    ///
    /// # Errors
    /// For ranges that cannot be bound.
    pub fn encode(
        &mut self,
        frame: &mut Frame,
        bits: wgpu::BufferSlice,
        indices: wgpu::BufferSlice,
        total: wgpu::BufferSlice,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let [bits, indices, total] = [bits, indices, total].map(Range::of_slice);
        check_storage(gpu, "the bits", &bits, 4)?;
        if bits.size >= MOST_BIT_BYTES {
            let fault = Misfit::TooManyBits {
                bytes: bits.size,
                limit_bytes: MOST_BIT_BYTES,
            };
            return Err(fault.of("the bits"));
        }
        check_storage(gpu, "the indices", &indices, 4)?;
        check_storage(gpu, "the total", &total, TOTAL_BYTES)?;
        gpu.checked(|| {
            let mut recorder = Recorder::default();
            recorder.stage("compact");
            self.record(gpu, &mut recorder, [&bits, &indices, &total]);
            recorder.finish(gpu)?.encode(frame);
            Ok(())
        })
    }

    fn record(&mut self, gpu: &Gpu, recorder: &mut Recorder, [bits, indices, total]: [&Range; 3]) {
        let word_count = (bits.size / 4) as u32;
        let before = &self.before.range(gpu, bits.size);
        let counts = Kernel::compact_counts;
        recorder.dispatch(counts, &[], &[bits], &[before], threads(word_count));
        self.scan.record(gpu, recorder, before, total);
        let items = threads(32 * word_count);
        recorder.dispatch(Kernel::compact, &[], &[bits, before], &[indices], items);
    }
}
