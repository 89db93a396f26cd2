//! Stages `topology` and `refit` of a radix tree in one reading: [`slimbvh_core::sweep`], a subtree a task.

use super::compact::Selection;
use super::encode::TASK;
use slimbvh_core::compact::rank;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::refit_node;
use slimbvh_core::sweep::{Subtree, sweep};
use slimbvh_core::topology::{SortedCodes, internal_node, kept_nodes};
use slimbvh_core::{LeafTriangle, Node, NodeRef};

/// Sweeps trees. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Sweep {
    kept: Selection,
}

/// What all tasks read.
struct Leaves<'a, C> {
    codes: &'a C,
    triangles: &'a [LeafTriangle],
    kept: &'a Selection,
}

/// A subtree, with the list that its nodes fill.
struct Part<'a> {
    /// Its first leaf and its last.
    run: [u32; 2],
    /// The number of its topmost node among all nodes of the radix tree.
    number: u32,
    nodes: &'a mut [Node],
    /// The index of the first of these.
    first: u32,
}

impl Sweep {
    /// Replaces the nodes by those over sorted triangles, with boxes.
    pub fn fill<C: SortedCodes + Sync>(
        &mut self,
        codes: &C,
        triangles: &[LeafTriangle],
        nodes: &mut Vec<Node>,
    ) {
        let count = codes.count();
        let word_count = count.saturating_sub(1).div_ceil(32).max(1);
        let kept = &mut self.kept;
        let node_count = kept.fill(word_count as usize, |word| kept_nodes(word, codes));
        nodes.resize(node_count, Node::EMPTY);
        if count <= LEAF_SIZE {
            let (node, split) = internal_node(0, codes, &kept.bits, &kept.before);
            nodes[0] = refit_node(node, split, triangles, &[]);
            return;
        }
        let leaves = Leaves {
            codes,
            triangles,
            kept,
        };
        leaves.fill(Part {
            run: [0, count - 1],
            number: 0,
            nodes,
            first: 0,
        });
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        self.kept.bytes()
    }
}

impl<C: SortedCodes + Sync> Leaves<'_, C> {
    /// The index of a node, by its number among all nodes of the radix tree.
    fn place(&self, number: u32) -> u32 {
        rank(number, &self.kept.bits, &self.kept.before)
    }

    /// Fills a subtree's nodes. The result does not depend on where it is cut.
    fn fill(&self, part: Part) -> Subtree {
        let [first, last] = part.run;
        if last - first < TASK {
            let store = |place: u32, node| part.nodes[(place - part.first) as usize] = node;
            return sweep(
                part.run,
                self.codes,
                self.triangles,
                |i| self.place(i),
                store,
            );
        }
        let Selection { bits, before, .. } = self.kept;
        let (bare, split) = internal_node(part.number, self.codes, bits, before);
        // A node is the first or the last of its subtree's, and the right child the first of its own.
        let own = (self.place(part.number) - part.first) as usize;
        let is_first = own == 0;
        let (node, below) = match is_first {
            true => part.nodes.split_first_mut(),
            false => part.nodes.split_last_mut(),
        }
        .expect("a subtree of more than a leaf has a node");
        let begin = part.first + u32::from(is_first);
        let middle = match bare.right.is_leaf() {
            true => below.len(),
            false => (bare.right.index() - begin) as usize,
        };
        let (left_nodes, right_nodes) = below.split_at_mut(middle);
        let left = Part {
            run: [first, split],
            number: split,
            nodes: left_nodes,
            first: begin,
        };
        let right = Part {
            run: [split + 1, last],
            number: split + 1,
            nodes: right_nodes,
            first: begin + middle as u32,
        };
        let (left, right) = crate::parallel::join(|| self.fill(left), || self.fill(right));
        *node = Subtree::node(&left, &right, first, last);
        Subtree::joined(NodeRef::inner(part.first + own as u32), &left, &right)
    }
}
