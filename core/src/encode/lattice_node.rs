//! The lattice codec's node: both children's boxes and what they are, in 12 to 28 bytes.
//!
//! Of both children's planes on one side of their parent, one is the parent's own, as a parent is no larger than its children
//! need. So a side takes one bit for which child has it, and one number for how far inside the other's plane lies: half of
//! what two boxes take (Fabianowski and Dingliana 2009, "Compact BVH Storage for Ray Tracing and Photon Mapping", share planes
//! so). The number counts steps of a power of two that follows from the decoded parent's extent, and is rounded down: outward
//! on both sides. Nothing overflows, no child leaves its parent, and all is exact.
//!
//! ```text
//! shift = bits(max − min) − BITS, or 0
//! inner min = min + (number << shift)
//! inner max = max − (number << shift)
//! ```
//!
//! Words of a node: those of [`Links`] that have no other place, then for each axis its lower and its upper side, in one word
//! up to 15 bits, else in two. What an axis leaves free takes links: for 10 bits
//!
//! ```text
//! word 0      links word 0
//! word 1–3    llllllllll h uuuuuuuuuu g nnnnnnnnnn   from the top: 10 bits of links word 1, which child has the upper side (0
//!             left, 1 right), the other's upper number, the same of the lower side
//! ```

use super::lattice_leaf::LeafWidth;
use super::links::Links;
use super::rounded::RoundedNode;
use crate::lattice::LatticeBox;
use crate::node::NodeRef;
use crate::slab::PlanePair;
use crate::trace::{BoxColumns, Children, Cursor, LeafRun, NodeSource};
use glam::Vec4;

/// Words of an axis.
#[inline(always)]
const fn axis_words(bits: u32) -> usize {
    if bits <= 15 { 1 } else { 2 }
}

/// Bits that an axis leaves free in its last word.
#[inline(always)]
const fn free_bits(bits: u32) -> u32 {
    32 - (bits + 1) * (2 / axis_words(bits) as u32)
}

/// Words before the axes.
#[inline(always)]
const fn link_words(bits: u32) -> usize {
    if free_bits(bits) >= 21 {
        0
    } else if free_bits(bits) >= 10 {
        1
    } else {
        2
    }
}

/// Words of a node with numbers of 1 to 21 bits: 3 for up to 4, 4 for up to 10, 5 for up to 15, 7 for more.
#[must_use]
pub const fn node_words(bits: u32) -> usize {
    link_words(bits) + 3 * axis_words(bits)
}

/// A node in words, and its children's boxes as they come out of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EncodedNode<const WORDS: usize> {
    /// What is stored.
    pub words: [u32; WORDS],
    /// The left child's box, decoded.
    pub left: LatticeBox,
    /// The right child's box, decoded.
    pub right: LatticeBox,
}

/// One thread per node. Reads its box, decoded, and the node on the lattice, whose children's boxes lie in it. Returns it coded,
/// yet without links. `WORDS` must be [`node_words`] of `BITS`.
#[inline]
#[must_use]
pub fn encode_node<const BITS: u32, const WORDS: usize>(
    parent: &LatticeBox,
    node: &RoundedNode,
) -> EncodedNode<WORDS> {
    let ([a, b, c], [d, e, f]) = (parent.min, parent.max);
    let x = sides::<BITS>(node.planes[0], a, d);
    let y = sides::<BITS>(node.planes[1], b, e);
    let z = sides::<BITS>(node.planes[2], c, f);
    let mut words = [0; WORDS];
    put_sides::<BITS, WORDS>(&mut words, 0, x);
    put_sides::<BITS, WORDS>(&mut words, 1, y);
    put_sides::<BITS, WORDS>(&mut words, 2, z);
    let [left, right] = boxes([
        side_planes::<BITS>(x, a, d),
        side_planes::<BITS>(y, b, e),
        side_planes::<BITS>(z, c, f),
    ]);
    EncodedNode { words, left, right }
}

