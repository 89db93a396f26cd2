//! Decoding: from a codec to nodes and triangles in full.

use super::plain::PlainTree;
use super::sources::{StoredNodes, StoredTriangles};
use super::stored::StoredTree;
use super::visitor::TreeVisitor;
use slimbvh_core::{LeafTriangle, Node, NodeRef};

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
            nodes: vec![Node::EMPTY; nodes.count()],
            triangles: Vec::new(),
        };
        decoder.open(NodeRef::inner(0), &nodes.root_box());
        PlainTree {
            nodes: decoder.nodes,
            triangles: decoder.triangles,
        }
    }
}

/// Collects decoded nodes and triangles from left to right.
struct Decoder<'a, N, T> {
    from: (&'a N, &'a T),
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
}

impl<N: StoredNodes, T: StoredTriangles<N>> Decoder<'_, N, T> {
    /// Decodes a node or a leaf, and everything below it. Returns the parent's link to it.
    fn open(&mut self, node: NodeRef, bounds: &N::Box) -> NodeRef {
        let (nodes, triangles) = self.from;
        let first = self.triangles.len() as u32;
        if node.is_leaf() {
            let places = (0..node.count()).map(|number| (node.first(), number));
            let triangles = places.map(|place| triangles.triangle(place, bounds));
            self.triangles.extend(triangles);
            return match node.count() {
                0 => NodeRef::EMPTY_LEAF,
                count => NodeRef::leaf(first, count),
            };
        }
        let index = node.index() as usize;
        if index >= self.nodes.len() {
            return NodeRef::EMPTY_LEAF;
        }
        let (children, boxes) = nodes.open(node.index(), bounds);
        let left = self.open(children[0], &boxes[0]);
        let right = self.open(children[1], &boxes[1]);
        let links = Node {
            left,
            right,
            first,
            last: (self.triangles.len() as u32).saturating_sub(1),
            ..Node::EMPTY
        };
        self.nodes[index] = links.with_boxes(nodes.aabb(&boxes[0]), nodes.aabb(&boxes[1]));
        node
    }
}
