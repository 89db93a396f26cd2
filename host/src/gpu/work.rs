//! The memory traffic of stages.

use std::ops::AddAssign;

/// A number of bytes, part of which depends on the node count, which only the GPU knows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Bytes that do not depend on the node count.
    pub bytes: u64,
    /// Bytes for each node.
    pub bytes_per_node: u64,
}

impl Traffic {
    /// All bytes, for `node_count` nodes.
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

/// The work of a stage. Each range counts once a dispatch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// The stage.
    pub stage: &'static str,
    /// Dispatches.
    pub dispatch_count: u32,
    /// Bytes read.
    pub read: Traffic,
    /// Bytes written.
    pub written: Traffic,
    /// The least possible traffic: inputs from other stages and results for later ones, each counted once.
    pub least: Traffic,
}
