//! Nodes that wait in a traversal, in memory that the lanes of a workgroup share.
//!
//! A private array of a GPU's thread lies in the GPU's main memory, and is filled with zeros there before the first node is read:
//! 1 KiB a ray for 128 nodes. Workgroup memory is as near as a cache, but scarce: 8 KiB a workgroup hold 32 nodes a lane. A
//! ray that needs more begins again with a private array.
//!
//! Word `lane` of each row of [`LANES`] words is the lane's own, so that lanes at the same row use different banks.

use super::stack::{BoxCursor, Rows};
use crate::build::node::NodeRef;
use crate::launch::LANES;

/// Nodes that may wait in each lane of a [`LaneStack`].
pub const LANE_ROWS: usize = 32;

/// The words of a workgroup's [`LaneStack`]s: 8 KiB.
pub type LaneWords = [u32; LANE_ROWS * LANES];

/// A lane's stack of nodes.
#[derive(Debug)]
pub struct LaneStack<'a> {
    /// Words of all lanes.
    words: &'a mut LaneWords,
    /// The lane's number.
    lane: u32,
}

impl<'a> LaneStack<'a> {
    /// The stack of a lane in the words of all lanes.
    #[inline(always)]
    #[must_use]
    pub const fn new(words: &'a mut LaneWords, lane: u32) -> Self {
        Self {
            words,
            lane: lane % LANES as u32,
        }
    }

    #[inline(always)]
    const fn place(&self, row: u32) -> usize {
        lane_place(row % LANE_ROWS as u32, self.lane)
    }
}

impl Rows<NodeRef> for LaneStack<'_> {
    type Enter = ();

    const ROWS: u32 = LANE_ROWS as u32;

    #[inline(always)]
    fn put(&mut self, row: u32, cursor: NodeRef, (): ()) {
        self.words[self.place(row)] = cursor.0;
    }

    #[inline(always)]
    fn cursor(&self, row: u32) -> NodeRef {
        NodeRef(self.words[self.place(row)])
    }

    #[inline(always)]
    fn enter(&self, _: u32) {}
}

/// Words of a node and its box.
const BOX_WORDS: usize = 7;

/// Nodes that may wait in each lane of a [`LaneBoxStack`].
pub const LANE_BOX_ROWS: usize = 9;

/// The words of a workgroup's [`LaneBoxStack`]s: 15.75 KiB, as the smallest limit of workgroup memory is 16 KiB.
pub type LaneBoxWords = [u32; LANE_BOX_ROWS * BOX_WORDS * LANES];

/// A lane's stack of nodes with their boxes.
#[derive(Debug)]
pub struct LaneBoxStack<'a> {
    /// Words of all lanes.
    words: &'a mut LaneBoxWords,
    /// The lane's number.
    lane: u32,
}

impl<'a> LaneBoxStack<'a> {
    /// The stack of a lane in the words of all lanes.
    #[inline(always)]
    #[must_use]
    pub const fn new(words: &'a mut LaneBoxWords, lane: u32) -> Self {
        Self {
            words,
            lane: lane % LANES as u32,
        }
    }

    #[inline(always)]
    const fn place(&self, row: u32, word: u32) -> usize {
        lane_place(
            row % LANE_BOX_ROWS as u32 * BOX_WORDS as u32 + word,
            self.lane,
        )
    }

    #[inline(always)]
    const fn number(&self, row: u32, word: u32) -> f32 {
        f32::from_bits(self.words[self.place(row, word)])
    }
}

impl<C: BoxCursor> Rows<C> for LaneBoxStack<'_> {
    type Enter = ();

    const ROWS: u32 = LANE_BOX_ROWS as u32;

    #[inline(always)]
    fn put(&mut self, row: u32, cursor: C, (): ()) {
        let [min, max] = cursor.corners();
        self.words[self.place(row, 0)] = cursor.node().0;
        self.words[self.place(row, 1)] = min[0].to_bits();
        self.words[self.place(row, 2)] = min[1].to_bits();
        self.words[self.place(row, 3)] = min[2].to_bits();
        self.words[self.place(row, 4)] = max[0].to_bits();
        self.words[self.place(row, 5)] = max[1].to_bits();
        self.words[self.place(row, 6)] = max[2].to_bits();
    }

    #[inline(always)]
    fn cursor(&self, row: u32) -> C {
        C::new(
            NodeRef(self.words[self.place(row, 0)]),
            [
                self.number(row, 1),
                self.number(row, 2),
                self.number(row, 3),
            ],
            [
                self.number(row, 4),
                self.number(row, 5),
                self.number(row, 6),
            ],
        )
    }

    #[inline(always)]
    fn enter(&self, _: u32) {}
}

/// A lane's word of a row of words.
#[inline(always)]
pub(super) const fn lane_place(word_row: u32, lane: u32) -> usize {
    (word_row * LANES as u32 + lane) as usize
}
