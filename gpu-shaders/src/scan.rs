//! Stage `scan`: exclusive prefix sums of any number of values, in two dispatches: the sum of each block, then the scan of
//! each block from the sum of all before it. A single block needs the second only.

use crate::group::barrier;
use crate::{LANE_STEPS, group_index, lane_index};
use glam::UVec3;
use slimbvh_core::launch::{LANES, dispatch, run_begin, run_length, scan_block_count, scan_run};
use slimbvh_core::scan::{doubling_step, run_scan, run_sum, strided_sum};
use spirv_std_macros::spirv;

/// One workgroup per block of values. Reads the values. Stores the block's sum.
#[spirv(compute(threads(64)))]
pub fn scan_sums(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] values: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] blocks: &mut [u32],
    #[spirv(workgroup)] sums: &mut [u32; LANES],
) {
    let count = values.len() as u32;
    let run = scan_run(count);
    let first = run_begin(lane_index(group, lane), run, count);
    let own = run_sum(values, first, run_length(first, run, count));
    scan_lanes(lane, own, sums);
    let block = group_index(group) as usize;
    if lane == 0 && block < blocks.len() {
        blocks[block] = sums[LANES - 1];
    }
}

/// One workgroup per block of values. Reads the sums of the blocks before its own. Stores the prefix sums of the values in
/// their place, and the sum of all as `[sum, x, y, z]`, with the dispatch of a thread for each.
#[spirv(compute(threads(64)))]
pub fn scan_apply(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] blocks: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] values: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] total: &mut [[u32; 4]],
    #[spirv(workgroup)] sums: &mut [u32; LANES],
) {
    let block = group_index(group);
    scan_lanes(lane, strided_sum(blocks, lane, block, LANES as u32), sums);
    let before_block = sums[LANES - 1];
    barrier();

    let count = values.len() as u32;
    let run = scan_run(count);
    let first = run_begin(lane_index(group, lane), run, count);
    let length = run_length(first, run, count);
    let before = scan_lanes(lane, run_sum(values, first, length), sums);
    let sum = run_scan(values, first, length, before.wrapping_add(before_block));

    let is_last = block + 1 == scan_block_count(count) && lane == LANES as u32 - 1;
    if is_last && !total.is_empty() {
        let [x, y, z] = dispatch(sum.div_ceil(LANES as u32));
        total[0] = [sum, x, y, z];
    }
}

/// Replaces `values[first..first + count]` by their prefix sums, by one workgroup. Returns the sum of all.
#[inline(always)]
pub(crate) fn scan_part(
    lane: u32,
    first: u32,
    count: u32,
    values: &mut [u32],
    sums: &mut [u32; LANES],
) -> u32 {
    let run = count.div_ceil(LANES as u32);
    let begin = run_begin(lane, run, count);
    let length = run_length(begin, run, count);
    let begin = first + begin;
    let before = scan_lanes(lane, run_sum(values, begin, length), sums);
    run_scan(values, begin, length, before);
    sums[LANES - 1]
}

/// The sum of all lanes before this one; the sum of all stays in the last of `sums`.
#[inline(always)]
pub(crate) fn scan_lanes(lane: u32, own: u32, sums: &mut [u32; LANES]) -> u32 {
    sums[lane as usize % LANES] = own;
    barrier();
    let mut distance = 1;
    for _ in 0..LANE_STEPS {
        let sum = doubling_step(lane, distance, sums);
        barrier();
        sums[lane as usize % LANES] = sum;
        barrier();
        distance *= 2;
    }
    sums[lane as usize % LANES].wrapping_sub(own)
}
