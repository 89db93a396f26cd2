//! What a node's children are, in 62 bits.

use crate::build::node::{LEAF_SIZE, NodeRef};

/// The count of a child that is an inner node.
const INNER: u32 = 0;

/// The count of a child that is not there.
const EMPTY_LEAF: u32 = 7;
const _: () = assert!(LEAF_SIZE < EMPTY_LEAF);

const INDEX_BITS: u32 = 28;
const INDEX_MASK: u32 = (1 << INDEX_BITS) - 1;

/// A node's children, as they lie one after the other. A left child that is an inner node comes right before a right one, and
/// a left leaf's triangles right before a right one's: one index for both nodes, and one place for both leaves.
///
/// ```text
/// word 0   r lll iiiiiiii iiiiiiii iiiiiiii iiii   first child's index, 28 bits; left count; lowest bit of the right count
/// word 1   00 rr ffffffff ffffffff ffffffff ffff   where the first leaf's triangles begin, 28 bits; rest of the right count
/// ```
///
/// A count is that of a leaf's triangles, 0 for an inner node, 7 for no child at all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Links(pub [u32; 2]);

impl Links {
    /// Joins a plain node's children. `place` is where the data of [`Self::first_triangle`] begin.
    #[inline(always)]
    #[must_use]
    pub const fn new(left: NodeRef, right: NodeRef, place: u32) -> Self {
        let index = if !left.is_leaf() {
            left.index()
        } else if right.is_leaf() {
            0
        } else {
            right.index()
        };
        let (left, right) = (count_of(left), count_of(right));
        Self([
            (index & INDEX_MASK) | left << INDEX_BITS | right << 31,
            (place & INDEX_MASK) | (right >> 1) << INDEX_BITS,
        ])
    }

    /// The first triangle of a plain node's first child that is a leaf, 0 where none is.
    #[inline(always)]
    #[must_use]
    pub const fn first_triangle(left: NodeRef, right: NodeRef) -> u32 {
        if left.is_leaf() && left.count() > 0 {
            left.first()
        } else if right.is_leaf() && right.count() > 0 {
            right.first()
        } else {
            0
        }
    }

    /// Both children. A leaf's reference holds where its triangles begin; `stride` is how far one triangle of the left leaf
    /// is from the next.
    #[inline(always)]
    #[must_use]
    pub const fn children(self, stride: u32) -> [NodeRef; 2] {
        let [a, b] = self.0;
        let (index, first) = (a & INDEX_MASK, b & INDEX_MASK);
        let left_count = (a >> INDEX_BITS) & 7;
        let right_count = a >> 31 | ((b >> INDEX_BITS) & 3) << 1;
        let is_left_leaf = left_count != INNER;
        let left = child(left_count, index, first);
        let right_first = if is_left_leaf && left_count != EMPTY_LEAF {
            first + left_count * stride
        } else {
            first
        };
        let right = child(right_count, index + (!is_left_leaf) as u32, right_first);
        [left, right]
    }
}

#[inline(always)]
const fn count_of(child: NodeRef) -> u32 {
    if !child.is_leaf() {
        INNER
    } else if child.count() == 0 {
        EMPTY_LEAF
    } else {
        child.count()
    }
}

#[inline(always)]
const fn child(count: u32, index: u32, first: u32) -> NodeRef {
    if count == INNER {
        NodeRef::inner(index)
    } else if count == EMPTY_LEAF {
        NodeRef::EMPTY_LEAF
    } else {
        NodeRef::leaf(first & INDEX_MASK, count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn counts() -> impl Strategy<Value = u32> {
        0..=LEAF_SIZE
    }

    proptest! {
        /// Children as the topology places them.
        #[test]
        fn children_come_back(left in counts(), right in counts(), index in 0..INDEX_MASK, first in 0..INDEX_MASK - 100, stride in 1u32..11) {
            let left = if left == 0 { NodeRef::inner(index) } else { NodeRef::leaf(first, left) };
            let right = match right {
                0 => NodeRef::inner(index + u32::from(!left.is_leaf())),
                _ if left.is_leaf() => NodeRef::leaf(first + left.count(), right),
                _ => NodeRef::leaf(first, right),
            };
            let triangle = Links::first_triangle(left, right);
            let links = Links::new(left, right, triangle);
            prop_assert_eq!(links.0[1] >> 30, 0);
            prop_assert_eq!(links.children(1), [left, right]);

            // How many places each triangle takes.
            let has_leaf = left.is_leaf() || right.is_leaf();
            prop_assert_eq!(triangle, if has_leaf { first } else { 0 });
            let links = Links::new(left, right, 5);
            let [a, b] = links.children(stride);
            for (child, expected) in [(a, left), (b, right)] {
                if expected.is_leaf() {
                    prop_assert_eq!(child, NodeRef::leaf((expected.first() - first) * stride + 5, expected.count()));
                } else {
                    prop_assert_eq!(child, expected);
                }
            }
        }
    }

    #[test]
    fn what_is_not_there_comes_back() {
        let links = Links::new(NodeRef::leaf(0, 3), NodeRef::EMPTY_LEAF, 0);
        assert_eq!(
            links.children(1),
            [NodeRef::leaf(0, 3), NodeRef::EMPTY_LEAF]
        );
        let links = Links::new(NodeRef::EMPTY_LEAF, NodeRef::EMPTY_LEAF, 0);
        assert_eq!(links.children(1), [NodeRef::EMPTY_LEAF; 2]);
    }
}
