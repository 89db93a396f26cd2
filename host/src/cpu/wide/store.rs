//! How each store encodes a wide node: first all but its place, then the node.

use super::super::encode::Leaf;
use super::{Corners, Triangles, leaves_of};
use bytemuck::Pod;
use slimbvh_core::NodeRef;
use slimbvh_core::encode::{
    FullWideNode, LeafWidth, MixedWideNode, RoundedChildren, WideNode, corner_count, corner_counts,
    leaf_words, store_shared_leaf,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::trace::child_count;
use slimbvh_core::wide::{WIDTH, WideChildren, placed};
use std::marker::PhantomData;

/// A way to store wide nodes.
pub(super) trait Store {
    /// A node.
    type Node: Pod + Send + Sync + Default;

    /// A node without its place.
    type Item: Copy + Send + Sync + Default;

    /// Whether triangles lie on the lattice: a number of words.
    const MIXED: bool;

    /// Whether corners that a leaf's triangles share are stored once, so that they must be numbered.
    const SHARES_CORNERS: bool = false;

    /// A node with these children, and this first and last triangle, on a lattice whose step is two to this power.
    fn item(
        children: &WideChildren,
        run: [u32; 2],
        corners: Corners,
        step_exponent: i32,
    ) -> Self::Item;

    /// The node whose inner children begin at this place, and the words of its leaves' triangles at this one.
    fn place(item: &Self::Item, at: [u32; 2]) -> Self::Node;

    /// The words of the triangles in an item's leaves.
    fn word_count(_item: &Self::Item) -> u32 {
        0
    }

    /// The same of a node with these children, if all corners have this width.
    fn words_of(_children: &WideChildren, _corners: Corners, _width: LeafWidth) -> u32 {
        0
    }

    /// Stores these words. Returns the widths of its leaves' corners, a bit each.
    fn put_leaves(
        _item: &Self::Item,
        _triangles: &Triangles,
        _corners: Corners,
        _words: &mut [u32],
    ) -> u32 {
        0
    }
}

/// 128 bytes.
pub(super) struct Full;

impl Store for Full {
    type Node = FullWideNode;
    type Item = FullWideNode;

    const MIXED: bool = false;

    #[inline(always)]
    fn item(children: &WideChildren, run: [u32; 2], _: Corners, _: i32) -> FullWideNode {
        FullWideNode {
            children: children.nodes(),
            ..FullWideNode::new(children, run, 0)
        }
    }

    #[inline(always)]
    fn place(item: &FullWideNode, [first_child, _]: [u32; 2]) -> FullWideNode {
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
    fn item(children: &WideChildren, _: [u32; 2], _: Corners, step_exponent: i32) -> WideNode {
        let rounded = RoundedChildren::new(children, step_exponent);
        WideNode {
            children: rounded.nodes,
            ..WideNode::new(&rounded, 0)
        }
    }

    #[inline(always)]
    fn place(item: &WideNode, [first_child, _]: [u32; 2]) -> WideNode {
        WideNode {
            children: placed(item.children, count_of(item.children), first_child),
            ..*item
        }
    }
}

/// How many children are there.
fn count_of(children: [NodeRef; WIDTH]) -> u32 {
    child_count(children.map(|child| child.0))
}

/// A node over triangles on the lattice, whose children begin at 0.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct MixedItem<N> {
    node: N,
    /// Its children in the tree that it comes from, leaves by their triangles.
    children: [NodeRef; WIDTH],
    count: u32,
    word_count: u32,
}

impl<N> MixedItem<N> {
    /// The leaves, with their numbers among the children.
    fn leaves(&self) -> impl Iterator<Item = (u32, NodeRef)> {
        let there = (0..self.count).zip(self.children);
        there.filter(|(_, child)| child.is_leaf() && child.count() > 0)
    }
}

/// Nodes over triangles on the lattice.
pub(super) struct Mixed<N>(PhantomData<N>);

impl<N: MixedWideNode + Pod + Send + Sync + Default> Store for Mixed<N> {
    type Node = N;
    type Item = MixedItem<N>;

    const MIXED: bool = true;
    const SHARES_CORNERS: bool = N::SHARES_CORNERS;

    #[inline(always)]
    fn item(
        children: &WideChildren,
        _: [u32; 2],
        corners: Corners,
        step_exponent: i32,
    ) -> MixedItem<N> {
        let rounded = RoundedChildren::new(children, step_exponent);
        let mut counts = [0; WIDTH];
        if N::SHARES_CORNERS {
            counts = corner_counts(children.nodes(), corners.first, corners.list);
        }
        let (node, word_count) = N::encode(&rounded, counts);
        MixedItem {
            node,
            children: rounded.nodes,
            count: rounded.count,
            word_count,
        }
    }

    #[inline(always)]
    fn place(item: &MixedItem<N>, [first_child, first_word]: [u32; 2]) -> N {
        item.node.placed(item.count, first_child, first_word)
    }

    #[inline(always)]
    fn word_count(item: &MixedItem<N>) -> u32 {
        item.word_count
    }

    #[inline(always)]
    fn words_of(children: &WideChildren, corners: Corners, width: LeafWidth) -> u32 {
        let words = leaves_of(children.nodes()).map(|leaf| {
            let count = leaf.count();
            if N::SHARES_CORNERS {
                let distinct = corner_count(0, count, corners.of(leaf));
                leaf_words(count, distinct, width.vertex_words())
            } else {
                count * width.words()
            }
        });
        words.sum()
    }

    #[inline(always)]
    fn put_leaves(
        item: &MixedItem<N>,
        triangles: &Triangles,
        corners: Corners,
        words: &mut [u32],
    ) -> u32 {
        let mut widths = 0;
        let step_exponent = triangles.step_exponent;
        let step = power_of_two(step_exponent);
        for (number, leaf) in item.leaves() {
            let corner = item.node.corner(number, step_exponent);
            widths |= 1 << corner.width() as u32;
            let (own, first) = (triangles.of(leaf), item.node.first_word(number));
            if N::SHARES_CORNERS {
                store_shared_leaf(own, corners.of(leaf), &corner, step, first, words);
            } else {
                let first = first as usize;
                let end = first + own.len() * corner.words as usize;
                let leaf = Leaf {
                    triangles: own,
                    corner,
                    step,
                };
                leaf.put(&mut words[first..end]);
            }
        }
        widths
    }
}
