//! What the stages ask of the GPU's memory.

use std::ops::AddAssign;

/// Bytes, some of which depend on how many nodes a hierarchy has: only the GPU knows that.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Whatever the number of nodes.
    pub bytes: u64,
    /// For each node.
    pub bytes_per_node: u64,
}

impl Traffic {
    /// All bytes, for N nodes.
    #[must_use]
    pub const fn total(self, node_count: u64) -> u64 {
        self.bytes + self.bytes_per_node * node_count
    }
}

impl AddAssign for Traffic {
    fn add_assign(&mut self, other: Self) {
        self.bytes += other.bytes;
        self.bytes_per_node += other.bytes_per_node;
    }
}

/// What a stage asks of the GPU. Each range counts once a dispatch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// The stage.
    pub stage: &'static str,
    /// Dispatches.
    pub dispatch_count: u32,
    /// What is read.
    pub read: Traffic,
    /// What is written.
    pub written: Traffic,
    /// What the stage reads that is not its own, and what it leaves for others, each counted once: no stage that does the
    /// same can move less.
    pub least: Traffic,
}
