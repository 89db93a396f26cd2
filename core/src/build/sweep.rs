//! Stages `topology` and `refit` in one reading, for a thread that has a run of leaves to itself: the nodes that
//! [`internal_node`](super::topology::internal_node) and [`refit_node`](super::refit::refit_node) find one by one, bit for
//! bit.
//!
//! Neighbouring leaves' common prefixes make a Cartesian tree (Vuillemin 1980). A stack holds the subtrees whose parents are
//! still open. After each leaf, subtrees that share more with their left than with their right neighbour are joined, and
//! their boxes with them. So each triangle is read once, no node is searched for, and no pyramid of boxes is needed.

use crate::build::node::{LEAF_SIZE, Node, NodeRef};
use crate::build::refit::WideBox;
use crate::build::topology::SortedCodes;
use crate::geometry::aabb::Aabb;
use crate::geometry::triangle::LeafTriangle;

/// Subtrees that wait, at most. Their prefixes grow from the bottom up: from −1 to fewer than 63 + 32.
const STACK_SIZE: usize = 96;

/// What is below a node's child: a node or a leaf, and its box.
#[derive(Clone, Copy, Debug)]
pub struct Subtree {
    /// The node, or the leaf.
    pub child: NodeRef,
    bounds: WideBox,
}

impl Subtree {
    const NOTHING: Self = Self {
        child: NodeRef::EMPTY_LEAF,
        bounds: WideBox::EMPTY,
    };

    /// The node over two subtrees, whose triangles are `first..=last`.
    #[inline]
    #[must_use]
    pub fn node(left: &Self, right: &Self, first: u32, last: u32) -> Node {
        let node = Node {
            left: left.child,
            right: right.child,
            first,
            last,
            ..Node::EMPTY
        };
        node.with_boxes(left.aabb(), right.aabb())
    }

    /// Two subtrees below one child.
    #[inline]
    #[must_use]
    pub fn joined(child: NodeRef, left: &Self, right: &Self) -> Self {
        Self {
            child,
            bounds: left.bounds.union(right.bounds),
        }
    }

    #[inline]
    fn aabb(&self) -> Aabb {
        Aabb {
            min: self.bounds.min.truncate(),
            max: self.bounds.max.truncate(),
        }
    }
}

/// A subtree whose parent is open.
#[derive(Clone, Copy)]
struct Open {
    tree: Subtree,
    first: u32,
    /// δ(first − 1, first).
    before: i32,
}

/// Reads the codes and the triangles of the leaves `first..=last`, which are those of one node or of fewer than
/// [`LEAF_SIZE`] + 1 triangles below one. Stores each node that is kept: `place` returns the index of a node by the number that it has
/// among all nodes of the radix tree. Returns what is below the parent.
#[inline]
pub fn sweep<C: SortedCodes>(
    [first, last]: [u32; 2],
    codes: &C,
    triangles: &[LeafTriangle],
    place: impl Fn(u32) -> u32,
    mut store: impl FnMut(u32, Node),
) -> Subtree {
    let mut stack = [Open {
        tree: Subtree::NOTHING,
        first,
        before: -1,
    }; STACK_SIZE];
    let mut open_count = 0;
    let mut before = prefix_after(codes, first.wrapping_sub(1));
    let mut current = stack[0];
    for i in first..=last {
        let after = prefix_after(codes, i);
        let leaf = Subtree {
            child: NodeRef::leaf(i, 1),
            bounds: WideBox::of_triangle(i, triangles),
        };
        current = Open {
            tree: leaf,
            first: i,
            before,
        };
        before = after;
        // The two prefixes are never equal: a bit changes from 0 to 1 only once.
        while current.before > after && open_count > 0 {
            open_count -= 1;
            let left = stack[open_count % STACK_SIZE];
            let count = i - left.first + 1;
            let child = if count > LEAF_SIZE {
                // A left child has the number of its last leaf, a right one that of its first.
                let number = if after > left.before { i } else { left.first };
                let place = place(number);
                store(
                    place,
                    Subtree::node(&left.tree, &current.tree, left.first, i),
                );
                NodeRef::inner(place)
            } else {
                NodeRef::leaf(left.first, count)
            };
            current.tree = Subtree::joined(child, &left.tree, &current.tree);
            (current.first, current.before) = (left.first, left.before);
        }
        stack[open_count % STACK_SIZE] = current;
        open_count += 1;
    }
    current.tree
}

