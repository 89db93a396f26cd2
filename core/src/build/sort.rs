//! Stage `sort`: one pass of a stable LSD radix sort (Satish, Harris and Garland 2009; Merrill and Grimshaw 2011).
//!
//! Items are cut into tiles. Phase 1: each tile counts its digits. The totals are stored digit by digit, tile by tile
//! ([`total_place`]). Phase 2: their exclusive prefix sums in that order ([`crate::build::scan`]) are where each tile's
//! first item with each digit goes; on a GPU a workgroup scans the totals of one digit, and phase 3 adds the sums of the digits
//! before it. Phase 3: each tile moves its items in order. Tiles and digits in order make the sort stable.
//!
//! On a CPU one task walks a tile item by item. On a GPU a workgroup sorts its tile by the digit first ([`tile`]), so that
//! lanes side by side store items side by side. The permutation is the same, as the stable order of equal keys is unique.

pub mod tile;

/// The digit of a key at a bit position. DIGITS must be a power of two.
#[inline(always)]
#[must_use]
pub const fn digit<const DIGITS: usize>(key: u32, shift: u32) -> u32 {
    (key >> shift) & (DIGITS as u32 - 1)
}

/// Returns where among all totals that of a tile's digit is stored: digit by digit, tile by tile.
#[inline(always)]
#[must_use]
pub const fn total_place(digit: u32, tile: u32, tile_count: u32) -> u32 {
    digit.wrapping_mul(tile_count).wrapping_add(tile)
}

/// Equal digits in succession, which a lane adds to a counter at once: where keys are nearly sorted, lanes seldom contend
/// for one counter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DigitRun {
    /// The digit.
    pub digit: u32,
    /// How often it occurred.
    pub count: u32,
}

impl DigitRun {
    /// A run of no digits.
    pub const EMPTY: Self = Self { digit: 0, count: 0 };

    /// The run with one more digit.
    #[inline(always)]
    #[must_use]
    pub const fn with(self, digit: u32) -> Self {
        let count = if self.ends_at(digit) {
            1
        } else {
            self.count + 1
        };
        Self { digit, count }
    }

    /// Whether this digit begins another run.
    #[inline(always)]
    #[must_use]
    pub const fn ends_at(self, digit: u32) -> bool {
        self.digit != digit
    }
}

#[cfg(test)]
mod tests;
