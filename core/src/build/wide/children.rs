//! The children of a wide node and their boxes, from its binary nodes.

use super::WIDTH;
use super::collapse::Collapse;
use crate::build::cluster::joint_area;
use crate::build::node::{Node, NodeRef};
use crate::build::refit::WideBox;
use crate::geometry::aabb::Aabb;

/// What is known of a child on the way.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub struct WideChild {
    bounds: WideBox,
    /// What it is. Where there is no child, a leaf without triangles.
    pub node: NodeRef,
}

impl WideChild {
    const ABSENT: Self = Self {
        bounds: WideBox::EMPTY,
        node: NodeRef::EMPTY_LEAF,
    };

    /// A child and its box.
    #[inline(always)]
    #[must_use]
    pub fn new(node: NodeRef, bounds: Aabb) -> Self {
        Self {
            bounds: WideBox::around(bounds),
            node,
        }
    }

    /// Its box. Where there is no child, it means nothing.
    #[inline(always)]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb {
            min: self.bounds.min.truncate(),
            max: self.bounds.max.truncate(),
        }
    }
}

/// The children of a wide node, in the order of their triangles. No array: one that is chosen from others lies in a GPU's memory.
#[derive(Clone, Copy, Debug)]
pub struct WideChildren {
    first: WideChild,
    second: WideChild,
    third: WideChild,
    fourth: WideChild,
    /// How many there are: 2 to 4, or at the root of a small tree 1 or none.
    pub count: u32,
}

impl WideChildren {
    /// Children of which the first `count` are there.
    #[inline(always)]
    #[must_use]
    pub const fn new([first, second, third, fourth]: [WideChild; WIDTH], count: u32) -> Self {
        Self {
            first,
            second,
            third,
            fourth,
            count,
        }
    }

    /// All four; the first `count` are there.
    #[inline(always)]
    #[must_use]
    pub const fn children(&self) -> [WideChild; WIDTH] {
        [self.first, self.second, self.third, self.fourth]
    }

    /// The two children of a binary node, those that are there.
    #[inline(always)]
    pub(super) fn of(node: &Node) -> Self {
        let boxes = node.child_boxes();
        let left = WideChild::new(node.left, boxes.left);
        let right = WideChild::new(node.right, boxes.right);
        let is_there = |child: &WideChild| child.node.0 != NodeRef::EMPTY_LEAF.0;
        let children = [left, right, WideChild::ABSENT, WideChild::ABSENT];
        Self::new(children, is_there(&left) as u32 + is_there(&right) as u32)
    }

    /// The same with the child at a place, counted from 1, replaced by its own two.
    #[inline(always)]
    pub(super) fn opened(self, place: u32, nodes: &[Node]) -> Self {
        if place == 0 || place > self.count || self.count as usize >= WIDTH {
            return self;
        }
        let (a, b, c) = (self.first, self.second, self.third);
        let parent = match place {
            1 => a.node,
            2 => b.node,
            _ => c.node,
        };
        let node = crate::load(nodes, parent.index(), Node::EMPTY);
        let two = Self::of(&node);
        let (left, right) = (two.first, two.second);
        let count = self.count + 1;
        match place {
            1 => Self::new([left, right, b, c], count),
            2 => Self::new([a, left, right, c], count),
            _ => Self::new([a, b, left, right], count),
        }
    }

    /// The place, counted from 1, of the inner child with the largest surface, the first of equals; 0 where there is none. Of two
    /// or three children.
    #[inline(always)]
    pub(super) fn largest(&self, opaque_zero: u32) -> u32 {
        let count = self.count;
        let area = |i: u32, WideChild { node, bounds }: WideChild| {
            if i < count && !node.is_leaf() {
                joint_area(&bounds, &bounds, opaque_zero)
            } else {
                0.0
            }
        };
        let (mut place, mut most) = (0, 0.0);
        let a = area(0, self.first);
        let b = area(1, self.second);
        let c = area(2, self.third);
        if a > most {
            (place, most) = (1, a);
        }
        if b > most {
            (place, most) = (2, b);
        }
        if c > most { 3 } else { place }
    }

    /// What the children are.
    #[inline(always)]
    #[must_use]
    pub const fn nodes(&self) -> [NodeRef; WIDTH] {
        [
            self.first.node,
            self.second.node,
            self.third.node,
            self.fourth.node,
        ]
    }

    /// A bit for each inner child, the first child's lowest.
    #[inline(always)]
    pub(super) fn inner(&self) -> u32 {
        inner_bits(self.nodes(), self.count)
    }
}

/// A bit for each inner one of the first `count` children, the first child's lowest.
#[inline(always)]
const fn inner_bits([a, b, c, d]: [NodeRef; WIDTH], count: u32) -> u32 {
    let all = !a.is_leaf() as u32
        | (!b.is_leaf() as u32) << 1
        | (!c.is_leaf() as u32) << 2
        | (!d.is_leaf() as u32) << 3;
    all & ((1 << (count & 7)) - 1)
}

/// One thread per wide node. Reads the binary node that it begins at, which nodes it takes in, and those. Returns its children.
#[inline]
#[must_use]
pub fn wide_children(node: &Node, collapse: Collapse, nodes: &[Node]) -> WideChildren {
    WideChildren::of(node)
        .opened(collapse.place(0), nodes)
        .opened(collapse.place(1), nodes)
}

/// The children as a wide tree names them, the first `count` of which are there: inner ones by their places side by side from
/// `first_child` on, leaves as they are, and leaves without triangles where there is no child.
#[inline(always)]
#[must_use]
pub fn placed(nodes: [NodeRef; WIDTH], count: u32, first_child: u32) -> [NodeRef; WIDTH] {
    let inner = inner_bits(nodes, count);
    let [a, b, c, d] = nodes;
    let child = |i: u32, node: NodeRef| {
        if i >= count {
            NodeRef::EMPTY_LEAF
        } else if node.is_leaf() {
            node
        } else {
            let rank = (inner & ((1 << i) - 1)).count_ones();
            NodeRef::inner(first_child.wrapping_add(rank))
        }
    };
    [child(0, a), child(1, b), child(2, c), child(3, d)]
}