/// One child's box as [`encode_node`] returns it, and nothing else.
#[inline(always)]
#[must_use]
pub const fn encode_child<const BITS: u32>(
    parent: &LatticeBox,
    node: &RoundedNode,
    is_left: bool,
) -> LatticeBox {
    let ([a, b, c], [d, e, f]) = (parent.min, parent.max);
    let [x, u] = child_planes::<BITS>(node.planes[0], a, d, is_left);
    let [y, v] = child_planes::<BITS>(node.planes[1], b, e, is_left);
    let [z, w] = child_planes::<BITS>(node.planes[2], c, f, is_left);
    LatticeBox {
        min: [x, y, z],
        max: [u, v, w],
    }
}

/// A child's planes on one axis, from both children's and the parent's.
#[inline(always)]
const fn child_planes<const BITS: u32>(
    planes: [i32; 4],
    low: i32,
    high: i32,
    is_left: bool,
) -> [i32; 2] {
    let shift = shift::<BITS>(low, high);
    let [lower, upper] = distances(planes, low, high);
    [
        low.wrapping_add(inside(lower, shift, is_left)),
        high.wrapping_sub(inside(upper, shift, is_left)),
    ]
}

/// How far a child's plane comes to lie from a side of its parent, from both children's distances.
#[inline(always)]
const fn inside([left, right]: [i32; 2], shift: u32, is_left: bool) -> i32 {
    // As in `side`: the nearer child has the side, and the left one where both are as near.
    let is_right = left > right;
    let inner = if is_right { left } else { right };
    if is_right == is_left {
        (inner >> shift) << shift
    } else {
        0
    }
}

/// How far both children's planes lie from the lower and from the upper side of their parent.
#[inline(always)]
const fn distances([a, b, c, d]: [i32; 4], low: i32, high: i32) -> [[i32; 2]; 2] {
    [
        [a.wrapping_sub(low), b.wrapping_sub(low)],
        [high.wrapping_sub(c), high.wrapping_sub(d)],
    ]
}

/// Both sides of an axis.
#[inline(always)]
const fn sides<const BITS: u32>(planes: [i32; 4], low: i32, high: i32) -> [u32; 2] {
    let shift = shift::<BITS>(low, high);
    let [lower, upper] = distances(planes, low, high);
    [side::<BITS>(lower, shift), side::<BITS>(upper, shift)]
}

/// Puts both sides of an axis into a node's words.
#[inline(always)]
const fn put_sides<const BITS: u32, const WORDS: usize>(
    words: &mut [u32; WORDS],
    axis: usize,
    [lower, upper]: [u32; 2],
) {
    let first = link_words(BITS) + axis * axis_words(BITS);
    if axis_words(BITS) == 1 {
        words[first % WORDS] = lower | upper << ((BITS + 1) & 31);
    } else {
        words[first % WORDS] = lower;
        words[(first + 1) % WORDS] = upper;
    }
}

/// Both sides of an axis, from a node's words. Higher bits are others'.
#[inline(always)]
const fn sides_of<const BITS: u32, const WORDS: usize>(
    words: &[u32; WORDS],
    axis: usize,
) -> [u32; 2] {
    let first = link_words(BITS) + axis * axis_words(BITS);
    if axis_words(BITS) == 1 {
        let word = words[first % WORDS];
        [word, word >> ((BITS + 1) & 31)]
    } else {
        [words[first % WORDS], words[(first + 1) % WORDS]]
    }
}

/// Both children's boxes, from their planes on each axis.
#[inline(always)]
const fn boxes([x, y, z]: [[i32; 4]; 3]) -> [LatticeBox; 2] {
    [
        LatticeBox {
            min: [x[0], y[0], z[0]],
            max: [x[2], y[2], z[2]],
        },
        LatticeBox {
            min: [x[1], y[1], z[1]],
            max: [x[3], y[3], z[3]],
        },
    ]
}

