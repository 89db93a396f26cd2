//! Decoding: from a codec to nodes of two children and triangles in full.
//!
//! A node of more children becomes several of two, with the children in order, and split where the tree below them is the lowest: no
//! higher than the binary tree that it was collapsed from.

use super::plain::PlainTree;
use super::sources::{LeafPlace, NodeOrder, StoredNodes, StoredTriangles};
use super::stored::StoredTree;
use super::visitor::TreeVisitor;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef};

impl StoredTree {
    /// The same tree in full: decoded boxes, triangles in leaf order.
    pub fn decode(&self) -> PlainTree {
        self.visit(Decode)
    }
}

struct Decode;

impl TreeVisitor for Decode {
    type Output = PlainTree;

    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) -> PlainTree {
        let mut decoder = Decoder {
            from: (nodes, triangles),
            sizes: Vec::new(),
            nodes: Vec::new(),
            triangles: Vec::new(),
        };
        let node_count = match N::ORDER {
            NodeOrder::Triangles => nodes.count(),
            NodeOrder::Runs => {
                decoder.sizes.resize(nodes.count(), BinarySize::default());
                let root = decoder.measure(0, &nodes.root_box());
                (root.nodes as usize).max(nodes.count().min(1))
            }
        };
        decoder.nodes.resize(node_count, Node::EMPTY);
        if node_count > 0 {
            let places = Places {
                own: 0,
                below: 1,
                end: node_count as u32,
            };
            decoder.open(NodeRef::inner(0), &nodes.root_box(), places);
        }
        PlainTree {
            nodes: decoder.nodes,
            triangles: decoder.triangles,
        }
    }
}

/// A tree of nodes with two children.
#[derive(Clone, Copy, Debug, Default)]
pub struct BinarySize {
    /// The number of its nodes.
    nodes: u32,
    /// The most of them along a path.
    pub height: u32,
    /// The number of its triangles.
    triangles: u32,
}

impl BinarySize {
    /// A leaf with this many triangles.
    pub const fn leaf(triangles: u32) -> Self {
        Self {
            nodes: 0,
            height: 0,
            triangles,
        }
    }

    /// A node over two trees; `None` if it has so few triangles that it must be a leaf.
    fn over(self, other: Self) -> Option<Self> {
        let triangles = self.triangles.saturating_add(other.triangles);
        (triangles > LEAF_SIZE).then_some(Self {
            nodes: self.nodes + other.nodes + 1,
            height: self.height.max(other.height) + 1,
            triangles,
        })
    }

    /// The lowest tree over several, in order; of as low ones, the first. Returns how many of them are on its left, too. `None` if
    /// there is no tree without nodes that must be leaves.
    pub fn lowest(of: &[Self]) -> Option<(Self, usize)> {
        match of {
            [] => Some((Self::default(), 0)),
            [one] => Some((*one, 1)),
            _ => {
                let split = |left| {
                    let (a, b) = of.split_at(left);
                    let (a, b) = (Self::lowest(a)?.0, Self::lowest(b)?.0);
                    Some((a.over(b)?, left))
                };
                let splits = (1..of.len()).filter_map(split);
                splits.min_by_key(|(size, _)| size.height)
            }
        }
    }
}

/// Where a decoded node and all below it lie.
#[derive(Clone, Copy)]
struct Places {
    own: u32,
    /// The first of those below.
    below: u32,
    /// The end of those below.
    end: u32,
}

impl Places {
    /// Those of two children of which the left one is, or begins, this many nodes; 0 if it is a leaf. In the order of triangles.
    const fn split(self, left: u32) -> [Self; 2] {
        let middle = self.below + left;
        let left = Self {
            own: middle.wrapping_sub(1),
            below: self.below,
            end: middle.wrapping_sub(1),
        };
        let right = Self {
            own: middle,
            below: middle.wrapping_add(1),
            end: self.end,
        };
        [left, right]
    }
}

/// The lowest tree over several. A valid tree has one.
fn lowest(of: &[BinarySize]) -> (BinarySize, usize) {
    BinarySize::lowest(of).unwrap_or((BinarySize::default(), 1))
}

