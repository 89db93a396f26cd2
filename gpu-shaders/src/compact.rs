//! Compaction, with a scan of the counts between its two dispatches.

use crate::thread_index;
use glam::UVec3;
use slimbvh_core::compact::{is_set, rank};
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
