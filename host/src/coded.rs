//! Nodes and triangles in codecs, and traversal of them.

use crate::codec::{LatticeBits, MeshCodec, NodeCodec, by_bits};
use crate::cpu::lanes::{LANES, Numbers};
use crate::cpu::packets::AskedPacket;
use slimbvh_core::classify::FacingFilter;
use slimbvh_core::encode::{
    LatticeCursor, LatticeNodes, LatticeTriangles, Paper10Box, Paper10Cursor, Paper10Node,
    Paper10Nodes, Paper10Triangle, Paper10Triangles, RootWords,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    ClosestOrAny, Collector, Lane, LeafTriangles, NodeSource, PacketStacks, PreparedRays, SkipAnd,
    TriangleSource, trace_alone, trace_packet, traverse_with,
};
use slimbvh_core::{LeafTriangle, NodeRef};
use std::cell::RefCell;

/// What stands in a hierarchy that is stored in a codec.
#[derive(Clone, Debug)]
pub struct Coded {
    pub nodes: CodedNodes,
    pub triangles: CodedTriangles,
    /// How many triangles there are.
    pub triangle_count: usize,
}

/// Inner nodes.
#[derive(Clone, Debug)]
pub enum CodedNodes {
    Paper10 {
        root: Paper10Box,
        nodes: Vec<Paper10Node>,
    },
    Lattice {
        bits: LatticeBits,
        root: LatticeBox,
        /// The step is 2 to this power, in the scene's magnitude.
        step_exponent: i32,
        words: Vec<u32>,
    },
}

/// Triangles in leaves.
#[derive(Clone, Debug)]
pub enum CodedTriangles {
    /// In full, where the hierarchy has them.
    F32,
    Leaf10(Vec<Paper10Triangle>),
    Lattice(Vec<u32>),
}

impl CodedNodes {
    pub fn count(&self) -> usize {
        match self {
            Self::Paper10 { nodes, .. } => nodes.len(),
            Self::Lattice { bits, words, .. } => words.len() / bits.words(),
        }
    }

    /// What is stored.
    pub fn stored(&self) -> &[u8] {
        match self {
            Self::Paper10 { nodes, .. } => bytemuck::cast_slice(nodes),
            Self::Lattice { words, .. } => bytemuck::cast_slice(words),
        }
    }

    /// The root's box.
    pub fn root_words(&self) -> RootWords {
        match self {
            Self::Paper10 { root, .. } => RootWords::of_paper10(root),
            Self::Lattice {
                root,
                step_exponent,
                ..
            } => RootWords::of_lattice(root, *step_exponent),
        }
    }

    pub fn bytes(&self) -> usize {
        self.stored().len()
    }

    pub fn held_bytes(&self) -> usize {
        match self {
            Self::Paper10 { nodes, .. } => nodes.capacity() * size_of::<Paper10Node>(),
            Self::Lattice { words, .. } => words.capacity() * size_of::<u32>(),
        }
    }
}

impl CodedTriangles {
    /// What is stored; `plain` are the triangles where they are stored in full.
    pub fn stored<'a>(&'a self, plain: &'a [u8]) -> &'a [u8] {
        match self {
            Self::F32 => plain,
            Self::Leaf10(triangles) => bytemuck::cast_slice(triangles),
            Self::Lattice(words) => bytemuck::cast_slice(words),
        }
    }

    pub fn bytes(&self) -> usize {
        self.stored(&[]).len()
    }

    pub fn held_bytes(&self) -> usize {
        match self {
            Self::F32 => 0,
            Self::Leaf10(triangles) => triangles.capacity() * size_of::<Paper10Triangle>(),
            Self::Lattice(words) => words.capacity() * size_of::<u32>(),
        }
    }
}

impl Coded {
    /// No nodes yet.
    pub const fn nothing() -> Self {
        Self {
            nodes: CodedNodes::Paper10 {
                root: Paper10Box::ZERO,
                nodes: Vec::new(),
            },
            triangles: CodedTriangles::F32,
            triangle_count: 0,
        }
    }

    pub fn held_bytes(&self) -> usize {
        self.nodes.held_bytes() + self.triangles.held_bytes()
    }

    /// Of a hierarchy whose scene has this exponent.
    pub fn codecs(&self, scene_exponent: i32) -> (NodeCodec, MeshCodec) {
        match (&self.nodes, &self.triangles) {
            (CodedNodes::Paper10 { .. }, CodedTriangles::Leaf10(_)) => {
                (NodeCodec::Paper10, MeshCodec::Leaf10)
            }
            (CodedNodes::Paper10 { .. }, _) => (NodeCodec::Paper10, MeshCodec::F32),
            (
                CodedNodes::Lattice {
                    bits,
                    step_exponent,
                    ..
                },
                CodedTriangles::Lattice(_),
            ) => {
                let step_exponent = step_exponent - scene_exponent;
                (
                    NodeCodec::Lattice(*bits),
                    MeshCodec::Lattice { step_exponent },
                )
            }
            (CodedNodes::Lattice { bits, .. }, _) => (NodeCodec::Lattice(*bits), MeshCodec::F32),
        }
    }

