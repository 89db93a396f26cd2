//! A tile of the sort in a workgroup's memory: its items are sorted by an 8-bit digit in two rounds of 4 bits.
//!
//! A round takes the words of [`packed`] from one array to another. Each lane owns a run of [`RUN`] words in order. It
//! counts their 4-bit digits ([`take`]), adds its counters up ([`lane_sum`]), the lanes' sums are scanned
//! ([`crate::build::scan::doubling_step`]), and each lane replaces its counters by their prefix sums ([`lane_scan`]). Then
//! it takes each word's rank from its counter, in order.
//!
//! There is a counter for each of the 16 digits and each lane. Two share a word:
//!
//! ```text
//! word 0          …  LANES − 1    LANES    …           8 LANES − 1
//!  low   digit 0, lane 0 … LANES − 1 | digit 1, … |  …  digit 7, lane LANES − 1
//!  high  digit 8, lane 0 … LANES − 1 | digit 9, … |  …  digit 15, lane LANES − 1
//! ```
//!
//! The scan adds both halves at once, and begins the high ones at the sum of all low ones. A sum of less than 2^16 words
//! never carries into the other half.

use crate::launch::{DIGITS, RUN};

/// Bits of a tile's digit, in two rounds of [`ROUND_BITS`].
pub const DIGIT_BITS: u32 = DIGITS.ilog2();

/// Bits of a round's digit.
pub const ROUND_BITS: u32 = DIGIT_BITS / 2;
const _: () = assert!(DIGITS == 1 << (2 * ROUND_BITS));

/// Words of counters for a lane.
pub const COUNTERS: u32 = 1 << (ROUND_BITS - 1);

/// Where word i of an array in workgroup memory lies. Words i, i + 8, i + 16 … and i, i + 16, i + 32 … fall into different
/// banks, as do words side by side, where there are 32 banks. A bijection of each range below a power of two.
#[inline(always)]
#[must_use]
pub const fn swizzle(i: u32) -> u32 {
    i ^ (i >> 5)
}

/// An item of a tile: its digit, below its place in the tile.
#[inline(always)]
#[must_use]
pub const fn packed(digit: u32, place: u32) -> u32 {
    digit | (place << DIGIT_BITS)
}

/// The digit of a [`packed`] item.
#[inline(always)]
#[must_use]
pub const fn packed_digit(item: u32) -> u32 {
    item & ((1 << DIGIT_BITS) - 1)
}

/// The place in the tile of a [`packed`] item.
#[inline(always)]
#[must_use]
pub const fn packed_place(item: u32) -> u32 {
    item >> DIGIT_BITS
}

/// The digit of a round, from the item's bit `shift` on.
#[inline(always)]
#[must_use]
pub const fn round_digit(item: u32, shift: u32) -> u32 {
    (item >> shift) & ((1 << ROUND_BITS) - 1)
}

/// The word at `step` of a lane's run, in an array in workgroup memory. The run has [`RUN`] words.
#[inline(always)]
#[must_use]
pub const fn of_run<const WORDS: usize>(lane: u32, step: u32, words: &[u32; WORDS]) -> u32 {
    words[swizzle(lane * RUN + step) as usize % WORDS]
}

/// Stores word i of an array in workgroup memory.
#[inline(always)]
pub const fn put<const WORDS: usize>(i: u32, word: u32, words: &mut [u32; WORDS]) {
    words[swizzle(i) as usize % WORDS] = word;
}

/// Word i of an array in workgroup memory.
#[inline(always)]
#[must_use]
pub const fn word<const WORDS: usize>(i: u32, words: &[u32; WORDS]) -> u32 {
    words[swizzle(i) as usize % WORDS]
}

/// Zeroes counters: each lane those that it scans.
#[inline(always)]
pub const fn clear<const WORDS: usize>(lane: u32, counters: &mut [u32; WORDS]) {
    let mut step = 0;
    while step < COUNTERS {
        put(lane * COUNTERS + step, 0, counters);
        step += 1;
    }
}

/// Returns a lane's counter of a round's digit, and adds 1. After the scan that is the rank of the lane's next item.
#[inline(always)]
pub const fn take<const WORDS: usize>(digit: u32, lane: u32, counters: &mut [u32; WORDS]) -> u32 {
    let lanes = WORDS as u32 / COUNTERS;
    let word = &mut counters[swizzle((digit % COUNTERS) * lanes + lane) as usize % WORDS];
    let shift = digit / COUNTERS * 16;
    let taken = (*word >> shift) & 0xffff;
    *word = word.wrapping_add(1 << shift);
    taken
}

/// The sum of the counters that a lane scans: both halves in one word.
#[inline(always)]
#[must_use]
pub const fn lane_sum<const WORDS: usize>(lane: u32, counters: &[u32; WORDS]) -> u32 {
    let mut sum = 0u32;
    let mut step = 0;
    while step < COUNTERS {
        sum = sum.wrapping_add(word(lane * COUNTERS + step, counters));
        step += 1;
    }
    sum
}

/// Replaces the counters that a lane scans by their prefix sums. `before` is the sum of the lanes before it, `all` that of
/// all lanes.
#[inline(always)]
pub const fn lane_scan<const WORDS: usize>(
    lane: u32,
    before: u32,
    all: u32,
    counters: &mut [u32; WORDS],
) {
    // High halves begin where the low ones end.
    let mut sum = before.wrapping_add(all << 16);
    let mut step = 0;
    while step < COUNTERS {
        let i = lane * COUNTERS + step;
        let next = sum.wrapping_add(word(i, counters));
        put(i, sum, counters);
        sum = next;
        step += 1;
    }
}

/// Whether item i of a sorted tile is the first with its digit.
#[inline(always)]
#[must_use]
pub const fn is_first<const WORDS: usize>(i: u32, sorted: &[u32; WORDS]) -> bool {
    i == 0 || packed_digit(word(i, sorted)) != packed_digit(word(i.wrapping_sub(1), sorted))
}
