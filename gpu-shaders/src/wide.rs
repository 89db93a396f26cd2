//! Stage `wide`: where wide nodes begin, and what a scan needs to find their places.

use crate::encode::lattice_step;
use crate::encode::wide::children;
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::Node;
use slimbvh_core::encode::{MixedWideNode, PackedWideNode, RoundedChildren, WideNode};
use slimbvh_core::wide::{Begins, Collapse, Origin, collapse, wide_origin};
use spirv_std_macros::spirv;

/// One thread per binary node. Reads the number of nodes, `opaque_zero` and the nodes. Stores which nodes a wide node that begins
/// here takes in.
#[spirv(compute(threads(64)))]
pub fn wide_collapse(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] opaque_zero: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] collapses: &mut [u32],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < plain.len() && i < collapses.len() {
        collapses[i] = collapse(&plain[i], plain, opaque_zero.x).0;
    }
}

/// One thread per binary node. Reads the number of nodes, the nodes and which of them wide ones take in. Stores where the wide node
/// that begins here comes from, and how many inner children it has: 0 where none begins.
#[spirv(compute(threads(64)))]
pub fn wide_places(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] origins: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counts: &mut [u32],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < collapses.len() && i < origins.len() && i < counts.len() {
        let origin = wide_origin(node, plain, collapses);
        origins[i] = origin.0;
        counts[i] = origin.inner_count(Collapse(collapses[i]));
    }
}

/// One thread per binary node. Reads the number of nodes, the scene's exponent, the exponent of the lattice's step with a flag
/// that is 1 where that is in the caller's unit, the nodes, which of them wide ones take in, and where these come from. Stores how
/// many inner children the wide node of 64 bytes that begins here has, and behind those of all nodes the words of its leaves'
/// triangles: 0 where none begins.
#[spirv(compute(threads(64)))]
pub fn wide_words_64(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] step: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] counts: &mut [u32],
) {
    let node = thread_index(id);
    if node < total.x {
        let step = lattice_step(exponent, step);
        store_words::<WideNode>(node, step, (plain, collapses, origins), counts);
    }
}

/// As [`wide_words_64`], of wide nodes of 48 bytes.
#[spirv(compute(threads(64)))]
pub fn wide_words_48(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] step: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] counts: &mut [u32],
) {
    let node = thread_index(id);
    if node < total.x {
        let step = lattice_step(exponent, step);
        store_words::<PackedWideNode>(node, step, (plain, collapses, origins), counts);
    }
}

#[inline(always)]
fn store_words<N: MixedWideNode>(
    node: u32,
    step_exponent: i32,
    (plain, collapses, origins): (&[Node], &[u32], &[u32]),
    counts: &mut [u32],
) {
    let i = node as usize;
    let behind = Begins::first_of_words(counts.len() as u32).wrapping_add(node) as usize;
    if i < collapses.len() && i < origins.len() && i < counts.len() && behind < counts.len() {
        let origin = Origin(origins[i]);
        let mut words = 0;
        if origin.is_there() {
            let from = RoundedChildren::new(&children(node, plain, collapses), step_exponent);
            words = N::encode(&from).mixed_links(&from).word_count();
        }
        counts[i] = origin.inner_count(Collapse(collapses[i]));
        counts[behind] = words;
    }
}
