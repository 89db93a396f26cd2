//! Which binary nodes a wide one takes in.

use super::children::WideChildren;
use crate::build::node::Node;

/// Which children of a binary node a wide one takes in, in a word. It need not be found again for boxes that have moved.
///
/// ```text
/// bits 0–1  step 0: the place, counted from 1, of the inner child of two that gives way; 0 where none does
/// bits 2–3  step 1: the same of three
/// bits 4–7  a bit for each child of the wide node: whether it is an inner one
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Collapse(pub u32);

impl Collapse {
    /// Of a node without inner children.
    pub const NONE: Self = Self(0);

    /// The place of the child that gives way at a step, if any does: at step 0 of two, at step 1 of three.
    #[inline(always)]
    #[must_use]
    pub const fn place(self, step: u32) -> u32 {
        (self.0 >> ((2 * step) & 31)) & 3
    }

    /// How many of the wide node's first `end` children, at most 4, are inner ones.
    #[inline(always)]
    #[must_use]
    pub const fn inner_before(self, end: u32) -> u32 {
        (self.0 >> 4 & ((1 << (end & 7)) - 1)).count_ones()
    }

    /// How many children of the wide node are inner ones.
    #[inline(always)]
    #[must_use]
    pub const fn inner_count(self) -> u32 {
        self.inner_before(super::WIDTH as u32)
    }
}

/// One thread per binary node. Reads it and those below, as if a wide node began at it. Returns which of them that takes in.
/// Areas decide, so their products are shielded from fusing by `opaque_zero`.
#[inline]
#[must_use]
pub fn collapse(node: &Node, nodes: &[Node], opaque_zero: u32) -> Collapse {
    collapsed(node, nodes, opaque_zero).0
}

/// [`collapse`], and the children of the wide node ([`super::wide_children`]).
#[inline(always)]
#[must_use]
pub fn collapsed(node: &Node, nodes: &[Node], opaque_zero: u32) -> (Collapse, WideChildren) {
    let two = WideChildren::of(node);
    let first = two.largest(opaque_zero);
    if first == 0 {
        return (Collapse::NONE, two);
    }
    let three = two.opened(first, nodes);
    let second = three.largest(opaque_zero);
    let four = three.opened(second, nodes);
    let collapse = Collapse(first | second << 2 | four.inner() << 4);
    (collapse, four)
}
