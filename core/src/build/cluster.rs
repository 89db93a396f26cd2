//! Stage `cluster`: a tree from the leaves up. Neighbours along the curve that suit each other best are merged, in rounds,
//! until one cluster is left (Meister and Bittner 2018, "Parallel Locally-Ordered Clustering for Bounding Volume Hierarchy
//! Construction"; as in Benthin et al. 2022, "PLOC++", with one scan a round).
//!
//! Clusters are numbered: the triangles in the order of the curve come first, then each merge. A round looks at the list of
//! clusters that are left, in order: [`merging_pairs`] says which of its pairs of neighbours merge, a scan numbers them,
//! and [`merge`] makes their clusters. Of a pair, the left place goes to the new cluster, and the list closes up.
//! [`open`] then numbers nodes and triangles as `topology` does, so that all later stages need not know.
//!
//! **Rounds are bounded.** In a round that merges by choice the cheapest of all pairs merges, so one cluster goes, but no
//! more where costs rise all along the curve. So a round that has as many clusters as halving can just bring to one by the
//! last round, merges every second pair, whatever it costs: `⌈log₂ count⌉ <= ROUNDS − round` holds from the first
//! round to the last.
//!
//! **Depth is bounded.** A merge puts one node above two. Rotating it may put one of its two children a step deeper, which
//! is allowed in the first [`DEEPENING_ROUNDS`] only: [`depth_bound`].

mod merge;
mod place;

pub use merge::{Change, Merge, Rotated, merge, rotate};
pub use place::{Place, PlacedNode, node_at, open, triangle_at};

use crate::build::node::LEAF_SIZE;
use crate::build::refit::{PyramidBox, WideBox};
use crate::geometry::orientation::product;
use crate::geometry::triangle::LeafTriangle;
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// Rounds at most.
pub const ROUNDS: u32 = 84;

/// Rounds in which a merge may put what it merges two steps down.
pub const DEEPENING_ROUNDS: u32 = 42;

const _: () = assert!(crate::MAX_TRIANGLES.ilog2() <= ROUNDS);

/// No cluster.
pub const NO_CLUSTER: u32 = u32::MAX;

/// Two clusters in one, with both boxes side by side as in a node. 64 bytes, one cache line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct Merged {
    /// Bytes 0–11: the first one's smallest coordinates.
    pub left_min: [f32; 3],
    /// Bytes 12–15: its number.
    pub left: u32,
    /// Bytes 16–27: its largest coordinates.
    pub left_max: [f32; 3],
    /// Bytes 28–31: the second one's number.
    pub right: u32,
    /// Bytes 32–43: its smallest coordinates.
    pub right_min: [f32; 3],
    /// Bytes 44–47: how many triangles are in both.
    pub triangles: u32,
    /// Bytes 48–59: the second one's largest coordinates.
    pub right_max: [f32; 3],
    /// Bytes 60–63: how many nodes with more than [`LEAF_SIZE`] triangles are in both, their own among them.
    pub nodes: u32,
}

const _: () = assert!(size_of::<Merged>() == 64);

/// How much is in a cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Size {
    /// Triangles.
    pub triangles: u32,
    /// Nodes with more than [`LEAF_SIZE`] triangles, its own among them.
    pub nodes: u32,
}

impl Size {
    /// A triangle's.
    const TRIANGLE: Self = Self {
        triangles: 1,
        nodes: 0,
    };
}

/// All merges that there are. Their numbers follow those of the triangles.
#[derive(Clone, Copy)]
pub struct Merges<'a> {
    /// The merges.
    pub merges: &'a [Merged],
    /// How many triangles.
    pub triangle_count: u32,
}

impl Merges<'_> {
    /// How much is in a cluster.
    #[inline(always)]
    #[must_use]
    pub fn size(&self, id: u32) -> Size {
        if id < self.triangle_count {
            Size::TRIANGLE
        } else {
            self.merged(id).size()
        }
    }

    /// A cluster that is no triangle.
    #[inline(always)]
    #[must_use]
    pub fn merged(&self, id: u32) -> Merged {
        crate::load(
            self.merges,
            id.wrapping_sub(self.triangle_count),
            Merged::NONE,
        )
    }
}

impl Merged {
    const NONE: Self = Self {
        left_min: [0.0; 3],
        left: 0,
        left_max: [0.0; 3],
        right: 0,
        right_min: [0.0; 3],
        triangles: 1,
        right_max: [0.0; 3],
        nodes: 0,
    };

    /// How much is in it.
    #[inline(always)]
    #[must_use]
    pub const fn size(&self) -> Size {
        Size {
            triangles: self.triangles,
            nodes: self.nodes,
        }
    }
}