/// One thread per node. Reads its words without links. Returns them with links.
#[inline]
#[must_use]
pub fn with_links<const BITS: u32, const WORDS: usize>(
    words: [u32; WORDS],
    links: Links,
) -> [u32; WORDS] {
    let mut words = words;
    let [a, b] = links.0;
    if link_words(BITS) > 0 {
        words[0] = a;
    }
    if link_words(BITS) > 1 {
        words[1 % WORDS] = b;
    }
    words[last_word(BITS, 0) % WORDS] |= link_piece::<BITS>(a, b, 0);
    words[last_word(BITS, 1) % WORDS] |= link_piece::<BITS>(a, b, 1);
    words[last_word(BITS, 2) % WORDS] |= link_piece::<BITS>(a, b, 2);
    words
}

/// The links of a node's words.
#[inline(always)]
#[must_use]
pub fn links_of<const BITS: u32, const WORDS: usize>(words: &[u32; WORDS]) -> Links {
    let last = |axis: usize| words[last_word(BITS, axis) % WORDS];
    links::<BITS>([words[0], words[1 % WORDS]], [last(0), last(1), last(2)])
}

/// An axis' last word.
#[inline(always)]
const fn last_word(bits: u32, axis: usize) -> usize {
    link_words(bits) + (axis + 1) * axis_words(bits) - 1
}

/// Both children's boxes, from a node's words and its own box, decoded.
#[inline]
#[must_use]
pub fn decode_node<const BITS: u32, const WORDS: usize>(
    words: &[u32; WORDS],
    parent: &LatticeBox,
) -> [LatticeBox; 2] {
    let ([a, b, c], [d, e, f]) = (parent.min, parent.max);
    boxes([
        side_planes::<BITS>(sides_of::<BITS, WORDS>(words, 0), a, d),
        side_planes::<BITS>(sides_of::<BITS, WORDS>(words, 1), b, e),
        side_planes::<BITS>(sides_of::<BITS, WORDS>(words, 2), c, f),
    ])
}

/// By how much numbers are shifted in a box between two planes.
#[inline(always)]
const fn shift<const BITS: u32>(low: i32, high: i32) -> u32 {
    let extent_bits = 32 - (high.wrapping_sub(low) as u32).leading_zeros();
    let most = if extent_bits > BITS {
        extent_bits
    } else {
        BITS
    };
    most - BITS
}

/// A side: which child has it, and the other's number. Distances from the side are never negative.
#[inline(always)]
const fn side<const BITS: u32>([left, right]: [i32; 2], shift: u32) -> u32 {
    let is_right = left > right;
    let inner = if is_right { left } else { right };
    (inner as u32 >> shift) & ((1 << BITS) - 1) | (is_right as u32) << BITS
}

/// The planes of one axis, from both its sides: left min, right min, left max, right max. Bits above a side's do not count.
#[inline(always)]
const fn side_planes<const BITS: u32>([lower, upper]: [u32; 2], low: i32, high: i32) -> [i32; 4] {
    let mask = (1 << BITS) - 1;
    let shift = shift::<BITS>(low, high);
    let inner_low = low.wrapping_add(((lower & mask) << shift) as i32);
    let inner_high = high.wrapping_sub(((upper & mask) << shift) as i32);
    let is_low_right = (lower >> BITS) & 1 == 1;
    let is_high_right = (upper >> BITS) & 1 == 1;
    [
        if is_low_right { inner_low } else { low },
        if is_low_right { low } else { inner_low },
        if is_high_right { inner_high } else { high },
        if is_high_right { high } else { inner_high },
    ]
}

/// What an axis holds of the links, at the top of its last word.
#[inline(always)]
const fn link_piece<const BITS: u32>(a: u32, b: u32, axis: usize) -> u32 {
    let bits = 10 * axis as u32;
    match link_words(BITS) {
        // 21 bits each of the 62.
        0 => {
            let piece = match axis {
                0 => a,
                1 => a >> 21 | b << 11,
                _ => b >> 10,
            };
            piece << 11
        }
        1 => (b >> bits) << 22,
        _ => 0,
    }
}

