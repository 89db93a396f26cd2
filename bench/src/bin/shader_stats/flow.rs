//! The control flow graph of a disassembled kernel: blocks, loops, and the cheapest way between two places.

use std::collections::{BTreeMap, BTreeSet};

/// What an instruction does, as far as splitting a kernel needs it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Anything not named below.
    #[default]
    Other,
    /// Stores to private or workgroup memory, where a walk's stack is.
    Stack,
    /// Stores to a buffer.
    Store,
    /// Multiplies floating-point numbers.
    Multiply,
}

/// An instruction of a disassembly.
#[derive(Clone, Debug, Default)]
pub struct Instruction {
    /// What it does.
    pub kind: Kind,
    /// Labels it may jump to.
    pub targets: Vec<String>,
    /// Whether the next instruction may follow.
    pub falls_through: bool,
}

/// A disassembly, as the readers of both compilers' texts leave it.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// All instructions in order.
    pub instructions: Vec<Instruction>,
    /// The place of the instruction behind each label.
    pub labels: BTreeMap<String, usize>,
}

/// Instructions that run one after the other, and where to from there.
#[derive(Clone, Debug)]
struct Block {
    size: u64,
    has_stack: bool,
    has_store: bool,
    has_multiply: bool,
    next: Vec<usize>,
}

/// Blocks by number, in the order of the text; the first is where the kernel begins.
pub struct Graph {
    blocks: Vec<Block>,
    loops: Vec<Loop>,
}

/// A natural loop: all jumps back to one header.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The block that all ways into the loop pass.
    pub header: usize,
    /// Its blocks, those of inner loops included.
    pub blocks: BTreeSet<usize>,
}

impl Graph {
    /// Splits a program into blocks and finds its loops. Code that is not reached is left out.
    pub fn new(program: &Program) -> Self {
        let count = program.instructions.len();
        let mut begins: BTreeSet<usize> = program.labels.values().copied().collect();
        begins.insert(0);
        for (place, instruction) in program.instructions.iter().enumerate() {
            if !instruction.targets.is_empty() || !instruction.falls_through {
                begins.insert(place + 1);
            }
        }
        begins.retain(|&place| place < count);
        let begins: Vec<usize> = begins.into_iter().collect();
        let number = |place: usize| begins.binary_search(&place).ok();
        let mut blocks = Vec::new();
        for (i, &begin) in begins.iter().enumerate() {
            let end = begins.get(i + 1).copied().unwrap_or(count);
            let part = &program.instructions[begin..end];
            let has = |kind| part.iter().any(|one| one.kind == kind);
            let mut next = Vec::new();
            if let Some(last) = part.last() {
                let places = last.targets.iter().filter_map(|to| program.labels.get(to));
                next.extend(places.filter_map(|&place| number(place)));
                if last.falls_through {
                    next.extend(number(end));
                }
            }
            blocks.push(Block {
                size: part.len() as u64,
                has_stack: has(Kind::Stack),
                has_store: has(Kind::Store),
                has_multiply: has(Kind::Multiply),
                next,
            });
        }
        let mut graph = Self {
            blocks,
            loops: Vec::new(),
        };
        graph.loops = graph.find_loops();
        graph
    }

    /// All loops, outer ones before those inside.
    pub fn loops(&self) -> &[Loop] {
        &self.loops
    }