/// Collects decoded nodes and triangles from left to right.
struct Decoder<'a, N, T> {
    from: (&'a N, &'a T),
    /// What each node of more than two children becomes.
    sizes: Vec<BinarySize>,
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
}

impl<N: StoredNodes, T: StoredTriangles<N>> Decoder<'_, N, T> {
    /// What becomes of a node and all below it.
    fn measure(&mut self, node: u32, bounds: &N::Box) -> BinarySize {
        if node as usize >= self.sizes.len() {
            return BinarySize::default();
        }
        let opened = self.from.0.open(node, bounds);
        let mut below = [BinarySize::default(); 4];
        for ((child, bounds), size) in opened.children().iter().zip(&mut below) {
            *size = if child.is_leaf() {
                BinarySize::leaf(child.count())
            } else {
                self.measure(child.index(), bounds)
            };
        }
        let (size, _) = lowest(&below[..opened.count]);
        // A root of one leaf is a node, too.
        self.sizes[node as usize] = size;
        size
    }

    fn size_of(&self, child: NodeRef) -> BinarySize {
        if child.is_leaf() {
            return BinarySize::leaf(child.count());
        }
        let size = self.sizes.get(child.index() as usize);
        size.copied().unwrap_or_default()
    }

    /// Decodes a node or a leaf, and everything below it. Returns the parent's link to it.
    fn open(&mut self, node: NodeRef, bounds: &N::Box, places: Places) -> NodeRef {
        let (nodes, triangles) = self.from;
        if node.is_leaf() {
            let first = self.triangles.len() as u32;
            let triangles = LeafPlace::all(node).map(|at| triangles.triangle(at, bounds));
            self.triangles.extend(triangles);
            return match node.count() {
                0 => NodeRef::EMPTY_LEAF,
                count => NodeRef::leaf(first, count),
            };
        }
        if node.index() as usize >= nodes.count() {
            return NodeRef::EMPTY_LEAF;
        }
        let opened = nodes.open(node.index(), bounds);
        self.pair(opened.children(), places)
    }

    /// Decodes children, as one node with two.
    fn pair(&mut self, children: &[(NodeRef, N::Box)], places: Places) -> NodeRef {
        let first = self.triangles.len() as u32;
        let mut sizes = [BinarySize::default(); 4];
        let left_count = match N::ORDER {
            NodeOrder::Triangles => 1,
            NodeOrder::Runs => {
                for ((child, _), size) in children.iter().zip(&mut sizes) {
                    *size = self.size_of(*child);
                }
                lowest(&sizes[..children.len()]).1
            }
        };
        let (left, right) = children.split_at(left_count.min(children.len()));
        let parts = match N::ORDER {
            NodeOrder::Triangles => {
                let own = |part: &[(NodeRef, N::Box)]| Places {
                    own: part.first().map_or(0, |(child, _)| child.index()),
                    ..places
                };
                [own(left), own(right)]
            }
            NodeOrder::Runs => places.split(lowest(&sizes[..left.len()]).0.nodes),
        };
        let left = self.half(left, parts[0]);
        let right = self.half(right, parts[1]);
        let links = Node {
            left: left.0,
            right: right.0,
            first,
            last: (self.triangles.len() as u32).saturating_sub(1),
            ..Node::EMPTY
        };
        if let Some(node) = self.nodes.get_mut(places.own as usize) {
            *node = links.with_boxes(left.1, right.1);
        }
        NodeRef::inner(places.own)
    }

    /// Decodes some children, as one child. Returns the link to it, and its box.
    fn half(&mut self, children: &[(NodeRef, N::Box)], places: Places) -> (NodeRef, Aabb) {
        let nodes = self.from.0;
        let bounds = children
            .iter()
            .map(|(_, bounds)| nodes.aabb(bounds))
            .reduce(Aabb::union);
        let node = match children {
            [] => NodeRef::EMPTY_LEAF,
            [(child, bounds)] => self.open(*child, bounds, places),
            _ => self.pair(children, places),
        };
        (node, bounds.unwrap_or(Node::EMPTY.left_box()))
    }
}
