//! What the children of a wide node of 48 bytes are: a run of nodes and a run of words.
//!
//! Inner children lie side by side, and so do the words of all leaves' triangles ([`super::shared_leaf`]), both in the order of
//! the children. So the first of each, what each child is, how many corners each leaf has and one width for all name all four. A
//! child is 7 for an inner node, else the number of a leaf's triangles, 0 where there is no child.
//!
//! ```text
//! x  bits 5–31   first word of the first leaf's triangles, its lowest 27 bits
//! y  bits 5–27   first inner child
//!    bit 28      bit 27 of the first word
//!    bits 29–31  the highest three bits of the leaves' corners
//! z  bits 5–6    the width of all leaves' corners (0 narrow, 1 middle, 2 wide)
//!    bits 7–19   four bits a child, the first child's lowest: how many corners a leaf has beyond three, else 0; the lowest 13
//!    bits 20–31  three bits a child, the first child's lowest: what it is
//! ```
//!
//! Bits 0–4 of each word are left to the axis ([`super::WideAxis`]).

use super::leaf_width::LeafWidth;
use super::shared_leaf::summed_words;
use super::wide_axis::SHIFT_BITS;
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use crate::trace::MOST_WIDE_NODES;

/// Bits of the first word that x has.
const WORD_BITS: u32 = u32::BITS - SHIFT_BITS;
const NODE_BITS: u32 = MOST_WIDE_NODES.trailing_zeros();
const WORD_HIGH: u32 = SHIFT_BITS + NODE_BITS;
const CORNERS_HIGH: u32 = WORD_HIGH + 1;
const CORNERS: u32 = SHIFT_BITS + 2;
const CORNERS_LOW_BITS: u32 = 16 - (u32::BITS - CORNERS_HIGH);
const KINDS: u32 = CORNERS + CORNERS_LOW_BITS;
const _: () = assert!(MOST_WIDE_NODES.is_power_of_two() && KINDS + 3 * WIDTH as u32 == u32::BITS);

const INNER: u32 = 7;

/// Corners that each leaf has at least: those of its first triangle.
const LEAST_CORNERS: u32 = 3;

/// The children of a wide node of 48 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PackedLinks {
    /// The first inner child's index, below [`MOST_WIDE_NODES`].
    pub first_child: u32,
    /// Where the first leaf's triangles begin, below 2^28.
    pub first_word: u32,
    /// Three bits for each child, the first lowest.
    pub kinds: u32,
    /// Four bits for each child, the first lowest: a leaf's corners beyond three.
    pub corners: u32,
    /// The width of all leaves' corners: 0 to 2.
    pub width: u32,
}

impl PackedLinks {
    /// Of the first `count` children; the others mean nothing. Only what they are is taken, how many corners leaves have, 3 to 18,
    /// and the width of all of these. Both runs begin at 0.
    #[inline(always)]
    #[must_use]
    pub fn new(
        children: [NodeRef; WIDTH],
        corner_counts: [u32; WIDTH],
        width: LeafWidth,
        count: u32,
    ) -> Self {
        let mut links = Self::default();
        for i in 0..WIDTH {
            if (i as u32) < count {
                let child = children[i];
                let kind = if child.is_leaf() {
                    links.corners |= corner_counts[i].wrapping_sub(LEAST_CORNERS) << (4 * i);
                    links.width = width as u32;
                    child.count()
                } else {
                    INNER
                };
                links.kinds |= kind << (3 * i);
            }
        }
        links
    }

    /// The same where runs begin at this inner child and at this word. A run of nothing begins at 0.
    #[inline(always)]
    #[must_use]
    pub const fn at(self, first_child: u32, first_word: u32) -> Self {
        let first_child = if self.inner() == 0 { 0 } else { first_child };
        let first_word = if self.leaf_words() == 0 {
            0
        } else {
            first_word
        };
        Self {
            first_child,
            first_word,
            ..self
        }
    }

