//! Wide nodes over triangles on the lattice, in both stores.

use super::lattice_leaf::LeafCorner;
use super::packed_wide_node::PackedWideNode;
use super::rounded_children::RoundedChildren;
use super::wide_links::WideLinks;
use super::wide_node::WideNode;
use crate::geometry::lattice::LatticeBox;

/// A wide node whose leaves hold triangles on the lattice.
pub trait MixedWideNode: Copy {
    /// One thread per wide node. Takes its children. Its links are not filled in yet.
    fn encode(from: &RoundedChildren) -> Self;

    /// What the children are; runs begin at 0. Takes the children that the node was encoded from.
    fn mixed_links(&self, from: &RoundedChildren) -> WideLinks;

    /// The node with these links.
    #[must_use]
    fn with_mixed_links(self, links: WideLinks) -> Self;

    /// A child's box, decoded, in steps.
    fn decoded(&self, child: u32, step_exponent: i32) -> LatticeBox;

    /// What the triangles of a leaf are encoded with.
    #[inline(always)]
    fn corner(&self, links: WideLinks, child: u32, step_exponent: i32) -> LeafCorner {
        LeafCorner {
            min: self.decoded(child, step_exponent).min,
            words: links.triangle_words(child),
        }
    }
}

impl MixedWideNode for WideNode {
    #[inline(always)]
    fn encode(from: &RoundedChildren) -> Self {
        Self::new(from, 0)
    }

    #[inline(always)]
    fn mixed_links(&self, from: &RoundedChildren) -> WideLinks {
        self.links(from)
    }

    #[inline(always)]
    fn with_mixed_links(self, links: WideLinks) -> Self {
        self.linked(links)
    }

    #[inline(always)]
    fn decoded(&self, child: u32, step_exponent: i32) -> LatticeBox {
        self.child_box(child, step_exponent)
    }
}

impl MixedWideNode for PackedWideNode {
    #[inline(always)]
    fn encode(from: &RoundedChildren) -> Self {
        Self::new(from)
    }

    #[inline(always)]
    fn mixed_links(&self, _: &RoundedChildren) -> WideLinks {
        self.links()
    }

    #[inline(always)]
    fn with_mixed_links(self, links: WideLinks) -> Self {
        self.linked(links)
    }

    #[inline(always)]
    fn decoded(&self, child: u32, step_exponent: i32) -> LatticeBox {
        self.child_box(child, step_exponent)
    }
}