/// The links, from the words before the axes and the last word of each.
#[inline(always)]
const fn links<const BITS: u32>(before: [u32; 2], [x, y, z]: [u32; 3]) -> Links {
    match link_words(BITS) {
        0 => {
            let (x, y, z) = (x >> 11, y >> 11, z >> 11);
            Links([x | y << 21, (y >> 11) | z << 10])
        }
        1 => Links([before[0], x >> 22 | (y >> 22) << 10 | (z >> 22) << 20]),
        _ => Links(before),
    }
}

/// A box on the lattice as the traversal carries it: the same numbers in the scene's unit, which floats hold exactly, with
/// coordinates in the order of the ray's axes. Last lanes are unused: what is stored as a vector can be loaded as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeFrame {
    /// Smallest coordinates.
    pub min: Vec4,
    /// Largest coordinates.
    pub max: Vec4,
}

impl LatticeFrame {
    /// Nothing but the origin; all bits zero.
    pub const ZERO: Self = Self {
        min: Vec4::ZERO,
        max: Vec4::ZERO,
    };

    /// A box whose steps have this length, for a ray whose axes are in this order.
    #[inline(always)]
    #[must_use]
    pub fn new(bounds: &LatticeBox, step: f32, axes: [u32; 3]) -> Self {
        let [a, b, c] = axes;
        let min = |axis: u32| bounds.min[axis as usize % 3] as f32 * step;
        let max = |axis: u32| bounds.max[axis as usize % 3] as f32 * step;
        Self {
            min: Vec4::new(min(a), min(b), min(c), 0.0),
            max: Vec4::new(max(a), max(b), max(c), 0.0),
        }
    }
}

/// A node or a leaf, and its box. 48 bytes, also where vectors need not be aligned: shaders align them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub struct LatticeCursor {
    /// Its box, decoded.
    pub bounds: LatticeFrame,
    /// Which.
    pub node: NodeRef,
}

const _: () = assert!(size_of::<LatticeCursor>() == 48);

impl Cursor for LatticeCursor {
    type Columns = BoxColumns;
    const EMPTY: BoxColumns = BoxColumns::EMPTY;

    #[inline(always)]
    fn put(self, columns: &mut BoxColumns, place: usize) {
        let LatticeFrame { min, max } = self.bounds;
        let (min, max) = ([min.x, min.y, min.z], [max.x, max.y, max.z]);
        columns.put(place, self.node, min, max);
    }

