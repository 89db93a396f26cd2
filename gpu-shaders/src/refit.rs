//! Stage `refit`. A dispatch makes seven levels of the pyramid: a workgroup makes its part of them in its own memory.

use crate::group::barrier;
use crate::{group_index, thread_index};
use glam::{UVec3, UVec4};
use slimbvh_core::launch::LANES;
use slimbvh_core::refit::{
    GROUP_LEVELS, Level, PyramidBox, group_bounds, pair_place, pair_step, parent_bounds,
    refit_node, split_of,
};
use slimbvh_core::{LeafTriangle, Node};
use spirv_std_macros::spirv;

/// One workgroup per LANES entries of level 0. Reads their triangles in leaf order. Stores the boxes of that level and of
/// the next six.
#[spirv(compute(threads(64)))]
pub fn refit_groups(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] pyramid: &mut [PyramidBox],
    #[spirv(workgroup)] boxes: &mut [PyramidBox; LANES],
) {
    let group = group_index(group);
    let level = Level::lowest(triangles.len() as u32);
    let own = group_bounds(group * LANES as u32 + lane, triangles);
    store_levels(group, lane, level, own, boxes, pyramid);
}

/// One workgroup per LANES entries of the level above one that is there. Reads that level; `params` is where it begins in
/// the pyramid and how many entries it has. Stores the boxes of the next seven levels.
#[spirv(compute(threads(64)))]
pub fn refit_parents(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] pyramid: &mut [PyramidBox],
    #[spirv(workgroup)] boxes: &mut [PyramidBox; LANES],
) {
    let below = Level {
        begin: params.x,
        count: params.y,
    };
    let group = group_index(group);
    let level = below.above();
    let entry = group * LANES as u32 + lane;
    let own = if entry < level.count {
        parent_bounds(entry, below, pyramid)
    } else {
        PyramidBox::EMPTY
    };
    store_levels(group, lane, level, own, boxes, pyramid);
}

/// Stores each lane's own box in a level, and the boxes of all levels above it that a workgroup can make of them.
#[inline(always)]
fn store_levels(
    group: u32,
    lane: u32,
    lowest: Level,
    own: PyramidBox,
    boxes: &mut [PyramidBox; LANES],
    pyramid: &mut [PyramidBox],
) {
    boxes[lane as usize % LANES] = own;
    store_entry(group * LANES as u32 + lane, lowest, own, pyramid);
    let mut level = lowest;
    let mut distance = 1;
    for _ in 1..GROUP_LEVELS {
        barrier();
        level = level.above();
        let lanes = LANES as u32 / 2 / distance;
        if lane < lanes {
            let bounds = pair_step(lane, distance, boxes);
            boxes[pair_place(lane, distance) as usize % LANES] = bounds;
            store_entry(group * lanes + lane, level, bounds, pyramid);
        }
        distance *= 2;
    }
}

/// Stores an entry of a level, if the level has it.
#[inline(always)]
fn store_entry(entry: u32, level: Level, bounds: PyramidBox, pyramid: &mut [PyramidBox]) {
    let to = (level.begin + entry) as usize;
    if entry < level.count && to < pyramid.len() {
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
