//! Stacks of the traversal: one set a thread, a stack for each kind of nodes.

use super::lanes::Numbers;
use slimbvh_core::NodeRef;
use slimbvh_core::encode::{LatticeCursor, PrintedCursor};
use slimbvh_core::trace::PacketStacks;
use std::cell::RefCell;

/// Stacks for each kind of nodes.
pub struct Stacks {
    pub plain: PacketStacks<NodeRef, Numbers>,
    pub paper10: PacketStacks<PrintedCursor, Numbers>,
    pub lattice: PacketStacks<LatticeCursor, Numbers>,
}

impl Stacks {
    /// All empty.
    pub const EMPTY: Self = Self {
        plain: PacketStacks::EMPTY,
        paper10: PacketStacks::EMPTY,
        lattice: PacketStacks::EMPTY,
    };
}

thread_local! {
    static STACKS: RefCell<Stacks> = const { RefCell::new(Stacks::EMPTY) };
}

/// Calls a function with the thread's own stacks.
pub fn with_stacks<R>(run: impl FnOnce(&mut Stacks) -> R) -> R {
    STACKS.with_borrow_mut(run)
}
