//! Stage `sort`: a pass over one digit of 8 bits, in three dispatches: each tile counts its digits; each digit's totals are
//! scanned over the tiles; each tile scans the digits' sums, is sorted in workgroup memory and stored. A tile is a block.

use crate::group::{atomic_add, barrier};
use crate::group_index;
use crate::scan::{scan_lanes, scan_part};
use glam::{UVec3, UVec4};
use slimbvh_core::launch::{BLOCK, DIGITS, LANES, RUN};
use slimbvh_core::scan::run_sum;
use slimbvh_core::sort::tile::{
    COUNTERS, ROUND_BITS, clear, is_first, lane_scan, lane_sum, of_run, packed, packed_digit,
    packed_place, put, round_digit, take, word,
};
use slimbvh_core::sort::{DigitRun, digit, total_place};
use spirv_std_macros::spirv;

/// Digits that a lane of a workgroup takes.
const LANE_DIGITS: u32 = (DIGITS / LANES) as u32;

/// The items of a tile, by [`put`] and [`word`].
type Tile = [u32; BLOCK as usize];

/// The counters of a round over a tile.
type Counters = [u32; LANES * COUNTERS as usize];

/// A key of one or two words, and what it belongs to.
trait Item: Copy {
    /// The digit at a bit of the key.
    fn digit(self, shift: u32) -> u32;
}

impl Item for [u32; 2] {
    #[inline(always)]
    fn digit(self, shift: u32) -> u32 {
        digit::<DIGITS>(self[0], shift)
    }
}

impl Item for [u32; 3] {
    #[inline(always)]
    fn digit(self, shift: u32) -> u32 {
        let word = if shift < 32 { self[1] } else { self[0] };
        digit::<DIGITS>(word, shift & 31)
    }
}

/// One workgroup per tile. Reads `[key, value]` items; `params.x` is the digit's first bit. Stores how often each digit
/// occurs, digit by digit, tile by tile.
#[spirv(compute(threads(64)))]
pub fn sort_count_30(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] totals: &mut [u32],
    #[spirv(workgroup)] counts: &mut [u32; DIGITS],
) {
    count(group, lane, params.x, items, totals, counts);
}

/// As [`sort_count_30`], of `[high word, low word, value]` items.
#[spirv(compute(threads(64)))]
pub fn sort_count_63(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] totals: &mut [u32],
    #[spirv(workgroup)] counts: &mut [u32; DIGITS],
) {
    count(group, lane, params.x, items, totals, counts);
}

/// One workgroup per digit. Reads the digit's totals of all tiles. Stores their prefix sums in their place, and their sum.
#[spirv(compute(threads(64)))]
pub fn sort_scan(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] totals: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] sums: &mut [u32],
    #[spirv(workgroup)] lanes: &mut [u32; LANES],
) {
    let tile_count = totals.len() as u32 / DIGITS as u32;
    let digit = group_index(group);
    let first = total_place(digit, 0, tile_count);
    let sum = scan_part(lane, first, tile_count, totals, lanes);
    let to = digit as usize;
    if lane == 0 && to < sums.len() {
        sums[to] = sum;
    }
}

/// One workgroup per tile. Reads `[key, value]` items and what [`sort_scan`] stored of their digits; `params.x` is the
/// digit's first bit. Stores the items in the digit's order.
#[spirv(compute(threads(64)))]
pub fn sort_scatter_30(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sums: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] sorted: &mut [[u32; 2]],
    #[spirv(workgroup)] tile: &mut Tile,
    #[spirv(workgroup)] other: &mut Tile,
    #[spirv(workgroup)] counters: &mut Counters,
    #[spirv(workgroup)] begins: &mut [u32; DIGITS],
    #[spirv(workgroup)] lanes: &mut [u32; LANES],
) {
    load_begins(group, lane, before, sums, begins, lanes);
    load(group, lane, params.x, items, tile);
    round(lane, 0, tile, other, counters, lanes);
    round(lane, ROUND_BITS, other, tile, counters, lanes);
    store(group, lane, items, tile, begins, sorted);
}

/// As [`sort_scatter_30`], of `[high word, low word, value]` items.
#[spirv(compute(threads(64)))]
pub fn sort_scatter_63(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sums: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] sorted: &mut [[u32; 3]],
    #[spirv(workgroup)] tile: &mut Tile,
    #[spirv(workgroup)] other: &mut Tile,
    #[spirv(workgroup)] counters: &mut Counters,
    #[spirv(workgroup)] begins: &mut [u32; DIGITS],
    #[spirv(workgroup)] lanes: &mut [u32; LANES],
) {
    load_begins(group, lane, before, sums, begins, lanes);
    load(group, lane, params.x, items, tile);
    round(lane, 0, tile, other, counters, lanes);
    round(lane, ROUND_BITS, other, tile, counters, lanes);
    store(group, lane, items, tile, begins, sorted);
}

