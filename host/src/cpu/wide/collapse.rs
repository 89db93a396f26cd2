//! Which nodes of a binary tree begin wide ones: from the root down.
//!
//! Few nodes at the top come first, on one thread. Below them lie runs of nodes, each a tree of its own.

use super::super::encode::TASK;
use super::store::Store;
use super::{Corners, Places, Triangles, leaves_of};
use crate::parallel::prelude::*;
use slimbvh_core::encode::LeafWidth;
use slimbvh_core::wide::{Collapse, Origin, WideChildren, collapsed};
use slimbvh_core::{Node, NodeRef};
use std::ops::Range;

/// Runs of [`TASK`] triangles that a thread encodes before it waits for others.
const RUNS_A_THREAD: u32 = 16;

/// A node at which a wide one begins, with all nodes below it. In lists of this range, it and they are counted from the first.
#[derive(Clone, Debug)]
pub(super) struct Run {
    /// Counted from the first.
    pub(super) root: u32,
    pub(super) range: Range<usize>,
    /// Where the wide node comes from, in the whole tree.
    pub(super) origin: Origin,
}

/// The parts of a binary tree.
#[derive(Debug, Default)]
pub(super) struct Division {
    /// The nodes at the top at which wide nodes begin.
    pub(super) top: Vec<u32>,
    /// What is below, in order.
    pub(super) runs: Vec<Run>,
}

/// A binary tree that is collapsed, and what is known of the wide nodes that begin at its nodes.
pub(super) struct Collapsing<'a> {
    pub(super) nodes: &'a [Node],
    pub(super) places: &'a mut Places,
    pub(super) triangles: &'a Triangles<'a>,
    /// The width of all corners on the lattice, as far as is known.
    pub(super) common: Option<LeafWidth>,
}

/// The parts of all lists for a run.
struct Part<'a> {
    run: &'a Run,
    collapses: &'a mut [u32],
    origins: &'a mut [u32],
    inner: &'a mut [u32],
    /// As long, or empty.
    words: &'a mut [u32],
    /// Which corners the run's triangles have, from the first one on, or empty.
    corners: &'a mut [u32],
}

impl Collapsing<'_> {
    /// Fills the lists for some runs. Inner children are counted from their run's first node. The lists of places then hold numbers:
    /// those of inner children, and of words, 0 where no wide node begins.
    pub(super) fn fill<S: Store>(&mut self, runs: &[Run]) {
        let Self {
            nodes,
            places,
            triangles,
            common,
        } = self;
        let mut collapses = Cut::new(&mut places.collapses);
        let mut origins = Cut::new(&mut places.origins);
        let mut inner = Cut::new(&mut places.begins);
        let mut words = Cut::new(&mut places.words);
        let mut corners = Cut::new(&mut places.corners);
        let mut parts = Vec::with_capacity(runs.len());
        for run in runs {
            let range = &run.range;
            let root = &nodes[range.start + run.root as usize];
            parts.push(Part {
                run,
                collapses: collapses.cut(range),
                origins: origins.cut(range),
                inner: inner.cut(range),
                words: words.cut(range),
                corners: corners.cut(&(root.first as usize..root.last as usize + 1)),
            });
        }
        let parts = parts.into_par_iter();
        parts.for_each(|part| part.fill::<S>(nodes, triangles, *common));
    }

    /// Clears the lists, and fills them for the nodes at the top.
    pub(super) fn divide<S: Store>(&mut self) -> Division {
        let count = self.nodes.len();
        self.places.clear::<S>(count, self.triangles.leaves.len());
        let mut division = Division::default();
        if self.nodes.is_empty() {
            return division;
        }
        let all = 0..self.nodes.len();
        let mut waiting = vec![(0, all, Origin::ROOT)];
        while let Some((root, range, origin)) = waiting.pop() {
            let node = &self.nodes[root as usize];
            if node.last - node.first < TASK {
                let root = root - range.start as u32;
                let run = Run {
                    root,
                    range,
                    origin,
                };
                division.runs.push(run);
                continue;
            }
            let (collapse, children) = collapsed(node, self.nodes, 0);
            let i = root as usize;
            self.places.collapses[i] = collapse.0;
            self.places.origins[i] = origin.0;
            self.places.begins[i] = collapse.inner_count();
            if S::MIXED {
                let (corners, first) = (self.places.corners.as_mut_slice(), 0);
                let words =
                    word_count::<S>(&children, self.triangles, self.common, (corners, first));
                self.places.words[i] = words;
            }
            division.top.push(root);
            let ranges = self.ranges(root, range, collapse);
            let inner = ranges.into_iter().filter(|(child, _)| !child.is_leaf());
            for ((child, range), rank) in inner.zip(0..) {
                waiting.push((child.index(), range, Origin::below(root, rank)));
            }
        }
        division.runs.sort_unstable_by_key(|run| run.range.start);
        division
    }

    /// The number of the first runs that are encoded together. On one thread that is one, as a rule: what it reads is then still in
    /// the processor's cache. Several threads need many, so that all have as much to do.
    pub(super) fn group(&self, runs: &[Run]) -> usize {
        let threads = crate::parallel::current_num_threads() as u32;
        let enough = if threads == 1 {
            TASK / 2
        } else {
            RUNS_A_THREAD * threads * TASK
        };
        let mut count = 0;
        let is_missing = |run: &&Run| {
            let node = &self.nodes[run.range.start + run.root as usize];
            let is_missing = count < enough;
            count += node.last - node.first + 1;
            is_missing
        };
        runs.iter().take_while(is_missing).count()
    }

    /// The children of a wide node whose own binary node and all below it are in a range, each with such a range.
    fn ranges(
        &self,
        node: u32,
        range: Range<usize>,
        collapse: Collapse,
    ) -> Vec<(NodeRef, Range<usize>)> {
        let halves = |node: u32, range: &Range<usize>| {
            let Node { left, right, .. } = self.nodes[node as usize];
            // A node is the first or the last of its range.
            let below = if node as usize == range.start {
                range.start + 1..range.end
            } else {
                range.start..range.end - 1
            };
            // The right child is the first of its range.
            let middle = if right.is_leaf() {
                below.end
            } else {
                right.index() as usize
            };
            [(left, below.start..middle), (right, middle..below.end)]
        };
        let mut children = Vec::from(halves(node, &range));
        for place in [0, 1].map(|step| collapse.place(step) as usize) {
            if place > 0 {
                let (child, range) = children[place - 1].clone();
                children.splice(place - 1..place, halves(child.index(), &range));
            }
        }
        children
    }
}

