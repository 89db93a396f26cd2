//! Stage `encode`: plain nodes and triangles in codecs. Each thread finds its node's box by itself, from the root down.

pub mod wide;

use crate::thread_index;
use crate::trace::root_words;
use glam::{UVec3, UVec4};
use slimbvh_core::encode::{
    LeafCorner, Paper10Box, Paper10Codec, Paper10Node, Paper10Triangle, RootWords,
    encode_paper10_triangle, encode_triangle, node_bounds, scaled_step,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::{LeafTriangle, Node, NodeRef};
use spirv_std_macros::spirv;

/// One thread per node. Reads the number of nodes, `opaque_zero` and the plain nodes. Stores the node in the paper10 codec, with links
/// to triangles that are stored in full, and the root's box.
#[spirv(compute(threads(64)))]
pub fn encode_paper10_f32(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] opaque_zero: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &mut [Paper10Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < plain.len() && i < nodes.len() {
        let codec = Paper10Codec {
            opaque_zero: opaque_zero.x,
        };
        let bounds = node_bounds(node, plain, &codec);
        nodes[i] = codec.encode(&bounds, &plain[i]).node;
        store_root(node, RootWords::of_paper10(&bounds), root);
    }
}

/// As [`encode_paper10_f32`]. Reads the triangles, too. Stores those of the leaves below the node in its boxes.
#[spirv(compute(threads(64)))]
pub fn encode_paper10_leaf10(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] opaque_zero: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] plain: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [Paper10Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] records: &mut [Paper10Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] root: &mut [RootWords],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < plain.len() && i < nodes.len() {
        let codec = Paper10Codec {
            opaque_zero: opaque_zero.x,
        };
        let bounds = node_bounds(node, plain, &codec);
        let coded = codec.encode(&bounds, &plain[i]);
        nodes[i] = coded.node;
        store_paper10(
            plain[i].left,
            &coded.left,
            opaque_zero.x,
            triangles,
            records,
        );
        store_paper10(
            plain[i].right,
            &coded.right,
            opaque_zero.x,
            triangles,
            records,
        );
        store_root(node, RootWords::of_paper10(&bounds), root);
    }
}

/// One thread per triangle. Reads how many there are, the root, the triangles, the corners of their leaves and where each one's
/// words begin. Stores these.
#[spirv(compute(threads(64)))]
pub fn encode_triangles(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] count: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] root: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] corners: &[LeafCorner],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] begins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] words: &mut [u32],
) {
    let triangle = thread_index(id);
    let i = triangle as usize;
    if triangle < count.x && i < triangles.len() && i < corners.len() && i < begins.len() {
        let step = power_of_two(root_words(root).step_exponent());
        let (to, size) = (begins[i], corners[i].words);
        let [a, b, c, d, e, f, g, h, j, k] = encode_triangle(&triangles[i], &corners[i], step);
        store_words(to, [a, b, c, d], words);
        if size > 4 {
            store_words(to.wrapping_add(4), [e, f, g], words);
        }
        if size > 7 {
            store_words(to.wrapping_add(7), [h, j, k], words);
        }
    }
}

/// The exponent of a lattice's step, in the scene's magnitude. Reads the scene's exponent, and the step's: in the caller's unit,
/// if the second number says so.
#[inline(always)]
pub(crate) fn lattice_step(exponent: &UVec4, step: &UVec4) -> i32 {
    if step.y == 0 {
        step.x as i32
    } else {
        scaled_step(step.x as i32, exponent.x as i32)
    }
}

#[inline(always)]
fn store_root(node: u32, words: RootWords, root: &mut [RootWords]) {
    if node == 0 && !root.is_empty() {
        root[0] = words;
    }
}

#[inline(always)]
fn store_paper10(
    child: NodeRef,
    bounds: &Paper10Box,
    opaque_zero: u32,
    triangles: &[LeafTriangle],
    records: &mut [Paper10Triangle],
) {
    if child.is_leaf() {
        for number in 0..child.count() {
            let i = (child.first() + number) as usize;
            if i < triangles.len() && i < records.len() {
                records[i] = encode_paper10_triangle(&triangles[i], bounds, opaque_zero);
            }
        }
    }
}

/// Stores words side by side, those that lie inside.
#[inline(always)]
fn store_words<const COUNT: usize>(to: u32, from: [u32; COUNT], words: &mut [u32]) {
    for i in 0..COUNT as u32 {
        let at = to.wrapping_add(i) as usize;
        if at < words.len() {
            words[at] = from[i as usize];
        }
    }
}
