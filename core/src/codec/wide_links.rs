//! What the children of a wide node on the lattice are, where they are not named one by one: a run of nodes and a run of words.
//!
//! Inner children lie side by side, and so do the words of all leaves' triangles, both in the order of the children. So the
//! first of each, a nibble a child and the width of each leaf's triangles name all four. The nibble is 8 for an inner child, else
//! the number of a leaf's triangles, 0 where there is no child.
//!
//! ```text
//! x  bits 5–31   first inner child, its lowest 27 bits
//! y  bits 5–31   first word of the first leaf's triangles, its lowest 27 bits
//! z  bits 5–20   the four nibbles, the first child's lowest
//!    bit 21      bit 27 of the first inner child
//!    bit 22      bit 27 of the first word
//!    bits 23–30  two bits a child: the width of a leaf's triangles (0 narrow, 1 middle, 2 wide), else 0
//!    bit 31      0
//! ```
//!
//! Bits 0–4 of each word are left to the axis ([`super::WideAxis`]).

use super::leaf_width::LeafWidth;
use super::wide_axis::SHIFT_BITS;
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;

/// Bits that a word has for links.
const BITS: u32 = u32::BITS - SHIFT_BITS;
const INNER: u32 = 8;
const FIRST_CHILD_HIGH: u32 = 21;
const FIRST_WORD_HIGH: u32 = 22;
const WIDTHS: u32 = 23;

/// The children of a wide node on the lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WideLinks {
    /// The first inner child's index, below 2^28.
    pub first_child: u32,
    /// Where the first leaf's triangles begin, below 2^28.
    pub first_word: u32,
    /// A nibble for each child, the first lowest.
    pub kinds: u32,
    /// Two bits for each child, the first lowest.
    pub widths: u32,
}