/// δ(i, i + 1), −1 outside the range.
#[inline(always)]
fn prefix_after<C: SortedCodes>(codes: &C, i: u32) -> i32 {
    let next = i.wrapping_add(1);
    if next > 0 && next < codes.count() {
        codes.common_prefix_length(i, next)
    } else {
        -1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::compact::rank;
    use crate::build::refit::{Level, group_bounds, parent_bounds};
    use crate::build::refit::{PyramidBox, pyramid_size, refit_node};
    use crate::build::topology::{Codes30, Codes63, internal_node, kept_nodes};
    use proptest::prelude::*;
    use std::vec::Vec;

    fn kept<C: SortedCodes>(codes: &C) -> (Vec<u32>, Vec<u32>) {
        let words = 0..codes.count().div_ceil(32);
        let bits: Vec<u32> = words.map(|word| kept_nodes(word, codes)).collect();
        let mut before: Vec<u32> = bits.iter().map(|bits| bits.count_ones()).collect();
        crate::build::scan::run_scan(&mut before, 0, bits.len() as u32, 0);
        (bits, before)
    }

    fn pyramid(triangles: &[LeafTriangle]) -> Vec<PyramidBox> {
        let mut pyramid = Vec::new();
        let mut level = Level::lowest(triangles.len() as u32);
        pyramid.extend((0..level.count).map(|i| group_bounds(i, triangles)));
        while level.count > 1 {
            let below = level;
            level = level.above();
            for i in 0..level.count {
                pyramid.push(parent_bounds(i, below, &pyramid));
            }
        }
        assert_eq!(pyramid.len() as u32, pyramid_size(triangles.len() as u32));
        pyramid
    }

    /// All nodes, each found on its own.
    fn one_by_one<C: SortedCodes>(codes: &C, triangles: &[LeafTriangle]) -> Vec<Node> {
        let ((bits, before), pyramid) = (kept(codes), pyramid(triangles));
        let all = 0..codes.count();
        let kept = all.filter(|i| bits[*i as usize / 32] >> (i % 32) & 1 == 1);
        let fitted = kept.map(|i| {
            let (node, split) = internal_node(i, codes, &bits, &before);
            refit_node(node, split, triangles, &pyramid)
        });
        fitted.collect()
    }

    /// All nodes by sweeps: of the whole, or of the subtrees of at most this many triangles.
    fn swept<C: SortedCodes>(codes: &C, triangles: &[LeafTriangle], task: u32) -> Vec<Node> {
        let (bits, before) = kept(codes);
        let count = bits.iter().map(|bits| bits.count_ones()).sum::<u32>();
        let mut nodes = std::vec![Node::EMPTY; count as usize];
        let place = |i| rank(i, &bits, &before);
        fn fill<C: SortedCodes>(
            [first, last]: [u32; 2],
            number: u32,
            (codes, triangles, task): (&C, &[LeafTriangle], u32),
            (bits, before): (&[u32], &[u32]),
            nodes: &mut Vec<Node>,
        ) -> Subtree {
            let place = |i| rank(i, bits, before);
            if last - first < task.max(LEAF_SIZE) {
                let store = |i: u32, node| nodes[i as usize] = node;
                return sweep([first, last], codes, triangles, place, store);
            }
            let (_, split) = internal_node(number, codes, bits, before);
            let shared = (codes, triangles, task);
            let kept = (bits, before);
            let left = fill([first, split], split, shared, kept, nodes);
            let right = fill([split + 1, last], split + 1, shared, kept, nodes);
            let at = place(number);
            nodes[at as usize] = Subtree::node(&left, &right, first, last);
            Subtree::joined(NodeRef::inner(at), &left, &right)
        }
        let all = [0, codes.count() - 1];
        let root = fill(
            all,
            0,
            (codes, triangles, task),
            (&bits, &before),
            &mut nodes,
        );
        assert_eq!(root.child, NodeRef::inner(place(0)));
        nodes
    }

    fn triangle() -> impl Strategy<Value = LeafTriangle> {
        (proptest::array::uniform9(-1.0f32..1.0), any::<u32>()).prop_map(|(vertices, primitive)| {
            LeafTriangle {
                vertices,
                primitive,
            }
        })
    }

    fn bits_of(nodes: &[Node]) -> Vec<[u32; 16]> {
        bytemuck::cast_slice(nodes).to_vec()
    }

    proptest! {
        #[test]
        fn nodes_are_those_found_one_by_one(
            leaves in proptest::collection::vec((prop_oneof![0u32..8, 0u32..1 << 30], triangle()), LEAF_SIZE as usize + 1..200),
            task in 1u32..100,
        ) {
            let (mut codes, triangles): (Vec<u32>, Vec<LeafTriangle>) = leaves.into_iter().unzip();
            codes.sort_unstable();
            let codes = Codes30::all(&codes);
            let expected = one_by_one(&codes, &triangles);
            for task in [u32::MAX, task] {
                let found = swept(&codes, &triangles, task);
                prop_assert_eq!(bits_of(&found), bits_of(&expected));
            }
        }

        #[test]
        fn long_codes_too(
            leaves in proptest::collection::vec(((prop_oneof![0u32..3, 0u32..1 << 31], prop_oneof![0u32..3, any::<u32>()]), triangle()), LEAF_SIZE as usize + 1..200),
            task in 1u32..100,
        ) {
            let (mut codes, triangles): (Vec<(u32, u32)>, Vec<LeafTriangle>) = leaves.into_iter().unzip();
            codes.sort_unstable();
            let codes: Vec<[u32; 2]> = codes.into_iter().map(|(high, low)| [high, low]).collect();
            let codes = Codes63::all(&codes);
            prop_assert_eq!(bits_of(&swept(&codes, &triangles, task)), bits_of(&one_by_one(&codes, &triangles)));
        }

        /// The negative control: a corner that moved after one of two ways is found.
        #[test]
        fn a_moved_corner_is_found(
            leaves in proptest::collection::vec((0u32..1 << 30, triangle()), LEAF_SIZE as usize + 1..100),
            at: prop::sample::Index,
        ) {
            let (mut codes, mut triangles): (Vec<u32>, Vec<LeafTriangle>) = leaves.into_iter().unzip();
            codes.sort_unstable();
            let codes = Codes30::all(&codes);
            let expected = one_by_one(&codes, &triangles);
            let i = at.index(triangles.len());
            triangles[i].vertices[4] += 2.0;
            prop_assert_ne!(bits_of(&swept(&codes, &triangles, 16)), bits_of(&expected));
        }
    }

    #[test]
    fn the_deepest_trees_keep_to_the_stack() {
        // One code for each bit, and as many equal ones as the indices can tell apart.
        let mut codes: Vec<[u32; 2]> = (0..63u32)
            .map(|bit| {
                let code = !(u64::MAX << bit);
                [(code >> 32) as u32, code as u32]
            })
            .collect();
        codes.splice(0..0, [[0; 2]; 5000]);
        codes.sort_unstable();
        let triangles: Vec<LeafTriangle> = (0..codes.len() as u32)
            .map(|i| LeafTriangle {
                vertices: [i as f32; 9],
                primitive: i,
            })
            .collect();
        let codes = Codes63::all(&codes);
        assert_eq!(
            bits_of(&swept(&codes, &triangles, u32::MAX)),
            bits_of(&one_by_one(&codes, &triangles))
        );
    }
}
