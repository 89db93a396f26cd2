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

use super::links::Links;
use super::rounded::{RoundedNode, boxes};
use crate::geometry::lattice::LatticeBox;

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
/// without links. `WORDS` must be [`node_words`] of `BITS`.
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
pub(super) const fn sides_of<const BITS: u32, const WORDS: usize>(
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

#[cfg(test)]
mod tests;
