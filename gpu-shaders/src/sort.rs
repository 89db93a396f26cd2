//! Stage `sort`: a pass over one digit, in two dispatches with a scan of the totals between them. A tile is a block.

use crate::group::barrier;
use crate::{LANE_STEPS, group_index, run_begin, run_length};
use glam::{UVec3, UVec4};
use slimbvh_core::launch::{BLOCK, DIGITS, LANES};
use slimbvh_core::scan::doubling_step;
use slimbvh_core::sort::{
    DigitCounts, count_digit, digit, digit_total, lane_begin, place, total_place,
};
use spirv_std_macros::spirv;

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
    #[spirv(workgroup)] counts: &mut DigitCounts<LANES, DIGITS>,
) {
    count(group, lane, params.x, items, counts);
    store_totals(group, lane, items.len() as u32, counts, totals);
}

/// As [`sort_count_30`], of `[high word, low word, value]` items.
#[spirv(compute(threads(64)))]
pub fn sort_count_63(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] totals: &mut [u32],
    #[spirv(workgroup)] counts: &mut DigitCounts<LANES, DIGITS>,
) {
    count(group, lane, params.x, items, counts);
    store_totals(group, lane, items.len() as u32, counts, totals);
}

/// One workgroup per tile. Reads `[key, value]` items and the prefix sums of what [`sort_count_30`] stored; `params.x`
/// is the digit's first bit. Stores the items in the digit's order.
#[spirv(compute(threads(64)))]
pub fn sort_scatter_30(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sorted: &mut [[u32; 2]],
    #[spirv(workgroup)] counts: &mut DigitCounts<LANES, DIGITS>,
) {
    count(group, lane, params.x, items, counts);
    place_lanes(group, lane, items.len() as u32, before, counts);
    scatter(group, lane, params.x, items, counts, sorted);
}

/// As [`sort_scatter_30`], of `[high word, low word, value]` items.
#[spirv(compute(threads(64)))]
pub fn sort_scatter_63(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sorted: &mut [[u32; 3]],
    #[spirv(workgroup)] counts: &mut DigitCounts<LANES, DIGITS>,
) {
    count(group, lane, params.x, items, counts);
    place_lanes(group, lane, items.len() as u32, before, counts);
    scatter(group, lane, params.x, items, counts, sorted);
}

/// Where the run that begins at `first` ends: in the items.
#[inline(always)]
fn run_end<I>(first: u32, items: &[I]) -> usize {
    let end = (first + run_length(first, items.len() as u32)) as usize;
    if end < items.len() { end } else { items.len() }
}

/// Phase 1: counts the digits of the lane's run.
#[inline(always)]
fn count<I: Item>(
    group: UVec3,
    lane: u32,
    shift: u32,
    items: &[I],
    counts: &mut DigitCounts<LANES, DIGITS>,
) {
    for digit in 0..DIGITS {
        counts[digit][lane as usize % LANES] = 0;
    }
    let first = run_begin(group, lane, items.len() as u32);
    let last = run_end(first, items);
    for i in first as usize..last {
        count_digit(items[i].digit(shift), lane, counts);
    }
    barrier();
}

/// Phase 2 over tiles: one lane per digit stores its total.
#[inline(always)]
fn store_totals(
    group: UVec3,
    lane: u32,
    item_count: u32,
    counts: &DigitCounts<LANES, DIGITS>,
    totals: &mut [u32],
) {
    let tile_count = item_count.div_ceil(BLOCK);
    let tile = group_index(group);
    let to = total_place(lane, tile, tile_count) as usize;
    if lane < DIGITS as u32 && tile < tile_count && to < totals.len() {
        totals[to] = digit_total(lane, counts);
    }
}

/// Phase 2 over lanes: turns the lanes' counts into the places of their next items.
#[inline(always)]
fn place_lanes(
    group: UVec3,
    lane: u32,
    item_count: u32,
    before: &[u32],
    counts: &mut DigitCounts<LANES, DIGITS>,
) {
    let tile_count = item_count.div_ceil(BLOCK);
    let tile = group_index(group);
    let mut own = [0; DIGITS];
    let mut sums = [0; DIGITS];
    for digit in 0..DIGITS {
        own[digit] = counts[digit][lane as usize % LANES];
    }
    let mut distance = 1;
    for _ in 0..LANE_STEPS {
        for digit in 0..DIGITS {
            sums[digit] = doubling_step(lane, distance, &counts[digit]);
        }
        barrier();
        for digit in 0..DIGITS {
            counts[digit][lane as usize % LANES] = sums[digit];
        }
        barrier();
        distance *= 2;
    }
    // From here on a lane touches only its own column.
    for digit in 0..DIGITS {
        let from = total_place(digit as u32, tile, tile_count) as usize;
        let tile_begin = if from < before.len() { before[from] } else { 0 };
        counts[digit][lane as usize % LANES] = lane_begin(tile_begin, sums[digit], own[digit]);
    }
}

/// Phase 3: moves the lane's run.
#[inline(always)]
fn scatter<I: Item>(
    group: UVec3,
    lane: u32,
    shift: u32,
    items: &[I],
    counts: &mut DigitCounts<LANES, DIGITS>,
    sorted: &mut [I],
) {
    let first = run_begin(group, lane, items.len() as u32);
    let last = run_end(first, items);
    for i in first as usize..last {
        let item = items[i];
        let to = place(item.digit(shift), lane, counts) as usize;
        if to < sorted.len() {
            sorted[to] = item;
        }
    }
}
