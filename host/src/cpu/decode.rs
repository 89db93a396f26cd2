//! From codecs back to plain nodes and triangles.

use crate::codec::by_bits;
use crate::coded::{Coded, CodedNodes, CodedTriangles};
use slimbvh_core::encode::{
    LatticeFrame, LatticeTriangles, LeafWidth, PrintedBox, PrintedTriangles, decode_node,
    decode_printed_node, links_of,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{Place, TriangleSource};
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef, Vec3};

/// Plain nodes and triangles that say what coded ones do: boxes as they are decoded, triangles in leaf order. `full` are the
/// triangles where they are stored in full.
pub fn decode(coded: &Coded, full: &[LeafTriangle]) -> (Vec<Node>, Vec<LeafTriangle>) {
    match &coded.nodes {
        CodedNodes::Printed { root, nodes } => {
            let source = match &coded.triangles {
                CodedTriangles::Leaf10(triangles) => Some(PrintedTriangles { triangles, zero: 0 }),
                CodedTriangles::F32 | CodedTriangles::Lattice(_) => None,
            };
            let mut decoder = Decoder::new(nodes.len(), full);
            decoder.open(
                NodeRef::inner(0),
                *root,
                &mut |node, bounds| {
                    let node = &nodes[node as usize];
                    (
                        [node.left, node.right],
                        decode_printed_node(node, bounds, 0),
                    )
                },
                &box_of_printed,
                &|place, bounds| source.map(|source| leaf_triangle(&source, place, *bounds)),
            );
            decoder.finish()
        }
        CodedNodes::Lattice { bits, .. } => by_bits!(*bits, decode_lattice(coded, full)),
    }
}

fn decode_lattice<const BITS: u32, const WORDS: usize>(
    coded: &Coded,
    full: &[LeafTriangle],
) -> (Vec<Node>, Vec<LeafTriangle>) {
    let CodedNodes::Lattice {
        root,
        step_exponent,
        words,
        ..
    } = &coded.nodes
    else {
        return (Vec::new(), Vec::new());
    };
    let nodes: &[[u32; WORDS]] = bytemuck::cast_slice(words);
    let step = power_of_two(*step_exponent);
    let source = match &coded.triangles {
        CodedTriangles::Lattice(words) => Some(LatticeTriangles { words, step }),
        CodedTriangles::F32 | CodedTriangles::Leaf10(_) => None,
    };
    let mut decoder = Decoder::new(nodes.len(), full);
    decoder.open(
        NodeRef::inner(0),
        *root,
        &mut |node, bounds| {
            let words = &nodes[node as usize];
            let boxes = decode_node::<BITS, WORDS>(words, bounds);
            let links = links_of::<BITS, WORDS>(words);
            let stride = source.map_or(1, |_| LeafWidth::of(&boxes[0]).words());
            (links.children(stride), boxes)
        },
        &|bounds| box_of_lattice(bounds, step),
        &|place, bounds| {
            source.map(|source| {
                let frame = LatticeFrame::new(bounds, step, [0, 1, 2]);
                leaf_triangle(&source, place, frame)
            })
        },
    );
    decoder.finish()
}

fn box_of_printed(bounds: &PrintedBox) -> Aabb {
    Aabb {
        min: Vec3::from_array(bounds.min),
        max: Vec3::from_array(bounds.max),
    }
}

fn box_of_lattice(bounds: &LatticeBox, step: f32) -> Aabb {
    let point = |v: [i32; 3]| Vec3::from_array(v.map(|x| x as f32 * step));
    Aabb {
        min: point(bounds.min),
        max: point(bounds.max),
    }
}

/// A triangle as the traversal reads it.
fn leaf_triangle<F: Copy>(
    source: &impl TriangleSource<F>,
    (first, number): (u32, u32),
    frame: F,
) -> LeafTriangle {
    let place = Place {
        first,
        number,
        frame,
    };
    let corners = source.corners(&place, [0, 1, 2]);
    let mut vertices = [0.0; 9];
    vertices.copy_from_slice(corners.as_flattened());
    LeafTriangle {
        vertices,
        primitive: source.primitive(&place),
    }
}

/// Gathers what comes out, from the left to the right.
struct Decoder<'a> {
    full: &'a [LeafTriangle],
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
}

impl<'a> Decoder<'a> {
    fn new(node_count: usize, full: &'a [LeafTriangle]) -> Self {
        Self {
            full,
            nodes: vec![Node::EMPTY; node_count],
            triangles: Vec::new(),
        }
    }

    /// Decodes a node, or a leaf, and all below it. Returns what a parent calls it.
    fn open<B: Copy>(
        &mut self,
        node: NodeRef,
        bounds: B,
        open: &mut impl FnMut(u32, &B) -> ([NodeRef; 2], [B; 2]),
        box_of: &impl Fn(&B) -> Aabb,
        triangle: &impl Fn((u32, u32), &B) -> Option<LeafTriangle>,
    ) -> NodeRef {
        let first = self.triangles.len() as u32;
        if node.is_leaf() {
            for number in 0..node.count() {
                let place = (node.first(), number);
                let full = || self.full[(node.first() + number) as usize];
                let own = triangle(place, &bounds).unwrap_or_else(full);
                self.triangles.push(own);
            }
            return match node.count() {
                0 => NodeRef::NOTHING,
                count => NodeRef::leaf(first, count),
            };
        }
        let index = node.index() as usize;
        if index >= self.nodes.len() {
            return NodeRef::NOTHING;
        }
        let (children, boxes) = open(node.index(), &bounds);
        let left = self.open(children[0], boxes[0], open, box_of, triangle);
        let right = self.open(children[1], boxes[1], open, box_of, triangle);
        let links = Node {
            left,
            right,
            first,
            last: (self.triangles.len() as u32).saturating_sub(1),
            ..Node::EMPTY
        };
        self.nodes[index] = links.with_boxes(box_of(&boxes[0]), box_of(&boxes[1]));
        node
    }

    fn finish(self) -> (Vec<Node>, Vec<LeafTriangle>) {
        (self.nodes, self.triangles)
    }
}