    /// Instructions of these blocks.
    pub fn size<'a>(&self, blocks: impl IntoIterator<Item = &'a usize>) -> u64 {
        blocks
            .into_iter()
            .map(|&block| self.blocks[block].size)
            .sum()
    }

    /// Whether one of these blocks stores to private or workgroup memory.
    pub fn has_stack(&self, blocks: &BTreeSet<usize>) -> bool {
        blocks.iter().any(|&block| self.blocks[block].has_stack)
    }

    /// All blocks that can be reached from these, these included, without entering `barred`.
    pub fn reached(&self, from: &[usize], barred: &BTreeSet<usize>) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut waiting = from.to_vec();
        while let Some(block) = waiting.pop() {
            if !barred.contains(&block) && found.insert(block) {
                waiting.extend(&self.blocks[block].next);
            }
        }
        found
    }

    /// Blocks outside a loop to which it leads.
    pub fn exits(&self, one: &Loop) -> Vec<usize> {
        let next = one
            .blocks
            .iter()
            .flat_map(|&block| &self.blocks[block].next);
        let outside: BTreeSet<usize> = next
            .copied()
            .filter(|to| !one.blocks.contains(to))
            .collect();
        outside.into_iter().collect()
    }

    /// Instructions of the cheapest way from the kernel's beginning to the header of a loop, which does not count.
    pub fn cheapest_to(&self, header: usize) -> Option<u64> {
        let blocks = (0..self.blocks.len()).filter(|&block| block != header);
        let cost = self.cheapest(&[0], &blocks.collect(), &[], |block| {
            self.blocks[block].next.contains(&header)
        });
        if header == 0 { Some(0) } else { cost }
    }

    /// Instructions of the cheapest way from a loop to the kernel's end that stores to a buffer and multiplies, each as far as
    /// any way does: the result of a hit is scaled, that of a miss is not.
    pub fn cheapest_from(&self, one: &Loop) -> Option<u64> {
        let exits = self.exits(one);
        let after = self.reached(&exits, &one.blocks);
        let wanted: [fn(&Block) -> bool; 2] = [|block| block.has_store, |block| block.has_multiply];
        let is_reached = |is: &fn(&Block) -> bool| after.iter().any(|&at| is(&self.blocks[at]));
        let wanted: Vec<_> = wanted.into_iter().filter(is_reached).collect();
        self.cheapest(&exits, &after, &wanted, |block| {
            self.blocks[block].next.is_empty()
        })
    }

    /// Instructions of the cheapest way over these blocks from any of `from` to one that `ends`, both included, on which each
    /// of `wanted` holds for some block.
    fn cheapest(
        &self,
        from: &[usize],
        over: &BTreeSet<usize>,
        wanted: &[fn(&Block) -> bool],
        ends: impl Fn(usize) -> bool,
    ) -> Option<u64> {
        // A bit of `met` for each of `wanted`.
        let enter = |cost: u64, block: usize, met: u32| {
            let block_met = wanted
                .iter()
                .enumerate()
                .filter(|(_, is)| is(&self.blocks[block]));
            let met = block_met.fold(met, |met, (bit, _)| met | 1 << bit);
            (cost + self.blocks[block].size, block, met)
        };
        let from = from.iter().filter(|block| over.contains(block));
        let mut waiting: BTreeSet<_> = from.map(|&block| enter(0, block, 0)).collect();
        let mut done = BTreeSet::new();
        while let Some((cost, block, met)) = waiting.pop_first() {
            if met + 1 == 1 << wanted.len() && ends(block) {
                return Some(cost);
            }
            if done.insert((block, met)) {
                let next = self.blocks[block]
                    .next
                    .iter()
                    .filter(|to| over.contains(to));
                waiting.extend(next.map(|&to| enter(cost, to, met)));
            }
        }
        None
    }

    /// Natural loops by back edges: an edge to a block without which its begin is not reached.
    fn find_loops(&self) -> Vec<Loop> {
        let all = self.reached(&[0], &BTreeSet::new());
        let mut loops = Vec::new();
        for &header in &all {
            let without = self.reached(&[0], &BTreeSet::from([header]));
            let back = all.iter().copied().filter(|&block| {
                self.blocks[block].next.contains(&header) && !without.contains(&block)
            });
            let mut waiting: Vec<usize> = back.collect();
            if waiting.is_empty() {
                continue;
            }
            let mut blocks = BTreeSet::from([header]);
            while let Some(block) = waiting.pop() {
                if blocks.insert(block) {
                    let before = all.iter().copied();
                    waiting.extend(before.filter(|&from| self.blocks[from].next.contains(&block)));
                }
            }
            loops.push(Loop { header, blocks });
        }
        loops.sort_by_key(|one| std::cmp::Reverse(self.size(&one.blocks)));
        loops
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A program of blocks: label, size, labels of the next blocks, and the kind of the first instruction.
    pub fn program(blocks: &[(&str, usize, &[&str], Kind)]) -> Program {
        let mut program = Program::default();
        for (label, size, next, kind) in blocks {
            let place = program.instructions.len();
            program.labels.insert((*label).to_owned(), place);
            for i in 0..*size {
                let is_last = i + 1 == *size;
                program.instructions.push(Instruction {
                    kind: if i == 0 { *kind } else { Kind::Other },
                    targets: if is_last {
                        next.iter().map(|&to| to.to_owned()).collect()
                    } else {
                        Vec::new()
                    },
                    falls_through: !is_last,
                });
            }
        }
        program
    }

    /// A slow and a straight path before and behind two nested loops; the kernel may also end without a store, or store a miss.
    fn walk() -> Graph {
        Graph::new(&program(&[
            ("begin", 3, &["slow", "outer"], Kind::Other),
            ("slow", 50, &["outer"], Kind::Other),
            ("outer", 5, &["inner", "after"], Kind::Other),
            ("inner", 7, &["inner", "next"], Kind::Stack),
            ("next", 2, &["outer"], Kind::Other),
            (
                "after",
                4,
                &["quit", "denormal", "scale", "store"],
                Kind::Other,
            ),
            ("denormal", 90, &["store"], Kind::Multiply),
            ("scale", 8, &["store"], Kind::Multiply),
            ("store", 6, &["quit"], Kind::Store),
            ("quit", 1, &[], Kind::Other),
        ]))
    }

    #[test]
    fn loops_nest() {
        let graph = walk();
        let loops = graph.loops();
        assert_eq!(loops.len(), 2);
        assert_eq!(loops[0].blocks, BTreeSet::from([2, 3, 4]));
        assert_eq!(loops[1].blocks, BTreeSet::from([3]));
        assert_eq!(graph.size(&loops[0].blocks), 14);
        assert!(graph.has_stack(&loops[1].blocks));
        assert!(!graph.has_stack(&BTreeSet::from([2, 4])));
    }

    #[test]
    fn the_straight_path_avoids_slow_blocks_but_scales_and_stores() {
        let graph = walk();
        let outer = &graph.loops()[0];
        assert_eq!(graph.cheapest_to(outer.header), Some(3));
        assert_eq!(graph.cheapest_from(outer), Some(4 + 8 + 6 + 1));
    }

    #[test]
    fn a_jump_back_that_is_no_loop_is_none() {
        // Two ways into the block pair: no header that all ways pass.
        let graph = Graph::new(&program(&[
            ("begin", 1, &["a", "b"], Kind::Other),
            ("a", 1, &["b"], Kind::Other),
            ("b", 1, &["end"], Kind::Other),
            ("end", 1, &[], Kind::Other),
        ]));
        assert!(graph.loops().is_empty());
        assert_eq!(graph.cheapest_to(3), Some(2));
    }
}
