//! Wide nodes and the words of their triangles, at their places.

use super::super::BLOCK;
use super::collapse::{Cut, Division, Run};
use super::store::Store;
use super::{Corners, Places, Triangles};
use crate::parallel::prelude::*;
use crate::tree::wide::WideConnection;
use slimbvh_core::wide::{Begins, Collapse, Origin, wide_children};
use slimbvh_core::{Node, NodeRef};
use std::ops::Range;

/// A binary tree that was collapsed, and what its wide nodes are encoded with.
pub(super) struct Placing<'a> {
    pub(super) nodes: &'a [Node],
    /// Prefix sums, up to some node.
    pub(super) places: &'a Places,
    pub(super) triangles: &'a Triangles<'a>,
}

/// A run, with the places of all its wide nodes but the first and the words of their leaves' triangles.
struct Part<'a, N> {
    run: &'a Run,
    nodes: &'a mut [N],
    words: &'a mut [u32],
}

/// A wide node, and the widths of its leaves' corners and of all that were placed before it, a bit each: [`UNSOUND`] if their words are
/// not as many as were counted. Then what all lists hold means nothing.
pub(super) type Sound<N> = (N, u32);

/// No set of widths.
const UNSOUND: u32 = 1 << 31;

impl Placing<'_> {
    /// Fills the lists, which end where runs before node `end` do. The inner children of wide nodes lie in the order of the binary
    /// nodes at which these begin, after the root; and so do the words of their leaves' triangles. Returns each run's first wide
    /// node, whose place follows from what is above it.
    pub(super) fn fill_runs<S: Store>(
        &self,
        runs: &[Run],
        end: usize,
        (nodes, words): (&mut [S::Node], &mut [u32]),
    ) -> Vec<Sound<S::Node>> {
        let places = self.places;
        let [place_end, word_end] = [nodes.len() - 1, words.len()];
        let (mut nodes, mut words) = (Cut::new(nodes), Cut::new(words));
        let ends = |list: &[u32], range: &Range<usize>, all: usize| {
            let list = &list[..end.min(list.len())];
            let end = |i| list.get(i).map_or(all, |&n: &u32| n as usize);
            end(range.start)..end(range.end)
        };
        let mut parts = Vec::with_capacity(runs.len());
        for run in runs {
            // The root comes before all.
            let own = ends(&places.begins, &run.range, place_end);
            let own = own.start + 1..own.end + 1;
            parts.push(Part {
                run,
                nodes: nodes.cut(&own),
                words: words.cut(&ends(&places.words, &run.range, word_end)),
            });
        }
        let parts = parts.into_par_iter();
        parts.map(|part| self.fill_run::<S>(part)).collect()
    }

    /// Fills what is left: the first nodes of runs, and those at the top. Returns the widths of all leaves' corners, a bit
    /// each, if all words are as many as were counted.
    pub(super) fn fill_top<S: Store>(
        &self,
        division: &Division,
        roots: Vec<Sound<S::Node>>,
        nodes: &mut [S::Node],
        words: &mut [u32],
    ) -> Option<u32> {
        let places = self.places;
        let begins = Begins(&places.begins);
        let word_count = words.len();
        let mut widths = 0;
        for (run, (root, run_widths)) in division.runs.iter().zip(roots) {
            nodes[begins.place(run.origin) as usize] = root;
            widths |= run_widths;
        }
        for i in division.top.iter().map(|&i| i as usize) {
            let first_word = at(&places.words, i);
            let end = places.words.get(i + 1).map_or(word_count, |&n| n as usize);
            let at = [begins.first_child(i as u32), first_word];
            let own = &mut words[first_word as usize..end];
            let (node, node_widths) = self.encode::<S>(i, at, own);
            nodes[begins.place(Origin(places.origins[i])) as usize] = node;
            widths |= node_widths;
        }
        (widths & UNSOUND == 0).then_some(widths)
    }

    /// Returns the first wide node of a run, whose place is not in it.
    fn fill_run<S: Store>(&self, part: Part<S::Node>) -> Sound<S::Node> {
        let Run { root, range, .. } = part.run;
        let places = self.places;
        let begins = Begins(&places.begins[range.clone()]);
        let origins = &places.origins[range.clone()];
        let first_place = begins.first_child(0);
        let (mut words, mut word) = (part.words, at(&places.words, range.start));
        let (mut first, mut widths) = (S::Node::default(), 0);
        for (i, &origin) in (0..).zip(origins) {
            let origin = Origin(origin);
            if !origin.is_there() {
                continue;
            }
            let (mut own, mut next) = (Default::default(), word);
            if S::MIXED {
                let after = places.words[range.clone()].get(i + 1);
                next = after.map_or_else(|| word + words.len() as u32, |&next| next);
                let rest = std::mem::take(&mut words);
                (own, words) = rest.split_at_mut((next - word) as usize);
            }
            let at = [begins.first_child(i as u32), word];
            let (node, node_widths) = self.encode::<S>(range.start + i, at, own);
            widths |= node_widths;
            word = next;
            if i as u32 == *root {
                first = node;
            } else {
                part.nodes[(begins.place(origin) - first_place) as usize] = node;
            }
        }
        (first, widths)
    }

    /// The wide node that begins at a binary node. Its inner children begin at a place, and its words at another, as many
    /// as there should be.
    #[inline(always)]
    fn encode<S: Store>(&self, i: usize, at: [u32; 2], words: &mut [u32]) -> Sound<S::Node> {
        let step_exponent = self.triangles.step_exponent;
        let node = &self.nodes[i];
        let collapse = Collapse(self.places.collapses[i]);
        let children = wide_children(node, collapse, self.nodes);
        let corners = Corners {
            first: 0,
            list: &self.places.corners,
        };
        let item = S::item(&children, [node.first, node.last], corners, step_exponent);
        let widths = if S::word_count(&item) as usize == words.len() {
            S::put_leaves(&item, self.triangles, corners, words)
        } else {
            UNSOUND
        };
        (S::place(&item, at), widths)
    }
}

