//! Stage `refit`. A level of the pyramid is made from the one below; as no buffer can be read and written at once, each
//! level is also stored in a buffer of its own.

use crate::encode::lattice_step;
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::encode::RoundedNode;
use slimbvh_core::node::Connection;
use slimbvh_core::refit::{
    PyramidBox, group_bounds, group_count, parent_bounds, refit_node, split_of,
};
use slimbvh_core::{LeafTriangle, Node};
use spirv_std_macros::spirv;

/// One thread per entry of level 0. Reads the triangles in leaf order. Stores their box, in the level and the pyramid.
#[spirv(compute(threads(64)))]
pub fn refit_groups(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] level: &mut [PyramidBox],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] pyramid: &mut [PyramidBox],
) {
    let group = thread_index(id);
    let i = group as usize;
    if group < group_count(triangles.len() as u32) && i < level.len() && i < pyramid.len() {
        let bounds = group_bounds(group, triangles);
        level[i] = bounds;
        pyramid[i] = bounds;
    }
}

/// One thread per entry of a further level. Reads the level below; `params.x` is where the level begins in the
/// pyramid. Stores the box, in the level and the pyramid.
#[spirv(compute(threads(64)))]
pub fn refit_parents(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] below: &[PyramidBox],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] level: &mut [PyramidBox],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] pyramid: &mut [PyramidBox],
) {
    let entry = thread_index(id);
    let i = entry as usize;
    let to = (params.x + entry) as usize;
    if i < level.len() && to < pyramid.len() {
        let bounds = parent_bounds(entry, below);
        level[i] = bounds;
        pyramid[to] = bounds;
    }
}

/// One thread per node. Reads the number of nodes, the triangles, the pyramid and the splits. Stores the node with its
/// children's boxes.
#[spirv(compute(threads(64)))]
pub fn refit_nodes(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] pyramid: &[PyramidBox],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] splits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [Node],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < nodes.len() && i < splits.len() {
        nodes[i] = refit_node(nodes[i], splits[i], triangles, pyramid);
    }
}

/// As [`refit_nodes`]. Reads the scene's exponent, that of a lattice's step and whether it is in the caller's unit, too. Stores the node on that lattice.
#[spirv(compute(threads(64)))]
pub fn refit_rounded(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] step: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] pyramid: &[PyramidBox],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] splits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] nodes: &mut [RoundedNode],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < nodes.len() && i < splits.len() {
        let RoundedNode {
            left,
            right,
            first,
            last,
            ..
        } = nodes[i];
        let bare = Connection {
            left,
            right,
            first,
            last,
        };
        let plain = refit_node((&bare).into(), splits[i], triangles, pyramid);
        nodes[i] = RoundedNode::new(&plain, lattice_step(exponent, step));
    }
}

/// One thread per node. Reads the number of nodes and the nodes. Stores the last triangle of the left child, which
/// [`refit_nodes`] wants again when the triangles have moved.
#[spirv(compute(threads(64)))]
pub fn refit_splits(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] total: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] splits: &mut [u32],
) {
    let node = thread_index(id);
    let i = node as usize;
    if node < total.x && i < nodes.len() && i < splits.len() {
        let left = nodes[i].left.index() as usize;
        let left_last = if left < nodes.len() {
            nodes[left].last
        } else {
            0
        };
        splits[i] = split_of(&nodes[i], left_last);
    }
}
