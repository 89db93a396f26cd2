//! Wide nodes and the words of their triangles, at their places.

use super::super::BLOCK;
use super::super::encode::Leaf;
use super::collapse::{Cut, Division, Run};
use super::store::Store;
use super::{Places, Triangles};
use crate::tree::wide::WideConnection;
use rayon::prelude::*;
use slimbvh_core::encode::{LeafCorner, WideLinks};
use slimbvh_core::float::power_of_two;
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

/// A wide node, and whether the words of its triangles, and of all that were placed before it, are as many as were counted. If not,
/// what all lists hold means nothing.
pub(super) type Sound<N> = (N, bool);

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

    /// Fills what is left: the first nodes of runs, and those at the top. Returns whether all words are as many as were counted.
    pub(super) fn fill_top<S: Store>(
        &self,
        division: &Division,
        roots: Vec<Sound<S::Node>>,
        nodes: &mut [S::Node],
        words: &mut [u32],
    ) -> bool {
        let places = self.places;
        let begins = Begins(&places.begins);
        let word_count = words.len();
        let mut is_sound = true;
        for (run, (root, is_run_sound)) in division.runs.iter().zip(roots) {
            nodes[begins.place(run.origin) as usize] = root;
            is_sound &= is_run_sound;
        }
        for i in division.top.iter().map(|&i| i as usize) {
            let binary = (self.nodes, places.collapses.as_slice());
            let first_word = at(&places.words, i);
            let end = places.words.get(i + 1).map_or(word_count, |&n| n as usize);
            let at = [begins.first_child(i as u32), first_word];
            let own = &mut words[first_word as usize..end];
            let (node, is_node_sound) = self.encode::<S>(i, binary, at, own);
            nodes[begins.place(Origin(places.origins[i])) as usize] = node;
            is_sound &= is_node_sound;
        }
        is_sound
    }

    /// Returns the first wide node of a run, whose place is not in it.
    fn fill_run<S: Store>(&self, part: Part<S::Node>) -> Sound<S::Node> {
        let Run { root, range, .. } = part.run;
        let places = self.places;
        let binary = (&self.nodes[range.clone()], &places.collapses[range.clone()]);
        let begins = Begins(&places.begins[range.clone()]);
        let origins = &places.origins[range.clone()];
        let first_place = begins.first_child(0);
        let (mut words, mut word) = (part.words, at(&places.words, range.start));
        let (mut first, mut is_sound) = (S::Node::default(), true);
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
            let (node, is_node_sound) = self.encode::<S>(i, binary, at, own);
            is_sound &= is_node_sound;
            word = next;
            if i as u32 == *root {
                first = node;
            } else {
                part.nodes[(begins.place(origin) - first_place) as usize] = node;
            }
        }
        (first, is_sound)
    }

    /// The wide node that begins at one of these binary nodes. Its inner children begin at a place, and its words at another, as many
    /// as there should be.
    #[inline(always)]
    fn encode<S: Store>(
        &self,
        i: usize,
        (nodes, collapses): (&[Node], &[u32]),
        at: [u32; 2],
        words: &mut [u32],
    ) -> Sound<S::Node> {
        let step_exponent = self.triangles.step_exponent;
        let node = &nodes[i];
        let children = wide_children(node, Collapse(collapses[i]), nodes);
        let item = S::item(&children, [node.first, node.last], step_exponent);
        let links = S::links(&item, step_exponent);
        let is_sound = !S::MIXED || links.word_count() as usize == words.len();
        if S::MIXED && is_sound {
            put_leaves::<S>(&item, links, self.triangles, words);
        }
        (S::place(&item, at, links), is_sound)
    }
}

/// A number of a list; 0 in an empty one.
fn at(list: &[u32], index: usize) -> u32 {
    list.get(index).copied().unwrap_or(0)
}

/// Fills the lists from items by place. Words lie in the order in which they were.
pub(super) fn place_again<S: Store>(
    items: &[S::Item],
    connections: &[WideConnection],
    triangles: &Triangles,
    nodes: &mut [S::Node],
    words: &mut Vec<u32>,
) {
    let step_exponent = triangles.step_exponent;
    let mut begins = vec![0; if S::MIXED { items.len() } else { 0 }];
    if S::MIXED {
        let mut with_leaves: Vec<usize> = (0..items.len())
            .filter(|&i| connections[i].place != u32::MAX)
            .collect();
        with_leaves.sort_unstable_by_key(|&i| connections[i].place);
        let mut end = 0;
        let mut counts = Vec::with_capacity(with_leaves.len());
        for &i in &with_leaves {
            let count = S::links(&items[i], step_exponent).word_count();
            begins[i] = end;
            end += count;
            counts.push(count as usize);
        }
        words.resize(end as usize, 0);
        let mut rest = words.as_mut_slice();
        let parts = with_leaves.iter().zip(counts).map(|(&i, count)| {
            let (own, after) = std::mem::take(&mut rest).split_at_mut(count);
            rest = after;
            (i, own)
        });
        let parts: Vec<_> = parts.collect();
        let parts = parts.into_par_iter().with_min_len(BLOCK);
        parts.for_each(|(i, own)| {
            let links = S::links(&items[i], step_exponent);
            put_leaves::<S>(&items[i], links, triangles, own);
        });
    }
    let blocks = nodes.par_chunks_mut(BLOCK).enumerate();
    blocks.for_each(|(block, nodes)| {
        for (to, i) in nodes.iter_mut().zip(block * BLOCK..) {
            let mut children = connections[i].children.into_iter();
            let first = children.find(|child| !child.is_leaf());
            let first = first.map_or(0, NodeRef::index);
            let links = S::links(&items[i], step_exponent);
            *to = S::place(&items[i], [first, at(&begins, i)], links);
        }
    });
}

/// Stores the triangles of an item's leaves.
#[inline(always)]
fn put_leaves<S: Store>(
    item: &S::Item,
    links: WideLinks,
    triangles: &Triangles,
    words: &mut [u32],
) {
    let step_exponent = triangles.step_exponent;
    let corners = S::corners(item, step_exponent);
    let step = power_of_two(step_exponent);
    let mut words = words;
    let children = S::children(item).into_iter().zip(corners);
    for ((child, min), number) in children.zip(0..) {
        if !child.is_leaf() || child.count() == 0 {
            continue;
        }
        let (first, count) = (child.first() as usize, child.count() as usize);
        let leaf = Leaf {
            triangles: &triangles.leaves[first..first + count],
            corner: LeafCorner {
                min,
                words: links.triangle_words(number),
            },
            step,
        };
        let (own, rest) = words.split_at_mut(count * leaf.corner.words as usize);
        leaf.put(own);
        words = rest;
    }
}
