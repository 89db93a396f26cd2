//! Nodes of the lattice codec as the traversal sees them.

use super::lattice_node::{links_of, sides_of};
use super::leaf_width::{LatticeBounds, LeafFrame, LeafWidth};
use crate::build::node::NodeRef;
use crate::geometry::float::whole_number;
use crate::geometry::lattice::LatticeBox;
use crate::geometry::planes::PlanePair;
use crate::trace::{BoxCursor, Children, LeafRun, NodeSource, Order};
use glam::Vec4;

/// A node or a leaf, and its box. 48 bytes, also where vectors need not be aligned: shaders align them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub struct LatticeCursor {
    /// Its box, decoded.
    pub bounds: LatticeBounds,
    /// Which.
    pub node: NodeRef,
}

const _: () = assert!(size_of::<LatticeCursor>() == 48);

impl BoxCursor for LatticeCursor {
    #[inline(always)]
    fn new(node: NodeRef, [a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> Self {
        Self {
            bounds: LatticeBounds {
                min: Vec4::new(a, b, c, 0.0),
                max: Vec4::new(x, y, z, 0.0),
            },
            node,
        }
    }

    #[inline(always)]
    fn node(&self) -> NodeRef {
        self.node
    }

    #[inline(always)]
    fn corners(&self) -> [[f32; 3]; 2] {
        let LatticeBounds { min, max } = self.bounds;
        [[min.x, min.y, min.z], [max.x, max.y, max.z]]
    }
}

/// Nodes of the lattice codec, the root first. `MIXED` where leaves hold triangles of the lattice codec, whose size follows
/// from their box.
#[derive(Clone, Copy)]
pub struct LatticeNodes<'a, const BITS: u32, const WORDS: usize, const MIXED: bool> {
    /// Words of nodes.
    pub nodes: &'a [[u32; WORDS]],
    /// The root's box.
    pub root: LatticeBox,
    /// The lattice's step, a power of two.
    pub step: f32,
}

/// [`decode_node`](super::decode_node) on three axes in the scene's unit, in floats: each is a whole number of steps, of less than 2^24, and exact.
/// An extent of more may be rounded, but never to another exponent. Lanes are axes, in the ray's order.
#[inline(always)]
fn child_frames<const BITS: u32>(
    lower: [u32; 4],
    upper: [u32; 4],
    frame: &LatticeBounds,
    step: f32,
) -> [LatticeBounds; 2] {
    // The number of bits of the extent is the exponent of its power of two.
    let power = each((frame.max - frame.min).to_array(), |x| {
        f32::from_bits(x.to_bits() & 0x7f80_0000)
    });
    let last = f32::from_bits((127 + 1 - BITS) << 23);
    let cell = (power * last).max(Vec4::splat(step));
    let (from_low, from_high) = (numbers::<BITS>(lower) * cell, numbers::<BITS>(upper) * cell);
    let (low_left, low_right) = dealt::<BITS>(from_low, lower);
    let (high_left, high_right) = dealt::<BITS>(from_high, upper);
    [
        LatticeBounds {
            min: frame.min + low_left,
            max: frame.max - high_left,
        },
        LatticeBounds {
            min: frame.min + low_right,
            max: frame.max - high_right,
        },
    ]
}

/// The numbers of sides.
#[inline(always)]
fn numbers<const BITS: u32>(sides: [u32; 4]) -> Vec4 {
    let number = |side: u32| whole_number(side & ((1 << BITS) - 1));
    let [a, b, c, d] = sides;
    Vec4::new(number(a), number(b), number(c), number(d))
}

/// Distances for the left child and for the right one: that of the other is 0.
#[inline(always)]
fn dealt<const BITS: u32>(distances: Vec4, sides: [u32; 4]) -> (Vec4, Vec4) {
    let [a, b, c, d] = distances.to_array();
    let is_left = |side: u32| (side << (31 - BITS)) as i32 >> 31;
    let left = |x: f32, side: u32| f32::from_bits(x.to_bits() & is_left(side) as u32);
    let right = |x: f32, side: u32| f32::from_bits(x.to_bits() & !is_left(side) as u32);
    (
        Vec4::new(
            left(a, sides[0]),
            left(b, sides[1]),
            left(c, sides[2]),
            left(d, sides[3]),
        ),
        Vec4::new(
            right(a, sides[0]),
            right(b, sides[1]),
            right(c, sides[2]),
            right(d, sides[3]),
        ),
    )
}

#[inline(always)]
fn each([a, b, c, d]: [f32; 4], f: impl Fn(f32) -> f32) -> Vec4 {
    Vec4::new(f(a), f(b), f(c), f(d))
}

impl<const BITS: u32, const WORDS: usize, const MIXED: bool> NodeSource
    for LatticeNodes<'_, BITS, WORDS, MIXED>
{
    type Cursor = LatticeCursor;
    type Node = Children<LatticeCursor>;
    type Bounds = LeafFrame;

    const NOTHING: LatticeCursor = LatticeCursor {
        node: NodeRef::EMPTY_LEAF,
        bounds: LatticeBounds::ZERO,
    };

    #[inline(always)]
    fn root(&self, axes: [u32; 3]) -> LatticeCursor {
        LatticeCursor {
            node: if self.nodes.is_empty() {
                NodeRef::EMPTY_LEAF
            } else {
                NodeRef::inner(0)
            },
            bounds: LatticeBounds::new(&self.root, self.step, axes),
        }
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: LatticeCursor) -> bool {
        cursor.node.is_leaf()
    }

    #[inline(always)]
    fn leaf(&self, cursor: LatticeCursor, _axes: [u32; 3]) -> LeafRun<LeafFrame> {
        LeafRun::of(cursor.node, LeafFrame::of(&cursor.bounds, self.step))
    }

    #[inline(always)]
    fn resume(&self, waited: LatticeCursor) -> LatticeCursor {
        waited
    }

    #[inline(always)]
    fn children(
        &self,
        cursor: LatticeCursor,
        Order { axes, .. }: Order,
    ) -> Children<LatticeCursor> {
        let index = cursor.node.index() as usize;
        if index >= self.nodes.len() {
            return Children {
                planes: [PlanePair::ZERO; 3],
                left: Self::NOTHING,
                right: Self::NOTHING,
            };
        }
        // Words are read where they lie, by axis.
        let words = &self.nodes[index];
        let [a, d] = sides_of::<BITS, WORDS>(words, axes[0] as usize);
        let [b, e] = sides_of::<BITS, WORDS>(words, axes[1] as usize);
        let [c, f] = sides_of::<BITS, WORDS>(words, axes[2] as usize);
        let (lower, upper) = ([a, b, c, 0], [d, e, f, 0]);
        let [left, right] = child_frames::<BITS>(lower, upper, &cursor.bounds, self.step);
        let planes = [
            PlanePair::new(left.min.x, right.min.x, left.max.x, right.max.x),
            PlanePair::new(left.min.y, right.min.y, left.max.y, right.max.y),
            PlanePair::new(left.min.z, right.min.z, left.max.z, right.max.z),
        ];
        let stride = if MIXED {
            LeafWidth::of_bounds(&left, self.step).words()
        } else {
            1
        };
        let [left_node, right_node] = links_of::<BITS, WORDS>(words).children(stride);
        Children {
            planes,
            left: LatticeCursor {
                node: left_node,
                bounds: left,
            },
            right: LatticeCursor {
                node: right_node,
                bounds: right,
            },
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.nodes.len() as u32 + 1
    }
}
