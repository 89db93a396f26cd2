//! Nodes without boxes, on the CPU: of a clustered tree, or of one to be refitted.

use slimbvh_core::node::Connection;
use slimbvh_core::refit::split_of;
use slimbvh_core::{Node, NodeRef};

/// Nodes without boxes. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Connections {
    /// The nodes.
    pub nodes: Vec<Connection>,
    /// The last triangle of each node's left child.
    pub splits: Vec<u32>,
}

impl Connections {
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
        size_of_val(self.nodes.as_slice()) + size_of_val(self.splits.as_slice())
    }
}
