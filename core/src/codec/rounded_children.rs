//! The children of a wide node on a lattice: what its nodes on the lattice are encoded from.

use crate::build::node::NodeRef;
use crate::build::wide::{WIDTH, WideChildren, placed};
use crate::geometry::aabb::Aabb;
use crate::geometry::lattice::LatticeBox;

/// The children of a wide node, whose boxes are the smallest on a lattice that hold the plain ones.
#[derive(Clone, Copy, Debug)]
pub struct RoundedChildren {
    /// What the children are in the binary tree.
    pub nodes: [NodeRef; WIDTH],
    /// Their boxes, in steps: at most `2^24` from zero.
    pub boxes: [LatticeBox; WIDTH],
    /// The first `count` children are there; the others mean nothing.
    pub count: u32,
    /// The lattice's step is two to this power, in the scene's magnitude.
    pub step_exponent: i32,
}

impl RoundedChildren {
    /// The children on the lattice whose step is two to this power, of which their coordinates are at most `2^24`.
    #[inline(always)]
    #[must_use]
    pub fn new(from: &WideChildren, step_exponent: i32) -> Self {
        let [a, b, c, d] = from.children();
        let around = |bounds: Aabb| LatticeBox::around(&bounds, step_exponent);
        Self {
            nodes: from.nodes(),
            boxes: [
                around(a.bounds()),
                around(b.bounds()),
                around(c.bounds()),
                around(d.bounds()),
            ],
            count: from.count,
            step_exponent,
        }
    }

    /// The children with inner ones side by side from a place on, and leaves as they are.
    #[inline(always)]
    #[must_use]
    pub fn placed(&self, first_child: u32) -> [NodeRef; WIDTH] {
        placed(self.nodes, self.count, first_child)
    }
}
