//! Triangles near a box, found with the tree.

use super::contact::touch;
use crate::Bvh;
use slimbvh_core::trace::STACK_SIZE;
use slimbvh_core::{Aabb, LeafTriangle, NodeRef};
use std::ops::ControlFlow;

/// Visits every triangle whose box touches a region, at the tree's magnitude, until the visitor stops. Adds the nodes opened
/// and the boxes of triangles compared to `steps`.
pub(super) fn for_each_within(
    bvh: &Bvh,
    region: &Aabb,
    steps: &mut u64,
    mut visit: impl FnMut(&LeafTriangle) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let (nodes, triangles) = (bvh.nodes(), bvh.leaf_triangles());
    if nodes.is_empty() {
        return ControlFlow::Continue(());
    }
    let mut stack = [NodeRef::EMPTY_LEAF; STACK_SIZE + 1];
    stack[0] = NodeRef::inner(0);
    let mut count = 1;
    while count > 0 {
        count -= 1;
        let cursor = stack[count];
        if cursor.is_leaf() {
            let first = cursor.first() as usize;
            *steps += u64::from(cursor.count());
            for triangle in &triangles[first..first + cursor.count() as usize] {
                if touch(&triangle.triangle().bounds(), region) {
                    visit(triangle)?;
                }
            }
        } else {
            *steps += 1;
            // Both children may wait: one entry a level, plus one.
            let node = &nodes[cursor.index() as usize];
            for (child, bounds) in [(node.left, node.left_box()), (node.right, node.right_box())] {
                if touch(&bounds, region) {
                    stack[count] = child;
                    count += 1;
                }
            }
        }
    }
    ControlFlow::Continue(())
}