impl WideLinks {
    /// Of the first `count` children; the others mean nothing. Only what they are is taken, and the width of leaves' triangles.
    /// Both runs begin at 0.
    #[inline(always)]
    #[must_use]
    pub fn new(children: [NodeRef; WIDTH], widths: [LeafWidth; WIDTH], count: u32) -> Self {
        let mut links = Self::default();
        for i in 0..WIDTH {
            if (i as u32) < count {
                let child = children[i];
                let is_leaf = child.is_leaf();
                let kind = if is_leaf { child.count() } else { INNER };
                let width = if is_leaf { widths[i] as u32 } else { 0 };
                links.kinds |= kind << (4 * i);
                links.widths |= width << (2 * i);
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
            self.first_child << SHIFT_BITS,
            self.first_word << SHIFT_BITS,
            self.kinds << SHIFT_BITS
                | (self.first_child >> BITS & 1) << FIRST_CHILD_HIGH
                | (self.first_word >> BITS & 1) << FIRST_WORD_HIGH
                | self.widths << WIDTHS,
        ]
    }

    /// The links in the words of x, y and z. The axes' bits do not count.
    #[inline(always)]
    #[must_use]
    pub const fn from_words([x, y, z]: [u32; 3]) -> Self {
        Self {
            first_child: x >> SHIFT_BITS | (z >> FIRST_CHILD_HIGH & 1) << BITS,
            first_word: y >> SHIFT_BITS | (z >> FIRST_WORD_HIGH & 1) << BITS,
            kinds: z >> SHIFT_BITS & 0xffff,
            widths: z >> WIDTHS & 0xff,
        }
    }

    /// A child's nibble.
    #[inline(always)]
    #[must_use]
    pub const fn kind(self, child: u32) -> u32 {
        self.kinds >> ((4 * child) & 31) & 0xf
    }

    /// The bits of a child's width.
    #[inline(always)]
    #[must_use]
    pub const fn width_bits(self, child: u32) -> u32 {
        self.widths >> ((2 * child) & 31) & 3
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
        self.kinds >> ((4 * child) & 31) & INNER != 0
    }

    /// An inner child's index.
    #[inline(always)]
    #[must_use]
    pub const fn inner_child(self, child: u32) -> u32 {
        self.first_child.wrapping_add(before(self.inner(), child))
    }

    /// The width of a leaf's triangles.
    #[inline(always)]
    #[must_use]
    pub const fn width(self, child: u32) -> LeafWidth {
        match self.width_bits(child) {
            0 => LeafWidth::Narrow,
            1 => LeafWidth::Middle,
            _ => LeafWidth::Wide,
        }
    }

    /// Words of a triangle in a leaf.
    #[inline(always)]
    #[must_use]
    pub const fn triangle_words(self, child: u32) -> u32 {
        LeafWidth::Narrow.words() + WORDS_A_WIDTH * self.width_bits(child)
    }

    /// A byte for each child: its nibble.
    #[inline(always)]
    const fn spread_kinds(self) -> u32 {
        let spread = (self.kinds | self.kinds << 8) & 0x00ff_00ff;
        (spread | spread << 4) & 0x0f0f_0f0f
    }

    /// A byte for each child: 1 for an inner child, else 0.
    #[inline(always)]
    const fn inner(self) -> u32 {
        self.spread_kinds() >> 3 & 0x0101_0101
    }

    /// A byte for each child: the words of a leaf's triangles, else 0.
    #[inline(always)]
    const fn leaf_words(self) -> u32 {
        let triangles = self.spread_kinds() & 0x0707_0707;
        let spread = (self.widths | self.widths << 12) & 0x000f_000f;
        let spread = (spread | spread << 6) & 0x0303_0303;
        // All bits of the bytes of children whose width has the lower bit, and of those whose width has the upper one.
        let middle = (spread & 0x0101_0101).wrapping_mul(0xff);
        let wide = (spread >> 1 & 0x0101_0101).wrapping_mul(0xff);
        let more = (triangles & middle) + 2 * (triangles & wide);
        LeafWidth::Narrow.words() * triangles + WORDS_A_WIDTH * more
    }

    /// Whether no other links name the same children: there are as many as `count`, the first ones, each a leaf or an inner node of a
    /// known kind; widths are known and those of leaves; and runs of nothing begin at 0.
    #[must_use]
    pub fn are_canonical(self, count: u32) -> bool {
        let is_known = |child: u32| {
            let (kind, width) = (self.kind(child), self.width_bits(child));
            match kind {
                0 => child >= count && width == 0,
                INNER => child < count && width == 0,
                _ => child < count && kind < INNER && width <= LeafWidth::Wide as u32,
            }
        };
        (0..WIDTH as u32).all(is_known) && self == self.at(self.first_child, self.first_word)
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
        if self.is_inner(number) {
            NodeRef::inner(self.inner_child(number))
        } else {
            let first = self
                .first_word
                .wrapping_add(before(self.leaf_words(), number));
            NodeRef::leaf(first & (crate::MAX_TRIANGLES - 1), self.kind(number) & 7)
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

/// How many words more a triangle takes than one of the next smaller width.
const WORDS_A_WIDTH: u32 = LeafWidth::Middle.words() - LeafWidth::Narrow.words();
const _: () = assert!(LeafWidth::Wide.words() - LeafWidth::Middle.words() == WORDS_A_WIDTH);
const _: () = assert!(
    LeafWidth::Narrow as u32 == 0 && LeafWidth::Middle as u32 == 1 && LeafWidth::Wide as u32 == 2
);

/// The sum of the bytes before a child's: a product adds up, in each byte, all that are lower. At most 255.
#[inline(always)]
const fn before(bytes: u32, child: u32) -> u32 {
    bytes.wrapping_mul(0x0101_0100) >> ((8 * child) & 31) & 0xff
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::array::uniform4;
    use proptest::prelude::*;

    /// Children with the widths of their triangles and how many they are, and where runs begin.
    fn links() -> impl Strategy<Value = ([NodeRef; 4], [LeafWidth; 4], u32, [u32; 2])> {
        let kind = prop_oneof![Just(INNER), 1..=6u32];
        let width = prop_oneof![
            Just(LeafWidth::Narrow),
            Just(LeafWidth::Middle),
            Just(LeafWidth::Wide)
        ];
        let first = || prop_oneof![0..100u32, (1u32 << 28) - 300..(1 << 28) - 240];
        let kinds = uniform4((kind, width));
        (kinds, 0..=4u32, first(), first()).prop_map(|(kinds, count, inner, word)| {
            let children = kinds.map(|(kind, _)| match kind {
                INNER => NodeRef::inner(77),
                count => NodeRef::leaf(33, count),
            });
            (
                children,
                kinds.map(|(_, width)| width),
                count,
                [inner, word],
            )
        })
    }

    proptest! {
        #[test]
        fn links_give_back_all_children((children, widths, count, [first_child, first_word]) in links(), others: [u32; 3]) {
            let links = WideLinks::new(children, widths, count).at(first_child, first_word);
            let mut words = links.words();
            for (word, other) in words.iter_mut().zip(others) {
                prop_assert_eq!(*word & 31, 0, "these bits are the axes'");
                *word |= other & 31;
            }
            prop_assert_eq!(words[2] >> 31, 0);
            let read = WideLinks::from_words(words);
            prop_assert_eq!(read, links);
            let is_at = |first: u32, count: u32| if count == 0 { 0 } else { first };
            prop_assert_eq!(read.first_child, is_at(first_child, read.inner_count()));
            prop_assert_eq!(read.first_word, is_at(first_word, read.word_count()));
            let (mut inner, mut word) = (first_child, first_word);
            for number in 0..4 {
                let (child, width) = (children[number as usize], widths[number as usize]);
                if number >= count {
                    prop_assert_eq!(read.child(number).count(), 0);
                    prop_assert_eq!(read.children()[number as usize], NodeRef::EMPTY_LEAF);
                    continue;
                }
                prop_assert_eq!(read.children()[number as usize], read.child(number));
                if child.is_leaf() {
                    prop_assert_eq!(read.child(number), NodeRef::leaf(word, child.count()));
                    prop_assert_eq!(read.triangle_words(number), width.words());
                    word += child.count() * width.words();
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

    /// The negative control: two kinds exchanged name other children, and so do two widths.
    #[test]
    fn exchanged_kinds_are_found() {
        let children = [
            NodeRef::leaf(0, 2),
            NodeRef::inner(0),
            NodeRef::leaf(0, 6),
            NodeRef::inner(0),
        ];
        let widths = [
            LeafWidth::Middle,
            LeafWidth::Narrow,
            LeafWidth::Wide,
            LeafWidth::Narrow,
        ];
        let links = WideLinks::new(children, widths, 4).at(5, 10);
        assert_eq!(links.child(0), NodeRef::leaf(10, 2));
        assert_eq!(links.child(2), NodeRef::leaf(10 + 2 * 7, 6));
        let spoilt = WideLinks {
            kinds: links.kinds >> 8 | (links.kinds & 0xff) << 8,
            ..links
        };
        assert_ne!(spoilt.child(0), links.child(0));
        assert_ne!(spoilt.child(2), links.child(2));
        let spoilt = WideLinks {
            widths: links.widths >> 4 | (links.widths & 0xf) << 4,
            ..links
        };
        assert_ne!(spoilt.child(2), links.child(2));
        // What is no child, of an unknown kind or width, or both a leaf and none.
        for (kinds, widths) in [(0xf, 0), (9 << 4, 0), (0, 1 << 2), (0, 2), (8 << 8, 0)] {
            let spoilt = WideLinks {
                kinds: links.kinds | kinds,
                widths: links.widths | widths,
                ..links
            };
            assert!(!spoilt.are_canonical(4), "{kinds} {widths}");
        }
        assert!(links.are_canonical(4) && !links.are_canonical(3));
        let without = WideLinks::new([NodeRef::leaf(0, 3); 4], widths, 1);
        let idle = WideLinks {
            first_child: 1,
            ..without
        };
        assert!(without.are_canonical(1) && !idle.are_canonical(1));
    }
}
