//! From the root down: where nodes and triangles come.
//!
//! They are numbered as `topology` numbers them. In the order of the leaves, below a node come first all nodes on its left,
//! the left child as the last of them, then the right child and all below it. So the places of a node's children follow from
//! where its run begins and how many nodes its parts have.

use super::{DEEPENING_ROUNDS, Merges, ROUNDS, Size};
use crate::build::node::{Node, NodeRef};

/// Steps from the root to a triangle, at most.
const STEPS: u32 = ROUNDS + DEEPENING_ROUNDS;

/// A cluster in its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Place {
    /// Its number.
    pub id: u32,
    /// Its first triangle, in leaf order.
    pub first_triangle: u32,
    /// The first of the nodes below it.
    pub first_node: u32,
}

impl Place {
    /// The last merge's, whose node is the first.
    #[inline(always)]
    #[must_use]
    pub const fn root(triangle_count: u32) -> Self {
        Self {
            id: (2 * triangle_count).wrapping_sub(2),
            first_triangle: 0,
            first_node: 1,
        }
    }
}

/// What is at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct PlacedNode {
    /// The node, without boxes.
    pub node: Node,
    /// The last triangle of its left child.
    pub split: u32,
    /// Its left child's place.
    pub left: Place,
    /// Its right child's place.
    pub right: Place,
    /// How much is in the left child.
    pub in_left: Size,
    /// How much is in the right child.
    pub in_right: Size,
}

/// Reads a merge and its children's sizes. Returns its node and where the children are.
#[inline(always)]
#[must_use]
pub fn open(place: Place, merges: &Merges) -> PlacedNode {
    let merged = merges.merged(place.id);
    let (left, right) = (merges.size(merged.left), merges.size(merged.right));
    let middle_triangle = place.first_triangle + left.triangles;
    let middle_node = place.first_node + left.nodes;
    PlacedNode {
        node: Node {
            left: if left.nodes > 0 {
                NodeRef::inner(middle_node.wrapping_sub(1))
            } else {
                NodeRef::leaf(place.first_triangle, left.triangles)
            },
            right: if right.nodes > 0 {
                NodeRef::inner(middle_node)
            } else {
                NodeRef::leaf(middle_triangle, right.triangles)
            },
            first: place.first_triangle,
            last: (middle_triangle + right.triangles).wrapping_sub(1),
            ..Node::EMPTY
        },
        split: middle_triangle.wrapping_sub(1),
        left: Place {
            id: merged.left,
            ..place
        },
        right: Place {
            id: merged.right,
            first_triangle: middle_triangle,
            first_node: middle_node + 1,
        },
        in_left: left,
        in_right: right,
    }
}

/// One thread per node. Walks from the root. Returns node `i`, without boxes, and the last triangle of its left child. For
/// more than [`crate::build::node::LEAF_SIZE`] triangles.
#[inline]
#[must_use]
pub fn node_at(i: u32, merges: &Merges) -> (Node, u32) {
    let mut own = 0;
    let mut found = open(Place::root(merges.triangle_count), merges);
    for _ in 0..STEPS {
        if own == i {
            break;
        }
        // Where the right child is, or would be.
        let middle = found.right.first_node.wrapping_sub(1);
        let (child, place) = if i < middle {
            (middle.wrapping_sub(1), found.left)
        } else {
            (middle, found.right)
        };
        own = child;
        found = open(place, merges);
    }
    (found.node, found.split)
}

/// One thread per triangle, in leaf order. Walks from the root. Returns which it is, in the order of the curve.
#[inline]
#[must_use]
pub fn triangle_at(i: u32, merges: &Merges) -> u32 {
    let mut place = Place::root(merges.triangle_count);
    for _ in 0..STEPS {
        if place.id < merges.triangle_count {
            break;
        }
        let found = open(place, merges);
        place = if i <= found.split {
            found.left
        } else {
            found.right
        };
    }
    place.id
}
