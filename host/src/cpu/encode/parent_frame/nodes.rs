//! Nodes on the lattice.

use super::super::leaf_words::Leaf;
use super::super::tree::{Part, TASK, Tree, both};
use crate::tree::parent_frame::{LatticeBits, by_bits};
use slimbvh_core::encode::{
    BoxCodec, EncodedNode, FINEST_STEP, LatticeCodec, LeafCorner, Links, RoundedNode, with_links,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::STACK_SIZE;
use slimbvh_core::{Node, NodeRef};

/// Codes a tree's nodes on the finest lattice, with links to triangles in full. Returns the root's box.
pub(super) fn encode_lattice(tree: &Tree, bits: LatticeBits, words: &mut Vec<u32>) -> LatticeBox {
    words.resize(tree.nodes.len() * bits.words(), 0);
    let root = root_box(tree, FINEST_STEP);
    let lattice = OnLattice {
        tree,
        root,
        step_exponent: FINEST_STEP,
    };
    by_bits!(bits, fill_nodes(&lattice, words));
    return root;

    fn fill_nodes<const BITS: u32, const WORDS: usize>(lattice: &OnLattice, words: &mut [u32]) {
        let part = lattice.part(words, &mut [] as &mut [()], 0);
        let link = linked_to::<BITS, WORDS>(|triangle| triangle);
        encode_nodes::<BITS, WORDS, ()>(lattice, part, &link, &|_, _, _| {});
    }
}

/// Sets the links in a node's words. A function returns the place of each triangle.
pub(super) fn linked_to<const BITS: u32, const WORDS: usize>(
    place_of: impl Fn(u32) -> u32 + Sync,
) -> impl Fn(&Node, [u32; WORDS]) -> [u32; WORDS] + Sync {
    move |node, words| {
        let place = place_of(Links::first_triangle(node.left, node.right));
        with_links::<BITS, WORDS>(words, Links::new(node.left, node.right, place))
    }
}

/// The root's box, on a lattice of this step.
pub(super) fn root_box(tree: &Tree, step_exponent: i32) -> LatticeBox {
    let root = RoundedNode::new(&tree.node(0), step_exponent);
    // Independent of the number of bits.
    LatticeCodec::<10, 4>.root(&root)
}

/// A tree to be coded on a lattice.
pub(super) struct OnLattice<'a> {
    pub(super) tree: &'a Tree<'a>,
    pub(super) root: LatticeBox,
    pub(super) step_exponent: i32,
}

impl OnLattice<'_> {
    /// The whole tree.
    pub(super) fn part<'a, const WORDS: usize, T>(
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

    /// A node with its boxes, and its code in the decoded box `bounds`.
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

    /// A leaf's triangles, and how they are to be stored.
    pub(super) fn leaf(&self, leaf: NodeRef, bounds: &LatticeBox) -> Leaf<'_> {
        let first = leaf.first() as usize;
        Leaf {
            triangles: &self.tree.leaves[first..first + leaf.count() as usize],
            corner: LeafCorner::of(bounds),
            step: power_of_two(self.step_exponent),
        }
    }
}

/// Codes a node and all below it, and calls `leaf` with each leaf, its box and its part of the triangles.
pub(super) fn encode_nodes<const BITS: u32, const WORDS: usize, T: Send>(
    lattice: &OnLattice,
    part: Part<[u32; WORDS], T, LatticeBox>,
    link: &(impl Fn(&Node, [u32; WORDS]) -> [u32; WORDS] + Sync),
    leaf: &(impl Fn(NodeRef, &LatticeBox, &mut [T]) + Sync),
) {
    let tree = lattice.tree;
    let Node { first, last, .. } = tree.node(part.node);
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