    #[inline(always)]
    fn at(columns: &BoxColumns, place: usize) -> Self {
        let ([a, b, c], [x, y, z]) = (columns.min(place), columns.max(place));
        Self {
            bounds: LatticeFrame {
                min: Vec4::new(a, b, c, 0.0),
                max: Vec4::new(x, y, z, 0.0),
            },
            node: columns.node(place),
        }
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

/// [`side_planes`] of three axes in the scene's unit, in floats: each is a whole number of steps, of less than 2^24, and exact.
/// An extent of more may be rounded, but never to another exponent. Lanes are axes, in the ray's order.
#[inline(always)]
fn child_frames<const BITS: u32>(
    lower: [u32; 4],
    upper: [u32; 4],
    frame: &LatticeFrame,
    step: f32,
) -> [LatticeFrame; 2] {
    // The power of two in the extent tells how many bits it has.
    let power = each((frame.max - frame.min).to_array(), |x| {
        f32::from_bits(x.to_bits() & 0x7f80_0000)
    });
    let last = f32::from_bits((127 + 1 - BITS) << 23);
    let cell = (power * last).max(Vec4::splat(step));
    let (from_low, from_high) = (numbers::<BITS>(lower) * cell, numbers::<BITS>(upper) * cell);
    let (low_left, low_right) = dealt::<BITS>(from_low, lower);
    let (high_left, high_right) = dealt::<BITS>(from_high, upper);
    [
        LatticeFrame {
            min: frame.min + low_left,
            max: frame.max - high_left,
        },
        LatticeFrame {
            min: frame.min + low_right,
            max: frame.max - high_right,
        },
    ]
}

/// The numbers of sides.
#[inline(always)]
fn numbers<const BITS: u32>(sides: [u32; 4]) -> Vec4 {
    let number = |side: u32| (side & ((1 << BITS) - 1)) as i32 as f32;
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
    type Frame = LatticeFrame;

    #[inline(always)]
    fn root(&self, axes: [u32; 3]) -> LatticeCursor {
        LatticeCursor {
            node: if self.nodes.is_empty() {
                NodeRef::NOTHING
            } else {
                NodeRef::inner(0)
            },
            bounds: LatticeFrame::new(&self.root, self.step, axes),
        }
    }

    #[inline(always)]
    fn leaf(&self, cursor: LatticeCursor) -> LeafRun<LatticeFrame> {
        LeafRun {
            is_leaf: cursor.node.is_leaf(),
            first: cursor.node.first(),
            count: cursor.node.count(),
            frame: cursor.bounds,
        }
    }

    #[inline(always)]
    fn children(&self, cursor: LatticeCursor, axes: [u32; 3]) -> Children<LatticeCursor> {
        let index = cursor.node.index() as usize;
        let nothing = LatticeCursor {
            node: NodeRef::NOTHING,
            bounds: LatticeFrame::ZERO,
        };
        if index >= self.nodes.len() {
            return Children {
                planes: [PlanePair::ZERO; 3],
                left: nothing,
                right: nothing,
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
            LeafWidth::of_frame(&left, self.step).words()
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
        // Every inner node once, and a leaf on both sides of each.
        3 * self.nodes.len() as u32 + 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn sizes_are_those_that_are_stated() {
        for (bits, words) in [
            (1, 3),
            (4, 3),
            (5, 4),
            (6, 4),
            (8, 4),
            (10, 4),
            (11, 5),
            (12, 5),
            (15, 5),
            (16, 7),
            (21, 7),
        ] {
            assert_eq!(node_words(bits), words, "{bits}");
        }
    }

    /// A box in another.
    fn inside(outer: LatticeBox) -> impl Strategy<Value = LatticeBox> {
        let axis = move |i: usize| {
            let range = outer.min[i]..=outer.max[i];
            (range.clone(), range).prop_map(|(a, b)| [a.min(b), a.max(b)])
        };
        [axis(0), axis(1), axis(2)].prop_map(|[x, y, z]| LatticeBox {
            min: [x[0], y[0], z[0]],
            max: [x[1], y[1], z[1]],
        })
    }

    fn any_box() -> impl Strategy<Value = LatticeBox> {
        prop_oneof![Just((1 << 24) - 1), 0i32..5000, 0i32..1 << 20].prop_flat_map(|most| {
            inside(LatticeBox {
                min: [-most; 3],
                max: [most; 3],
            })
        })
    }

    /// A node with these boxes.
    fn rounded(left: &LatticeBox, right: &LatticeBox) -> RoundedNode {
        RoundedNode {
            planes: [0, 1, 2].map(|i| [left.min[i], right.min[i], left.max[i], right.max[i]]),
            ..RoundedNode::EMPTY
        }
    }

    fn family() -> impl Strategy<Value = [LatticeBox; 3]> {
        any_box()
            .prop_flat_map(|parent| (Just(parent), inside(parent), inside(parent)))
            .prop_map(|(parent, left, right)| [parent, left, right])
    }

    fn links_of_any() -> impl Strategy<Value = Links> {
        (any::<u32>(), 0..1u32 << 30).prop_map(|(a, b)| Links([a, b]))
    }

    fn check<const BITS: u32, const WORDS: usize>(
        [parent, left, right]: [LatticeBox; 3],
        given: Links,
    ) -> Result<(), TestCaseError> {
        assert_eq!(WORDS, node_words(BITS));
        let rounded = rounded(&left, &right);
        let node = encode_node::<BITS, WORDS>(&parent, &rounded);
        for (decoded, exact) in [(node.left, left), (node.right, right)] {
            prop_assert!(decoded.contains(&exact), "{decoded:?} {exact:?}");
            prop_assert!(parent.contains(&decoded));
            for axis in 0..3 {
                // At most a step of the number beyond what the parent's own planes leave no choice of.
                let extent = i64::from(parent.max[axis]) - i64::from(parent.min[axis]);
                let step = (extent >> (BITS - 1)).max(1);
                let slack =
                    |d: i32, e: i32, side: i32| d == side || i64::from(d.abs_diff(e)) < step.max(1);
                prop_assert!(slack(decoded.min[axis], exact.min[axis], parent.min[axis]));
                prop_assert!(slack(decoded.max[axis], exact.max[axis], parent.max[axis]));
            }
        }
        prop_assert_eq!(encode_child::<BITS>(&parent, &rounded, true), node.left);
        prop_assert_eq!(encode_child::<BITS>(&parent, &rounded, false), node.right);
        let words = with_links::<BITS, WORDS>(node.words, given);
        prop_assert_eq!(links_of::<BITS, WORDS>(&words), given);
        prop_assert_eq!(
            decode_node::<BITS, WORDS>(&words, &parent),
            [node.left, node.right]
        );
        Ok(())
    }

    proptest! {
        #[test]
        fn decoded_boxes_hold_the_children_and_stay_in_the_parent(family in family(), links in links_of_any()) {
            check::<4, 3>(family, links)?;
            check::<6, 4>(family, links)?;
            check::<8, 4>(family, links)?;
            check::<10, 4>(family, links)?;
            check::<12, 5>(family, links)?;
            check::<16, 7>(family, links)?;
            check::<21, 7>(family, links)?;
        }
    }

    /// The longest extents have more bits than floats: their exponents must be right all the same.
    #[test]
    fn the_longest_extents_decode_alike() {
        let most = (1 << 24) - 1;
        for low in [-most, 1 - most, 2 - most] {
            for high in [most, most - 1, most - 2] {
                let parent = LatticeBox {
                    min: [low; 3],
                    max: [high; 3],
                };
                let left = LatticeBox {
                    min: [low, 5 + low, low],
                    max: [high - 77, 9, 12],
                };
                let right = LatticeBox {
                    min: [-3, low, 7],
                    max: [high, high, high],
                };
                let checked = check::<10, 4>([parent, left, right], Links::default());
                assert!(checked.is_ok(), "{checked:?}");
            }
        }
    }

    /// All pairs of cells of one axis, for all extents up to 70 and 3 bits.
    #[test]
    fn every_pair_of_cells_of_one_axis() {
        for extent in 0..=70 {
            let parent = LatticeBox {
                min: [-7; 3],
                max: [extent - 7; 3],
            };
            for low in 0..=extent {
                for high in low..=extent {
                    let child = LatticeBox {
                        min: [low - 7; 3],
                        max: [high - 7; 3],
                    };
                    for (left, right) in [(child, parent), (parent, child), (child, child)] {
                        let node = encode_node::<3, 3>(&parent, &rounded(&left, &right));
                        assert!(node.left.contains(&left) && node.right.contains(&right));
                        assert!(parent.contains(&node.left) && parent.contains(&node.right));
                    }
                }
            }
        }
    }

    /// Extents that the numbers can count come out as they went in, where one child has each side.
    #[test]
    fn small_boxes_are_exact() {
        let parent = LatticeBox {
            min: [100, -100, 0],
            max: [1123, 923, 7],
        };
        let left = LatticeBox {
            min: [100, -99, 0],
            max: [600, 923, 3],
        };
        let right = LatticeBox {
            min: [599, -100, 2],
            max: [1123, 0, 7],
        };
        let node = encode_node::<10, 4>(&parent, &rounded(&left, &right));
        assert_eq!((node.left, node.right), (left, right));
    }
}