    /// Takes an errand to nodes and triangles. `plain` are the triangles where they are stored in full.
    pub fn walk(&self, plain: &[LeafTriangle], errand: impl Errand, stacks: &mut Stacks) {
        match (&self.nodes, &self.triangles) {
            (CodedNodes::Paper10 { root, nodes }, triangles) => {
                let nodes = Paper10Nodes {
                    nodes,
                    root: *root,
                    opaque_zero: 0,
                };
                if let CodedTriangles::Leaf10(triangles) = triangles {
                    let triangles = Paper10Triangles {
                        triangles,
                        opaque_zero: 0,
                    };
                    errand.run(&mut stacks.paper10, &nodes, &triangles);
                } else {
                    errand.run(&mut stacks.paper10, &nodes, &LeafTriangles(plain));
                }
            }
            (CodedNodes::Lattice { bits, .. }, _) => {
                by_bits!(*bits, lattice(self, plain, errand, stacks));
            }
        }
    }
}

/// What is to be done where nodes and triangles are, whatever they are.
pub trait Errand {
    /// Does it.
    fn run<N: NodeSource, T: TriangleSource<N::Bounds>>(
        self,
        stacks: &mut PacketStacks<N::Cursor, Numbers>,
        nodes: &N,
        triangles: &T,
    );
}

/// The closest hit of one ray, or any, as its collector wants.
pub struct Alone<'a, 'b>(
    pub &'a PreparedRay,
    pub &'a mut Lane<SkipAnd<'b, FacingFilter<'b>>, ClosestOrAny>,
);

impl Errand for Alone<'_, '_> {
    #[inline(always)]
    fn run<N: NodeSource, T: TriangleSource<N::Bounds>>(
        self,
        stacks: &mut PacketStacks<N::Cursor, Numbers>,
        nodes: &N,
        triangles: &T,
    ) {
        trace_alone(&mut stacks.alone, nodes, triangles, self.0, self.1);
    }
}

/// The same of several rays.
pub struct Together<'a, 'b>(
    pub &'a mut PreparedRays<Numbers, LANES>,
    pub &'a mut AskedPacket<'b>,
);

impl Errand for Together<'_, '_> {
    #[inline(always)]
    fn run<N: NodeSource, T: TriangleSource<N::Bounds>>(
        self,
        stacks: &mut PacketStacks<N::Cursor, Numbers>,
        nodes: &N,
        triangles: &T,
    ) {
        trace_packet(stacks, nodes, triangles, self.0, self.1);
    }
}

/// Whatever else may be asked, at the price of a call for each node.
pub struct Watched<'a, 'b> {
    pub ray: &'a PreparedRay,
    pub filter: SkipAnd<'b, FacingFilter<'b>>,
    pub collector: &'a mut dyn Collector,
}

impl Errand for Watched<'_, '_> {
    #[inline(always)]
    fn run<N: NodeSource, T: TriangleSource<N::Bounds>>(
        self,
        stacks: &mut PacketStacks<N::Cursor, Numbers>,
        nodes: &N,
        triangles: &T,
    ) {
        let collector = &mut Shared(self.collector);
        traverse_with(
            &mut stacks.alone,
            nodes,
            triangles,
            self.ray,
            &self.filter,
            collector,
        );
    }
}

// Functions of their own: one for all would be too large to be compiled well.
#[inline(never)]
fn lattice<const BITS: u32, const WORDS: usize>(
    coded: &Coded,
    plain: &[LeafTriangle],
    errand: impl Errand,
    stacks: &mut Stacks,
) {
    let stacks = &mut stacks.lattice;
    let CodedNodes::Lattice {
        root,
        step_exponent,
        words,
        ..
    } = &coded.nodes
    else {
        return;
    };
    let (root, step) = (*root, power_of_two(*step_exponent));
    let nodes: &[[u32; WORDS]] = bytemuck::cast_slice(words);
    if let CodedTriangles::Lattice(words) = &coded.triangles {
        let nodes = LatticeNodes::<BITS, WORDS, true> { nodes, root, step };
        let triangles = LatticeTriangles { words, step };
        errand.run(stacks, &nodes, &triangles);
    } else {
        let nodes = LatticeNodes::<BITS, WORDS, false> { nodes, root, step };
        errand.run(stacks, &nodes, &LeafTriangles(plain));
    }
}

/// Stacks for each kind of nodes.
pub struct Stacks {
    pub plain: PacketStacks<NodeRef, Numbers>,
    paper10: PacketStacks<Paper10Cursor, Numbers>,
    lattice: PacketStacks<LatticeCursor, Numbers>,
}

impl Stacks {
    /// Nothing waits.
    pub const NEW: Self = Self {
        plain: PacketStacks::EMPTY,
        paper10: PacketStacks::EMPTY,
        lattice: PacketStacks::EMPTY,
    };
}

thread_local! {
    static STACKS: RefCell<Stacks> = const { RefCell::new(Stacks::NEW) };
}

/// With the thread's own stacks.
pub fn with_stacks<R>(run: impl FnOnce(&mut Stacks) -> R) -> R {
    STACKS.with_borrow_mut(run)
}

/// A collector behind a reference.
pub struct Shared<'a>(pub &'a mut dyn Collector);

impl Collector for Shared<'_> {
    fn limit(&self) -> f32 {
        self.0.limit()
    }

    fn offer(&mut self, hit: slimbvh_core::Hit) {
        self.0.offer(hit);
    }

    fn count_node(&mut self) {
        self.0.count_node();
    }

    fn count_triangle(&mut self) {
        self.0.count_triangle();
    }
}
