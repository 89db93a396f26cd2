//! From the root down to one node: what a thread must know to code it without waiting for another.
//!
//! A node is coded in its own box as it comes out of the codec, and that depends on all above it. Nodes below a left child
//! come before those below a right one, so that comparing indices leads to any of them; on the way each box is coded anew.

use super::lattice_node::{EncodedNode, encode_node};
use super::printed::{EncodedPrinted, PrintedBox, encode_printed_node, printed_child};
use crate::aabb::Aabb;
use crate::lattice::LatticeBox;
use crate::node::{Node, NodeRef};
use crate::trace::STACK_SIZE;

/// A codec, as far as boxes go.
pub trait BoxCodec {
    /// A box, decoded.
    type Bounds: Copy;

    /// The root's box.
    fn root(&self, bounds: &Aabb) -> Self::Bounds;

    /// A child's box, from its parent's and the plain parent.
    fn child(&self, bounds: &Self::Bounds, node: &Node, is_left: bool) -> Self::Bounds;
}

/// The root's box of a plain tree: the origin, where there is nothing in it.
#[inline]
#[must_use]
pub fn root_bounds<C: BoxCodec>(nodes: &[Node], codec: &C) -> C::Bounds {
    let boxes = crate::load(nodes, 0, Node::EMPTY).child_boxes();
    codec.root(&boxes.left.union(boxes.right))
}

/// A node's own box, decoded. Reads the plain nodes above it, and no more of them than any tree is deep.
#[inline]
#[must_use]
pub fn node_bounds<C: BoxCodec>(target: u32, nodes: &[Node], codec: &C) -> C::Bounds {
    let mut bounds = root_bounds(nodes, codec);
    let mut at = 0;
    for _ in 0..STACK_SIZE as u32 {
        if at == target {
            break;
        }
        let node = crate::load(nodes, at, Node::EMPTY);
        let is_left = is_below_left(target, node.left);
        bounds = codec.child(&bounds, &node, is_left);
        at = if is_left {
            node.left.index()
        } else {
            node.right.index()
        };
    }
    bounds
}

/// Whether a node that is below another is below that one's left child: all of these come before it, or are it.
#[inline(always)]
const fn is_below_left(target: u32, left: NodeRef) -> bool {
    !left.is_leaf() && target <= left.index()
}

/// The lattice codec with so many bits and words a node, on a lattice whose step is two to this power.
#[derive(Clone, Copy, Debug)]
pub struct LatticeCodec<const BITS: u32, const WORDS: usize> {
    /// In the scene's magnitude.
    pub step_exponent: i32,
}

impl<const BITS: u32, const WORDS: usize> LatticeCodec<BITS, WORDS> {
    /// One thread per node. Reads the plain node and its box, decoded. Returns it in the codec, yet without links.
    #[inline]
    #[must_use]
    pub fn encode(&self, bounds: &LatticeBox, node: &Node) -> EncodedNode<WORDS> {
        let boxes = node.child_boxes();
        let left = LatticeBox::around(&boxes.left, self.step_exponent);
        let right = LatticeBox::around(&boxes.right, self.step_exponent);
        encode_node::<BITS, WORDS>(bounds, &left, &right)
    }
}

impl<const BITS: u32, const WORDS: usize> BoxCodec for LatticeCodec<BITS, WORDS> {
    type Bounds = LatticeBox;

    #[inline(always)]
    fn root(&self, bounds: &Aabb) -> LatticeBox {
        LatticeBox::around(bounds, self.step_exponent)
    }

    #[inline(always)]
    fn child(&self, bounds: &LatticeBox, node: &Node, is_left: bool) -> LatticeBox {
        let encoded = self.encode(bounds, node);
        if is_left { encoded.left } else { encoded.right }
    }
}

/// The printed codec.
#[derive(Clone, Copy, Debug)]
pub struct PrintedCodec {
    /// 0, but only at run time.
    pub zero: u32,
}

impl PrintedCodec {
    /// One thread per node. Reads the plain node and its box, decoded. Returns it in the codec.
    #[inline]
    #[must_use]
    pub fn encode(&self, bounds: &PrintedBox, node: &Node) -> EncodedPrinted {
        let boxes = node.child_boxes();
        let (left, right) = (PrintedBox::of(&boxes.left), PrintedBox::of(&boxes.right));
        encode_printed_node(bounds, &left, &right, node, self.zero)
    }
}

impl BoxCodec for PrintedCodec {
    type Bounds = PrintedBox;

    #[inline(always)]
    fn root(&self, bounds: &Aabb) -> PrintedBox {
        PrintedBox::of(bounds)
    }

    /// Half of what [`Self::encode`] does.
    #[inline(always)]
    fn child(&self, bounds: &PrintedBox, node: &Node, is_left: bool) -> PrintedBox {
        let boxes = node.child_boxes();
        let child = if is_left { boxes.left } else { boxes.right };
        printed_child(bounds, &PrintedBox::of(&child), self.zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let lattice = LatticeCodec::<6, 4> { step_exponent: -20 };
        let root = root_bounds(&nodes, &lattice);
        let top = lattice.encode(&root, &nodes[0]);
        let below = lattice.encode(&top.left, &nodes[2]);
        let expected = [root, below.left, top.left, top.right];
        for (target, expected) in (0..).zip(expected) {
            assert_eq!(node_bounds(target, &nodes, &lattice), expected, "{target}");
        }
        assert!(below.left != top.left);

        let printed = PrintedCodec { zero: 0 };
        let root = root_bounds(&nodes, &printed);
        let top = printed.encode(&root, &nodes[0]);
        let below = printed.encode(&top.left, &nodes[2]);
        let expected = [root, below.left, top.left, top.right];
        for (target, expected) in (0..).zip(expected) {
            assert_eq!(node_bounds(target, &nodes, &printed), expected, "{target}");
        }
    }

    #[test]
    fn what_is_not_there_ends() {
        let lattice = LatticeCodec::<6, 4> { step_exponent: -20 };
        assert_eq!(node_bounds(7, &[], &lattice), LatticeBox::ZERO);
        let _ = node_bounds(7, &tree(), &lattice);
        assert_eq!(root_bounds(&[Node::EMPTY], &lattice), LatticeBox::ZERO);
    }
}
