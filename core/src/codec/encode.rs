//! From the root down to one node: what a thread must know to code it without waiting for another.
//!
//! A node is coded in its own box as it comes out of the codec, and that depends on all above it. Nodes below a left child
//! come before those below a right one, so that comparing indices leads to any of them; on the way each box is coded anew.

use super::lattice_node::{EncodedNode, encode_child, encode_node};
use super::paper10::{EncodedPaper10, Paper10Box, encode_paper10_node, paper10_child};
use super::rounded::RoundedNode;
use crate::build::node::{Node, NodeRef};
use crate::geometry::lattice::LatticeBox;
use crate::trace::STACK_SIZE;

/// What a codec reads of a node.
pub trait PlainNode: Copy {
    /// A node without triangles.
    const EMPTY: Self;

    /// The left child and the right one.
    fn children(&self) -> [NodeRef; 2];
}

impl PlainNode for Node {
    const EMPTY: Self = Self::EMPTY;

    #[inline(always)]
    fn children(&self) -> [NodeRef; 2] {
        [self.left, self.right]
    }
}

impl PlainNode for RoundedNode {
    const EMPTY: Self = Self::EMPTY;

    #[inline(always)]
    fn children(&self) -> [NodeRef; 2] {
        [self.left, self.right]
    }
}

/// A codec, as far as boxes go.
pub trait BoxCodec {
    /// What it reads.
    type Node: PlainNode;

    /// A box, decoded.
    type Bounds: Copy;

    /// The root's box: the origin, where there is nothing in it.
    fn root(&self, node: &Self::Node) -> Self::Bounds;

    /// A child's box, from its parent's and the plain parent.
    fn child(&self, bounds: &Self::Bounds, node: &Self::Node, is_left: bool) -> Self::Bounds;
}

/// A node's own box, decoded. Reads the plain nodes above it, and no more of them than any tree is deep.
#[inline]
#[must_use]
pub fn node_bounds<C: BoxCodec>(target: u32, nodes: &[C::Node], codec: &C) -> C::Bounds {
    let mut bounds = codec.root(&crate::load(nodes, 0, C::Node::EMPTY));
    let mut at = 0;
    for _ in 0..STACK_SIZE as u32 {
        if at == target {
            break;
        }
        let node = crate::load(nodes, at, C::Node::EMPTY);
        let [left, right] = node.children();
        let is_left = is_below_left(target, left);
        bounds = codec.child(&bounds, &node, is_left);
        at = if is_left { left.index() } else { right.index() };
    }
    bounds
}

/// Whether a node that is below another is below that one's left child: all of these come before it, or are it.
#[inline(always)]
const fn is_below_left(target: u32, left: NodeRef) -> bool {
    !left.is_leaf() && target <= left.index()
}

/// The lattice codec with `BITS` bits a plane and `WORDS` words a node.
#[derive(Clone, Copy, Debug)]
pub struct LatticeCodec<const BITS: u32, const WORDS: usize>;

impl<const BITS: u32, const WORDS: usize> LatticeCodec<BITS, WORDS> {
    /// One thread per node. Reads the plain node and its box, decoded. Returns the encoded node; its links are not filled in yet.
    #[inline]
    #[must_use]
    pub fn encode(&self, bounds: &LatticeBox, node: &RoundedNode) -> EncodedNode<WORDS> {
        encode_node::<BITS, WORDS>(bounds, node)
    }
}

impl<const BITS: u32, const WORDS: usize> BoxCodec for LatticeCodec<BITS, WORDS> {
    type Node = RoundedNode;
    type Bounds = LatticeBox;

    #[inline(always)]
    fn root(&self, node: &RoundedNode) -> LatticeBox {
        let [left, right] = node.boxes();
        left.union(&right)
    }

    /// A fraction of what [`Self::encode`] does.
    #[inline(always)]
    fn child(&self, bounds: &LatticeBox, node: &RoundedNode, is_left: bool) -> LatticeBox {
        encode_child::<BITS>(bounds, node, is_left)
    }
}

/// The paper10 codec.
#[derive(Clone, Copy, Debug)]
pub struct Paper10Codec {
    /// Always 0, hidden from the compiler so that it cannot fuse a product with a sum.
    pub opaque_zero: u32,
}

