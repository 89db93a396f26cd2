//! Where nodes and triangles come from: the plain tree, and the brute-force list that every tree must agree with.

use super::{Children, LeafRun, LeafSlot, NodeSource, Order, TriangleSource};
use crate::build::node::{Node, NodeRef};
use crate::geometry::planes::PlanePair;
use crate::geometry::ray::NO_PRIMITIVE;
use crate::geometry::triangle::LeafTriangle;

/// Uncompressed nodes, the root first.
#[derive(Clone, Copy)]
pub struct PlainNodes<'a>(pub &'a [Node]);

impl NodeSource for PlainNodes<'_> {
    type Cursor = NodeRef;
    type Node = Children<NodeRef>;
    type Bounds = ();

    const NOTHING: NodeRef = NodeRef::EMPTY_LEAF;

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) -> NodeRef {
        if self.0.is_empty() {
            NodeRef::EMPTY_LEAF
        } else {
            NodeRef::inner(0)
        }
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: NodeRef) -> bool {
        cursor.is_leaf()
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef, _axes: [u32; 3]) -> LeafRun<()> {
        LeafRun::of(cursor, ())
    }

    #[inline(always)]
    fn resume(&self, waited: NodeRef) -> NodeRef {
        waited
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, Order { axes, .. }: Order) -> Children<NodeRef> {
        // Rows are read where they lie: a node in registers could not be indexed by axis.
        let index = cursor.index() as usize;
        if index >= self.0.len() {
            return NO_CHILDREN;
        }
        let node = &self.0[index];
        Children {
            planes: [
                PlanePair::from_array(node.planes[axes[0] as usize % 3]),
                PlanePair::from_array(node.planes[axes[1] as usize % 3]),
                PlanePair::from_array(node.planes[axes[2] as usize % 3]),
            ],
            left: node.left,
            right: node.right,
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.0.len() as u32 + 1
    }
}

/// What an index out of range opens.
const NO_CHILDREN: Children<NodeRef> = Children {
    planes: [PlanePair::ZERO; 3],
    left: NodeRef::EMPTY_LEAF,
    right: NodeRef::EMPTY_LEAF,
};

/// No tree at all: one leaf with this many triangles.
#[derive(Clone, Copy)]
pub struct BruteForce(pub u32);

impl NodeSource for BruteForce {
    type Cursor = ();
    type Node = Children<()>;
    type Bounds = ();

    const NOTHING: () = ();

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) {}

    #[inline(always)]
    fn is_leaf(&self, (): ()) -> bool {
        true
    }

    #[inline(always)]
    fn leaf(&self, (): (), _axes: [u32; 3]) -> LeafRun<()> {
        LeafRun {
            first: 0,
            count: self.0,
            bounds: (),
        }
    }

    #[inline(always)]
    fn resume(&self, (): ()) {}

    #[inline(always)]
    fn children(&self, (): (), _order: Order) -> Children<()> {
        Children {
            planes: [PlanePair::ZERO; 3],
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

impl<F: Copy> TriangleSource<F> for LeafTriangles<'_> {
    #[inline(always)]
    fn corners(&self, slot: &LeafSlot<F>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let index = (slot.first + slot.number) as usize;
        if index >= self.0.len() {
            return [[0.0; 3]; 3];
        }
        let v = &self.0[index].vertices;
        let a = axes[0] as usize % 3;
        let b = axes[1] as usize % 3;
        let c = axes[2] as usize % 3;
        [
            [v[a], v[b], v[c]],
            [v[3 + a], v[3 + b], v[3 + c]],
            [v[6 + a], v[6 + b], v[6 + c]],
        ]
    }

    #[inline(always)]
    fn primitive(&self, slot: &LeafSlot<F>) -> u32 {
        let index = (slot.first + slot.number) as usize;
        if index < self.0.len() {
            self.0[index].primitive
        } else {
            NO_PRIMITIVE
        }
    }
}
