//! Stage `encode` on the CPU: from the root down, as a box is coded in its parent's, once that is decoded.
//!
//! A node's descendants lie together: those of the left child before the right child, those of the right child from there on.
//! So both halves can be filled at once, each in its part of the lists.

use crate::Bvh;
use crate::codec::{LatticeBits, MeshCodec, NodeCodec, by_bits};
use crate::coded::{Coded, CodedNodes, CodedTriangles};
use slimbvh_core::encode::{
    FINEST_STEP, LatticeCodec, LeafWidth, Links, PrintedBox, PrintedCodec, PrintedNode,
    PrintedTriangle, decode_node, encode_printed_triangle, encode_triangle, in_steps, root_bounds,
    scaled_step, with_links,
};
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::scan::run_scan;
use slimbvh_core::{LeafTriangle, Node, NodeRef};

/// Codes hierarchies, and keeps what was plain of them for the next.
#[derive(Debug, Default)]
pub struct Encoder {
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
    sizes: Vec<u32>,
}

impl Encoder {
    /// Gives a hierarchy room for plain nodes and triangles, where the last one left any.
    pub fn lend(&mut self, bvh: &mut Bvh) {
        if bvh.nodes.capacity() == 0 {
            std::mem::swap(&mut bvh.nodes, &mut self.nodes);
        }
        if bvh.triangles.capacity() == 0 {
            std::mem::swap(&mut bvh.triangles, &mut self.triangles);
        }
    }

    /// Codes a plain hierarchy, and takes back what is plain of it. Its vertices must lie on the mesh's lattice.
    pub fn encode(&mut self, (nodes, mesh): (NodeCodec, MeshCodec), bvh: &mut Bvh) {
        let (plain, leaves) = (bvh.nodes.as_slice(), bvh.triangles.as_slice());
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
                let root = encode_printed(plain, leaves, &mut nodes, &mut triangles);
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
                encode_lattice_mesh(plain, leaves, bits, step_exponent, &mut self.sizes, to);
                coded.triangles = CodedTriangles::Lattice(words);
            }
            (NodeCodec::Lattice(bits), _) => {
                encode_lattice(plain, bits, &mut coded.nodes);
                coded.triangles = CodedTriangles::F32;
            }
        }
        self.nodes = std::mem::take(&mut bvh.nodes);
        if !matches!(coded.triangles, CodedTriangles::F32) {
            self.triangles = std::mem::take(&mut bvh.triangles);
        }
        bvh.coded = Some(coded);
    }

    /// Bytes of what is kept.
    pub fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice())
            + size_of_val(self.triangles.as_slice())
            + size_of_val(self.sizes.as_slice())
    }
}

/// Nodes with fewer triangles are not divided among threads.
const TASK: u32 = 8192;

/// Where a node's right child's descendants begin, and its right child's triangles.
fn split(nodes: &[Node], node: &Node, nodes_end: usize) -> (usize, u32) {
    let place = if node.right.is_leaf() {
        nodes_end
    } else {
        node.right.index() as usize
    };
    let triangle = if node.left.is_leaf() {
        node.left.first() + node.left.count()
    } else {
        nodes[node.left.index() as usize].last + 1
    };
    (place, triangle)
}

/// A node to be coded, and the parts of the lists that it and its descendants fill.
struct Part<'a, N, T, B> {
    node: u32,
    bounds: B,
    nodes: &'a mut [N],
    first_node: usize,
    triangles: &'a mut [T],
    first_triangle: usize,
}

