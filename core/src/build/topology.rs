//! Stage `topology`: the binary radix tree over sorted codes (Karras 2012, "Maximizing Parallelism in the Construction
//! of BVHs, Octrees, and k-d Trees"), each node found on its own.
//!
//! The tree over n leaves has n − 1 nodes; node i covers a run of leaves that begins or ends at leaf i. Nodes with more
//! than [`LEAF_SIZE`] leaves are kept, in order; runs at most that long become leaves.

use crate::build::compact::rank;
use crate::build::node::{LEAF_SIZE, Node, NodeRef};
use crate::build::refit::split_of;

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
pub struct Codes30<'a> {
    /// The codes, or room for more.
    pub codes: &'a [u32],
    /// How many count.
    pub count: u32,
}

/// Codes of two words, the high one first.
#[derive(Clone, Copy)]
pub struct Codes63<'a> {
    /// The codes, or room for more.
    pub codes: &'a [[u32; 2]],
    /// How many count.
    pub count: u32,
}

impl<'a> Codes30<'a> {
    /// All of a list.
    #[must_use]
    pub const fn all(codes: &'a [u32]) -> Self {
        let count = codes.len() as u32;
        Self { codes, count }
    }
}

impl<'a> Codes63<'a> {
    /// All of a list.
    #[must_use]
    pub const fn all(codes: &'a [[u32; 2]]) -> Self {
        let count = codes.len() as u32;
        Self { codes, count }
    }
}

