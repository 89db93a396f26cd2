//! Stage `encode` on the CPU: from the root down, as a box is coded in its parent's, once that is decoded.
//!
//! A node's descendants lie together: those of the left child before the right child, those of the right child from there on.
//! So both halves can be filled at once, each in its part of the lists.

use super::topology::Connections;
use crate::Bvh;
use crate::codec::{LatticeBits, MeshCodec, NodeCodec, by_bits};
use crate::coded::{Coded, CodedNodes, CodedTriangles};
use slimbvh_core::encode::{
    BoxCodec, EncodedNode, FINEST_STEP, LatticeCodec, LeafCorner, LeafWidth, Links, PrintedBox,
    PrintedCodec, PrintedNode, PrintedTriangle, RoundedNode, decode_node, encode_narrow_triangle,
    encode_printed_triangle, encode_triangle, scaled_step, with_links,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::node::Connection;
use slimbvh_core::refit::{PyramidBox, refit_node};
use slimbvh_core::scan::run_scan;
use slimbvh_core::trace::STACK_SIZE;
use slimbvh_core::{LeafTriangle, Node, NodeRef};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Codes hierarchies, and keeps what was plain of them for the next.
#[derive(Debug)]
pub struct Encoder {
    triangles: Vec<LeafTriangle>,
    sizes: Vec<u32>,
    /// How wide all triangles of the last hierarchy were, where they were alike.
    width: Option<LeafWidth>,
}

impl Default for Encoder {
    fn default() -> Self {
        Self {
            triangles: Vec::new(),
            sizes: Vec::new(),
            width: Some(LeafWidth::Narrow),
        }
    }
}

impl Encoder {
    /// Gives a hierarchy room for triangles, where the last one left any.
    pub fn lend(&mut self, bvh: &mut Bvh) {
        if bvh.triangles.capacity() == 0 {
            std::mem::swap(&mut bvh.triangles, &mut self.triangles);
        }
    }

    /// Codes a hierarchy over these nodes, and takes back its triangles where they are coded. Its vertices must lie
    /// on the mesh's lattice.
    pub fn encode(
        &mut self,
        (nodes, mesh): (NodeCodec, MeshCodec),
        bvh: &mut Bvh,
        (connections, pyramid): (&Connections, &[PyramidBox]),
    ) {
        let leaves = bvh.triangles.as_slice();
        let tree = Tree {
            nodes: &connections.nodes,
            splits: &connections.splits,
            leaves,
            pyramid,
        };
        let mut coded = bvh.coded.take().unwrap_or_else(Coded::nothing);
        coded.triangle_count = leaves.len();
        match (nodes, mesh) {
            (NodeCodec::F32, _) => return,
            (NodeCodec::Printed, _) => {
                let mut nodes = match coded.nodes {
                    CodedNodes::Printed { nodes, .. } => nodes,
                    CodedNodes::Lattice { .. } => Vec::new(),
                };
                let mut triangles = match coded.triangles {
                    CodedTriangles::Leaf10(triangles) => triangles,
                    CodedTriangles::F32 | CodedTriangles::Lattice(_) => Vec::new(),
                };
                let is_leaf_10 = mesh == MeshCodec::Leaf10;
                let count = if is_leaf_10 { leaves.len() } else { 0 };
                triangles.resize(count, PrintedTriangle::default());
                let root = encode_printed(&tree, &mut nodes, &mut triangles);
                coded.nodes = CodedNodes::Printed { root, nodes };
                coded.triangles = match mesh {
                    MeshCodec::Leaf10 => CodedTriangles::Leaf10(triangles),
                    MeshCodec::F32 | MeshCodec::Lattice { .. } => CodedTriangles::F32,
                };
            }
            (NodeCodec::Lattice(bits), MeshCodec::Lattice { step_exponent }) => {
                let mut words = match coded.triangles {
                    CodedTriangles::Lattice(words) => words,
                    CodedTriangles::F32 | CodedTriangles::Leaf10(_) => Vec::new(),
                };
                let step_exponent = scaled_step(step_exponent, bvh.scene_exponent);
                let to = (&mut coded.nodes, &mut words);
                let shape = (bits, step_exponent);
                let scratch = (&mut self.sizes, &mut self.width);
                encode_lattice_mesh(&tree, shape, scratch, to);
                coded.triangles = CodedTriangles::Lattice(words);
            }
            (NodeCodec::Lattice(bits), _) => {
                encode_lattice(&tree, bits, &mut coded.nodes);
                coded.triangles = CodedTriangles::F32;
            }
        }
        bvh.nodes = Vec::new();
        if !matches!(coded.triangles, CodedTriangles::F32) {
            self.triangles = std::mem::take(&mut bvh.triangles);
        }
        bvh.coded = Some(coded);
    }

    /// Bytes of what is kept.
    pub fn bytes(&self) -> usize {
        size_of_val(self.triangles.as_slice()) + size_of_val(self.sizes.as_slice())
    }
}

/// Nodes with fewer triangles are not divided among threads.
const TASK: u32 = 8192;

/// A tree on its way into a codec: its nodes have no boxes, which are found from the pyramid when their turn comes.
struct Tree<'a> {
    nodes: &'a [Connection],
    /// The last triangle of each node's left child.
    splits: &'a [u32],
    leaves: &'a [LeafTriangle],
    pyramid: &'a [PyramidBox],
}

