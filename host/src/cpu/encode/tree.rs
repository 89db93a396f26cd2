//! A tree to be coded, and its division among threads.

use slimbvh_core::refit::split_of;
use slimbvh_core::{LeafTriangle, Node, NodeRef};

/// Nodes with fewer triangles are coded on one thread.
pub(in crate::cpu) const TASK: u32 = 8192;

/// A tree to be coded.
pub(in crate::cpu) struct Tree<'a> {
    pub(in crate::cpu) nodes: &'a [Node],
    pub(super) leaves: &'a [LeafTriangle],
}

impl Tree<'_> {
    /// A node.
    pub(super) fn node(&self, index: u32) -> Node {
        self.nodes[index as usize]
    }

    /// The last triangle of a node's left child.
    fn split(&self, node: &Node) -> u32 {
        let left = self.nodes.get(node.left.index() as usize);
        split_of(node, left.map_or(0, |left| left.last))
    }
}

/// A node to be coded, and the parts of the lists that it and its descendants fill.
pub(super) struct Part<'a, N, T, B> {
    pub(super) node: u32,
    pub(super) bounds: B,
    pub(super) nodes: &'a mut [N],
    pub(super) first_node: usize,
    pub(super) triangles: &'a mut [T],
    pub(super) first_triangle: usize,
    /// The entries of the list that each triangle takes, if that is the same for all.
    pub(super) per_triangle: usize,
}

impl<'a, N, T, B> Part<'a, N, T, B> {
    /// The children's parts. `place_of` returns where a triangle's entries begin.
    pub(super) fn split(
        self,
        tree: &Tree,
        [left, right]: [B; 2],
        place_of: impl Fn(u32) -> usize,
    ) -> [Self; 2] {
        let node = &tree.nodes[self.node as usize];
        // The right child is the first of its part.
        let middle = if node.right.is_leaf() {
            self.first_node + self.nodes.len()
        } else {
            node.right.index() as usize
        };
        let triangle = tree.split(node).wrapping_add(1);
        let (left_nodes, right_nodes) = self.nodes.split_at_mut(middle - self.first_node);
        let middle_triangle = if self.triangles.is_empty() {
            self.first_triangle
        } else {
            place_of(triangle)
        };
        let (triangles, per_triangle) = (self.triangles, self.per_triangle);
        let (left_triangles, right_triangles) =
            triangles.split_at_mut(middle_triangle - self.first_triangle);
        let part = |child: NodeRef, bounds, nodes, first_node, triangles, first_triangle| Self {
            node: child.0,
            bounds,
            nodes,
            first_node,
            triangles,
            first_triangle,
            per_triangle,
        };
        [
            part(
                node.left,
                left,
                left_nodes,
                self.first_node,
                left_triangles,
                self.first_triangle,
            ),
            part(
                node.right,
                right,
                right_nodes,
                middle,
                right_triangles,
                middle_triangle,
            ),
        ]
    }
}

/// Codes both children, in parallel if that pays.
pub(super) fn both<P: Send>(node: &Node, [left, right]: [P; 2], code: impl Fn(P) + Sync) {
    if node.last - node.first < TASK {
        code(left);
        code(right);
    } else {
        crate::parallel::join(|| code(left), || code(right));
    }
}