    /// The words of x, y and z, without the axes' bits.
    #[inline(always)]
    #[must_use]
    pub const fn words(self) -> [u32; 3] {
        [
            self.first_word << SHIFT_BITS,
            self.first_child << SHIFT_BITS
                | (self.first_word >> WORD_BITS & 1) << WORD_HIGH
                | self.corners >> CORNERS_LOW_BITS << CORNERS_HIGH,
            self.width << SHIFT_BITS
                | (self.corners & ((1 << CORNERS_LOW_BITS) - 1)) << CORNERS
                | self.kinds << KINDS,
        ]
    }

    /// The links in the words of x, y and z. The axes' bits do not count.
    #[inline(always)]
    #[must_use]
    pub const fn from_words([x, y, z]: [u32; 3]) -> Self {
        Self {
            first_child: y >> SHIFT_BITS & (MOST_WIDE_NODES - 1),
            first_word: x >> SHIFT_BITS | (y >> WORD_HIGH & 1) << WORD_BITS,
            kinds: z >> KINDS,
            corners: z >> CORNERS & ((1 << CORNERS_LOW_BITS) - 1)
                | y >> CORNERS_HIGH << CORNERS_LOW_BITS,
            width: z >> SHIFT_BITS & 3,
        }
    }

    /// What a child is.
    #[inline(always)]
    #[must_use]
    pub const fn kind(self, child: u32) -> u32 {
        self.kinds >> ((3 * child) & 31) & 7
    }

    /// How many children there are.
    #[inline(always)]
    #[must_use]
    pub const fn count(self) -> u32 {
        (self.kind(0) != 0) as u32
            + (self.kind(1) != 0) as u32
            + (self.kind(2) != 0) as u32
            + (self.kind(3) != 0) as u32
    }

    /// Whether a child is an inner node.
    #[inline(always)]
    #[must_use]
    pub const fn is_inner(self, child: u32) -> bool {
        self.kind(child) == INNER
    }

    /// An inner child's index.
    #[inline(always)]
    #[must_use]
    pub const fn inner_child(self, child: u32) -> u32 {
        self.first_child.wrapping_add(before(self.inner(), child))
    }

    /// The width of leaves' corners.
    #[inline(always)]
    #[must_use]
    pub const fn width(self) -> LeafWidth {
        LeafWidth::of_number(self.width)
    }

    /// A leaf's number of corners.
    #[inline(always)]
    #[must_use]
    pub const fn corner_count(self, child: u32) -> u32 {
        LEAST_CORNERS + (self.corners >> ((4 * child) & 31) & 0xf)
    }

    /// A byte for each child: what it is.
    #[inline(always)]
    const fn spread_kinds(self) -> u32 {
        let spread = (self.kinds | self.kinds << 10) & 0x003f_003f;
        (spread | spread << 5) & 0x0707_0707
    }

    /// A byte for each child: 1 for an inner child, else 0.
    #[inline(always)]
    const fn inner(self) -> u32 {
        (self.spread_kinds() + 0x0101_0101) >> 3 & 0x0101_0101
    }

    /// A byte for each child: the words of a leaf's triangles, else 0.
    #[inline(always)]
    const fn leaf_words(self) -> u32 {
        let triangles = self.spread_kinds() - INNER * self.inner();
        let is_leaf = (triangles + 0x0707_0707) >> 3 & 0x0101_0101;
        let spread = (self.corners | self.corners << 8) & 0x00ff_00ff;
        let more = (spread | spread << 4) & 0x0f0f_0f0f;
        // Bytes do not overflow: at most 6 triangles and 18 corners of at most 4 words. What is halved of a byte's odd number is
        // in the byte below, where it is masked.
        summed_words(
            triangles,
            triangles >> 1 & 0x0303_0303,
            more + LEAST_CORNERS * is_leaf,
            self.width + 1,
        )
    }