impl Tree<'_> {
    /// A node with its boxes.
    fn node(&self, index: u32) -> Node {
        let (bare, split) = (&self.nodes[index as usize], self.splits[index as usize]);
        if self.leaves.is_empty() {
            return bare.into();
        }
        refit_node(bare.into(), split, self.leaves, self.pyramid)
    }
}

/// A node to be coded, and the parts of the lists that it and its descendants fill.
struct Part<'a, N, T, B> {
    node: u32,
    bounds: B,
    nodes: &'a mut [N],
    first_node: usize,
    triangles: &'a mut [T],
    first_triangle: usize,
    /// How much of the list each triangle takes, where that is the same for all.
    per_triangle: usize,
}

impl<'a, N, T, B> Part<'a, N, T, B> {
    /// What its children fill. `place_of` tells where a triangle's part of the list begins.
    fn split(
        self,
        tree: &Tree,
        [left, right]: [B; 2],
        place_of: impl Fn(u32) -> usize,
    ) -> [Self; 2] {
        let node = &tree.nodes[self.node as usize];
        // The right child's descendants begin with itself.
        let middle = if node.right.is_leaf() {
            self.first_node + self.nodes.len()
        } else {
            node.right.index() as usize
        };
        let triangle = tree.splits[self.node as usize].wrapping_add(1);
        let (left_nodes, right_nodes) = self.nodes.split_at_mut(middle - self.first_node);
        let middle_triangle = if self.triangles.is_empty() {
            self.first_triangle
        } else {
            place_of(triangle)
        };
        let (triangles, per_triangle) = (self.triangles, self.per_triangle);
        let (left_triangles, right_triangles) =
            triangles.split_at_mut(middle_triangle - self.first_triangle);
        let part = |child: NodeRef, bounds, nodes, first_node, triangles, first_triangle| Self {
            node: child.0,
            bounds,
            nodes,
            first_node,
            triangles,
            first_triangle,
            per_triangle,
        };
        [
            part(
                node.left,
                left,
                left_nodes,
                self.first_node,
                left_triangles,
                self.first_triangle,
            ),
            part(
                node.right,
                right,
                right_nodes,
                middle,
                right_triangles,
                middle_triangle,
            ),
        ]
    }
}

/// Codes both children, at once where that pays.
fn both<P: Send>(node: &Node, [left, right]: [P; 2], code: impl Fn(P) + Sync) {
    if node.last - node.first < TASK {
        code(left);
        code(right);
    } else {
        rayon::join(|| code(left), || code(right));
    }
}

/// Codes a tree's nodes on the lattice, with links to triangles that are stored in full.
fn encode_lattice(tree: &Tree, bits: LatticeBits, to: &mut CodedNodes) {
    let (root, words) = lattice_words(tree, bits, FINEST_STEP, to);
    let lattice = OnLattice {
        tree,
        root,
        step_exponent: FINEST_STEP,
    };
    by_bits!(bits, fill_nodes(&lattice, words));

    fn fill_nodes<const BITS: u32, const WORDS: usize>(lattice: &OnLattice, words: &mut [u32]) {
        let part = lattice.part(words, &mut [] as &mut [()], 0);
        let link = linked_to::<BITS, WORDS>(|triangle| triangle);
        encode_nodes::<BITS, WORDS, ()>(lattice, part, &link, &|_, _, _| {});
    }
}