impl Part<'_> {
    /// Fills the lists of a run.
    fn fill<S: Store>(self, nodes: &[Node], triangles: &Triangles, common: Option<LeafWidth>) {
        let first = self.run.range.start as u32;
        let root = first + self.run.root;
        let first_triangle = nodes[root as usize].first;
        let mut waiting = vec![(root, self.run.origin)];
        while let Some((index, origin)) = waiting.pop() {
            let (collapse, children) = collapsed(&nodes[index as usize], nodes, 0);
            let own = index - first;
            let i = own as usize;
            self.collapses[i] = collapse.0;
            self.origins[i] = origin.0;
            self.inner[i] = collapse.inner_count();
            if S::MIXED {
                let corners = (&mut *self.corners, first_triangle);
                self.words[i] = word_count::<S>(&children, triangles, common, corners);
            }
            let inner = children
                .nodes()
                .into_iter()
                .filter(|child| !child.is_leaf());
            let inner = inner.zip(0..);
            waiting.extend(inner.map(|(child, rank)| (child.index(), Origin::below(own, rank))));
        }
    }
}

/// The words of the triangles in the leaves of a wide node with these children, whose corners it numbers where they are shared: in a
/// list that begins with those of a triangle.
fn word_count<S: Store>(
    children: &WideChildren,
    triangles: &Triangles,
    common: Option<LeafWidth>,
    (list, first): (&mut [u32], u32),
) -> u32 {
    if S::SHARES_CORNERS {
        for leaf in leaves_of(children.nodes()) {
            triangles.number(leaf, first, list);
        }
    }
    let corners = Corners { first, list };
    match common {
        Some(width) => S::words_of(children, corners, width),
        None => {
            let item = S::item(children, [0; 2], corners, triangles.step_exponent);
            S::word_count(&item)
        }
    }
}

/// A list that runs are cut off, in order.
pub(super) struct Cut<'a, T> {
    rest: &'a mut [T],
    /// The place of the first that is left.
    first: usize,
}

impl<'a, T> Cut<'a, T> {
    pub(super) const fn new(rest: &'a mut [T]) -> Self {
        Self { rest, first: 0 }
    }

    /// Cuts off a run, and what comes before it. Of an empty list, nothing.
    pub(super) fn cut(&mut self, range: &Range<usize>) -> &'a mut [T] {
        let rest = std::mem::take(&mut self.rest);
        if rest.is_empty() {
            return rest;
        }
        let (_, rest) = rest.split_at_mut(range.start - self.first);
        let (run, rest) = rest.split_at_mut(range.len());
        self.rest = rest;
        self.first = range.end;
        run
    }
}
