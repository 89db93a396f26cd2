//! Stage `topology` on the CPU.

use super::compact::Selection;
use slimbvh_core::node::Connection;
use slimbvh_core::refit::split_of;
use slimbvh_core::topology::{SortedCodes, internal_node, kept_nodes};
use slimbvh_core::{Node, NodeRef};

/// The nodes that are kept, and their positions. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Connections {
    kept: Selection,
    /// The nodes.
    pub nodes: Vec<Connection>,
    /// The last triangle of each node's left child.
    pub splits: Vec<u32>,
}

impl Connections {
    /// Replaces the nodes by those over sorted codes.
    pub fn connect<C: SortedCodes + Sync>(&mut self, codes: &C) {
        let word_count = codes.count().saturating_sub(1).div_ceil(32).max(1);
        let node_count = self
            .kept
            .fill(word_count as usize, |word| kept_nodes(word, codes));
        self.nodes.resize(node_count, Connection::default());
        self.splits.resize(node_count, 0);
        let (kept, nodes) = (&self.kept, &mut self.nodes);
        kept.for_each(nodes, &mut self.splits, |i, node, split| {
            let (found, last) = internal_node(i as u32, codes, &kept.bits, &kept.before);
            (*node, *split) = (Connection::from(&found), last);
        });
    }

    /// Takes the nodes of an existing hierarchy. One that was never built has one empty node.
    pub fn follow(&mut self, nodes: &[Node]) {
        let nodes = if nodes.is_empty() {
            &[Node::EMPTY]
        } else {
            nodes
        };
        let last_of = |child: NodeRef| nodes.get(child.index() as usize).map_or(0, |n| n.last);
        self.nodes.clear();
        self.nodes.extend(nodes.iter().map(Connection::from));
        self.splits.clear();
        let splits = nodes.iter().map(|node| split_of(node, last_of(node.left)));
        self.splits.extend(splits);
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        self.kept.bytes() + size_of_val(self.nodes.as_slice()) + size_of_val(self.splits.as_slice())
    }
}