/// Puts links into a node's words, to triangles that are where a function tells.
fn linked_to<const BITS: u32, const WORDS: usize>(
    place_of: impl Fn(u32) -> u32 + Sync,
) -> impl Fn(&Node, [u32; WORDS]) -> [u32; WORDS] + Sync {
    move |node, words| {
        let place = place_of(Links::first_triangle(node.left, node.right));
        with_links::<BITS, WORDS>(words, Links::new(node.left, node.right, place))
    }
}

/// The root's box, and room for the words of as many nodes as there are.
fn lattice_words<'a>(
    tree: &Tree,
    bits: LatticeBits,
    step_exponent: i32,
    to: &'a mut CodedNodes,
) -> (LatticeBox, &'a mut [u32]) {
    // All widths have the same.
    let root = RoundedNode::new(&tree.node(0), step_exponent);
    let root = LatticeCodec::<10, 4>.root(&root);
    let old = std::mem::replace(
        to,
        CodedNodes::Printed {
            root: PrintedBox::ZERO,
            nodes: Vec::new(),
        },
    );
    let mut words = match old {
        CodedNodes::Lattice { words, .. } => words,
        CodedNodes::Printed { .. } => Vec::new(),
    };
    words.resize(tree.nodes.len() * bits.words(), 0);
    *to = CodedNodes::Lattice {
        bits,
        root,
        step_exponent,
        words,
    };
    match to {
        CodedNodes::Lattice { words, .. } => (root, words),
        CodedNodes::Printed { .. } => (root, &mut []),
    }
}

/// A tree on its way onto a lattice.
struct OnLattice<'a> {
    tree: &'a Tree<'a>,
    root: LatticeBox,
    step_exponent: i32,
}

impl OnLattice<'_> {
    /// All of it.
    fn part<'a, const WORDS: usize, T>(
        &self,
        words: &'a mut [u32],
        triangles: &'a mut [T],
        per_triangle: usize,
    ) -> Part<'a, [u32; WORDS], T, LatticeBox> {
        Part {
            node: 0,
            bounds: self.root,
            nodes: bytemuck::cast_slice_mut(words),
            first_node: 0,
            triangles,
            first_triangle: 0,
            per_triangle,
        }
    }

    /// A node with its boxes, and the same coded in its own, decoded.
    #[inline(always)]
    fn encode<const BITS: u32, const WORDS: usize>(
        &self,
        index: u32,
        bounds: &LatticeBox,
    ) -> (Node, EncodedNode<WORDS>) {
        let node = self.tree.node(index);
        let rounded = RoundedNode::new(&node, self.step_exponent);
        let coded = LatticeCodec::<BITS, WORDS>.encode(bounds, &rounded);
        (node, coded)
    }

    /// Puts a leaf's triangles in place, which are narrow.
    fn put_narrow(&self, leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]) {
        let first = leaf.first() as usize;
        let leaves = &self.tree.leaves[first..first + leaf.count() as usize];
        let (corner, step) = (LeafCorner::of(bounds), power_of_two(self.step_exponent));
        for (to, leaf) in words.as_chunks_mut::<NARROW>().0.iter_mut().zip(leaves) {
            *to = encode_narrow_triangle(leaf, &corner, step);
        }
    }

    /// Puts a leaf's triangles in place, of so many words each.
    fn put<const SIZE: usize>(&self, leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]) {
        let first = leaf.first() as usize;
        let leaves = &self.tree.leaves[first..first + leaf.count() as usize];
        let (corner, step) = (LeafCorner::of(bounds), power_of_two(self.step_exponent));
        for (to, leaf) in words.chunks_exact_mut(SIZE).zip(leaves) {
            let words = encode_triangle(leaf, &corner, step);
            to.copy_from_slice(&words[..SIZE]);
        }
    }
}

/// Codes a node and all below it, and shows each leaf with its box and its part of the triangles.
fn encode_nodes<const BITS: u32, const WORDS: usize, T: Send>(
    lattice: &OnLattice,
    part: Part<[u32; WORDS], T, LatticeBox>,
    link: &(impl Fn(&Node, [u32; WORDS]) -> [u32; WORDS] + Sync),
    leaf: &(impl Fn(NodeRef, &LatticeBox, &mut [T]) + Sync),
) {
    let tree = lattice.tree;
    let Connection { first, last, .. } = tree.nodes[part.node as usize];
    if last - first < TASK {
        return encode_below::<BITS, WORDS, T>(lattice, part, link, leaf);
    }
    let (node, coded) = lattice.encode::<BITS, WORDS>(part.node, &part.bounds);
    part.nodes[part.node as usize - part.first_node] = link(&node, coded.words);
    let per_triangle = part.per_triangle;
    let place_of = |triangle: u32| per_triangle * triangle as usize;
    let parts = part.split(tree, [coded.left, coded.right], place_of);
    both(&node, parts, |part| {
        let child = NodeRef(part.node);
        if child.is_leaf() {
            leaf(child, &part.bounds, part.triangles);
        } else {
            encode_nodes::<BITS, WORDS, T>(lattice, part, link, leaf);
        }
    });
}