/// The place in the tile of the item that a lane reads or stores at a step: lanes side by side take items side by side.
#[inline(always)]
const fn at_step(lane: u32, step: u32) -> u32 {
    step * LANES as u32 + lane
}

/// Phase 1: counts the digits of a tile.
#[inline(always)]
#[expect(
    unsafe_code,
    reason = "rust-gpu has no safe atomics; these are plain additions, in range"
)]
fn count<I: Item>(
    group: UVec3,
    lane: u32,
    shift: u32,
    items: &[I],
    totals: &mut [u32],
    counts: &mut [u32; DIGITS],
) {
    for step in 0..LANE_DIGITS {
        counts[at_step(lane, step) as usize % DIGITS] = 0;
    }
    barrier();
    let tile = group_index(group);
    let mut run = DigitRun::EMPTY;
    for step in 0..RUN {
        let i = (tile * BLOCK + at_step(lane, step)) as usize;
        if i < items.len() {
            let digit = items[i].digit(shift);
            if run.ends_at(digit) {
                // SAFETY: between the barriers the counts are accessed by atomics only.
                unsafe { atomic_add(&mut counts[run.digit as usize % DIGITS], run.count) };
            }
            run = run.with(digit);
        }
    }
    // SAFETY: as above.
    unsafe { atomic_add(&mut counts[run.digit as usize % DIGITS], run.count) };
    barrier();
    let tile_count = (items.len() as u32).div_ceil(BLOCK);
    for step in 0..LANE_DIGITS {
        let digit = at_step(lane, step);
        let to = total_place(digit, tile, tile_count) as usize;
        if tile < tile_count && to < totals.len() {
            totals[to] = counts[digit as usize % DIGITS];
        }
    }
}

/// Phase 3: where the tile's first item with each digit goes, from the scans of phase 2.
#[inline(always)]
fn load_begins(
    group: UVec3,
    lane: u32,
    before: &[u32],
    sums: &[u32],
    begins: &mut [u32; DIGITS],
    lanes: &mut [u32; LANES],
) {
    let tile = group_index(group);
    let tile_count = before.len() as u32 / DIGITS as u32;
    let first = lane * LANE_DIGITS;
    let mut begin = scan_lanes(lane, run_sum(sums, first, LANE_DIGITS), lanes);
    for digit in first..first + LANE_DIGITS {
        let from = total_place(digit, tile, tile_count) as usize;
        let of_tile = if from < before.len() { before[from] } else { 0 };
        begins[digit as usize % DIGITS] = begin.wrapping_add(of_tile);
        begin = begin.wrapping_add(run_sum(sums, digit, 1));
    }
}

/// Phase 3: loads a tile. What is absent has the last digit, so that it comes last.
#[inline(always)]
fn load<I: Item>(group: UVec3, lane: u32, shift: u32, items: &[I], tile: &mut Tile) {
    for step in 0..RUN {
        let place = at_step(lane, step);
        let i = (group_index(group) * BLOCK + place) as usize;
        let digit = if i < items.len() {
            items[i].digit(shift)
        } else {
            DIGITS as u32 - 1
        };
        put(place, packed(digit, place), tile);
    }
}

/// Phase 3: sorts a tile by 4 bits of its digits, from the bit `shift` on.
#[inline(always)]
fn round(
    lane: u32,
    shift: u32,
    from: &Tile,
    to: &mut Tile,
    counters: &mut Counters,
    lanes: &mut [u32; LANES],
) {
    clear(lane, counters);
    barrier();
    for step in 0..RUN {
        take(round_digit(of_run(lane, step, from), shift), lane, counters);
    }
    barrier();
    let before = scan_lanes(lane, lane_sum(lane, counters), lanes);
    lane_scan(lane, before, lanes[LANES - 1], counters);
    barrier();
    for step in 0..RUN {
        let item = of_run(lane, step, from);
        let rank = take(round_digit(item, shift), lane, counters);
        put(rank, item, to);
    }
    barrier();
}

/// Phase 3: stores a sorted tile. Where a digit begins in the tile is taken off, so that place and `begins` add up.
#[inline(always)]
fn store<I: Item>(
    group: UVec3,
    lane: u32,
    items: &[I],
    tile: &Tile,
    begins: &mut [u32; DIGITS],
    sorted: &mut [I],
) {
    for step in 0..RUN {
        let place = at_step(lane, step);
        if is_first(place, tile) {
            let digit = packed_digit(word(place, tile)) as usize % DIGITS;
            begins[digit] = begins[digit].wrapping_sub(place);
        }
    }
    barrier();
    for step in 0..RUN {
        let place = at_step(lane, step);
        let item = word(place, tile);
        let from = (group_index(group) * BLOCK + packed_place(item)) as usize;
        let begin = begins[packed_digit(item) as usize % DIGITS];
        let to = begin.wrapping_add(place) as usize;
        if from < items.len() && to < sorted.len() {
            sorted[to] = items[from];
        }
    }
}