impl<'a, N, T, B> Part<'a, N, T, B> {
    /// What its children fill. `place_of` tells where a triangle's part of the list begins.
    fn split(
        self,
        plain: &[Node],
        [left, right]: [B; 2],
        place_of: impl Fn(u32) -> usize,
    ) -> [Self; 2] {
        let node = &plain[self.node as usize];
        let end = self.first_node + self.nodes.len();
        let (middle, triangle) = split(plain, node, end);
        let (left_nodes, right_nodes) = self.nodes.split_at_mut(middle - self.first_node);
        let middle_triangle = if self.triangles.is_empty() {
            self.first_triangle
        } else {
            place_of(triangle)
        };
        let triangles = self.triangles;
        let (left_triangles, right_triangles) =
            triangles.split_at_mut(middle_triangle - self.first_triangle);
        let part = |child: NodeRef, bounds, nodes, first_node, triangles, first_triangle| Self {
            node: child.0,
            bounds,
            nodes,
            first_node,
            triangles,
            first_triangle,
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
fn both<P: Send>(triangle_count: u32, [left, right]: [P; 2], code: impl Fn(P) + Sync) {
    if triangle_count < TASK {
        code(left);
        code(right);
    } else {
        rayon::join(|| code(left), || code(right));
    }
}

/// Codes a plain tree's nodes on the lattice, with links to triangles that are stored in full.
fn encode_lattice(plain: &[Node], bits: LatticeBits, to: &mut CodedNodes) {
    let words = by_bits!(bits, lattice_words(plain, bits, FINEST_STEP, to));
    by_bits!(bits, fill_nodes(plain, words));

    fn fill_nodes<const BITS: u32, const WORDS: usize>(plain: &[Node], words: &mut [u32]) {
        let codec = LatticeCodec::<BITS, WORDS> {
            step_exponent: FINEST_STEP,
        };
        let part = Part {
            node: 0,
            bounds: root_bounds(plain, &codec),
            nodes: bytemuck::cast_slice_mut::<u32, [u32; WORDS]>(words),
            first_node: 0,
            triangles: &mut [] as &mut [()],
            first_triangle: 0,
        };
        let link = |node: &Node, words| {
            let triangle = Links::first_triangle(node.left, node.right);
            with_links::<BITS, WORDS>(words, Links::new(node.left, node.right, triangle))
        };
        encode_nodes::<BITS, WORDS, ()>(plain, &codec, part, &link, &|_, _| {});
    }
}

/// Room for the words of as many nodes as there are.
fn lattice_words<'a, const BITS: u32, const WORDS: usize>(
    plain: &[Node],
    bits: LatticeBits,
    step_exponent: i32,
    to: &'a mut CodedNodes,
) -> &'a mut [u32] {
    let root = root_bounds(plain, &LatticeCodec::<BITS, WORDS> { step_exponent });
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
    words.resize(plain.len() * WORDS, 0);
    *to = CodedNodes::Lattice {
        bits,
        root,
        step_exponent,
        words,
    };
    match to {
        CodedNodes::Lattice { words, .. } => words,
        CodedNodes::Printed { .. } => &mut [],
    }
}

/// Codes a node and all below it, and shows each leaf's box with its part of the triangles.
fn encode_nodes<const BITS: u32, const WORDS: usize, T: Send>(
    plain: &[Node],
    codec: &LatticeCodec<BITS, WORDS>,
    part: Part<[u32; WORDS], T, LatticeBox>,
    link: &(impl Fn(&Node, [u32; WORDS]) -> [u32; WORDS] + Sync),
    leaf: &(impl Fn(&LatticeBox, &mut [T]) + Sync),
) {
    let reference = NodeRef(part.node);
    if reference.is_leaf() {
        leaf(&part.bounds, part.triangles);
        return;
    }
    let node = &plain[part.node as usize];
    let coded = codec.encode(&part.bounds, node);
    part.nodes[part.node as usize - part.first_node] = link(node, coded.words);
    let triangle_count = node.last - node.first;
    let place_of = |triangle: u32| triangle as usize;
    let parts = part.split(plain, [coded.left, coded.right], place_of);
    both(triangle_count, parts, |part| {
        encode_nodes::<BITS, WORDS, T>(plain, codec, part, link, leaf);
    });
}

/// Codes a plain tree's nodes and triangles on the lattice with this step, on which all vertices lie. `sizes` is scratch.
fn encode_lattice_mesh(
    plain: &[Node],
    leaves: &[LeafTriangle],
    bits: LatticeBits,
    step_exponent: i32,
    sizes: &mut Vec<u32>,
    (nodes, triangles): (&mut CodedNodes, &mut Vec<u32>),
) {
    let words = by_bits!(bits, lattice_words(plain, bits, step_exponent, nodes));
    by_bits!(
        bits,
        fill(plain, leaves, step_exponent, sizes, words, triangles)
    );

    fn fill<const BITS: u32, const WORDS: usize>(
        plain: &[Node],
        leaves: &[LeafTriangle],
        step_exponent: i32,
        sizes: &mut Vec<u32>,
        words: &mut [u32],
        triangles: &mut Vec<u32>,
    ) {
        // How many words each triangle takes follows from its leaf's box; where it begins, from all before it.
        let codec = LatticeCodec::<BITS, WORDS> { step_exponent };
        let root = root_bounds(plain, &codec);
        sizes.clear();
        sizes.resize(leaves.len(), 0);
        let part = Part {
            node: 0,
            bounds: root,
            nodes: bytemuck::cast_slice_mut::<u32, [u32; WORDS]>(words),
            first_node: 0,
            triangles: sizes.as_mut_slice(),
            first_triangle: 0,
        };
        let unlinked = |_: &Node, words| words;
        let size = |bounds: &LatticeBox, sizes: &mut [u32]| {
            sizes.fill(LeafWidth::of(bounds).words());
        };
        encode_nodes::<BITS, WORDS, u32>(plain, &codec, part, &unlinked, &size);
        let count = sizes.len() as u32;
        let total = run_scan(sizes, 0, count, 0);
        triangles.resize(total as usize, 0);
        let begins = sizes.as_slice();
        let begin_of = |triangle: u32| begins.get(triangle as usize).map_or(total, |&b| b);
        let part = Part {
            node: 0,
            bounds: root,
            nodes: bytemuck::cast_slice_mut::<u32, [u32; WORDS]>(words),
            first_node: 0,
            triangles: triangles.as_mut_slice(),
            first_triangle: 0,
        };
        place_triangles::<BITS, WORDS>(plain, leaves, step_exponent, part, &begin_of);
    }
}

/// Puts triangles where they belong, and links to them into the nodes.
fn place_triangles<const BITS: u32, const WORDS: usize>(
    plain: &[Node],
    leaves: &[LeafTriangle],
    step_exponent: i32,
    part: Part<[u32; WORDS], u32, LatticeBox>,
    begin_of: &(impl Fn(u32) -> u32 + Sync),
) {
    let reference = NodeRef(part.node);
    if reference.is_leaf() {
        let size = LeafWidth::of(&part.bounds).words() as usize;
        let leaves = leaves.iter().skip(reference.first() as usize);
        for (to, leaf) in part.triangles.chunks_exact_mut(size).zip(leaves) {
            let vertices = in_steps(leaf, step_exponent);
            let words = encode_triangle(&vertices, leaf.primitive, &part.bounds);
            to.copy_from_slice(&words[..size]);
        }
        return;
    }
    let node = &plain[part.node as usize];
    let words = &mut part.nodes[part.node as usize - part.first_node];
    let boxes = decode_node::<BITS, WORDS>(words, &part.bounds);
    let place = begin_of(Links::first_triangle(node.left, node.right));
    let links = Links::new(node.left, node.right, place);
    *words = with_links::<BITS, WORDS>(*words, links);
    let triangle_count = node.last - node.first;
    let parts = part.split(plain, boxes, |triangle| begin_of(triangle) as usize);
    both(triangle_count, parts, |part| {
        place_triangles::<BITS, WORDS>(plain, leaves, step_exponent, part, begin_of);
    });
}

/// Codes a plain tree's nodes as printed, and its triangles, where there is room for them.
fn encode_printed(
    plain: &[Node],
    leaves: &[LeafTriangle],
    nodes: &mut Vec<PrintedNode>,
    triangles: &mut [PrintedTriangle],
) -> PrintedBox {
    nodes.resize(plain.len(), PrintedNode::default());
    let root = root_bounds(plain, &PrintedCodec { zero: 0 });
    let part = Part {
        node: 0,
        bounds: root,
        nodes: nodes.as_mut_slice(),
        first_node: 0,
        triangles,
        first_triangle: 0,
    };
    printed(plain, leaves, part);
    root
}

fn printed(
    plain: &[Node],
    leaves: &[LeafTriangle],
    part: Part<PrintedNode, PrintedTriangle, PrintedBox>,
) {
    let reference = NodeRef(part.node);
    if reference.is_leaf() {
        let leaves = leaves.iter().skip(reference.first() as usize);
        for (to, leaf) in part.triangles.iter_mut().zip(leaves) {
            *to = encode_printed_triangle(leaf, &part.bounds, 0);
        }
        return;
    }
    let node = &plain[part.node as usize];
    let coded = PrintedCodec { zero: 0 }.encode(&part.bounds, node);
    part.nodes[part.node as usize - part.first_node] = coded.node;
    let triangle_count = node.last - node.first;
    let parts = part.split(plain, [coded.left, coded.right], |triangle| {
        triangle as usize
    });
    both(triangle_count, parts, |part| printed(plain, leaves, part));
}
