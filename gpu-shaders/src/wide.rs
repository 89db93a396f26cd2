//! Stage `wide`: where wide nodes begin, and what a scan needs to find their places.

use crate::encode::lattice_step;
use crate::encode::wide::{children, store_wide_root};
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::encode::{
    MixedWideNode, PackedWideNode, RootWords, RoundedChildren, WideNode, corner_counts,
    number_corners,
};
use slimbvh_core::wide::{Begins, Collapse, Origin, WIDTH, WideChildren, collapse, wide_origin};
use slimbvh_core::{LeafTriangle, Node};
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

/// One thread per binary node. Reads the number of nodes, the nodes and the triangles. Numbers the corners of the triangles in the
/// node's own leaves, those in one place once.
#[spirv(compute(threads(64)))]
pub fn wide_corners(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] corners: &mut [u32],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < plain.len() {
        let (left, right) = (plain[i].left, plain[i].right);
        if left.is_leaf() {
            number_corners(left.first(), left.count(), triangles, corners);
        }
        if right.is_leaf() {
            number_corners(right.first(), right.count(), triangles, corners);
        }
    }
}

/// One thread per binary node. Reads the number of nodes, the scene's exponent, the exponent of the lattice's step with a flag
/// that is 1 where that is in the caller's unit, the nodes, which of them wide ones take in, and where these come from. Stores how
/// many inner children the wide node of 64 bytes that begins here has, and behind those of all nodes the words of its leaves'
/// triangles: 0 where none begins; and the root's box.
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
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    if node < total.x {
        let step = lattice_step(exponent, step);
        let mut words = 0;
        if begins(node, origins) {
            let found = children(node, plain, collapses);
            words = word_count::<WideNode>(&found, [0; WIDTH], step);
        }
        store_counts(node, words, (collapses, origins), counts);
        store_wide_root(node, step, plain, root);
    }
}

/// As [`wide_words_64`], of wide nodes of 48 bytes. Reads which corners triangles have, too.
#[spirv(compute(threads(64)))]
pub fn wide_words_48(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] step: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] corners: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] counts: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    if node < total.x {
        let step = lattice_step(exponent, step);
        let mut words = 0;
        if begins(node, origins) {
            let found = children(node, plain, collapses);
            words = word_count::<PackedWideNode>(
                &found,
                corner_counts(found.nodes(), 0, corners),
                step,
            );
        }
        store_counts(node, words, (collapses, origins), counts);
        store_wide_root(node, step, plain, root);
    }
}

/// Whether a wide node begins at a binary one.
#[inline(always)]
fn begins(node: u32, origins: &[u32]) -> bool {
    let i = node as usize;
    i < origins.len() && Origin(origins[i]).is_there()
}

#[inline(always)]
fn word_count<N: MixedWideNode>(
    found: &WideChildren,
    corner_counts: [u32; WIDTH],
    step_exponent: i32,
) -> u32 {
    let from = RoundedChildren::new(found, step_exponent);
    let (_, words) = N::encode(&from, corner_counts);
    words
}

/// Stores a node's number of inner children, and behind those of all nodes its words.
#[inline(always)]
fn store_counts(node: u32, words: u32, (collapses, origins): (&[u32], &[u32]), counts: &mut [u32]) {
    let i = node as usize;
    let behind = Begins::first_of_words(counts.len() as u32).wrapping_add(node) as usize;
    if i < collapses.len() && i < origins.len() && i < counts.len() && behind < counts.len() {
        counts[i] = Origin(origins[i]).inner_count(Collapse(collapses[i]));
        counts[behind] = words;
    }
}
