//! Trees that begin anywhere in lists of nodes and triangles.

use super::{Fork, LeafRun, NodeSource, Order};
use crate::build::node::NodeRef;
use crate::geometry::planes::PlanePair;

/// Nodes that begin behind those of other trees in the same list, and whose leaves' triangles do. Links count from the tree's own
/// beginning.
#[derive(Clone, Copy)]
pub struct Based<N> {
    /// The list.
    pub list: N,
    /// Where the tree's nodes begin.
    pub first_node: u32,
    /// Where its triangles begin, in the unit of leaves' links.
    pub first_triangle: u32,
}

impl<N> Based<N> {
    /// An inner node, counted from the list's beginning.
    #[inline(always)]
    const fn in_list(&self, cursor: NodeRef) -> NodeRef {
        NodeRef(cursor.0.wrapping_add(self.first_node))
    }
}

impl<N: NodeSource<Cursor = NodeRef>> NodeSource for Based<N> {
    type Cursor = NodeRef;
    type Node = N::Node;
    type Bounds = N::Bounds;

    const NOTHING: NodeRef = N::NOTHING;
    const TESTS_ROOT: bool = N::TESTS_ROOT;

    #[inline(always)]
    fn root(&self, axes: [u32; 3]) -> NodeRef {
        self.list.root(axes)
    }

    #[inline(always)]
    fn root_planes(&self, axes: [u32; 3]) -> [PlanePair; 3] {
        self.list.root_planes(axes)
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: NodeRef) -> bool {
        // The second comparison is that of the access in `children`, which then needs no other. A leaf's sum may wrap.
        self.list.is_leaf(cursor) | self.list.is_leaf(self.in_list(cursor))
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef, axes: [u32; 3]) -> LeafRun<N::Bounds> {
        // What a leaf's cursor says of nodes, `children` has said: it counts from the list's beginning.
        let run = self.list.leaf(cursor, axes);
        LeafRun {
            first: run.first.wrapping_add(self.first_triangle),
            ..run
        }
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, order: Order) -> N::Node {
        self.list.children(self.in_list(cursor), order)
    }

    #[inline(always)]
    fn resume(&self, waited: <N::Node as Fork>::Waiting) -> NodeRef {
        self.list.resume(waited)
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.list.step_limit()
    }
}
