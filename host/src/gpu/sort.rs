//! Stage `sort`: a stable radix sort.

use super::buffer::{Range, Slot};
use super::mesh::check_storage;
use super::program::{Recorder, Uniform, groups};
use super::{Frame, Gpu, GpuError, Kernel};
use slimbvh_core::launch::{BLOCK, DIGITS};

/// The form of the items to sort.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keys {
    /// Items `[key, value]`, by all 32 bits of the key.
    OneWord,
    /// Items `[high word, low word, value]`, by all 64 bits of the key.
    TwoWords,
}

impl Keys {
    /// Bytes of an item.
    #[must_use]
    pub const fn item_bytes(self) -> u64 {
        match self {
            Self::OneWord => 8,
            Self::TwoWords => 12,
        }
    }

    const fn bits(self) -> u32 {
        match self {
            Self::OneWord => 32,
            Self::TwoWords => 64,
        }
    }
}

/// Sorts items by their keys. Keeps its buffers.
#[derive(Debug)]
pub struct Sort {
    other: Slot,
    totals: Slot,
    sums: Slot,
}

impl Default for Sort {
    fn default() -> Self {
        Self::new()
    }
}

impl Sort {
    /// A sort with empty buffers.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            other: Slot::storage("slimbvh sort items"),
            totals: Slot::storage("slimbvh sort totals"),
            sums: Slot::storage("slimbvh sort sums"),
        }
    }

    /// Records a stable sort of a buffer's items by their keys.
    ///
    /// # Errors
    /// For a range that cannot be bound.
    pub fn encode(
        &mut self,
        frame: &mut Frame,
        keys: Keys,
        items: wgpu::BufferSlice,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let items = Range::of_slice(items);
        check_storage(gpu, "the items", &items, keys.item_bytes())?;
        gpu.checked(|| {
            let mut recorder = Recorder::default();
            recorder.stage("sort");
            self.record(gpu, &mut recorder, keys, &items);
            recorder.finish(gpu)?.encode(frame);
            Ok(())
        })
    }

    /// Bytes of each digit's sum.
    const SUM_BYTES: u64 = 4 * DIGITS as u64;

    /// Bytes of the digits' totals.
    const fn total_bytes(item_count: u32) -> u64 {
        4 * DIGITS as u64 * item_count.div_ceil(BLOCK) as u64
    }

    /// Count, scan, scatter (Satish, Harris, Garland 2009), from the last digit to the first.
    pub(super) fn record(&mut self, gpu: &Gpu, recorder: &mut Recorder, keys: Keys, items: &Range) {
        let scan = Kernel::sort_scan;
        let (count, scatter) = match keys {
            Keys::OneWord => (Kernel::sort_count_30, Kernel::sort_scatter_30),
            Keys::TwoWords => (Kernel::sort_count_63, Kernel::sort_scatter_63),
        };
        let item_count = (items.size / keys.item_bytes()) as u32;
        let other = self.other.range(gpu, items.size);
        let totals = &self.totals.range(gpu, Self::total_bytes(item_count));
        let sums = &self.sums.range(gpu, Self::SUM_BYTES);
        let tiles = || groups(item_count.div_ceil(BLOCK));
        let digit_bits = DIGITS.ilog2();

        // After an even number of passes the items are back in their buffer.
        const { assert!((32 / DIGITS.ilog2()).is_multiple_of(2)) };
        let (mut from, mut to) = (items, &other);
        for pass in 0..keys.bits() / digit_bits {
            let shift = Uniform::Params([pass * digit_bits, 0, 0, 0]);
            recorder.dispatch(count, &[shift], &[from], &[totals], tiles());
            recorder.read(totals);
            recorder.dispatch(scan, &[], &[], &[totals, sums], groups(DIGITS as u32));
            let reads = &[from, totals, sums];
            recorder.dispatch(scatter, &[shift], reads, &[to], tiles());
            (from, to) = (to, from);
        }
    }

    pub(super) fn bytes(&self) -> u64 {
        self.other.bytes() + self.totals.bytes() + self.sums.bytes()
    }
}
