//! obvhs' compressed tree of eight children a node, in its own 80 bytes: Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray
//! Traversal on GPUs Through Compressed Wide BVHs", section 3.

use super::{PeerTree, Walk, woop};
use anyhow::{Result, ensure};
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::node::CwBvhNode;
use obvhs::triangle::Triangle;
use rayon::prelude::*;

const _: () = assert!(size_of::<CwBvhNode>() == 80);

/// Converts a tree over triangles in leaf order.
///
/// # Errors
/// If the tree is empty.
pub fn convert(bvh: &CwBvh, leaf_triangles: &[Triangle]) -> Result<PeerTree> {
    ensure!(!bvh.nodes.is_empty(), "the tree is empty");
    let bytes: &[u8] = bytemuck::cast_slice(&bvh.nodes);
    Ok(PeerTree {
        walk: Walk::Cwbvh,
        nodes: bytemuck::pod_collect_to_vec(bytes),
        triangles: leaf_triangles
            .par_iter()
            .flat_map_iter(woop::rows)
            .collect(),
        numbers: bvh.primitive_indices.clone(),
        // At most one group of each node on the way waits.
        stack_rows: depth(bvh),
    })
}

/// Nodes from the root to the deepest one.
fn depth(bvh: &CwBvh) -> u32 {
    let mut deepest = 0;
    let mut pending = vec![(0, 1)];
    while let Some((node, depth)) = pending.pop() {
        deepest = deepest.max(depth);
        let CwBvhNode {
            imask,
            child_base_idx,
            ..
        } = bvh.nodes[node as usize];
        let children = 0..imask.count_ones();
        pending.extend(children.map(|child| (child_base_idx + child, depth + 1)));
    }
    deepest
}
