//! How each store encodes a wide node: first all but its place, then the node.

use super::count_of;
use bytemuck::Pod;
use slimbvh_core::NodeRef;
use slimbvh_core::encode::{
    FullWideNode, LeafWidth, PackedWideNode, RoundedChildren, WideLinks, WideNode,
};
use slimbvh_core::wide::{WIDTH, WideChildren, placed};

/// A way to store wide nodes.
pub(super) trait Store {
    /// A node.
    type Node: Pod + Send + Sync + Default;

    /// A node without its place: children are named as in the tree that it comes from, leaves by their triangles.
    type Item: Copy + Send + Sync + Default;

    /// Whether triangles lie on the lattice: a number of words.
    const MIXED: bool;

    /// A node with these children, and this first and last triangle, on a lattice whose step is two to this power.
    fn item(children: &WideChildren, run: [u32; 2], step_exponent: i32) -> Self::Item;

    /// The children of an item, those that are not there last: leaves without triangles.
    fn children(item: &Self::Item) -> [NodeRef; WIDTH];

    /// The node whose inner children begin at this place, and the words of its leaves' triangles at this one. Takes [`Self::links`].
    fn place(item: &Self::Item, at: [u32; 2], links: WideLinks) -> Self::Node;

    /// What children of an item are, if triangles lie on the lattice.
    fn links(_item: &Self::Item, _step_exponent: i32) -> WideLinks {
        WideLinks::default()
    }

    /// The smallest corners of the children's boxes, decoded.
    fn corners(_item: &Self::Item, _step_exponent: i32) -> [[i32; 3]; WIDTH] {
        [[0; 3]; WIDTH]
    }
}

/// How the words of triangles on the lattice are counted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Widths {
    /// The width of all of them, as far as is known.
    pub(super) common: Option<LeafWidth>,
    /// The lattice's step is two to this power.
    pub(super) step_exponent: i32,
}

/// The words of the triangles in the leaves of a wide node with these children.
#[inline(always)]
pub(super) fn word_count<S: Store>(children: &WideChildren, widths: Widths) -> u32 {
    match widths.common {
        Some(width) => {
            let leaves = children.nodes().into_iter().filter(|child| child.is_leaf());
            width.words() * leaves.map(NodeRef::count).sum::<u32>()
        }
        None => {
            let item = S::item(children, [0; 2], widths.step_exponent);
            S::links(&item, widths.step_exponent).word_count()
        }
    }
}

/// 128 bytes.
pub(super) struct Full;

impl Store for Full {
    type Node = FullWideNode;
    type Item = FullWideNode;

    const MIXED: bool = false;

    #[inline(always)]
    fn item(children: &WideChildren, run: [u32; 2], _: i32) -> FullWideNode {
        FullWideNode {
            children: children.nodes(),
            ..FullWideNode::new(children, run, 0)
        }
    }

    #[inline(always)]
    fn children(item: &FullWideNode) -> [NodeRef; WIDTH] {
        item.children
    }

    #[inline(always)]
    fn place(item: &FullWideNode, [first_child, _]: [u32; 2], _: WideLinks) -> FullWideNode {
        FullWideNode {
            children: placed(item.children, count_of(item.children), first_child),
            ..*item
        }
    }
}

/// 64 bytes, triangles in full.
pub(super) struct Exact;

impl Store for Exact {
    type Node = WideNode;
    type Item = WideNode;

    const MIXED: bool = false;

    #[inline(always)]
    fn item(children: &WideChildren, _: [u32; 2], step_exponent: i32) -> WideNode {
        let rounded = RoundedChildren::new(children, step_exponent);
        WideNode {
            children: rounded.nodes,
            ..WideNode::new(&rounded, 0)
        }
    }

    #[inline(always)]
    fn children(item: &WideNode) -> [NodeRef; WIDTH] {
        item.children
    }

    #[inline(always)]
    fn place(item: &WideNode, [first_child, _]: [u32; 2], _: WideLinks) -> WideNode {
        WideNode {
            children: placed(item.children, count_of(item.children), first_child),
            ..*item
        }
    }
}

/// 64 bytes, triangles on the lattice.
pub(super) struct Mixed;

impl Store for Mixed {
    type Node = WideNode;
    type Item = WideNode;

    const MIXED: bool = true;

    #[inline(always)]
    fn item(children: &WideChildren, run: [u32; 2], step_exponent: i32) -> WideNode {
        Exact::item(children, run, step_exponent)
    }

    #[inline(always)]
    fn children(item: &WideNode) -> [NodeRef; WIDTH] {
        item.children
    }

    #[inline(always)]
    fn place(item: &WideNode, [child, word]: [u32; 2], links: WideLinks) -> WideNode {
        item.linked(links.at(child, word))
    }

    #[inline(always)]
    fn links(item: &WideNode, step_exponent: i32) -> WideLinks {
        item.links_of(item.children, count_of(item.children), step_exponent)
    }

    #[inline(always)]
    fn corners(item: &WideNode, step_exponent: i32) -> [[i32; 3]; WIDTH] {
        [0, 1, 2, 3].map(|child| item.child_box(child, step_exponent).min)
    }
}

/// 48 bytes. An item holds the node's axes, with links, and the children beside them.
pub(super) struct Packed;

impl Packed {
    const fn node(item: &WideNode) -> PackedWideNode {
        PackedWideNode { axes: item.axes }
    }
}

impl Store for Packed {
    type Node = PackedWideNode;
    type Item = WideNode;

    const MIXED: bool = true;

    #[inline(always)]
    fn item(children: &WideChildren, _: [u32; 2], step_exponent: i32) -> WideNode {
        let rounded = RoundedChildren::new(children, step_exponent);
        WideNode {
            axes: PackedWideNode::new(&rounded).axes,
            children: rounded.nodes,
        }
    }

    #[inline(always)]
    fn children(item: &WideNode) -> [NodeRef; WIDTH] {
        item.children
    }

    #[inline(always)]
    fn place(item: &WideNode, [child, word]: [u32; 2], links: WideLinks) -> PackedWideNode {
        Self::node(item).linked(links.at(child, word))
    }

    #[inline(always)]
    fn links(item: &WideNode, _: i32) -> WideLinks {
        Self::node(item).links()
    }

    #[inline(always)]
    fn corners(item: &WideNode, step_exponent: i32) -> [[i32; 3]; WIDTH] {
        let node = Self::node(item);
        [0, 1, 2, 3].map(|child| node.child_box(child, step_exponent).min)
    }
}
