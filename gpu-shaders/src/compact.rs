//! Compaction, with a scan of the counts between its two dispatches.

use crate::group::barrier;
use crate::thread_index;
use glam::UVec3;
use slimbvh_core::compact::{is_set, pack_lanes, rank};
use slimbvh_core::launch::LANES;
use spirv_std_macros::spirv;

/// One thread per word of 32 bits. Reads the bits. Stores how many of the word are set.
#[spirv(compute(threads(64)))]
pub fn compact_counts(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] counts: &mut [u32],
) {
    let i = thread_index(id) as usize;
    if i < bits.len() && i < counts.len() {
        counts[i] = bits[i].count_ones();
    }
}

/// One thread per item. Reads the bits and the prefix sums of their counts. Stores the number of each item whose bit is
/// set, in order.
#[spirv(compute(threads(64)))]
pub fn compact(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &mut [u32],
) {
    let i = thread_index(id);
    if is_set(i, bits) {
        let to = rank(i, bits, before) as usize;
        if to < indices.len() {
            indices[to] = i;
        }
    }
}

/// Stores the flags of a workgroup's threads, each 0 or 1, as the bits of words, and how many of each word are set.
#[inline(always)]
pub(crate) fn store_bits(
    id: UVec3,
    lane: u32,
    flag: u32,
    flags: &mut [u32; LANES],
    bits: &mut [u32],
    counts: &mut [u32],
) {
    flags[lane as usize % LANES] = flag;
    barrier();
    let word = (thread_index(id) / 32) as usize;
    if lane & 31 == 0 && word < bits.len() && word < counts.len() {
        let packed = pack_lanes(lane, flags);
        bits[word] = packed;
        counts[word] = packed.count_ones();
    }
}
