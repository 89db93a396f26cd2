//! What remains of a wide tree when its triangles move: which children its nodes have, and where they lie.

use super::super::sources::{LeafPlace, StoredNodes, StoredTriangles};
use super::super::stored::StoredTree;
use super::super::visitor::TreeVisitor;
use slimbvh_core::wide::WIDTH;
use slimbvh_core::{LeafTriangle, NodeRef};

/// A wide tree without boxes, and its triangles in the order of leaves.
#[derive(Debug, Default)]
pub struct WideShape {
    pub nodes: Vec<WideConnection>,
    pub triangles: Vec<LeafTriangle>,
}

/// A node without boxes.
#[derive(Clone, Copy, Debug, Default)]
pub struct WideConnection {
    /// The children, leaves by their triangles in the order of leaves.
    pub children: [NodeRef; WIDTH],
    /// How many there are.
    pub count: u32,
    /// The first triangle below.
    pub first: u32,
    /// The last one.
    pub last: u32,
    /// Where the first leaf's triangles are stored; `u32::MAX` without a leaf.
    pub place: u32,
}

impl StoredTree {
    /// The shape of a wide tree.
    pub fn wide_shape(&self) -> WideShape {
        self.visit(Shape)
    }
}

struct Shape;

impl TreeVisitor for Shape {
    type Output = WideShape;

    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) -> WideShape {
        let mut shape = WideShape {
            nodes: vec![WideConnection::default(); nodes.count()],
            triangles: Vec::new(),
        };
        shape.open((nodes, triangles), 0, &nodes.root_box());
        shape
    }
}

impl WideShape {
    /// Takes a node and all below it.
    fn open<N: StoredNodes, T: StoredTriangles<N>>(
        &mut self,
        from: (&N, &T),
        node: u32,
        bounds: &N::Box,
    ) {
        if node as usize >= self.nodes.len() {
            return;
        }
        let (nodes, triangles) = from;
        let opened = nodes.open(node, bounds);
        let first = self.triangles.len() as u32;
        let mut own = WideConnection {
            children: [NodeRef::EMPTY_LEAF; WIDTH],
            count: opened.count as u32,
            place: u32::MAX,
            first,
            last: 0,
        };
        for (to, (child, bounds)) in own.children.iter_mut().zip(opened.children()) {
            *to = *child;
            if child.is_leaf() {
                *to = NodeRef::leaf(self.triangles.len() as u32, child.count());
                own.place = own.place.min(child.first());
                let triangles = LeafPlace::all(*child).map(|at| triangles.triangle(at, bounds));
                self.triangles.extend(triangles);
            } else {
                self.open(from, child.index(), bounds);
            }
        }
        own.last = (self.triangles.len() as u32).saturating_sub(1);
        self.nodes[node as usize] = own;
    }
}
