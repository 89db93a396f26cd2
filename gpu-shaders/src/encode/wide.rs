//! Wide nodes: each thread encodes the one that begins at its binary node, if any does, and stores it at its place.

use super::{lattice_step, store_root};
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::encode::{
    FINEST_STEP, FullWideNode, LeafCorner, MixedWideNode, PackedWideNode, RootWords,
    RoundedChildren, RoundedNode, WideNode,
};
use slimbvh_core::wide::{Begins, Collapse, Origin, WIDTH, WideChildren, wide_children};
use slimbvh_core::{Node, NodeRef};
use spirv_std_macros::spirv;

/// One thread per binary node. Reads the number of nodes, the nodes, which of them wide ones take in, where these come from, and
/// the prefix sums of their numbers of inner children. Stores the wide node that begins here with planes in full.
#[spirv(compute(threads(64)))]
pub fn encode_w4(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] begins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] nodes: &mut [FullWideNode],
) {
    let node = thread_index(id);
    let to = place(node, total, origins, begins) as usize;
    if to < nodes.len() && (node as usize) < plain.len() {
        let run = [plain[node as usize].first, plain[node as usize].last];
        let first_child = Begins(begins).first_child(node);
        nodes[to] = FullWideNode::new(&children(node, plain, collapses), run, first_child);
    }
}

/// As [`encode_w4`]. Stores the node on the finest lattice, with links to triangles that are stored in full, and the root's box.
#[spirv(compute(threads(64)))]
pub fn encode_w4_64_f32(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] begins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] nodes: &mut [WideNode],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    let to = place(node, total, origins, begins) as usize;
    if to < nodes.len() && (node as usize) < plain.len() {
        let from = RoundedChildren::new(&children(node, plain, collapses), FINEST_STEP);
        nodes[to] = WideNode::new(&from, Begins(begins).first_child(node));
        store_wide_root(node, FINEST_STEP, plain, root);
    }
}

/// One thread per binary node. Reads the number of nodes, the scene's exponent, the exponent of the lattice's step with a flag
/// that is 1 where that is in the caller's unit, the nodes, which of them wide ones take in, where these come from, and the prefix
/// sums of their numbers of inner children, then of their leaves' words. Stores the wide node that begins here in 64 bytes, for each
/// triangle of its leaves the leaf's corner and where its words begin, and the root's box.
#[spirv(compute(threads(64)))]
pub fn encode_w4_64_lattice(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] step: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] begins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] nodes: &mut [WideNode],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] corners: &mut [LeafCorner],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] words: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    let to = place(node, total, origins, begins);
    let step = lattice_step(exponent, step);
    let tree = (plain, collapses, begins);
    store_mixed(node, to, step, tree, (nodes, corners, words, root));
}

/// As [`encode_w4_64_lattice`]. Stores the node in 48 bytes.
#[spirv(compute(threads(64)))]
pub fn encode_w4_48_lattice(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] step: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] collapses: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] origins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] begins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] nodes: &mut [PackedWideNode],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] corners: &mut [LeafCorner],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] words: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    let to = place(node, total, origins, begins);
    let step = lattice_step(exponent, step);
    let tree = (plain, collapses, begins);
    store_mixed(node, to, step, tree, (nodes, corners, words, root));
}

/// The place of the wide node that begins at a binary node; `u32::MAX` where none begins.
#[inline(always)]
fn place(node: u32, total: &UVec4, origins: &[u32], begins: &[u32]) -> u32 {
    let i = node as usize;
    if node < total.x && i < origins.len() {
        Begins(begins).place(Origin(origins[i]))
    } else {
        u32::MAX
    }
}

/// The children of the wide node that begins at a binary node.
#[inline(always)]
pub(crate) fn children(node: u32, plain: &[Node], collapses: &[u32]) -> WideChildren {
    let i = node as usize;
    if i < plain.len() && i < collapses.len() {
        wide_children(&plain[i], Collapse(collapses[i]), plain)
    } else {
        wide_children(&Node::EMPTY, Collapse::NONE, plain)
    }
}

/// Stores the root's exact box on the lattice.
#[inline(always)]
fn store_wide_root(node: u32, step_exponent: i32, plain: &[Node], root: &mut [RootWords]) {
    if node == 0 && !plain.is_empty() {
        let [left, right] = RoundedNode::new(&plain[0], step_exponent).boxes();
        let words = RootWords::of_lattice(&left.union(&right), step_exponent);
        store_root(node, words, root);
    }
}

#[inline(always)]
fn store_mixed<N: MixedWideNode>(
    node: u32,
    place: u32,
    step_exponent: i32,
    (plain, collapses, begins): (&[Node], &[u32], &[u32]),
    (nodes, corners, words, root): (&mut [N], &mut [LeafCorner], &mut [u32], &mut [RootWords]),
) {
    let to = place as usize;
    if to < nodes.len() {
        let from = RoundedChildren::new(&children(node, plain, collapses), step_exponent);
        let coded = N::encode(&from);
        let begins = Begins(begins);
        let links = coded.mixed_links(&from);
        let links = links.at(begins.first_child(node), begins.first_word(node));
        nodes[to] = coded.with_mixed_links(links);
        for child in 0..WIDTH as u32 {
            let leaf = from.nodes[child as usize];
            if child < from.count && leaf.is_leaf() {
                let corner = coded.corner(links, child, step_exponent);
                store_triangles(leaf, links.child(child).first(), corner, corners, words);
            }
        }
        store_wide_root(node, step_exponent, plain, root);
    }
}

/// Stores for each triangle of a leaf its corner and where its words begin, those of the first at `word`.
#[inline(always)]
fn store_triangles(
    leaf: NodeRef,
    word: u32,
    corner: LeafCorner,
    corners: &mut [LeafCorner],
    words: &mut [u32],
) {
    for number in 0..leaf.count() {
        let i = leaf.first().wrapping_add(number) as usize;
        if i < corners.len() && i < words.len() {
            corners[i] = corner;
            words[i] = word.wrapping_add(number.wrapping_mul(corner.words));
        }
    }
}