    /// Whether no other links name the same children: there are as many as `count`, the first ones; leaves' corners are as many as
    /// their triangles can have; the width is known, and there is one only for leaves; and runs of nothing begin at 0.
    #[must_use]
    pub fn are_canonical(self, count: u32) -> bool {
        let is_known = |child: u32| {
            let (kind, corners) = (self.kind(child), self.corner_count(child));
            match kind {
                0 => child >= count && corners == LEAST_CORNERS,
                INNER => child < count && corners == LEAST_CORNERS,
                _ => child < count && corners <= 3 * kind,
            }
        };
        let has_width = self.leaf_words() != 0 && self.width <= LeafWidth::Wide as u32;
        (0..WIDTH as u32).all(is_known)
            && (has_width || self.width == 0)
            && self == self.at(self.first_child, self.first_word)
    }

    /// How many children are inner nodes.
    #[inline(always)]
    #[must_use]
    pub const fn inner_count(self) -> u32 {
        self.inner().wrapping_mul(0x0101_0101) >> 24
    }

    /// The words of all leaves' triangles.
    #[inline(always)]
    #[must_use]
    pub const fn word_count(self) -> u32 {
        let words = self.leaf_words();
        before(words, 3) + (words >> 24)
    }

    /// A child by its number, 0 to 3. A leaf begins at a word.
    #[inline(always)]
    #[must_use]
    pub const fn child(self, number: u32) -> NodeRef {
        let kind = self.kind(number);
        if kind == INNER {
            NodeRef::inner(self.inner_child(number))
        } else {
            let first = self
                .first_word
                .wrapping_add(before(self.leaf_words(), number));
            NodeRef::leaf(first & (crate::MAX_TRIANGLES - 1), kind)
        }
    }

    /// All four children, leaves without triangles where there are none.
    #[inline(always)]
    #[must_use]
    pub fn children(self) -> [NodeRef; WIDTH] {
        let child = |number: u32| {
            if self.kind(number) == 0 {
                NodeRef::EMPTY_LEAF
            } else {
                self.child(number)
            }
        };
        [child(0), child(1), child(2), child(3)]
    }
}

/// The sum of the bytes before a child's: a product adds up, in each byte, all that are lower. At most 255.
#[inline(always)]
const fn before(bytes: u32, child: u32) -> u32 {
    bytes.wrapping_mul(0x0101_0100) >> ((8 * child) & 31) & 0xff
}

#[cfg(test)]
mod tests {
    use super::super::shared_leaf::leaf_words;
    use super::*;
    use proptest::array::uniform4;
    use proptest::prelude::*;

    /// Children with the numbers of their corners, the width of these and how many children there are, and where runs begin.
    fn links() -> impl Strategy<Value = ([NodeRef; 4], [u32; 4], LeafWidth, u32, [u32; 2])> {
        let child = prop_oneof![
            Just((NodeRef::inner(77), 0)),
            (1..=6u32).prop_flat_map(|count| (3..=3 * count)
                .prop_map(move |corners| (NodeRef::leaf(33, count), corners)))
        ];
        let width = prop_oneof![
            Just(LeafWidth::Narrow),
            Just(LeafWidth::Middle),
            Just(LeafWidth::Wide)
        ];
        let node = prop_oneof![0..100u32, (1u32 << 23) - 300..(1 << 23) - 4];
        let word = prop_oneof![0..100u32, (1u32 << 28) - 300..(1 << 28) - 252];
        (uniform4(child), width, 0..=4u32, node, word).prop_map(
            |(children, width, count, node, word)| {
                let (corners, children) = (children.map(|it| it.1), children.map(|it| it.0));
                (children, corners, width, count, [node, word])
            },
        )
    }