/// [`encode_nodes`] on one thread.
fn encode_below<const BITS: u32, const WORDS: usize, T: Send>(
    lattice: &OnLattice,
    part: Part<[u32; WORDS], T, LatticeBox>,
    link: &(impl Fn(&Node, [u32; WORDS]) -> [u32; WORDS] + Sync),
    leaf: &(impl Fn(NodeRef, &LatticeBox, &mut [T]) + Sync),
) {
    let mut waiting = Vec::with_capacity(STACK_SIZE);
    waiting.push((part.node, part.bounds));
    while let Some((index, bounds)) = waiting.pop() {
        let (node, coded) = lattice.encode::<BITS, WORDS>(index, &bounds);
        part.nodes[index as usize - part.first_node] = link(&node, coded.words);
        for (child, bounds) in [(node.right, coded.right), (node.left, coded.left)] {
            if !child.is_leaf() {
                waiting.push((child.0, bounds));
            } else if child.count() > 0 {
                let begin = part.per_triangle * child.first() as usize - part.first_triangle;
                let end = begin + part.per_triangle * child.count() as usize;
                leaf(child, &bounds, &mut part.triangles[begin..end]);
            }
        }
    }
}

/// Codes a tree's nodes and triangles on the lattice with this step, on which all vertices lie.
fn encode_lattice_mesh(
    tree: &Tree,
    (bits, step_exponent): (LatticeBits, i32),
    (sizes, width): (&mut Vec<u32>, &mut Option<LeafWidth>),
    (nodes, triangles): (&mut CodedNodes, &mut Vec<u32>),
) {
    let (root, words) = lattice_words(tree, bits, step_exponent, nodes);
    let tree = OnLattice {
        tree,
        root,
        step_exponent,
    };
    // Most often all triangles are as wide, as wide as they were the last time, and it is known where each is: one way down
    // does it. Else it takes another.
    let is_done = match *width {
        Some(LeafWidth::Narrow) => by_bits!(bits, fill_narrow(&tree, words, triangles)),
        Some(LeafWidth::Middle) => by_bits!(bits, fill_middle(&tree, words, triangles)),
        Some(LeafWidth::Wide) | None => false,
    };
    if !is_done {
        *width = by_bits!(bits, fill_mixed(&tree, words, triangles, sizes));
    }
}

const NARROW: usize = LeafWidth::Narrow.words() as usize;
const MIDDLE: usize = LeafWidth::Middle.words() as usize;
const WIDE: usize = LeafWidth::Wide.words() as usize;

/// [`fill_alike`] where all triangles are narrow.
fn fill_narrow<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
) -> bool {
    let put = |leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]| {
        lattice.put_narrow(leaf, bounds, words);
    };
    fill_alike::<BITS, WORDS>(lattice, words, triangles, (LeafWidth::Narrow, &put))
}

/// [`fill_alike`] where all triangles are of middle width.
fn fill_middle<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
) -> bool {
    let put = |leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]| {
        lattice.put::<MIDDLE>(leaf, bounds, words);
    };
    fill_alike::<BITS, WORDS>(lattice, words, triangles, (LeafWidth::Middle, &put))
}

/// Where all triangles are of one width. Returns whether they are, and leaves the lists in disorder if not.
fn fill_alike<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
    (width, put): (
        LeafWidth,
        &(impl Fn(NodeRef, &LatticeBox, &mut [u32]) + Sync),
    ),
) -> bool {
    let size = width.words() as usize;
    triangles.resize(size * lattice.tree.leaves.len(), 0);
    let is_other = AtomicBool::new(false);
    let put = |leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]| {
        if LeafWidth::of(bounds) == width {
            put(leaf, bounds, words);
        } else if leaf.count() > 0 {
            is_other.store(true, Relaxed);
        }
    };
    let link = linked_to::<BITS, WORDS>(|triangle| size as u32 * triangle);
    let part = lattice.part(words, triangles, size);
    encode_nodes::<BITS, WORDS, u32>(lattice, part, &link, &put);
    !is_other.into_inner()
}