impl SortedCodes for Codes30<'_> {
    #[inline(always)]
    fn count(&self) -> u32 {
        self.count
    }

    #[inline(always)]
    fn common_prefix_length(&self, i: u32, j: u32) -> i32 {
        let difference = crate::load(self.codes, i, 0) ^ crate::load(self.codes, j, 0);
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
        self.count
    }

    #[inline(always)]
    fn common_prefix_length(&self, i: u32, j: u32) -> i32 {
        let [a_high, a_low] = crate::load(self.codes, i, [0; 2]);
        let [b_high, b_low] = crate::load(self.codes, j, [0; 2]);
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

/// One thread per node. Reads the codes. Returns whether node i covers more than [`LEAF_SIZE`] leaves. Where there are no
/// more codes than that, the first node is kept all the same: there is a root.
#[inline(always)]
#[must_use]
pub fn is_kept<C: SortedCodes>(i: u32, codes: &C) -> bool {
    if codes.count() <= LEAF_SIZE {
        return i == 0;
    }
    let (direction, outside) = orient(codes, i);
    let reaches = prefix_at(codes, i, direction * LEAF_SIZE as i32) > outside;
    i + 1 < codes.count() && reaches
}

/// The nodes that are kept of 32, from `32·word` on, as the bits of a word.
#[inline]
#[must_use]
pub fn kept_nodes<C: SortedCodes>(word: u32, codes: &C) -> u32 {
    let mut bits = 0;
    for bit in 0..32u32 {
        bits |= (is_kept(word * 32 + bit, codes) as u32) << bit;
    }
    bits
}

/// One thread per kept node. Reads the codes, a bit for each node that is kept and the exclusive prefix sums of the bits'
/// counts. Returns the node with its children and its run of leaves, without boxes, and the last leaf of its left child.
#[inline]
#[must_use]
pub fn internal_node<C: SortedCodes>(
    i: u32,
    codes: &C,
    bits: &[u32],
    before: &[u32],
) -> (Node, u32) {
    if codes.count() <= LEAF_SIZE {
        let node = single_node(codes.count());
        return (node, split_of(&node, 0));
    }
    let (direction, outside) = orient(codes, i);

    // Double the reach until it leaves the node, then bisect for the other end.
    let mut length = LEAF_SIZE_FLOOR as i32;
    for _ in 0..31u32 {
        if prefix_at(codes, i, 2 * length * direction) <= outside {
            break;
        }
        length *= 2;
    }
    let mut step = length / 2;
    for _ in 0..31u32 {
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
    for _ in 0..32u32 {
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
const fn single_node(triangle_count: u32) -> Node {
    Node {
        left: NodeRef::leaf(0, triangle_count),
        last: triangle_count - (triangle_count > 0) as u32,
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::vec::Vec;

    /// All kept nodes, in order.
    fn nodes<C: SortedCodes>(codes: &C) -> Vec<(Node, u32)> {
        let bits: Vec<u32> = (0..codes.count().div_ceil(32))
            .map(|word| kept_nodes(word, codes))
            .collect();
        let mut before: Vec<u32> = bits.iter().map(|bits| bits.count_ones()).collect();
        crate::build::scan::run_scan(&mut before, 0, bits.len() as u32, 0);
        (0..codes.count())
            .filter(|i| bits[*i as usize / 32] >> (i % 32) & 1 == 1)
            .map(|i| internal_node(i, codes, &bits, &before))
            .collect()
    }

    /// Walks from a node over the run `first..=last`, splitting where the highest bit changes that is not the same in
    /// the whole run. Returns the greatest depth.
    fn check(
        nodes: &[(Node, u32)],
        child: NodeRef,
        keys: &[u128],
        first: u32,
        last: u32,
        seen: &mut Vec<u32>,
    ) -> u32 {
        let count = last - first + 1;
        if count <= LEAF_SIZE {
            assert_eq!(child, NodeRef::leaf(first, count));
            return 0;
        }
        assert!(!child.is_leaf());
        seen.push(child.index());
        let (node, split) = nodes[child.index() as usize];
        assert_eq!((node.first, node.last), (first, last));
        let top = (keys[first as usize] ^ keys[last as usize]).ilog2();
        let expected = (first..last)
            .find(|&i| (keys[i as usize] ^ keys[i as usize + 1]).ilog2() == top)
            .expect("the ends differ in that bit");
        assert_eq!(split, expected);
        let left = check(nodes, node.left, keys, first, split, seen);
        let right = check(nodes, node.right, keys, split + 1, last, seen);
        1 + left.max(right)
    }

    fn check_all<C: SortedCodes>(codes: &C, keys: &[u128], key_bits: u32) {
        let nodes = nodes(codes);
        let mut seen = Vec::new();
        let last = codes.count() - 1;
        let depth = check(&nodes, NodeRef::inner(0), keys, 0, last, &mut seen);
        seen.sort_unstable();
        assert!(seen.iter().copied().eq(0..nodes.len() as u32));
        assert!(depth <= depth_bound(key_bits, codes.count()));
    }

    #[test]
    fn the_papers_example() {
        // Figure 3 of Karras 2012: eight codes of five bits; the root splits after the fourth.
        let codes = [
            0b00001, 0b00010, 0b00100, 0b00101, 0b10011, 0b11000, 0b11001, 0b11110,
        ];
        let nodes = nodes(&Codes30::all(&codes));
        assert_eq!(nodes.len(), 1);
        assert_eq!(nodes[0].1, 3);
        assert_eq!(nodes[0].0.left, NodeRef::leaf(0, 4));
        assert_eq!(nodes[0].0.right, NodeRef::leaf(4, 4));
    }

    #[test]
    fn the_deepest_trees_keep_to_the_bound() {
        // One code for each bit, and as many equal ones at the end.
        let mut codes: Vec<u32> = (0..30).map(|bit| !(u32::MAX << bit)).collect();
        codes.splice(0..0, [0; 1000]);
        codes.sort_unstable();
        let keys: Vec<u128> = (0..)
            .zip(&codes)
            .map(|(i, &code)| (u128::from(code) << 32) | i)
            .collect();
        check_all(&Codes30::all(&codes), &keys, 30);
    }

    proptest! {
        #[test]
        fn nodes_are_those_of_the_recursive_split(mut codes in proptest::collection::vec(prop_oneof![0u32..8, 0u32..1 << 30], LEAF_SIZE as usize + 1..300)) {
            codes.sort_unstable();
            let keys: Vec<u128> = (0..).zip(&codes).map(|(i, &code)| (u128::from(code) << 32) | i).collect();
            check_all(&Codes30::all(&codes), &keys, 30);
        }

        #[test]
        fn long_codes_too(mut codes in proptest::collection::vec((prop_oneof![0u32..3, 0u32..1 << 31], prop_oneof![0u32..3, any::<u32>()]), LEAF_SIZE as usize + 1..300)) {
            codes.sort_unstable();
            let keys: Vec<u128> = (0..).zip(&codes).map(|(i, &(high, low))| (u128::from(high) << 64) | (u128::from(low) << 32) | i).collect();
            let codes: Vec<[u32; 2]> = codes.iter().map(|&(high, low)| [high, low]).collect();
            check_all(&Codes63::all(&codes), &keys, 63);
        }
    }
}