    proptest! {
        #[test]
        fn links_give_back_all_children((children, corners, width, count, [first_child, first_word]) in links(), others: [u32; 3]) {
            let links = PackedLinks::new(children, corners, width, count).at(first_child, first_word);
            let mut words = links.words();
            for (word, other) in words.iter_mut().zip(others) {
                prop_assert_eq!(*word & 31, 0, "these bits are the axes'");
                *word |= other & 31;
            }
            let read = PackedLinks::from_words(words);
            prop_assert_eq!(read, links);
            let is_at = |first: u32, count: u32| if count == 0 { 0 } else { first };
            prop_assert_eq!(read.first_child, is_at(first_child, read.inner_count()));
            prop_assert_eq!(read.first_word, is_at(first_word, read.word_count()));
            let (mut inner, mut word) = (first_child, first_word);
            for number in 0..4 {
                let (child, corners) = (children[number as usize], corners[number as usize]);
                if number >= count {
                    prop_assert_eq!(read.child(number).count(), 0);
                    prop_assert_eq!(read.children()[number as usize], NodeRef::EMPTY_LEAF);
                    continue;
                }
                prop_assert_eq!(read.children()[number as usize], read.child(number));
                if child.is_leaf() {
                    prop_assert_eq!(read.child(number), NodeRef::leaf(word, child.count()));
                    prop_assert_eq!(read.width(), width);
                    prop_assert_eq!(read.corner_count(number), corners);
                    word += leaf_words(child.count(), corners, width.vertex_words());
                } else {
                    prop_assert_eq!(read.child(number), NodeRef::inner(inner));
                    inner += 1;
                }
            }
            prop_assert!(read.are_canonical(count));
            prop_assert_eq!(read.inner_count(), inner - first_child);
            prop_assert_eq!(read.word_count(), word - first_word);
        }
    }

    /// The negative control: kinds exchanged name other children, and so do other corners and another width.
    #[test]
    fn exchanged_kinds_are_found() {
        let children = [
            NodeRef::leaf(0, 2),
            NodeRef::inner(0),
            NodeRef::leaf(0, 6),
            NodeRef::inner(0),
        ];
        let links = PackedLinks::new(children, [4, 0, 18, 0], LeafWidth::Middle, 4).at(5, 10);
        assert_eq!(links.child(0), NodeRef::leaf(10, 2));
        assert_eq!(links.child(2), NodeRef::leaf(10 + 4 * 2 + 2 + 1, 6));
        assert_eq!(links.word_count(), 11 + 18 * 2 + 6 + 3);
        let spoilt = PackedLinks {
            kinds: links.kinds >> 6 | (links.kinds & 0x3f) << 6,
            ..links
        };
        assert_ne!(spoilt.child(0), links.child(0));
        assert_ne!(spoilt.child(2), links.child(2));
        for (corners, width) in [(links.corners + 1, links.width), (links.corners, 0)] {
            let spoilt = PackedLinks {
                corners,
                width,
                ..links
            };
            assert_ne!(spoilt.child(2), links.child(2));
        }
        // What is no child, corners of what is no leaf, more corners than there can be, an unknown width.
        for (kinds, corners, width) in [(7, 0, 0), (0, 1 << 4, 0), (0, 7, 0), (0, 0, 3)] {
            let spoilt = PackedLinks {
                kinds: links.kinds & !kinds,
                corners: links.corners | corners,
                width: links.width | width,
                ..links
            };
            assert!(!spoilt.are_canonical(4), "{kinds} {corners} {width}");
        }
        assert!(links.are_canonical(4) && !links.are_canonical(3));
        let without = PackedLinks::new([NodeRef::leaf(0, 3); 4], [3; 4], LeafWidth::Narrow, 1);
        let idle = PackedLinks {
            first_child: 1,
            ..without
        };
        assert!(without.are_canonical(1) && !idle.are_canonical(1));
        let inner = PackedLinks::new([NodeRef::inner(0); 4], [0; 4], LeafWidth::Wide, 2);
        let wide = PackedLinks { width: 1, ..inner };
        assert!(inner.are_canonical(2) && !wide.are_canonical(2));
    }
}