impl Paper10Codec {
    /// One thread per node. Reads the plain node and its box, decoded. Returns it in the codec.
    #[inline]
    #[must_use]
    pub fn encode(&self, bounds: &Paper10Box, node: &Node) -> EncodedPaper10 {
        let boxes = node.child_boxes();
        let (left, right) = (Paper10Box::of(&boxes.left), Paper10Box::of(&boxes.right));
        encode_paper10_node(bounds, &left, &right, node, self.opaque_zero)
    }
}

impl BoxCodec for Paper10Codec {
    type Node = Node;
    type Bounds = Paper10Box;

    #[inline(always)]
    fn root(&self, node: &Node) -> Paper10Box {
        let boxes = node.child_boxes();
        Paper10Box::of(&boxes.left.union(boxes.right))
    }

    /// Half of what [`Self::encode`] does.
    #[inline(always)]
    fn child(&self, bounds: &Paper10Box, node: &Node, is_left: bool) -> Paper10Box {
        let boxes = node.child_boxes();
        let child = if is_left { boxes.left } else { boxes.right };
        paper10_child(bounds, &Paper10Box::of(&child), self.opaque_zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::aabb::Aabb;
    use glam::Vec3;

    fn bounds(min: [f32; 3], max: [f32; 3]) -> Aabb {
        Aabb {
            min: Vec3::from_array(min),
            max: Vec3::from_array(max),
        }
    }

    /// A root with two inner children, of which the left one is the last of its nodes and the right one the first.
    fn tree() -> [Node; 4] {
        let a = bounds([0.0; 3], [0.25, 0.5, 0.125]);
        let b = bounds([0.1, -0.3, 0.0], [0.3, 0.4, 0.8]);
        let c = bounds([-0.7, 0.2, 0.3], [-0.1, 0.3, 0.9]);
        let d = bounds([-0.2, -0.1, 0.1], [0.6, 0.1, 0.2]);
        let leaf = |first| NodeRef::leaf(first, 4);
        let node = |left, right| Node {
            left,
            right,
            ..Node::EMPTY
        };
        [
            node(NodeRef::inner(2), NodeRef::inner(3)).with_boxes(a.union(b).union(c), d),
            node(leaf(0), leaf(4)).with_boxes(a, b),
            node(NodeRef::inner(1), leaf(8)).with_boxes(a.union(b), c),
            node(leaf(12), leaf(16)).with_boxes(d, d),
        ]
    }

    #[test]
    fn every_node_is_found_with_the_box_that_its_parent_decodes() {
        let nodes = tree();
        let rounded = nodes.map(|node| RoundedNode::new(&node, -20));
        let lattice = LatticeCodec::<6, 4>;
        let root = lattice.root(&rounded[0]);
        let top = lattice.encode(&root, &rounded[0]);
        let below = lattice.encode(&top.left, &rounded[2]);
        let expected = [root, below.left, top.left, top.right];
        for (target, expected) in (0..).zip(expected) {
            let found = node_bounds(target, &rounded, &lattice);
            assert_eq!(found, expected, "{target}");
        }
        assert!(below.left != top.left);

        let paper10 = Paper10Codec { opaque_zero: 0 };
        let root = paper10.root(&nodes[0]);
        let top = paper10.encode(&root, &nodes[0]);
        let below = paper10.encode(&top.left, &nodes[2]);
        let expected = [root, below.left, top.left, top.right];
        for (target, expected) in (0..).zip(expected) {
            assert_eq!(node_bounds(target, &nodes, &paper10), expected, "{target}");
        }
    }

    #[test]
    fn what_is_not_there_ends() {
        let lattice = LatticeCodec::<6, 4>;
        assert_eq!(node_bounds(7, &[], &lattice), LatticeBox::ZERO);
        let rounded = tree().map(|node| RoundedNode::new(&node, -20));
        let _ = node_bounds(7, &rounded, &lattice);
        let paper10 = Paper10Codec { opaque_zero: 0 };
        assert_eq!(paper10.root(&Node::EMPTY), Paper10Box::ZERO);
    }
}