/// Where triangles take more or less room, as their leaf's box tells: where one begins follows from all before it. Returns their
/// width if they are of one.
fn fill_mixed<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
    sizes: &mut Vec<u32>,
) -> Option<LeafWidth> {
    let count = lattice.tree.leaves.len();
    sizes.clear();
    sizes.resize(count, 0);
    let size = |_: NodeRef, bounds: &LatticeBox, sizes: &mut [u32]| {
        sizes.fill(LeafWidth::of(bounds).words());
    };
    let unlinked = |_: &Node, words| words;
    let part = lattice.part(words, sizes.as_mut_slice(), 1);
    encode_nodes::<BITS, WORDS, u32>(lattice, part, &unlinked, &size);

    let total = run_scan(sizes, 0, count as u32, 0);
    triangles.resize(total as usize, 0);
    let begins = sizes.as_slice();
    let begin_of = |triangle: u32| begins.get(triangle as usize).map_or(total, |&b| b);
    let part = lattice.part(words, triangles, 1);
    place_triangles::<BITS, WORDS>(lattice, part, &begin_of);

    // The narrowest width that would take as much; others in equal parts may as well, and come out as disorder next time.
    let widths = [LeafWidth::Narrow, LeafWidth::Middle];
    let takes_as_much = |width: &LeafWidth| width.words() as usize * count == total as usize;
    widths.into_iter().find(takes_as_much)
}

/// Puts triangles where they belong, and links to them into the nodes.
fn place_triangles<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    part: Part<[u32; WORDS], u32, LatticeBox>,
    begin_of: &(impl Fn(u32) -> u32 + Sync),
) {
    let tree = lattice.tree;
    let node = Node::from(&tree.nodes[part.node as usize]);
    let words = &mut part.nodes[part.node as usize - part.first_node];
    let boxes = decode_node::<BITS, WORDS>(words, &part.bounds);
    *words = linked_to::<BITS, WORDS>(begin_of)(&node, *words);
    let parts = part.split(tree, boxes, |triangle| begin_of(triangle) as usize);
    both(&node, parts, |part| {
        let child = NodeRef(part.node);
        if !child.is_leaf() {
            place_triangles::<BITS, WORDS>(lattice, part, begin_of);
            return;
        }
        match LeafWidth::of(&part.bounds) {
            LeafWidth::Narrow => lattice.put_narrow(child, &part.bounds, part.triangles),
            LeafWidth::Middle => lattice.put::<MIDDLE>(child, &part.bounds, part.triangles),
            LeafWidth::Wide => lattice.put::<WIDE>(child, &part.bounds, part.triangles),
        }
    });
}

/// Codes a tree's nodes as printed, and its triangles, where there is room for them.
fn encode_printed(
    tree: &Tree,
    nodes: &mut Vec<PrintedNode>,
    triangles: &mut [PrintedTriangle],
) -> PrintedBox {
    nodes.resize(tree.nodes.len(), PrintedNode::default());
    let root = CODEC.root(&tree.node(0));
    let part = Part {
        node: 0,
        bounds: root,
        nodes: nodes.as_mut_slice(),
        first_node: 0,
        triangles,
        first_triangle: 0,
        per_triangle: 1,
    };
    printed(tree, part);
    root
}

const CODEC: PrintedCodec = PrintedCodec { zero: 0 };

fn printed(tree: &Tree, part: Part<PrintedNode, PrintedTriangle, PrintedBox>) {
    let node = tree.node(part.node);
    let coded = CODEC.encode(&part.bounds, &node);
    part.nodes[part.node as usize - part.first_node] = coded.node;
    let boxes = [coded.left, coded.right];
    let parts = part.split(tree, boxes, |triangle| triangle as usize);
    both(&node, parts, |part| {
        let child = NodeRef(part.node);
        if !child.is_leaf() {
            printed(tree, part);
            return;
        }
        let leaves = tree.leaves.iter().skip(child.first() as usize);
        for (to, leaf) in part.triangles.iter_mut().zip(leaves) {
            *to = encode_printed_triangle(leaf, &part.bounds, 0);
        }
    });
}
