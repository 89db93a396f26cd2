//! For any children of a wide node, decoded boxes hold the exact ones, links are decoded as they were encoded, and the traversal
//! decodes the same values as the encoder.

use super::input::{Extent, any, lattice_box};
use arbitrary::Arbitrary;
use slimbvh_core::encode::{
    LeafFrame, LeafWidth, MixedWideNode, MixedWideRow, PackedWideNode, PackedWideNodes,
    PackedWideRow, RoundedChildren, WideMixedNodes, WideNode, WideNodes, WideRow, leaf_words,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::slab::{CodedPlanes, FourPlanes};
use slimbvh_core::trace::{LeafRun, MOST_WIDE_NODES, NodeSource, Order, WideFork, WideRef};
use slimbvh_core::wide::WIDTH;
use slimbvh_core::{MAX_TRIANGLES, NodeRef};

/// The orders of axes of rays.
const ORDERS: [[u32; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

#[derive(Arbitrary, Debug)]
struct Input {
    children: [[Extent; 3]; WIDTH],
    kinds: [u8; WIDTH],
    count: u8,
    first_child: u32,
    first_word: u32,
    step: u8,
}

/// See the module.
///
/// # Panics
/// If a box or a link is wrong.
pub fn wide_codec(data: &[u8]) {
    let Some(input) = any::<Input>(data) else {
        return;
    };
    let from = RoundedChildren {
        nodes: input
            .kinds
            .map(|kind| match u32::from(kind) % (LEAF_SIZE + 1) {
                0 => NodeRef::inner(5),
                count => NodeRef::leaf(9, count),
            }),
        boxes: input.children.map(lattice_box),
        count: u32::from(input.count) % (WIDTH as u32 + 1),
        step_exponent: i32::from(input.step % 33) - 24,
    };
    let first_child = input.first_child % (MOST_WIDE_NODES - WIDTH as u32);
    let first_word = input.first_word % (MAX_TRIANGLES - 300);
    let whole = from.boxes[..from.count as usize].iter().copied();
    let root = whole.reduce(|a, b| a.union(&b)).unwrap_or(LatticeBox::ZERO);
    let step = power_of_two(from.step_exponent);

    let node = WideNode::new(&from, first_child);
    check_boxes(&from, |child| node.child_box(child, from.step_exponent));
    let rows: [WideRow; 1] = [bytemuck::cast(node)];
    let nodes = &rows;
    let source = WideNodes { nodes, root, step };
    let decoded = |child| node.child_box(child, from.step_exponent);
    check_source(&from, &source, decoded, |child| {
        node.children[child as usize]
    });

    let (coded, word_count) = WideNode::encode(&from, [0; WIDTH]);
    let coded = coded.placed(from.count, first_child, first_word);
    let rows = [MixedWideRow(bytemuck::cast(coded))];
    let nodes = &rows;
    let source = WideMixedNodes { nodes, root, step };
    check_source(&from, &source, decoded, |child| {
        named(coded.children[child as usize], child)
    });
    let words_of = |child: u32| {
        let count = from.nodes[child as usize].count();
        count * LeafWidth::of(&decoded(child)).words()
    };
    check_leaves(
        &from,
        (first_word, word_count),
        decoded,
        words_of,
        |child, axes| source.leaf(child, axes),
    );

    let corner_counts = from.nodes.map(|child| child.count() * 2 + 1);
    let (packed, word_count) = PackedWideNode::encode(&from, corner_counts);
    let packed = packed.placed(from.count, first_child, first_word);
    let links = packed.links();
    assert!(links.are_canonical(from.count), "{links:?}");
    let decoded = |child| packed.child_box(child, from.step_exponent);
    check_boxes(&from, decoded);
    let rows: [PackedWideRow; 1] = [bytemuck::cast(packed)];
    let nodes = &rows;
    let source = PackedWideNodes { nodes, root, step };
    check_source(&from, &source, decoded, |child| {
        named(links.child(child), child)
    });
    let words_of = |child: u32| {
        let count = from.nodes[child as usize].count();
        let corners = corner_counts[child as usize];
        leaf_words(count, corners, links.width().vertex_words())
    };
    check_leaves(
        &from,
        (first_word, word_count),
        decoded,
        words_of,
        |child, axes| source.leaf(child, axes),
    );
}

/// How a walk names a child whose leaves are decoded from their node.
fn named(reference: NodeRef, child: u32) -> NodeRef {
    if reference.is_leaf() {
        WideRef::new(0, child).leaf()
    } else {
        reference
    }
}

/// Decoded boxes hold the exact ones, and have their smallest corner less than a cell below.
fn check_boxes(from: &RoundedChildren, decoded: impl Fn(u32) -> LatticeBox) {
    let there = &from.boxes[..from.count as usize];
    let whole = there.iter().copied().reduce(|a, b| a.union(&b));
    for (child, exact) in (0..).zip(there) {
        let decoded = decoded(child);
        assert!(decoded.contains(exact), "{decoded:?} {exact:?}");
        for axis in 0..3 {
            let extent = whole.map_or(0, |whole| whole.max[axis] - whole.min[axis]);
            let below = exact.min[axis] - decoded.min[axis];
            // At most 256 cells, which are less than twice as large as they must be; a flat child at the end is in the last.
            assert!(i64::from(below) <= i64::from(extent) / 128 + 1);
        }
    }
}

/// The walk decodes the same planes as the encoder, and names the same children.
fn check_source<N: NodeSource<Cursor = NodeRef, Node = WideFork<CodedPlanes>>>(
    from: &RoundedChildren,
    source: &N,
    decoded: impl Fn(u32) -> LatticeBox,
    child_of: impl Fn(u32) -> NodeRef,
) {
    let step = power_of_two(from.step_exponent);
    for axes in ORDERS {
        for reversed in [[0; 3], [1; 3], [0, 1, 0]] {
            let node = source.children(source.root(axes), Order { axes, reversed });
            assert_eq!(node.count, from.count);
            for child in 0..from.count {
                assert_eq!(source.resume(WideRef::new(0, child)), child_of(child));
                let bounds = decoded(child);
                for (place, axis) in axes.into_iter().enumerate() {
                    let planes = [node.first[place], node.second[place]];
                    let planes = planes.map(|planes| planes.planes()[child as usize]);
                    let [low, high] = if reversed[place] == 1 {
                        [planes[1], planes[0]]
                    } else {
                        planes
                    };
                    let axis = axis as usize;
                    assert_eq!(low, bounds.min[axis] as f32 * step);
                    // Beyond what 24 bits hold, both are rounded, to no less than the exact plane.
                    let exact = from.boxes[child as usize].max[axis] as f32 * step;
                    assert!(high >= exact, "{high} {exact}");
                    assert!(bounds.max[axis] >= 1 << 24 || high == bounds.max[axis] as f32 * step);
                }
            }
        }
    }
}

/// The walk finds each leaf's triangles, and what they are decoded relative to. Takes the first word and how many there are, and the
/// words of a leaf.
fn check_leaves(
    from: &RoundedChildren,
    (first_word, word_count): (u32, u32),
    decoded: impl Fn(u32) -> LatticeBox,
    leaf_words: impl Fn(u32) -> u32,
    leaf: impl Fn(NodeRef, [u32; 3]) -> LeafRun<LeafFrame>,
) {
    let step = power_of_two(from.step_exponent);
    let mut word = first_word;
    for child in 0..from.count {
        let reference = from.nodes[child as usize];
        if !reference.is_leaf() {
            continue;
        }
        for axes in ORDERS {
            let run = leaf(WideRef::new(0, child).leaf(), axes);
            assert_eq!((run.first, run.count), (word, reference.count()));
            let bounds = decoded(child);
            let expected = axes.map(|axis| bounds.min[axis as usize] as f32 * step);
            assert_eq!(run.bounds.min.to_array()[..3], expected);
            // Every corner of the exact box is within reach.
            let exact = from.boxes[child as usize];
            let bits = [10, 21, 32][run.bounds.width as usize];
            for (min, max) in bounds.min.into_iter().zip(exact.max) {
                assert!(i64::from(max) - i64::from(min) < 1 << bits);
            }
        }
        word += leaf_words(child);
    }
    assert_eq!(word - first_word, word_count);
}
