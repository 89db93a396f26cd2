//! Where nodes and triangles come from: the plain tree, and the brute-force list that every tree must agree with.

use super::{Children, LeafRun, NodeSource, TriangleSource};
use crate::load;
use crate::node::{Node, NodeRef};
use crate::triangle::{LeafTriangle, Triangle};
use bytemuck::Zeroable;

/// Uncompressed nodes, the root first.
#[derive(Clone, Copy)]
pub struct PlainNodes<'a>(pub &'a [Node]);

impl NodeSource for PlainNodes<'_> {
    type Cursor = NodeRef;

    #[inline(always)]
    fn root(&self) -> NodeRef {
        if self.0.is_empty() {
            NodeRef::NOTHING
        } else {
            NodeRef::inner(0)
        }
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef) -> LeafRun {
        LeafRun {
            is_leaf: cursor.is_leaf(),
            first: cursor.first(),
            count: cursor.count(),
        }
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, axes: [u32; 3]) -> Children<NodeRef> {
        let node = load(self.0, cursor.index(), Node::EMPTY);
        let a = node.planes[axes[0] as usize % 3];
        let b = node.planes[axes[1] as usize % 3];
        let c = node.planes[axes[2] as usize % 3];
        Children {
            low: [[a[0], a[1]], [b[0], b[1]], [c[0], c[1]]],
            high: [[a[2], a[3]], [b[2], b[3]], [c[2], c[3]]],
            left: node.left,
            right: node.right,
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        // Every inner node once, and a leaf on both sides of each.
        3 * self.0.len() as u32 + 1
    }
}

/// No tree at all: one leaf with this many triangles.
#[derive(Clone, Copy)]
pub struct BruteForce(pub u32);

impl NodeSource for BruteForce {
    type Cursor = ();

    #[inline(always)]
    fn root(&self) {}

    #[inline(always)]
    fn leaf(&self, (): ()) -> LeafRun {
        LeafRun {
            is_leaf: true,
            first: 0,
            count: self.0,
        }
    }

    #[inline(always)]
    fn children(&self, (): (), _axes: [u32; 3]) -> Children<()> {
        Children {
            low: [[0.0; 2]; 3],
            high: [[0.0; 2]; 3],
            left: (),
            right: (),
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        1
    }
}

/// Triangles in leaf order.
#[derive(Clone, Copy)]
pub struct LeafTriangles<'a>(pub &'a [LeafTriangle]);

impl TriangleSource for LeafTriangles<'_> {
    #[inline(always)]
    fn triangle(&self, place: u32) -> Triangle {
        load(self.0, place, LeafTriangle::zeroed()).triangle()
    }

    #[inline(always)]
    fn primitive(&self, place: u32) -> u32 {
        load(self.0, place, LeafTriangle::zeroed()).primitive
    }
}
