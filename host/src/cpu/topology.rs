//! Stage `topology` on the CPU.

use super::select::Selection;
use slimbvh_core::Node;
use slimbvh_core::topology::{SortedCodes, internal_node, kept_nodes};

/// Which nodes are kept, and where each comes. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Connections {
    kept: Selection,
    /// The last triangle of each node's left child.
    pub splits: Vec<u32>,
}

impl Connections {
    /// Replaces the nodes by those over sorted codes, of which a function takes what is to be stored.
    pub fn connect<C: SortedCodes + Sync, N: Clone + Default + Send>(
        &mut self,
        codes: &C,
        nodes: &mut Vec<N>,
        stored: impl Fn(&Node) -> N + Sync,
    ) {
        let word_count = codes.count().saturating_sub(1).div_ceil(32).max(1);
        let node_count = self
            .kept
            .fill(word_count as usize, |word| kept_nodes(word, codes));
        nodes.resize(node_count, N::default());
        self.splits.resize(node_count, 0);
        let kept = &self.kept;
        kept.for_each(nodes, &mut self.splits, |i, node, split| {
            let (found, last) = internal_node(i as u32, codes, &kept.bits, &kept.before);
            (*node, *split) = (stored(&found), last);
        });
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        self.kept.bytes() + size_of_val(self.splits.as_slice())
    }
}
