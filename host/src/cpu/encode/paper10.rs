//! Nodes and triangles in the codec `paper10`.

use super::tree::{Part, Tree, both};
use slimbvh_core::NodeRef;
use slimbvh_core::encode::{
    BoxCodec, Paper10Box, Paper10Codec, Paper10Node, Paper10Triangle, encode_paper10_triangle,
};

/// Codes a tree's nodes, and its triangles if `triangles` has room for them. Returns the root's box.
pub(super) fn encode_paper10(
    tree: &Tree,
    nodes: &mut Vec<Paper10Node>,
    triangles: &mut [Paper10Triangle],
) -> Paper10Box {
    nodes.resize(tree.nodes.len(), Paper10Node::default());
    let root = CODEC.root(&tree.node(0));
    let part = Part {
        node: 0,
        bounds: root,
        nodes: nodes.as_mut_slice(),
        first_node: 0,
        triangles,
        first_triangle: 0,
        per_triangle: 1,
    };
    encode_part(tree, part);
    root
}

const CODEC: Paper10Codec = Paper10Codec { opaque_zero: 0 };

fn encode_part(tree: &Tree, part: Part<Paper10Node, Paper10Triangle, Paper10Box>) {
    let node = tree.node(part.node);
    let coded = CODEC.encode(&part.bounds, &node);
    part.nodes[part.node as usize - part.first_node] = coded.node;
    let boxes = [coded.left, coded.right];
    let parts = part.split(tree, boxes, |triangle| triangle as usize);
    both(&node, parts, |part| {
        let child = NodeRef(part.node);
        if !child.is_leaf() {
            encode_part(tree, part);
            return;
        }
        let leaves = tree.leaves.iter().skip(child.first() as usize);
        for (to, leaf) in part.triangles.iter_mut().zip(leaves) {
            *to = encode_paper10_triangle(leaf, &part.bounds, 0);
        }
    });
}
