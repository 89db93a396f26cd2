//! A trace kernel's instructions by part.

use super::flow::{Graph, Loop, Program};
use anyhow::{Context, Result};
use std::collections::BTreeSet;

/// Instructions of a trace kernel by part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Split {
    /// On the straight path from the beginning to the walk.
    pub prepare: u64,
    /// Of a step to a node: the innermost loop with the stack, without a loop of triangles inside.
    pub step: u64,
    /// Of a test of a triangle: the largest loop without the stack inside the walk.
    pub triangle: u64,
    /// Of a visit to a leaf besides its triangles: the walk's outer loop without the two; 0 if the walk is one loop.
    pub leaf: u64,
    /// On the straight path from the walk to the end.
    pub restore: u64,
    /// Before and behind the walk, on slow paths as well.
    pub outside: [u64; 2],
    /// Loops besides these, whose instructions count once.
    pub other_loops: usize,
}

impl Split {
    /// Splits a disassembled kernel.
    pub fn new(graph: &Graph) -> Result<Self> {
        let walk = graph.loops().first().context("there is no loop")?;
        let is_inside =
            |one: &Loop, of: &Loop| one.header != of.header && one.blocks.is_subset(&of.blocks);
        // Smaller loops come last.
        let inner: Vec<&Loop> = graph
            .loops()
            .iter()
            .filter(|one| is_inside(one, walk))
            .collect();
        let with_stack = inner.iter().rev().find(|one| graph.has_stack(&one.blocks));
        let node = with_stack.copied().unwrap_or(walk);
        let triangle = inner
            .iter()
            .find(|one| !graph.has_stack(&one.blocks) && !is_inside(node, one));
        let triangle = triangle.context("there is no loop of triangles")?;

        let of = |blocks: &BTreeSet<usize>, without: &BTreeSet<usize>| -> BTreeSet<usize> {
            blocks.difference(without).copied().collect()
        };
        let step = of(&node.blocks, &triangle.blocks);
        let leaf = of(&of(&walk.blocks, &node.blocks), &triangle.blocks);
        let after = graph.reached(&graph.exits(walk), &walk.blocks);
        let all = graph.reached(&[0], &BTreeSet::new());
        let before = of(&of(&all, &after), &walk.blocks);

        let named = BTreeSet::from([walk.header, node.header, triangle.header]);
        let others = graph
            .loops()
            .iter()
            .filter(|one| !named.contains(&one.header));
        let cut = "the walk cannot be reached or left";
        Ok(Self {
            prepare: graph.cheapest_to(walk.header).context(cut)?,
            step: graph.size(&step),
            triangle: graph.size(&triangle.blocks),
            leaf: graph.size(&leaf),
            restore: graph.cheapest_from(walk).context(cut)?,
            outside: [graph.size(&before), graph.size(&after)],
            other_loops: others.count(),
        })
    }

    /// Instructions of a ray with these numbers of node steps and triangle tests: on the straight path, and with all that is
    /// outside the walk. No leaf is empty, so triangles bound leaves.
    pub fn ray(&self, [nodes, triangles]: [f64; 2]) -> [f64; 2] {
        let tests = triangles * (self.triangle + self.leaf) as f64;
        let walk = nodes * self.step as f64 + tests;
        [self.prepare + self.restore, self.outside.iter().sum()].map(|more| more as f64 + walk)
    }
}

/// Instructions of each loop without those of loops inside, outer loops first.
pub fn loops(program: &Program) -> Vec<u64> {
    let graph = Graph::new(program);
    let own = |one: &Loop| {
        let inner = graph
            .loops()
            .iter()
            .filter(|other| other.header != one.header && other.blocks.is_subset(&one.blocks));
        let inner: BTreeSet<usize> = inner.flat_map(|other| &other.blocks).copied().collect();
        graph.size(one.blocks.difference(&inner))
    };
    graph.loops().iter().map(own).collect()
}

#[cfg(test)]
mod tests {
    use super::super::flow::Kind::{Multiply, Other, Stack, Store};
    use super::super::flow::tests::program;
    use super::*;

    #[test]
    fn a_walk_of_one_loop() {
        let program = program(&[
            ("begin", 10, &["slow", "walk"], Other),
            ("slow", 70, &["walk"], Other),
            ("walk", 20, &["triangle", "open"], Other),
            ("triangle", 40, &["triangle", "next"], Other),
            ("open", 30, &["next"], Stack),
            ("next", 3, &["walk", "end"], Other),
            ("end", 5, &[], Store),
        ]);
        let split = Split::new(&Graph::new(&program)).expect("it is a walk");
        let expected = Split {
            prepare: 10,
            step: 53,
            triangle: 40,
            leaf: 0,
            restore: 5,
            outside: [80, 5],
            other_loops: 0,
        };
        assert_eq!(split, expected);
        assert_eq!(
            split.ray([2.0, 0.5]),
            [15.0 + 106.0 + 20.0, 85.0 + 106.0 + 20.0]
        );
        assert_eq!(loops(&program), [53, 40]);
    }

    #[test]
    fn a_walk_of_two_loops_in_one() {
        let program = program(&[
            ("begin", 9, &["clear"], Other),
            ("clear", 2, &["clear", "walk"], Stack),
            ("walk", 20, &["node"], Other),
            ("node", 11, &["push", "more"], Other),
            ("push", 6, &["more"], Stack),
            ("more", 4, &["node", "triangle"], Other),
            ("triangle", 100, &["triangle", "next"], Multiply),
            ("next", 3, &["walk", "scale"], Other),
            ("scale", 8, &["end"], Multiply),
            ("end", 5, &[], Store),
        ]);
        let split = Split::new(&Graph::new(&program)).expect("it is a walk");
        let expected = Split {
            prepare: 11,
            step: 21,
            triangle: 100,
            leaf: 23,
            restore: 13,
            outside: [11, 13],
            other_loops: 1,
        };
        assert_eq!(split, expected);
        assert_eq!(split.ray([3.0, 2.0])[0], 24.0 + 63.0 + 246.0);
        assert_eq!(loops(&program), [23, 100, 21, 2]);
    }

    #[test]
    fn what_is_no_walk_is_refused() {
        let straight = program(&[("begin", 10, &[], Store)]);
        assert!(Split::new(&Graph::new(&straight)).is_err());
        let one = program(&[
            ("begin", 1, &["begin", "end"], Stack),
            ("end", 1, &[], Store),
        ]);
        assert!(Split::new(&Graph::new(&one)).is_err());
    }
}