/// The clusters that are left, in order.
#[derive(Clone, Copy)]
pub struct Active<'a> {
    /// Their numbers.
    pub ids: &'a [u32],
    /// Their boxes: what is looked at in each round, one after the other.
    pub boxes: &'a [PyramidBox],
}

/// A round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Round {
    /// Which, from 0.
    pub index: u32,
    /// Clusters that are left.
    pub count: u32,
}

impl Round {
    /// Whether every second pair must merge, or there would not be rounds enough.
    #[inline(always)]
    #[must_use]
    pub const fn is_forced(self) -> bool {
        let halvings = 32 - self.count.wrapping_sub(1).leading_zeros();
        self.index + halvings >= ROUNDS
    }

    /// Whether a merge may put what it merges two steps down.
    #[inline(always)]
    #[must_use]
    pub const fn may_deepen(self) -> bool {
        self.index < DEEPENING_ROUNDS
    }

    /// The number of this round's first merge, for a mesh of `triangle_count` triangles.
    #[inline(always)]
    #[must_use]
    pub const fn first_merge(self, triangle_count: u32) -> u32 {
        2 * triangle_count - self.count
    }
}

/// One thread per triangle, in the order of the curve. Returns its box.
#[inline(always)]
#[must_use]
pub fn triangle_box(i: u32, triangles: &[LeafTriangle]) -> PyramidBox {
    WideBox::of_triangle(i, triangles).entry()
}

/// One thread per 32 pairs of neighbours among the clusters that are left. Reads their boxes. Returns a bit for each pair that
/// merges: the clusters `32·word + bit` and the next, if their cost is below that of both pairs that share one with them.
/// Of equal costs, that of a pair that begins at an even place counts as lower, so that a row of them merges in one round.
///
/// `opaque_zero` is always 0, hidden from the compiler so that it cannot fuse a product with a sum.
#[inline]
#[must_use]
pub fn merging_pairs(word: u32, round: Round, boxes: &[PyramidBox], opaque_zero: u32) -> u32 {
    let first = 32 * word;
    let pair_count = round.count - (round.count > 0) as u32;
    if round.is_forced() {
        return every_second(first, pair_count);
    }
    let mut next = WideBox::of_entry(first, boxes);
    let mut before = NO_PAIR;
    if first > 0 {
        let last = WideBox::of_entry(first - 1, boxes);
        before = joint_area(&last, &next, opaque_zero);
    }
    // Costs come one after the other, each from the box that the last one left. Past the end all are of no pair.
    let mut bits = 0;
    let mut own = NO_PAIR;
    for step in 0..33u32 {
        let i = first + step;
        let mut after = NO_PAIR;
        if i < pair_count {
            let last = next;
            next = WideBox::of_entry(i + 1, boxes);
            after = joint_area(&last, &next, opaque_zero);
        }
        // `own` is the pair before i.
        if step > 0 {
            let is_even = i & 1 == 1;
            let is_lower = if is_even {
                own <= before && own <= after
            } else {
                own < before && own < after
            };
            bits |= ((is_lower && i <= pair_count) as u32) << (step - 1);
            before = own;
        }
        own = after;
    }
    bits
}

/// Costs more than any pair.
const NO_PAIR: f32 = f32::MAX;

/// Bits of the pairs that begin at an even place.
#[inline(always)]
const fn every_second(first: u32, pair_count: u32) -> u32 {
    let there = if first >= pair_count {
        0
    } else if pair_count - first < 32 {
        !(u32::MAX << (pair_count - first))
    } else {
        u32::MAX
    };
    0x5555_5555 & there
}

/// Sides count as no shorter, so that flat boxes differ by their length, and no product is too small to be exact
/// everywhere. The scene's magnitude is 1.
const SHORTEST: f32 = f32::from_bits((127 - 60) << 23);

/// Half the surface of the box around two, at least that of a cube of side [`SHORTEST`].
#[inline(always)]
pub(super) fn joint_area(a: &WideBox, b: &WideBox, opaque_zero: u32) -> f32 {
    let joint = a.union(*b);
    let side = (joint.max - joint.min).max(Vec4::splat(SHORTEST));
    let [x, y, z, _] = side.to_array();
    product(x, y, opaque_zero) + product(y, z, opaque_zero) + product(z, x, opaque_zero)
}

/// Bound on the number of nodes on any path. Each has more than [`LEAF_SIZE`] triangles, one more than the next at least.
#[must_use]
pub const fn depth_bound(triangle_count: u32) -> u32 {
    let chain = triangle_count.saturating_sub(LEAF_SIZE);
    let most = ROUNDS + DEEPENING_ROUNDS;
    if chain == 0 {
        1
    } else if chain < most {
        chain
    } else {
        most
    }
}

#[cfg(test)]
mod tests;
