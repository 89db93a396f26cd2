//! Stage `topology`: the binary radix tree over sorted codes (Karras 2012, "Maximizing Parallelism in the Construction
//! of BVHs, Octrees, and k-d Trees"), each node found on its own.
//!
//! The tree over n leaves has n − 1 nodes; node i covers a run of leaves that begins or ends at leaf i. Nodes with more
//! than [`LEAF_SIZE`] leaves are kept, in order; runs at most that long become leaves.

use crate::node::{LEAF_SIZE, Node, NodeRef};

/// Sorted codes.
pub trait SortedCodes {
    /// How many there are.
    fn count(&self) -> u32;

    /// δ(i, j): the length of the common prefix of two codes, where equal codes count as longer by the prefix of their
    /// indices. Both must be in range. At most key bits + 32.
    fn common_prefix_length(&self, i: u32, j: u32) -> i32;
}

/// Codes of one word.
#[derive(Clone, Copy)]
pub struct Codes30<'a>(pub &'a [u32]);

/// Codes of two words, the high one first.
#[derive(Clone, Copy)]
pub struct Codes63<'a>(pub &'a [[u32; 2]]);

impl SortedCodes for Codes30<'_> {
    #[inline(always)]
    fn count(&self) -> u32 {
        self.0.len() as u32
    }

    #[inline(always)]
    fn common_prefix_length(&self, i: u32, j: u32) -> i32 {
        let difference = crate::load(self.0, i, 0) ^ crate::load(self.0, j, 0);
        let (word, before) = if difference != 0 {
            (difference, 0)
        } else {
            (i ^ j, 32)
        };
        before + word.leading_zeros() as i32
    }
}

impl SortedCodes for Codes63<'_> {
    #[inline(always)]
    fn count(&self) -> u32 {
        self.0.len() as u32
    }

    #[inline(always)]
    fn common_prefix_length(&self, i: u32, j: u32) -> i32 {
        let [a_high, a_low] = crate::load(self.0, i, [0; 2]);
        let [b_high, b_low] = crate::load(self.0, j, [0; 2]);
        let (high, low) = (a_high ^ b_high, a_low ^ b_low);
        let (word, before) = if high != 0 {
            (high, 0)
        } else if low != 0 {
            (low, 32)
        } else {
            (i ^ j, 64)
        };
        before + word.leading_zeros() as i32
    }
}

/// δ(i, i + offset), −1 outside the range.
#[inline(always)]
fn prefix_at<C: SortedCodes>(codes: &C, i: u32, offset: i32) -> i32 {
    let j = i.wrapping_add(offset as u32);
    if j < codes.count() {
        codes.common_prefix_length(i, j)
    } else {
        -1
    }
}

/// Which way node i extends from leaf i, and the prefix that all its leaves share more than.
#[inline(always)]
fn orient<C: SortedCodes>(codes: &C, i: u32) -> (i32, i32) {
    let after = prefix_at(codes, i, 1);
    let before = prefix_at(codes, i, -1);
    if after > before {
        (1, before)
    } else {
        (-1, after)
    }
}

/// One thread per 32 nodes. Reads the codes. Returns a bit for each node of `32·word …` that covers more than
/// [`LEAF_SIZE`] leaves.
#[inline]
#[must_use]
pub fn kept_nodes<C: SortedCodes>(word: u32, codes: &C) -> u32 {
    let mut bits = 0;
    let first = word * 32;
    for bit in 0..32 {
        let i = first + bit;
        if i + 1 < codes.count() {
            let (direction, outside) = orient(codes, i);
            let reaches = prefix_at(codes, i, direction * LEAF_SIZE as i32) > outside;
            bits |= (reaches as u32) << bit;
        }
    }
    bits
}

/// How many kept nodes come before node i: its place among them. `bits` is what [`kept_nodes`] returned, `before` the
/// exclusive prefix sums of its bit counts.
#[inline(always)]
#[must_use]
pub fn rank(i: u32, bits: &[u32], before: &[u32]) -> u32 {
    let word = i >> 5;
    let below = crate::load(bits, word, 0) & !(u32::MAX << (i & 31));
    crate::load(before, word, 0) + below.count_ones()
}

/// One thread per kept node. Reads the codes and the ranks. Returns the node with its children and its run of leaves,
/// without boxes, and the last leaf of its left child.
#[inline]
#[must_use]
pub fn internal_node<C: SortedCodes>(
    i: u32,
    codes: &C,
    bits: &[u32],
    before: &[u32],
) -> (Node, u32) {
    let (direction, outside) = orient(codes, i);

    // Double the reach until it leaves the node, then bisect for the other end.
    let mut length = LEAF_SIZE_FLOOR as i32;
    for _ in 0..31 {
        if prefix_at(codes, i, 2 * length * direction) <= outside {
            break;
        }
        length *= 2;
    }
    let mut step = length / 2;
    for _ in 0..31 {
        if step == 0 {
            break;
        }
        if prefix_at(codes, i, (length + step) * direction) > outside {
            length += step;
        }
        step /= 2;
    }

    // Bisect for the last leaf that shares more with leaf i than the node's ends share.
    let shared = prefix_at(codes, i, length * direction);
    let mut split = 0;
    let mut step = length;
    for _ in 0..32 {
        step = (step + 1) / 2;
        if prefix_at(codes, i, (split + step) * direction) > shared {
            split += step;
        }
        if step <= 1 {
            break;
        }
    }

    let end = i.wrapping_add((length * direction) as u32);
    let (first, last) = if direction > 0 { (i, end) } else { (end, i) };
    let gamma = i
        .wrapping_add((split * direction) as u32)
        .wrapping_sub((direction < 0) as u32);

    let left_count = gamma - first + 1;
    let left = if left_count > LEAF_SIZE {
        NodeRef::inner(rank(gamma, bits, before))
    } else {
        NodeRef::leaf(first, left_count)
    };
    let right_count = last - gamma;
    let right = if right_count > LEAF_SIZE {
        NodeRef::inner(rank(gamma + 1, bits, before))
    } else {
        NodeRef::leaf(gamma + 1, right_count)
    };
    let node = Node {
        left,
        right,
        first,
        last,
        ..Node::EMPTY
    };
    (node, gamma)
}

/// The only node of a tree with at most [`LEAF_SIZE`] leaves: all of them on its left.
#[inline]
#[must_use]
pub const fn single_node(triangle_count: u32) -> Node {
    Node {
        left: NodeRef::leaf(0, triangle_count),
        last: triangle_count.saturating_sub(1),
        ..Node::EMPTY
    }
}

/// The largest power of two up to [`LEAF_SIZE`].
const LEAF_SIZE_FLOOR: u32 = 1 << LEAF_SIZE.ilog2();

/// Bound on the number of nodes on any path: each step down lengthens the common prefix, and equal codes are told
/// apart by at most ⌈log₂ n⌉ bits of their indices.
#[must_use]
pub const fn depth_bound(key_bits: u32, triangle_count: u32) -> u32 {
    key_bits + (32 - triangle_count.saturating_sub(1).leading_zeros())
}
