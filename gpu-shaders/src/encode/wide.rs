//! Wide nodes: each thread encodes the one that begins at its binary node, if any does, and stores it at its place.

use super::{lattice_step, store_root};
use crate::thread_index;
use crate::trace::root_words;
use glam::{UVec3, UVec4};
use slimbvh_core::encode::{
    FINEST_STEP, FullWideNode, LeafCorner, MixedWideNode, PackedWideNode, RootWords,
    RoundedChildren, RoundedNode, TriangleCorners, WideNode, corner_counts, store_shared_triangle,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::wide::{Begins, Collapse, Origin, WIDTH, WideChildren, wide_children};
use slimbvh_core::{LeafTriangle, Node};
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
/// sums of their numbers of inner children, then of their leaves' words. Stores the wide node that begins here in 64 bytes, and for
/// each triangle of its leaves the leaf's corner and where its words begin.
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
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] frames: &mut [LeafCorner],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] words: &mut [u32],
) {
    let node = thread_index(id);
    let to = place(node, total, origins, begins);
    if (to as usize) < nodes.len() {
        let step = lattice_step(exponent, step);
        let found = children(node, plain, collapses);
        let from = RoundedChildren::new(&found, step);
        store_mixed(
            node,
            to,
            (&from, [0; WIDTH]),
            begins,
            (nodes, frames, words),
        );
    }
}

/// As [`encode_w4_64_lattice`]. Reads which corners triangles have, too. Stores the node in 48 bytes, and for each triangle where the
/// words of its leaf begin.
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
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] corners: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] nodes: &mut [PackedWideNode],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] frames: &mut [LeafCorner],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] words: &mut [u32],
) {
    let node = thread_index(id);
    let to = place(node, total, origins, begins);
    if (to as usize) < nodes.len() {
        let step = lattice_step(exponent, step);
        let found = children(node, plain, collapses);
        let from = RoundedChildren::new(&found, step);
        let counts = corner_counts(found.nodes(), 0, corners);
        store_mixed(node, to, (&from, counts), begins, (nodes, frames, words));
    }
}

/// One thread per triangle. Reads how many there are, the root, the triangles, the corners of their leaves' boxes, where the words of
/// each one's leaf begin, and which of its leaf's corners it has. Stores its part of these words.
#[spirv(compute(threads(64)))]
pub fn encode_shared_triangles(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] count: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] root: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] frames: &[LeafCorner],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] begins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] corners: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] words: &mut [u32],
) {
    let triangle = thread_index(id);
    let i = triangle as usize;
    if triangle < count.x
        && i < triangles.len()
        && i < frames.len()
        && i < begins.len()
        && i < corners.len()
    {
        let step = power_of_two(root_words(root).step_exponent());
        // The last one has none beside it.
        let next = (i + 1).min(corners.len() - 1);
        let own = [TriangleCorners(corners[i]), TriangleCorners(corners[next])];
        store_shared_triangle::<false>(&triangles[i], &frames[i], own, step, begins[i], words);
    }
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
pub(crate) fn store_wide_root(
    node: u32,
    step_exponent: i32,
    plain: &[Node],
    root: &mut [RootWords],
) {
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
    (from, corner_counts): (&RoundedChildren, [u32; WIDTH]),
    begins: &[u32],
    (nodes, frames, words): (&mut [N], &mut [LeafCorner], &mut [u32]),
) {
    let begins = Begins(begins);
    let (first_child, first_word) = (begins.first_child(node), begins.first_word(node));
    let (coded, _) = N::encode(from, corner_counts);
    let coded = coded.placed(from.count, first_child, first_word);
    if (place as usize) < nodes.len() {
        nodes[place as usize] = coded;
    }
    store_leaf(&coded, 0, from, frames, words);
    store_leaf(&coded, 1, from, frames, words);
    store_leaf(&coded, 2, from, frames, words);
    store_leaf(&coded, 3, from, frames, words);
}

/// Stores for each triangle of a child, if that is a leaf, the leaf's corner and where its words begin: its own, or those of its leaf
/// where they share corners.
#[inline(always)]
fn store_leaf<N: MixedWideNode>(
    coded: &N,
    child: u32,
    from: &RoundedChildren,
    frames: &mut [LeafCorner],
    words: &mut [u32],
) {
    let leaf = from.nodes[child as usize];
    if child < from.count && leaf.is_leaf() {
        let corner = coded.corner(child, from.step_exponent);
        let stride = if N::SHARES_CORNERS { 0 } else { corner.words };
        let first = coded.first_word(child);
        for number in 0..leaf.count() {
            let i = leaf.first().wrapping_add(number) as usize;
            if i < frames.len() && i < words.len() {
                frames[i] = corner;
                words[i] = first.wrapping_add(number.wrapping_mul(stride));
            }
        }
    }
}
