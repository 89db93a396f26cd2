//! Stage `sort`: one pass of a stable LSD radix sort, in phases over one workgroup (Merrill and Grimshaw 2011).
//!
//! A workgroup owns a tile of items, each of its lanes a run of them. Phase 1: every lane counts the digits of its run
//! ([`count_digit`]). Phase 2: for each digit the lanes' counts are scanned, and the tile's totals are stored digit by
//! digit, tile by tile, and scanned over all tiles ([`crate::scan`]). Phase 3: every lane walks its run again in order
//! and stores each item where [`place`] says. Lanes, tiles and digits in order make the sort stable.
//!
//! A GPU runs many lanes and small digits, a CPU one lane and large ones: the permutation is the same, as the stable
//! order of equal keys is unique.

/// How often each digit occurs in the run of each lane; after the scan, where each lane's next item with it goes.
pub type DigitCounts<const LANES: usize, const DIGITS: usize> = [[u32; LANES]; DIGITS];

/// The digit of a key at a bit position. DIGITS must be a power of two.
#[inline(always)]
#[must_use]
pub const fn digit<const DIGITS: usize>(key: u32, shift: u32) -> u32 {
    (key >> shift) & (DIGITS as u32 - 1)
}

/// Phase 1, for each item of the lane's run: counts its digit.
#[inline(always)]
pub const fn count_digit<const LANES: usize, const DIGITS: usize>(
    digit: u32,
    lane: u32,
    counts: &mut DigitCounts<LANES, DIGITS>,
) {
    counts[digit as usize % DIGITS][lane as usize % LANES] += 1;
}

/// Phase 3, for each item of the lane's run in order. Returns where the item goes.
#[inline(always)]
#[must_use]
pub const fn place<const LANES: usize, const DIGITS: usize>(
    digit: u32,
    lane: u32,
    offsets: &mut DigitCounts<LANES, DIGITS>,
) -> u32 {
    let next = &mut offsets[digit as usize % DIGITS][lane as usize % LANES];
    let destination = *next;
    *next = destination.wrapping_add(1);
    destination
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::{vec, vec::Vec};

    /// One pass over a single tile.
    fn pass<const LANES: usize, const DIGITS: usize>(
        items: &[(u32, u32)],
        shift: u32,
    ) -> Vec<(u32, u32)> {
        let mut counts = [[0; LANES]; DIGITS];
        let run = items.len().div_ceil(LANES).max(1);
        for (lane, items) in items.chunks(run).enumerate() {
            for &(key, _) in items {
                count_digit(digit::<DIGITS>(key, shift), lane as u32, &mut counts);
            }
        }
        let mut sum = 0;
        for count in counts.iter_mut().flatten() {
            let next = sum + *count;
            *count = sum;
            sum = next;
        }
        let mut sorted = vec![(0, 0); items.len()];
        for (lane, items) in items.chunks(run).enumerate() {
            for &item in items {
                let to = place(digit::<DIGITS>(item.0, shift), lane as u32, &mut counts);
                sorted[to as usize] = item;
            }
        }
        sorted
    }

    proptest! {
        #[test]
        fn stable_for_any_lanes_and_digits(keys in proptest::collection::vec(0u32..1 << 12, 0..500)) {
            let items: Vec<(u32, u32)> = keys.iter().copied().zip(0..).collect();
            let mut expected = items.clone();
            expected.sort_by_key(|item| item.0);
            let wide = (0..12).step_by(6).fold(items.clone(), |items, shift| pass::<1, 64>(&items, shift));
            let narrow = (0..12).step_by(4).fold(items, |items, shift| pass::<16, 16>(&items, shift));
            prop_assert_eq!(&wide, &expected);
            prop_assert_eq!(&narrow, &expected);
        }
    }
}
