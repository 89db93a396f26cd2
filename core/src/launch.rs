//! How GPU threads are counted: the constants and index functions that entry points and their callers share.

/// Threads in a workgroup.
pub const LANES: usize = 64;

/// Digits that a pass of the sort tells apart: 8 bits.
pub const DIGITS: usize = 256;

/// Items that a lane takes in `bounds` and `sort`.
pub const RUN: u32 = 16;

/// Items that a workgroup takes in `bounds` and `sort`: a block.
pub const BLOCK: u32 = LANES as u32 * RUN;

/// Values that a lane takes in a `scan`, at least. A build scans few values: short runs spread them over more workgroups.
pub const SCAN_RUN: u32 = 4;

/// Blocks of a `scan`, at most. The workgroup of a block reads the sums of all blocks before its own.
pub const MOST_SCAN_BLOCKS: u32 = 1 << 12;

/// Hits that `trace_nearest` finds.
pub const NEAREST_COUNT: usize = 8;

/// Workgroups along x in a dispatch; what is more goes on in the next row. Each axis takes at most 65,535.
pub const GROUPS_PER_ROW: u32 = 1 << 15;

/// The dispatch of this many workgroups, and of as many more as fill the last row.
#[inline(always)]
#[must_use]
pub const fn dispatch(group_count: u32) -> [u32; 3] {
    let row = if group_count < GROUPS_PER_ROW {
        group_count
    } else {
        GROUPS_PER_ROW
    };
    [row, group_count.div_ceil(GROUPS_PER_ROW), 1]
}

/// A number of items, and the [`dispatch`] of a thread for each: the form of an indirect dispatch.
#[inline(always)]
#[must_use]
pub const fn dispatch_each(item_count: u32) -> [u32; 4] {
    let [x, y, z] = dispatch(item_count.div_ceil(LANES as u32));
    [item_count, x, y, z]
}

/// How many of `count` items are in the part that begins at the item `first` and holds at most `most`.
#[inline(always)]
#[must_use]
pub const fn count_in_part(count: u32, first: u32, most: u32) -> u32 {
    if first >= count {
        0
    } else if count - first < most {
        count - first
    } else {
        most
    }
}

/// From the dispatch of the rays that go through a set to that of those that go through the whole tree, in dispatches: both can be
/// bound as uniforms.
pub const PART_STEP: usize = 16;

/// Values that a lane takes in a `scan` of `value_count`: [`SCAN_RUN`], or more where there would be over [`MOST_SCAN_BLOCKS`].
#[inline(always)]
#[must_use]
pub const fn scan_run(value_count: u32) -> u32 {
    let run = value_count.div_ceil(MOST_SCAN_BLOCKS * LANES as u32);
    if run > SCAN_RUN { run } else { SCAN_RUN }
}

/// Blocks of a `scan` of `value_count` values, a workgroup each. At most [`MOST_SCAN_BLOCKS`].
#[inline(always)]
#[must_use]
pub const fn scan_block_count(value_count: u32) -> u32 {
    value_count.div_ceil(scan_run(value_count) * LANES as u32)
}

/// Where the run of a lane begins in a list, for lanes that each take `run` items: at most `count`. `lane` is numbered over
/// all workgroups.
#[inline(always)]
#[must_use]
pub const fn run_begin(lane: u32, run: u32, count: u32) -> u32 {
    let begin = lane.wrapping_mul(run);
    if begin < count { begin } else { count }
}

/// How long the run is that begins there: at most `run`.
#[inline(always)]
#[must_use]
pub const fn run_length(begin: u32, run: u32, count: u32) -> u32 {
    let rest = count.wrapping_sub(begin);
    if rest < run { rest } else { run }
}

/// Rows of a picture in a buffer begin at multiples of this many texels, so that they can be copied to textures.
const ROW_TEXELS: u32 = 64;

