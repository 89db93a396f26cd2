//! Stage `topology` on the CPU.

use super::BLOCK;
use rayon::prelude::*;
use slimbvh_core::Node;
use slimbvh_core::scan::run_scan;
use slimbvh_core::topology::{SortedCodes, internal_node, kept_nodes};

/// Which nodes are kept, and where each comes. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Connections {
    kept: Vec<u32>,
    kept_before: Vec<u32>,
    /// The last triangle of each node's left child.
    pub splits: Vec<u32>,
}

impl Connections {
    /// Replaces the nodes by those over more than LEAF_SIZE sorted codes, without boxes.
    pub fn connect<C: SortedCodes + Sync>(&mut self, codes: &C, nodes: &mut Vec<Node>) {
        let Self {
            kept,
            kept_before,
            splits,
        } = self;
        const WORDS: usize = BLOCK / 32;
        let word_count = (codes.count() as usize - 1).div_ceil(32);
        kept.resize(word_count, 0);
        kept_before.resize(word_count, 0);
        let blocks = kept
            .par_chunks_mut(WORDS)
            .zip(kept_before.par_chunks_mut(WORDS))
            .enumerate();
        blocks.for_each(|(block, (kept, counts))| {
            for ((bits, count), word) in kept.iter_mut().zip(counts).zip((block * WORDS) as u32..) {
                *bits = kept_nodes(word, codes);
                *count = bits.count_ones();
            }
        });
        let node_count = run_scan(kept_before, 0, word_count as u32, 0) as usize;

        // Each block of words writes the run of kept nodes that begins where the counts say.
        nodes.resize(node_count, Node::EMPTY);
        splits.resize(node_count, 0);
        let mut blocks = Vec::with_capacity(word_count.div_ceil(WORDS));
        let (mut rest, mut split_rest) = (nodes.as_mut_slice(), splits.as_mut_slice());
        for block in 0..word_count.div_ceil(WORDS) {
            let begin = kept_before[block * WORDS] as usize;
            let end = kept_before
                .get((block + 1) * WORDS)
                .map_or(node_count, |&next| next as usize);
            let (run, after) = rest.split_at_mut(end - begin);
            let (split_run, split_after) = split_rest.split_at_mut(end - begin);
            (rest, split_rest) = (after, split_after);
            blocks.push((block * WORDS, run, split_run));
        }
        let (kept, kept_before) = (kept.as_slice(), kept_before.as_slice());
        blocks
            .into_par_iter()
            .for_each(|(first_word, run, split_run)| {
                let mut places = run.iter_mut().zip(split_run);
                for (word, &bits) in kept.iter().enumerate().skip(first_word).take(WORDS) {
                    let mut left = bits;
                    while left != 0 {
                        let i = (word * 32) as u32 + left.trailing_zeros();
                        left &= left - 1;
                        if let Some((node, split)) = places.next() {
                            (*node, *split) = internal_node(i, codes, kept, kept_before);
                        }
                    }
                }
            });
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        size_of_val(self.kept.as_slice())
            + size_of_val(self.kept_before.as_slice())
            + size_of_val(self.splits.as_slice())
    }
}