/// A number of a list; 0 in an empty one.
fn at(list: &[u32], index: usize) -> u32 {
    list.get(index).copied().unwrap_or(0)
}

/// Fills the lists from items by place. Words lie in the order in which they were.
pub(super) fn place_again<S: Store>(
    (items, connections): (&[S::Item], &[WideConnection]),
    triangles: &Triangles,
    corners: Corners,
    (nodes, words): (&mut [S::Node], &mut Vec<u32>),
) {
    let mut begins = vec![0; if S::MIXED { items.len() } else { 0 }];
    if S::MIXED {
        let mut with_leaves: Vec<usize> = (0..items.len())
            .filter(|&i| connections[i].place != u32::MAX)
            .collect();
        with_leaves.sort_unstable_by_key(|&i| connections[i].place);
        let mut end = 0;
        for &i in &with_leaves {
            begins[i] = end;
            end += S::word_count(&items[i]);
        }
        words.resize(end as usize, 0);
        let mut rest = words.as_mut_slice();
        let parts = with_leaves.iter().map(|&i| {
            let count = S::word_count(&items[i]) as usize;
            let (own, after) = std::mem::take(&mut rest).split_at_mut(count);
            rest = after;
            (i, own)
        });
        let parts: Vec<_> = parts.collect();
        let parts = parts.into_par_iter().with_min_len(BLOCK);
        parts.for_each(|(i, own)| {
            S::put_leaves(&items[i], triangles, corners, own);
        });
    }
    let blocks = nodes.par_chunks_mut(BLOCK).enumerate();
    blocks.for_each(|(block, nodes)| {
        for (to, i) in nodes.iter_mut().zip(block * BLOCK..) {
            let mut children = connections[i].children.into_iter();
            let first = children.find(|child| !child.is_leaf());
            let first = first.map_or(0, NodeRef::index);
            *to = S::place(&items[i], [first, at(&begins, i)]);
        }
    });
}
