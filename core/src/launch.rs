//! How GPU threads are counted: the constants and index functions that entry points and their callers share.

/// Threads in a workgroup.
pub const LANES: usize = 64;

/// Digits that a pass of the sort tells apart: 8 bits.
pub const DIGITS: usize = 256;

/// Items that a lane takes in `bounds`, `sort` and `scan`.
pub const RUN: u32 = 16;

/// Items that a workgroup takes in `bounds`, `sort` and `scan`: a block.
pub const BLOCK: u32 = LANES as u32 * RUN;

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
        fn two_words_add_like_one_of_64_bits(old: u32, amount: u32) {
            let sum = u64::from(old) + u64::from(amount);
            let words = [old.wrapping_add(amount), u32::from(carries(old, amount))];
            prop_assert_eq!(words, [sum as u32, (sum >> 32) as u32]);
        }
    }
}
