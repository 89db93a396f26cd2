//! obvhs' binary tree in nodes of 64 bytes with the boxes of both children: Aila and Laine 2009, "Understanding the Efficiency of
//! Ray Traversal on GPUs", section 3.

use super::{PeerTree, Walk, woop};
use anyhow::{Result, ensure};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::triangle::Triangle;
use rayon::prelude::*;

/// Rows of 16 bytes a node.
const NODE_ROWS: u32 = 4;

/// Marks a reference to triangles.
const LEAF: u32 = 1 << 31;

/// Triangles of a leaf, at most.
const MOST_IN_LEAF: u32 = 8;

/// Children after the place of their parent's reference: inner nodes in depth-first order, first child first.
struct Pending {
    /// The inner node in obvhs' list.
    node: u32,
    /// The row that gets its reference, and the component there; `None` for the root.
    to: Option<(usize, usize)>,
    /// Inner nodes from the root to it.
    depth: u32,
}

/// Converts a tree over triangles in leaf order.
///
/// # Errors
/// If the tree is empty, a leaf has more than 8 triangles, or there are more than 2^28 triangles or 2^29 nodes.
pub fn convert(bvh: &Bvh2, leaf_triangles: &[Triangle]) -> Result<PeerTree> {
    ensure!(!bvh.nodes.is_empty(), "the tree is empty");
    ensure!(
        leaf_triangles.len() <= 1 << 28 && bvh.nodes.len() <= 1 << 29,
        "references are too short for {} triangles",
        leaf_triangles.len()
    );
    let node = |index: u32| &bvh.nodes[index as usize];
    let mut rows = Vec::with_capacity(bvh.nodes.len() / 2 * NODE_ROWS as usize);
    let mut deepest = 1;
    if node(0).is_leaf() {
        // A root with one child: no ray meets the other one's box.
        let nowhere = Aabb::new(glam::Vec3A::INFINITY, glam::Vec3A::NEG_INFINITY);
        push_boxes(&mut rows, node(0).aabb(), &nowhere);
        let leaf = leaf_reference(node(0))?;
        rows.push([leaf, leaf, 0, 0]);
    } else {
        let root = Pending {
            node: 0,
            to: None,
            depth: 1,
        };
        let mut pending = vec![root];
        while let Some(Pending {
            node: at,
            to,
            depth,
        }) = pending.pop()
        {
            deepest = deepest.max(depth);
            let first_row = rows.len();
            if let Some((row, component)) = to {
                rows[row][component] = first_row as u32;
            }
            let children = [0, 1].map(|side| node(at).first_index + side);
            let [first, second] = children.map(node);
            push_boxes(&mut rows, first.aabb(), second.aabb());
            rows.push([0; 4]);
            let last = rows.len() - 1;
            for component in [1, 0] {
                let child = node(children[component]);
                if child.is_leaf() {
                    rows[last][component] = leaf_reference(child)?;
                } else {
                    pending.push(Pending {
                        node: children[component],
                        to: Some((last, component)),
                        depth: depth + 1,
                    });
                }
            }
        }
    }
    Ok(PeerTree {
        walk: Walk::AilaLaine,
        nodes: rows,
        triangles: leaf_triangles
            .par_iter()
            .flat_map_iter(woop::rows)
            .collect(),
        numbers: bvh.primitive_indices.clone(),
        // One child of each inner node on the way, and what ends the walk.
        stack_rows: deepest + 1,
    })
}

fn push_boxes(rows: &mut Vec<[u32; 4]>, a: &Aabb, b: &Aabb) {
    let boxes = [
        [a.min.x, a.max.x, a.min.y, a.max.y],
        [b.min.x, b.max.x, b.min.y, b.max.y],
        [a.min.z, a.max.z, b.min.z, b.max.z],
    ];
    rows.extend(boxes.map(|row| row.map(f32::to_bits)));
}

fn leaf_reference(leaf: &Bvh2Node) -> Result<u32> {
    let (first, count) = (leaf.first_index, leaf.prim_count);
    ensure!(
        (1..=MOST_IN_LEAF).contains(&count),
        "a leaf has {count} triangles"
    );
    Ok(LEAF | first << 3 | (count - 1))
}
