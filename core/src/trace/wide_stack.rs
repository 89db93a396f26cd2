//! Children of wide nodes that wait in a traversal.

use super::lane_stack::{LANE_ROWS, LaneWords, lane_place};
use super::query::{ChildList, Rays};
use super::stack::{Empty, Enter, Waiting};
use super::wide::{MOST_WIDE_NODES, WideFork, WideRef};
use super::{DONE, NodeSource, STACK_SIZE};
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use crate::geometry::slab::FourPlanes;
use crate::launch::LANES;
use glam::Vec4;

/// A stack of the walk's own: a row a level of the tree, with a node, the list of its children that wait, and where rays enter each
/// of its children. Callers reuse it without clearing it.
#[derive(Clone, Copy, Debug)]
pub struct WideStack<E: Enter> {
    nodes: [u32; STACK_SIZE],
    lists: [ChildList; STACK_SIZE],
    enters: [E::Four; STACK_SIZE],
}

impl<E: Enter> Empty for WideStack<E> {
    const EMPTY: Self = Self {
        nodes: [0; STACK_SIZE],
        lists: [ChildList::NONE; STACK_SIZE],
        enters: [E::FOUR; STACK_SIZE],
    };
}

impl<P: FourPlanes, E: Enter> Waiting<WideFork<P>> for WideStack<E> {
    type Enter = E;

    /// A sound tree has fewer levels than [`STACK_SIZE`]. In another one rows are used again.
    const ROWS: u32 = i32::MAX as u32;

    #[inline(always)]
    fn go<N: NodeSource<Node = WideFork<P>, Cursor = NodeRef>, R: Rays<E>>(
        &mut self,
        node: WideFork<P>,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> NodeRef {
        let row = *waiting as usize % STACK_SIZE;
        let met = rays.open_wide(&node, &mut self.enters[row]);
        if met == ChildList::NONE {
            return self.take(nodes, rays, waiting);
        }
        let rest = met.rest();
        if rest != ChildList::NONE {
            self.nodes[row] = node.node;
            self.lists[row] = rest;
            *waiting += 1;
        }
        nodes.resume(WideRef::new(node.node, met.first()))
    }

    #[inline(always)]
    fn take<N: NodeSource<Node = WideFork<P>, Cursor = NodeRef>, R: Rays<E>>(
        &mut self,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> NodeRef {
        let mut waits = *waiting;
        while waits != 0 {
            let last = waits - 1;
            let row = last as usize % STACK_SIZE;
            let list = self.lists[row];
            let (child, rest) = (list.first(), list.rest());
            self.lists[row] = rest;
            waits = last + (rest != ChildList::NONE) as u32;
            if rays.is_due(E::of(&self.enters[row], child)) {
                *waiting = waits;
                return nodes.resume(WideRef::new(self.nodes[row], child));
            }
        }
        *waiting = DONE;
        N::NOTHING
    }
}

/// Bits of a list of up to three children that wait.
const LIST_BITS: u32 = ChildList::BITS / WIDTH as u32 * (WIDTH as u32 - 1);
const _: () = assert!(MOST_WIDE_NODES <= 1 << (u32::BITS - LIST_BITS));

/// Rows of a word each.
pub trait WordRows {
    /// How many rows there are.
    const ROWS: u32;

    /// The word in a row; in one beyond the last, that of another.
    fn word(&self, row: u32) -> u32;

    /// Puts a word in a row, as [`Self::word`].
    fn put(&mut self, row: u32, word: u32);
}

/// A lane's rows of an array that the lanes of a workgroup share.
#[derive(Debug)]
pub struct LaneRows<'a> {
    /// Words of all lanes.
    words: &'a mut LaneWords,
    /// The lane's number.
    lane: u32,
}

impl LaneRows<'_> {
    #[inline(always)]
    const fn place(&self, row: u32) -> usize {
        lane_place(row % LANE_ROWS as u32, self.lane)
    }
}

impl WordRows for LaneRows<'_> {
    const ROWS: u32 = LANE_ROWS as u32;

    #[inline(always)]
    fn word(&self, row: u32) -> u32 {
        self.words[self.place(row)]
    }

    #[inline(always)]
    fn put(&mut self, row: u32, word: u32) {
        self.words[self.place(row)] = word;
    }
}

/// Rows of a thread's own: one a level of any tree.
#[derive(Clone, Copy, Debug)]
pub struct OwnRows([u32; STACK_SIZE]);

impl WordRows for OwnRows {
    /// A sound tree has fewer levels than rows. In another one rows are used again.
    const ROWS: u32 = i32::MAX as u32;

    #[inline(always)]
    fn word(&self, row: u32) -> u32 {
        self.0[row as usize % STACK_SIZE]
    }

    #[inline(always)]
    fn put(&mut self, row: u32, word: u32) {
        self.0[row as usize % STACK_SIZE] = word;
    }
}

/// A stack of nodes, each with the list of its children that wait: a word a level of the tree. Where rays enter them is not kept.
#[derive(Clone, Copy, Debug)]
pub struct ListStack<R>(R);

/// A lane's stack in memory that the lanes of a workgroup share.
pub type LaneListStack<'a> = ListStack<LaneRows<'a>>;

impl<'a> LaneListStack<'a> {
    /// The stack of a lane in the words of all lanes.
    #[inline(always)]
    #[must_use]
    pub const fn new(words: &'a mut LaneWords, lane: u32) -> Self {
        Self(LaneRows {
            words,
            lane: lane % LANES as u32,
        })
    }
}

impl Empty for ListStack<OwnRows> {
    const EMPTY: Self = Self(OwnRows([0; STACK_SIZE]));
}

impl<R: WordRows> ListStack<R> {
    /// Takes the next child of the last row.
    #[inline(always)]
    fn pop(&mut self, waiting: &mut u32) -> WideRef {
        let row = waiting.wrapping_sub(1);
        let word = self.0.word(row);
        let list = ChildList(word & ((1 << LIST_BITS) - 1));
        let rest = list.rest().0;
        if (rest == 0) | (row == DONE) {
            *waiting = row;
        } else {
            self.0.put(row, word >> LIST_BITS << LIST_BITS | rest);
        }
        WideRef::new(word >> LIST_BITS, list.first())
    }
}

impl<P: FourPlanes, W: WordRows> Waiting<WideFork<P>> for ListStack<W> {
    type Enter = ();

    const ROWS: u32 = W::ROWS;

    #[inline(always)]
    fn go<N: NodeSource<Node = WideFork<P>, Cursor = NodeRef>, R: Rays<()>>(
        &mut self,
        node: WideFork<P>,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> NodeRef {
        let mut unused = Vec4::ZERO;
        let met = rays.open_wide(&node, &mut unused);
        let next = if met.0 == 0 {
            self.pop(waiting)
        } else {
            let list = met.rest().0;
            if list != 0 {
                // Beyond the last row the loops end.
                self.0.put(*waiting, node.node << LIST_BITS | list);
                *waiting += 1;
            }
            WideRef::new(node.node, met.first())
        };
        nodes.resume(next)
    }

    #[inline(always)]
    fn take<N: NodeSource<Node = WideFork<P>, Cursor = NodeRef>, R: Rays<()>>(
        &mut self,
        nodes: &N,
        _rays: &mut R,
        waiting: &mut u32,
    ) -> NodeRef {
        nodes.resume(self.pop(waiting))
    }
}
