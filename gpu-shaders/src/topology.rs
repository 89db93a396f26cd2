//! Stage `topology`: which nodes are kept, a scan of their counts, then the nodes.

use crate::compact::store_bits;
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::Node;
use slimbvh_core::compact::{is_set, rank};
use slimbvh_core::launch::LANES;
use slimbvh_core::topology::{Codes30, Codes63, SortedCodes, internal_node, is_kept};
use spirv_std_macros::spirv;

/// One thread per node. Reads how many codes there are, and the sorted codes. Stores a bit for each node that is kept, and
/// how many each word has.
#[spirv(compute(threads(64)))]
pub fn topology_kept_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] codes: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] bits: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] counts: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let codes = Codes30 {
        codes,
        count: total.x,
    };
    let flag = is_kept(thread_index(id), &codes) as u32;
    store_bits(id, lane, flag, flags, bits, counts);
}

/// As [`topology_kept_30`], of codes of two words.
#[spirv(compute(threads(64)))]
pub fn topology_kept_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] codes: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] bits: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] counts: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let codes = Codes63 {
        codes,
        count: total.x,
    };
    let flag = is_kept(thread_index(id), &codes) as u32;
    store_bits(id, lane, flag, flags, bits, counts);
}

/// One thread per code. Reads how many codes there are, the sorted codes, the bits of the kept nodes and the prefix sums of their counts. Stores
/// the kept nodes in order, without boxes, and the last leaf of each one's left child.
#[spirv(compute(threads(64)))]
pub fn topology_nodes_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] codes: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] splits: &mut [u32],
) {
    store_node(
        thread_index(id),
        &Codes30 {
            codes,
            count: total.x,
        },
        bits,
        before,
        nodes,
        splits,
    );
}

/// As [`topology_nodes_30`], of codes of two words.
#[spirv(compute(threads(64)))]
pub fn topology_nodes_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] codes: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] splits: &mut [u32],
) {
    store_node(
        thread_index(id),
        &Codes63 {
            codes,
            count: total.x,
        },
        bits,
        before,
        nodes,
        splits,
    );
}

#[inline(always)]
fn store_node<C: SortedCodes>(
    i: u32,
    codes: &C,
    bits: &[u32],
    before: &[u32],
    nodes: &mut [Node],
    splits: &mut [u32],
) {
    if is_set(i, bits) {
        let to = rank(i, bits, before) as usize;
        let (node, split) = internal_node(i, codes, bits, before);
        if to < nodes.len() && to < splits.len() {
            nodes[to] = node;
            splits[to] = split;
        }
    }
}
