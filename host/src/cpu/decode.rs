//! From codecs back to plain nodes and triangles.

use crate::bvh::view::{TreeView, Visit, show_coded};
use crate::coded::Coded;
use slimbvh_core::{LeafTriangle, Node, NodeRef};

/// Plain nodes and triangles that say what coded ones do: boxes as they are decoded, triangles in leaf order. `full` are the
/// triangles where they are stored in full.
pub fn decode(coded: &Coded, full: &[LeafTriangle]) -> (Vec<Node>, Vec<LeafTriangle>) {
    let mut decoder = Decoder::default();
    show_coded(coded, full, &mut decoder);
    (decoder.nodes, decoder.triangles)
}

/// Gathers what comes out, from the left to the right.
#[derive(Default)]
struct Decoder {
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
}

impl Visit for Decoder {
    fn visit<V: TreeView>(&mut self, view: &V) {
        self.nodes = vec![Node::EMPTY; view.node_count()];
        self.open(view, NodeRef::inner(0), &view.root());
    }
}

impl Decoder {
    /// Decodes a node, or a leaf, and all below it. Returns what a parent calls it.
    fn open<V: TreeView>(&mut self, view: &V, node: NodeRef, bounds: &V::Box) -> NodeRef {
        let first = self.triangles.len() as u32;
        if node.is_leaf() {
            let places = (0..node.count()).map(|number| (node.first(), number));
            let triangles = places.map(|place| view.triangle(place, bounds));
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
        let (children, boxes) = view.open(node.index(), bounds);
        let left = self.open(view, children[0], &boxes[0]);
        let right = self.open(view, children[1], &boxes[1]);
        let links = Node {
            left,
            right,
            first,
            last: (self.triangles.len() as u32).saturating_sub(1),
            ..Node::EMPTY
        };
        self.nodes[index] = links.with_boxes(view.aabb(&boxes[0]), view.aabb(&boxes[1]));
        node
    }
}