/// Texels from one row of a picture in a buffer to the next.
#[inline(always)]
#[must_use]
pub const fn row_texels(width: u32) -> u32 {
    width.wrapping_add(ROW_TEXELS - 1) / ROW_TEXELS * ROW_TEXELS
}

/// A thread's number among all rows of a [`dispatch`], from its place along x and y.
#[inline(always)]
#[must_use]
pub const fn thread_index(x: u32, y: u32) -> u32 {
    x + y * (GROUPS_PER_ROW * LANES as u32)
}

/// A workgroup's number among all rows of a [`dispatch`], from its place along x and y.
#[inline(always)]
#[must_use]
pub const fn group_index(x: u32, y: u32) -> u32 {
    x + y * GROUPS_PER_ROW
}

/// Whether one is to be added to the high word of a sum of 64 bits, where its low word was `old` and `amount` is added.
#[inline(always)]
#[must_use]
pub const fn carries(old: u32, amount: u32) -> bool {
    old.wrapping_add(amount) < old
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn rows_hold_every_group_once() {
        assert_eq!(dispatch(0), [0, 0, 1]);
        assert_eq!(dispatch(5), [5, 1, 1]);
        assert_eq!(dispatch(GROUPS_PER_ROW), [GROUPS_PER_ROW, 1, 1]);
        assert_eq!(dispatch(GROUPS_PER_ROW + 1), [GROUPS_PER_ROW, 2, 1]);
        assert_eq!(group_index(3, 1), GROUPS_PER_ROW + 3);
        assert_eq!(thread_index(7, 1), GROUPS_PER_ROW * LANES as u32 + 7);
    }

    #[test]
    fn parts_hold_every_item_once() {
        let parts = [0, 64, 128, 192].map(|first| count_in_part(130, first, 64));
        assert_eq!(parts, [64, 64, 2, 0]);
        assert_eq!(dispatch_each(65), [65, 2, 1, 1]);
        assert_eq!(dispatch_each(0), [0, 0, 0, 1]);
    }

    #[test]
    fn runs_of_a_scan_grow_where_its_blocks_would_be_too_many() {
        assert_eq!([0, 1, 1 << 20].map(scan_run), [4; 3]);
        assert_eq!([0, 1, 256, 257].map(scan_block_count), [0, 1, 1, 2]);
        assert_eq!(scan_block_count(1 << 20), 4096);
        assert_eq!(scan_run((1 << 20) + 1), 5);
        assert_eq!(scan_block_count((1 << 20) + 1), 3277);
        assert_eq!(scan_run(1 << 30), 4096);
    }

    #[test]
    fn rows_of_texels_may_be_padded() {
        assert_eq!([1, 64, 65, 1280].map(row_texels), [64, 64, 128, 1280]);
    }

    #[test]
    fn a_full_word_carries() {
        assert!(!carries(u32::MAX, 0));
        assert!(!carries(u32::MAX - 5, 5));
        assert!(carries(u32::MAX - 5, 6));
        assert!(carries(u32::MAX, u32::MAX));
    }

    proptest! {
        #[test]
        fn the_runs_of_a_scan_hold_every_value_once(count in prop_oneof![0u32..5000, (1u32 << 20)..(1 << 30)]) {
            let run = scan_run(count);
            let lanes = scan_block_count(count) * LANES as u32;
            prop_assert!(lanes <= MOST_SCAN_BLOCKS * LANES as u32);
            let mut end = 0;
            for lane in 0..lanes {
                let begin = run_begin(lane, run, count);
                prop_assert_eq!(begin, end);
                end += run_length(begin, run, count);
            }
            prop_assert_eq!(end, count);
            prop_assert_eq!(run_length(run_begin(lanes, run, count), run, count), 0);
        }

        #[test]
        fn two_words_add_like_one_of_64_bits(old: u32, amount: u32) {
            let sum = u64::from(old) + u64::from(amount);
            let words = [old.wrapping_add(amount), u32::from(carries(old, amount))];
            prop_assert_eq!(words, [sum as u32, (sum >> 32) as u32]);
        }
    }
}
