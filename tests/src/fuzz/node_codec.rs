//! For any node in any parent, decoded boxes hold the exact ones and lie in their parent's box, links are decoded as they
//! were encoded, and the traversal decodes the same values as the encoder.

use super::input::{Extent, any, below_one, between, lattice_box};
use arbitrary::Arbitrary;
use slimbvh_core::encode::{
    LatticeBounds, LatticeNodes, LeafWidth, Links, Paper10Box, Paper10Nodes, RoundedNode,
    decode_node, decode_paper10_node, encode_child, encode_node, encode_paper10_node, links_of,
    node_words, paper10_child, with_links,
};
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::trace::{NodeSource, Order};
use slimbvh_core::{MAX_TRIANGLES, Node, NodeRef};

/// The orders of axes of rays.
const ORDERS: [[u32; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

#[derive(Arbitrary, Debug)]
struct Input {
    parent: [Extent; 3],
    children: [[[u32; 2]; 3]; 2],
    index: u32,
    first: u32,
    counts: [u8; 2],
    step: u8,
}

/// See the module.
///
/// # Panics
/// If a box or a link is wrong.
pub fn node_codec(data: &[u8]) {
    let Some(input) = any::<Input>(data) else {
        return;
    };
    let parent = lattice_box(input.parent);
    let children = input.children.map(|axes| inside(&parent, axes));
    let links = links(&input);
    let step = 2f32.powi(i32::from(input.step % 33) - 24);
    on_lattice::<4, 3>(&parent, &children, links, step);
    on_lattice::<6, 4>(&parent, &children, links, step);
    on_lattice::<8, 4>(&parent, &children, links, step);
    on_lattice::<10, 4>(&parent, &children, links, step);
    on_lattice::<12, 5>(&parent, &children, links, step);
    on_lattice::<16, 7>(&parent, &children, links, step);
    on_lattice::<21, 7>(&parent, &children, links, step);
    as_paper10(&input, links);
}

fn inside(parent: &LatticeBox, axes: [[u32; 2]; 3]) -> LatticeBox {
    let mut bounds = *parent;
    for (axis, choices) in axes.into_iter().enumerate() {
        let plane = |choice| between(parent.min[axis], parent.max[axis], choice);
        let [a, b] = choices.map(plane);
        (bounds.min[axis], bounds.max[axis]) = (a.min(b), a.max(b));
    }
    bounds
}

/// Children as in a tree: inner nodes side by side, leaves in a run.
fn links(input: &Input) -> [NodeRef; 2] {
    let [left, right] = input.counts.map(|count| u32::from(count) % (LEAF_SIZE + 1));
    let index = input.index % (MAX_TRIANGLES - 1);
    let first = input.first % (MAX_TRIANGLES - 2 * LEAF_SIZE);
    let left_child = match left {
        0 => NodeRef::inner(index),
        count => NodeRef::leaf(first, count),
    };
    let right_child = match right {
        0 => NodeRef::inner(index + u32::from(left == 0)),
        count => NodeRef::leaf(first + left, count),
    };
    [left_child, right_child]
}

fn on_lattice<const BITS: u32, const WORDS: usize>(
    parent: &LatticeBox,
    [left, right]: &[LatticeBox; 2],
    children: [NodeRef; 2],
    step: f32,
) {
    assert_eq!(WORDS, node_words(BITS));
    let rounded = RoundedNode {
        planes: [0, 1, 2].map(|i| [left.min[i], right.min[i], left.max[i], right.max[i]]),
        ..RoundedNode::EMPTY
    };
    let node = encode_node::<BITS, WORDS>(parent, &rounded);
    for (decoded, exact) in [(&node.left, left), (&node.right, right)] {
        assert!(decoded.contains(exact), "{BITS} {decoded:?} {exact:?}");
        assert!(parent.contains(decoded), "{BITS} {parent:?} {decoded:?}");
        for axis in 0..3 {
            // The plane moves at most one step of the number, unless it is the parent's plane.
            let extent = i64::from(parent.max[axis]) - i64::from(parent.min[axis]);
            let step = (extent >> (BITS - 1)).max(1);
            let is_near = |d: i32, e: i32, side: i32| d == side || i64::from(d.abs_diff(e)) < step;
            assert!(is_near(
                decoded.min[axis],
                exact.min[axis],
                parent.min[axis]
            ));
            assert!(is_near(
                decoded.max[axis],
                exact.max[axis],
                parent.max[axis]
            ));
        }
    }
    assert_eq!(encode_child::<BITS>(parent, &rounded, true), node.left);
    assert_eq!(encode_child::<BITS>(parent, &rounded, false), node.right);

    // Links and boxes do not overwrite each other.
    let [a, b] = children;
    let links = Links::new(a, b, Links::first_triangle(a, b));
    let words = with_links::<BITS, WORDS>(node.words, links);
    assert_eq!(links_of::<BITS, WORDS>(&words), links);
    assert_eq!(links.children(1), children);
    let decoded = decode_node::<BITS, WORDS>(&words, parent);
    assert_eq!(decoded, [node.left, node.right]);

    // The traversal decodes in floats.
    let nodes = [words];
    let plain = LatticeNodes::<BITS, WORDS, false> {
        nodes: &nodes,
        root: *parent,
        step,
    };
    let mixed = LatticeNodes::<BITS, WORDS, true> {
        nodes: &nodes,
        root: *parent,
        step,
    };
    let stride = LeafWidth::of(&node.left).words();
    for axes in ORDERS {
        let frames = decoded.map(|bounds| LatticeBounds::new(&bounds, step, axes));
        let seen = plain.children(plain.root(axes), Order::of(axes));
        assert_eq!([seen.left.bounds, seen.right.bounds], frames, "{BITS}");
        assert_eq!([seen.left.node, seen.right.node], children);
        let seen = mixed.children(mixed.root(axes), Order::of(axes));
        assert_eq!([seen.left.bounds, seen.right.bounds], frames, "{BITS}");
        assert_eq!([seen.left.node, seen.right.node], links.children(stride));
    }
}

fn as_paper10(input: &Input, [left_child, right_child]: [NodeRef; 2]) {
    let axis_of = |[a, b]: [u32; 2]| {
        let (a, b) = (below_one(a), below_one(b));
        [a.min(b), a.max(b)]
    };
    let box_of = |axes: [[f32; 2]; 3]| Paper10Box {
        min: axes.map(|[low, _]| low),
        max: axes.map(|[_, high]| high),
    };
    let exact = input.children.map(|axes| box_of(axes.map(axis_of)));
    let mut parent = box_of(input.parent.map(|(a, b, _)| axis_of([a as u32, b])));
    for child in &exact {
        for axis in 0..3 {
            parent.min[axis] = parent.min[axis].min(child.min[axis]);
            parent.max[axis] = parent.max[axis].max(child.max[axis]);
        }
    }
    let plain = Node {
        left: left_child,
        right: right_child,
        ..Node::EMPTY
    };
    let coded = encode_paper10_node(&parent, &exact[0], &exact[1], &plain, 0);
    assert_eq!(
        [coded.node.left, coded.node.right],
        [left_child, right_child]
    );
    let decoded = [coded.left, coded.right];
    assert_eq!(decode_paper10_node(&coded.node, &parent, 0), decoded);
    for (decoded, exact) in decoded.iter().zip(&exact) {
        assert_eq!(paper10_child(&parent, exact, 0), *decoded);
        for axis in 0..3 {
            let [low, high] = [parent.min[axis], parent.max[axis]];
            let [below, above] = [decoded.min[axis], decoded.max[axis]];
            assert!(low <= below && above <= high, "{parent:?} {decoded:?}");
            assert!(
                below <= exact.min[axis] && exact.max[axis] <= above,
                "{decoded:?} {exact:?}"
            );
            let cell = cell(low, high);
            assert!(f64::from(exact.min[axis]) - f64::from(below) <= cell);
            assert!(f64::from(above) - f64::from(exact.max[axis]) <= cell);
        }
    }
    let nodes = [coded.node];
    let source = Paper10Nodes {
        nodes: &nodes,
        root: parent,
        opaque_zero: 0,
    };
    for axes in ORDERS {
        let order = |v: [f32; 3]| axes.map(|axis| v[axis as usize]);
        let ordered = decoded.map(|bounds| Paper10Box {
            min: order(bounds.min),
            max: order(bounds.max),
        });
        let seen = source.children(source.root(axes), Order::of(axes));
        assert_eq!([seen.left.bounds, seen.right.bounds], ordered);
        assert_eq!([seen.left.node, seen.right.node], [left_child, right_child]);
    }
}

/// The size of a cell, plus the rounding of its ends.
fn cell(low: f32, high: f32) -> f64 {
    let largest = f64::from(low.abs().max(high.abs()));
    (f64::from(high) - f64::from(low)) / 1023.0 * 1.001 + 4.0 * largest * 2f64.powi(-24) + 1e-37
}
