//! Wide nodes over triangles on the lattice, in both stores.

use super::lattice_leaf::LeafCorner;
use super::packed_wide_node::PackedWideNode;
use super::rounded_children::RoundedChildren;
use super::wide_node::WideNode;
use crate::build::wide::WIDTH;

/// A wide node whose leaves hold triangles on the lattice.
pub trait MixedWideNode: Copy {
    /// Whether corners that a leaf's triangles share are stored once.
    const SHARES_CORNERS: bool;

    /// One thread per wide node. Takes its children, and how many corners each has that is a leaf, where they are shared. Returns the
    /// node, whose inner children and whose leaves' words begin at 0, and how many words these are.
    fn encode(from: &RoundedChildren, corner_counts: [u32; WIDTH]) -> (Self, u32);

    /// The node whose inner children begin at this place, and its leaves' words at this one, where they began at 0. Its children are
    /// the first `count`.
    #[must_use]
    fn placed(self, count: u32, first_child: u32, first_word: u32) -> Self;

    /// Where a leaf's words begin.
    fn first_word(&self, child: u32) -> u32;

    /// What the triangles of a leaf are encoded with.
    fn corner(&self, child: u32, step_exponent: i32) -> LeafCorner;
}

impl MixedWideNode for WideNode {
    const SHARES_CORNERS: bool = false;

    #[inline(always)]
    fn encode(from: &RoundedChildren, _: [u32; WIDTH]) -> (Self, u32) {
        Self::new(from, 0).over_words(from)
    }

    #[inline(always)]
    fn placed(self, count: u32, first_child: u32, first_word: u32) -> Self {
        self.moved(count, first_child, first_word)
    }

    #[inline(always)]
    fn first_word(&self, child: u32) -> u32 {
        self.children[child as usize & 3].first()
    }

    #[inline(always)]
    fn corner(&self, child: u32, step_exponent: i32) -> LeafCorner {
        LeafCorner::of(&self.child_box(child, step_exponent))
    }
}

impl MixedWideNode for PackedWideNode {
    const SHARES_CORNERS: bool = true;

    #[inline(always)]
    fn encode(from: &RoundedChildren, corner_counts: [u32; WIDTH]) -> (Self, u32) {
        let node = Self::new(from, corner_counts);
        (node, node.links().word_count())
    }

    #[inline(always)]
    fn placed(self, _: u32, first_child: u32, first_word: u32) -> Self {
        self.linked(self.links().at(first_child, first_word))
    }

    #[inline(always)]
    fn first_word(&self, child: u32) -> u32 {
        self.links().child(child).first()
    }

    #[inline(always)]
    fn corner(&self, child: u32, step_exponent: i32) -> LeafCorner {
        LeafCorner {
            min: self.child_box(child, step_exponent).min,
            words: self.links().width().words(),
        }
    }
}
