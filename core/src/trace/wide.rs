//! Wide nodes as the walk sees them: up to four children, tested at once.

use super::Fork;
use super::stack::Enter;
use super::wide_stack::{ListStack, OwnRows, WideStack};
use crate::build::node::NodeRef;
use crate::geometry::slab::FourPlanes;

/// The largest number of wide nodes in a tree on a GPU: a word names a node and the children of it that wait.
pub const MOST_WIDE_NODES: u32 = 1 << 23;

/// A child of a wide node, by the node's index and its number. It is named so while it waits, as its box is decoded from the node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WideRef(pub u32);

impl WideRef {
    /// A child of a node.
    #[inline(always)]
    #[must_use]
    pub const fn new(node: u32, child: u32) -> Self {
        Self(node << 2 | child & 3)
    }

    /// The node.
    #[inline(always)]
    #[must_use]
    pub const fn node(self) -> u32 {
        self.0 >> 2
    }

    /// The child's number, 0 to 3.
    #[inline(always)]
    #[must_use]
    pub const fn child(self) -> u32 {
        self.0 & 3
    }

    /// As a leaf that is walked to, where its triangles are decoded from its box.
    #[inline(always)]
    #[must_use]
    pub const fn leaf(self) -> NodeRef {
        NodeRef(LEAF | self.0)
    }

    /// The child that a leaf's cursor names.
    #[inline(always)]
    #[must_use]
    pub const fn of_leaf(cursor: NodeRef) -> Self {
        Self(cursor.0 & !LEAF)
    }
}

const LEAF: u32 = NodeRef::EMPTY_LEAF.0;
const _: () = assert!(WideRef::new(MOST_WIDE_NODES - 1, 3).0 < LEAF);

/// A wide node, opened. Children's planes lie side by side, a lane a child; lanes without a child hold a box that no ray meets by its
/// first and second planes.
#[derive(Clone, Copy)]
pub struct WideFork<P> {
    /// On each axis, in the rays' order, the lower planes; where rays are reversed there, the upper ones.
    pub first: [P; 3],
    /// The others.
    pub second: [P; 3],
    /// The node's index.
    pub node: u32,
    /// How many children there are.
    pub count: u32,
}

impl<P: FourPlanes> Fork for WideFork<P> {
    type Cursor = NodeRef;
    type Waiting = WideRef;
    type Stack<E: Enter> = WideStack<E>;
    type PrivateStack = ListStack<OwnRows>;

    #[inline(always)]
    fn child_count(&self) -> u32 {
        self.count
    }
}

/// How many of four references are children: those that are not there come last.
#[inline(always)]
#[must_use]
pub const fn child_count(children: [u32; 4]) -> u32 {
    let [a, b, c, d] = children;
    (a != LEAF) as u32 + (b != LEAF) as u32 + (c != LEAF) as u32 + (d != LEAF) as u32
}
