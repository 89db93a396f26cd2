//! Stage `sort`: one pass of a stable LSD radix sort, in phases over one workgroup (Merrill and Grimshaw 2011).
//!
//! A workgroup owns a tile of items, each of its lanes a run of them. Phase 1: every lane counts the digits of its run
//! ([`count_digit`]). Phase 2: the tile's totals ([`digit_total`]) are stored digit by digit, tile by tile
//! ([`total_place`]), and scanned over all tiles ([`crate::build::scan`]); for each digit the lanes' counts are scanned too, and
//! each lane begins at the sum of both ([`lane_begin`]). Phase 3: every lane walks its run again in order and stores
//! each item where [`place`] says. Lanes, tiles and digits in order make the sort stable.
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

/// Phase 2, for each digit. Returns how many items of the tile have it: the sum of the lanes' counts.
#[inline(always)]
#[must_use]
#[expect(
    clippy::needless_range_loop,
    reason = "iterators over workgroup memory do not compile to SPIR-V"
)]
pub fn digit_total<const LANES: usize, const DIGITS: usize>(
    digit: u32,
    counts: &DigitCounts<LANES, DIGITS>,
) -> u32 {
    let mut sum = 0;
    for lane in 0..LANES {
        sum += counts[digit as usize % DIGITS][lane];
    }
    sum
}

/// Phase 2. Returns where among all totals that of a tile's digit is stored: digit by digit, tile by tile.
#[inline(always)]
#[must_use]
pub const fn total_place(digit: u32, tile: u32, tile_count: u32) -> u32 {
    digit * tile_count + tile
}

/// Phase 2, for each digit. Returns where the lane's first item with it goes. Those of the tile begin at `tile_begin`, the
/// scanned total; the lanes up to this one have `through` of them, this one `own`.
#[inline(always)]
#[must_use]
pub const fn lane_begin(tile_begin: u32, through: u32, own: u32) -> u32 {
    tile_begin.wrapping_add(through.wrapping_sub(own))
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
    use crate::build::scan::run_scan;
    use proptest::prelude::*;
    use std::{vec, vec::Vec};

    /// One pass, each lane with a run of this many items.
    fn pass<const LANES: usize, const DIGITS: usize>(
        items: &[(u32, u32)],
        shift: u32,
        run: usize,
    ) -> Vec<(u32, u32)> {
        let tiles: Vec<_> = items.chunks(LANES * run).collect();
        let item_digit = |item: &(u32, u32)| digit::<DIGITS>(item.0, shift);

        let mut counts = vec![[[0; LANES]; DIGITS]; tiles.len()];
        for (items, counts) in tiles.iter().zip(&mut counts) {
            for (item, i) in items.iter().zip(0..) {
                count_digit(item_digit(item), i / run as u32, counts);
            }
        }

        let tile_count = tiles.len() as u32;
        let mut totals = vec![0; DIGITS * tiles.len()];
        for digit in 0..DIGITS as u32 {
            for (counts, tile) in counts.iter().zip(0..) {
                totals[total_place(digit, tile, tile_count) as usize] = digit_total(digit, counts);
            }
        }
        let total_count = totals.len() as u32;
        run_scan(&mut totals, 0, total_count, 0);
        for (counts, tile) in counts.iter_mut().zip(0..) {
            for (lanes, digit) in counts.iter_mut().zip(0..) {
                let tile_begin = totals[total_place(digit, tile, tile_count) as usize];
                let mut through = 0;
                for own in lanes {
                    through += *own;
                    *own = lane_begin(tile_begin, through, *own);
                }
            }
        }

        let mut sorted = vec![(0, 0); items.len()];
        for (items, offsets) in tiles.iter().zip(&mut counts) {
            for (item, i) in items.iter().zip(0..) {
                let to = place(item_digit(item), i / run as u32, offsets);
                sorted[to as usize] = *item;
            }
        }
        sorted
    }

    #[test]
    fn totals_are_summed_over_lanes_and_stored_digit_by_digit() {
        let counts: DigitCounts<3, 2> = [[1, 2, 4], [8, 0, 16]];
        assert_eq!([0, 1].map(|digit| digit_total(digit, &counts)), [7, 24]);

        let places: Vec<u32> = (0..3)
            .flat_map(|digit| (0..5).map(move |tile| total_place(digit, tile, 5)))
            .collect();
        assert_eq!(places, (0..15).collect::<Vec<_>>());
    }

    #[test]
    fn a_lane_begins_behind_the_lanes_before_it() {
        // Lanes of 3, 0 and 2 items in a tile that begins at 10.
        let lanes = [(3, 3), (3, 0), (5, 2)];
        assert_eq!(
            lanes.map(|(through, own)| lane_begin(10, through, own)),
            [10, 13, 13]
        );
    }

    proptest! {
        #[test]
        fn stable_for_any_lanes_digits_and_tiles(keys in proptest::collection::vec(0u32..1 << 12, 0..500), run in 1usize..40) {
            let items: Vec<(u32, u32)> = keys.iter().copied().zip(0..).collect();
            let mut expected = items.clone();
            expected.sort_by_key(|item| item.0);
            let wide = (0..12).step_by(6).fold(items.clone(), |items, shift| pass::<1, 64>(&items, shift, run));
            let narrow = (0..12).step_by(4).fold(items, |items, shift| pass::<16, 16>(&items, shift, run));
            prop_assert_eq!(&wide, &expected);
            prop_assert_eq!(&narrow, &expected);
        }
    }
}
