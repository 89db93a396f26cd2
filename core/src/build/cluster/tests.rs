use super::*;
use crate::build::node::{Node, NodeRef};
use proptest::prelude::*;
use std::vec;
use std::vec::Vec;

/// A tree that was merged one round after the other.
struct Tree {
    merges: Vec<Merged>,
    triangle_count: u32,
    rounds: u32,
}

impl Tree {
    fn new(triangles: &[LeafTriangle], opaque_zero: u32) -> Self {
        let triangle_count = triangles.len() as u32;
        let mut merges = Vec::new();
        let mut ids: Vec<u32> = (0..triangle_count).collect();
        let mut boxes: Vec<PyramidBox> = ids.iter().map(|&i| triangle_box(i, triangles)).collect();
        let mut round = Round {
            index: 0,
            count: triangle_count,
        };
        while round.count > 1 {
            let old = merges.clone();
            let known = Merges {
                merges: &old,
                triangle_count,
            };
            let active = Active {
                ids: &ids,
                boxes: &boxes,
            };
            let (mut next_ids, mut next_boxes) = (Vec::new(), Vec::new());
            let mut i = 0;
            while i < round.count {
                let bits = merging_pairs(i / 32, round, &boxes, opaque_zero);
                if bits >> (i % 32) & 1 == 0 {
                    next_ids.push(ids[i as usize]);
                    next_boxes.push(boxes[i as usize]);
                    i += 1;
                    continue;
                }
                let made = merge(i, round, &active, &known, opaque_zero);
                let mut node = made.node;
                if made.rotation != 0 {
                    let rotated = rotate(i, made.rotation, &active, &known);
                    for change in [rotated.first, rotated.second] {
                        if change.id != NO_CLUSTER {
                            merges[(change.id - triangle_count) as usize] = change.merged;
                        }
                    }
                    node = rotated.node;
                }
                next_ids.push(triangle_count + merges.len() as u32);
                next_boxes.push(made.bounds);
                merges.push(node);
                i += 2;
            }
            assert!(next_ids.len() < ids.len(), "a round merges something");
            assert_eq!(
                Round {
                    count: next_ids.len() as u32,
                    ..round
                }
                .first_merge(triangle_count),
                triangle_count + merges.len() as u32
            );
            (ids, boxes) = (next_ids, next_boxes);
            round = Round {
                index: round.index + 1,
                count: ids.len() as u32,
            };
        }
        Self {
            merges,
            triangle_count,
            rounds: round.index,
        }
    }

    fn merges(&self) -> Merges<'_> {
        Merges {
            merges: &self.merges,
            triangle_count: self.triangle_count,
        }
    }

    /// Checks a cluster and all below. Returns its box, its size and its height.
    fn check(&self, id: u32, triangles: &[LeafTriangle]) -> ([f32; 6], Size, u32) {
        let corners = |b: PyramidBox| [b.0[0], b.0[1], b.0[2], b.0[4], b.0[5], b.0[6]];
        if id < self.triangle_count {
            return (corners(triangle_box(id, triangles)), Size::TRIANGLE, 0);
        }
        let merged = self.merges().merged(id);
        let (left, left_size, left_height) = self.check(merged.left, triangles);
        let (right, right_size, right_height) = self.check(merged.right, triangles);
        let stored =
            |min: [f32; 3], max: [f32; 3]| [min[0], min[1], min[2], max[0], max[1], max[2]];
        assert_eq!(stored(merged.left_min, merged.left_max), left);
        assert_eq!(stored(merged.right_min, merged.right_max), right);
        let count = left_size.triangles + right_size.triangles;
        let nodes = if count > LEAF_SIZE {
            1 + left_size.nodes + right_size.nodes
        } else {
            0
        };
        assert_eq!((merged.triangles, merged.nodes), (count, nodes));
        let joint = core::array::from_fn(|i| {
            if i < 3 {
                left[i].min(right[i])
            } else {
                left[i].max(right[i])
            }
        });
        (joint, merged.size(), 1 + left_height.max(right_height))
    }

    /// Walks the nodes as a traversal does. Returns the depth.
    fn walk(&self, nodes: &[(Node, u32)], child: NodeRef, run: [u32; 2], seen: &mut [bool]) -> u32 {
        let [first, last] = run;
        let count = last - first + 1;
        if count <= LEAF_SIZE {
            assert_eq!(child, NodeRef::leaf(first, count));
            return 0;
        }
        assert!(!child.is_leaf());
        assert!(!core::mem::replace(&mut seen[child.index() as usize], true));
        let (node, split) = nodes[child.index() as usize];
        assert_eq!([node.first, node.last], run);
        let left = self.walk(nodes, node.left, [first, split], seen);
        let right = self.walk(nodes, node.right, [split + 1, last], seen);
        // The left child comes right before all that is on the right.
        if !node.left.is_leaf() && !node.right.is_leaf() {
            assert_eq!(node.left.index() + 1, node.right.index());
        }
        1 + left.max(right)
    }
}

/// Checks all laws. Returns the rounds and the depth.
fn check(triangles: &[LeafTriangle]) -> [u32; 2] {
    let count = triangles.len() as u32;
    let tree = Tree::new(triangles, 0);
    assert!(tree.rounds <= ROUNDS);
    if count < 2 {
        assert!(tree.merges.is_empty());
        return [tree.rounds, 0];
    }
    let root = Place::root(count);
    let (_, size, height) = tree.check(root.id, triangles);
    assert_eq!(size.triangles, count);
    assert!(height <= (ROUNDS + DEEPENING_ROUNDS).min(count - 1));

    // Each triangle has one place.
    let merges = tree.merges();
    let mut order: Vec<u32> = (0..count).map(|i| triangle_at(i, &merges)).collect();
    order.sort_unstable();
    assert!(order.into_iter().eq(0..count));
    if count <= LEAF_SIZE {
        assert_eq!(size.nodes, 0);
        return [tree.rounds, 1];
    }
    let nodes: Vec<(Node, u32)> = (0..size.nodes).map(|i| node_at(i, &merges)).collect();
    let mut seen = vec![false; nodes.len()];
    let depth = tree.walk(&nodes, NodeRef::inner(0), [0, count - 1], &mut seen);
    assert!(seen.iter().all(|&seen| seen));
    assert!(depth <= depth_bound(count), "{depth} of {count}");
    [tree.rounds, depth]
}

/// A triangle whose box goes from one corner to the other.
fn across(min: [f32; 3], max: [f32; 3]) -> LeafTriangle {
    LeafTriangle {
        vertices: [
            min[0], min[1], min[2], max[0], max[1], max[2], min[0], max[1], min[2],
        ],
        primitive: 0,
    }
}

/// Points along x.
fn points(places: impl IntoIterator<Item = f32>) -> Vec<LeafTriangle> {
    let point = |x| across([x, 0.0, 0.0], [x, 0.0, 0.0]);
    places.into_iter().map(point).collect()
}

#[test]
fn few_triangles() {
    for count in 0..40u16 {
        let [_, depth] = check(&points((0..count).map(|i| f32::from(i * i))));
        assert!(depth <= u32::from(count.max(1)));
    }
}

#[test]
fn computed_by_hand() {
    // Gaps of 3, 1, 4, 1, 5: the second and the fourth merge. Of what is left, 0 | 3–4 | 8–9 | 14, the first is nearest to
    // its neighbour, then that to 8–9, from which 14 is farthest.
    let triangles = points([0.0, 3.0, 4.0, 8.0, 9.0, 14.0]);
    let boxes: Vec<PyramidBox> = (0..6).map(|i| triangle_box(i, &triangles)).collect();
    let round = Round { index: 0, count: 6 };
    assert_eq!(merging_pairs(0, round, &boxes, 0), 0b01010);
    let tree = Tree::new(&triangles, 0);
    let held: Vec<[u32; 2]> = tree.merges.iter().map(|m| [m.left, m.right]).collect();
    assert_eq!(held[..2], [[1, 2], [3, 4]]);
    let order: Vec<u32> = (0..6).map(|i| triangle_at(i, &tree.merges())).collect();
    assert_eq!(order, [0, 1, 2, 3, 4, 5]);
    check(&triangles);
}

#[test]
fn equal_boxes_halve_in_each_round() {
    for count in [2, 31, 32, 33, 64, 1000, 4096] {
        let [rounds, depth] = check(&points(vec![0.5; count]));
        assert_eq!(rounds, (count as u32).next_power_of_two().ilog2());
        assert!(depth <= rounds);
    }
}

#[test]
fn costs_that_rise_all_along_the_curve_keep_to_the_bounds() {
    // Each is farther from the last than that from the one before: one pair a round, for as long as there is time.
    let growing = points((0..3000).map(|i: i16| f32::from(i) * f32::from(i) / 9e6));
    let [rounds, depth] = check(&growing);
    assert_eq!(rounds, ROUNDS);
    assert!(depth <= ROUNDS + DEEPENING_ROUNDS);

    // The same backward, and in growing boxes about one point.
    let mut falling = growing;
    falling.reverse();
    assert_eq!(check(&falling)[0], ROUNDS);
    let nested: Vec<LeafTriangle> = (1..2000u16)
        .map(|i| across([-f32::from(i); 3], [f32::from(i); 3]))
        .collect();
    check(&nested);
}

#[test]
fn rounds_are_forced_in_time() {
    for count in [2, 3, 4, 5, 1 << 20, (1 << 20) + 1, crate::MAX_TRIANGLES] {
        // One pair a round until halving must begin, then halving.
        let mut round = Round { index: 0, count };
        while round.count > 1 {
            round.count = if round.is_forced() {
                round.count.div_ceil(2)
            } else {
                round.count - 1
            };
            round.index += 1;
        }
        assert!(round.index <= ROUNDS);
        assert!(round.index == ROUNDS || count < ROUNDS);
    }
}

#[test]
fn a_rotation_brings_together_what_belongs_together() {
    // a holds what is at 0 and at 10, b what is at 0.1 and at 10.1.
    let triangles = points([0.0, 10.0, 0.1, 10.1, 50.0]);
    let boxes: Vec<PyramidBox> = (0..5).map(|i| triangle_box(i, &triangles)).collect();
    let member = |id| PyramidBox(boxes[id as usize].0);
    let held = |left: u32, right: u32| {
        let (l, r) = (member(left).0, member(right).0);
        Merged {
            left_min: [l[0], l[1], l[2]],
            left,
            left_max: [l[4], l[5], l[6]],
            right,
            right_min: [r[0], r[1], r[2]],
            triangles: 2 * LEAF_SIZE,
            right_max: [r[4], r[5], r[6]],
            nodes: 1,
        }
    };
    let list = [held(0, 1), held(2, 3)];
    let merges = Merges {
        merges: &list,
        triangle_count: 5,
    };
    let wide = PyramidBox([0.0, 0.0, 0.0, 0.0, 10.0, 0.0, 0.0, 0.0]);
    let active = Active {
        ids: &[5, 6],
        boxes: &[wide, PyramidBox([0.1, 0.0, 0.0, 0.0, 10.1, 0.0, 0.0, 0.0])],
    };
    let late = Round {
        index: DEEPENING_ROUNDS,
        count: 2,
    };
    let rotation = merge(0, late, &active, &merges, 0).rotation;
    assert_eq!(rotation, 5);
    let made = rotate(0, rotation, &active, &merges);
    assert_eq!([made.first.id, made.second.id], [5, 6]);
    assert_eq!([made.first.merged.left, made.first.merged.right], [0, 2]);
    assert_eq!([made.second.merged.left, made.second.merged.right], [1, 3]);
    assert_eq!([made.node.left, made.node.right], [5, 6]);
}

fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![
        (0u8..8).prop_map(|x| f32::from(x) / 8.0),
        -1.0f32..1.0,
        (0i32..140).prop_map(|e| f32::from_bits(((127 - e.min(126)) as u32) << 23)),
    ]
}

fn some_triangles() -> impl Strategy<Value = Vec<LeafTriangle>> {
    let triangle = proptest::array::uniform9(coordinate()).prop_map(|vertices| LeafTriangle {
        vertices,
        primitive: 0,
    });
    proptest::collection::vec(triangle, 0..400)
}

proptest! {
    #[test]
    fn every_triangle_has_one_place_and_no_path_is_too_long(triangles in some_triangles()) {
        check(&triangles);
    }

    #[test]
    fn sizes_that_grow_by_any_factor_keep_to_the_bounds(factor in 1.001f32..4.0, count in 2usize..600, back in any::<bool>()) {
        let mut places: Vec<f32> = (0..count).map(|i| factor.powi(i as i32 % 60) * (1.0 + (i / 60) as f32)).collect();
        if back {
            places.reverse();
        }
        check(&points(places));
    }

    #[test]
    fn the_cheapest_pair_of_all_merges_and_no_cluster_twice(triangles in some_triangles()) {
        prop_assume!(triangles.len() > 1);
        let count = triangles.len() as u32;
        let boxes: Vec<PyramidBox> = (0..count).map(|i| triangle_box(i, &triangles)).collect();
        let cost = |i: u32| {
            let at = |i| WideBox::of_entry(i, &boxes);
            (joint_area(&at(i), &at(i + 1), 0), i % 2)
        };
        let round = Round { index: 0, count };
        let merges = |i: u32| merging_pairs(i / 32, round, &boxes, 0) >> (i % 32) & 1 == 1;
        for i in 0..count.next_multiple_of(32) {
            let is_lowest = i + 1 < count
                && (i == 0 || cost(i) < cost(i - 1))
                && (i + 2 >= count || cost(i) < cost(i + 1));
            prop_assert_eq!(merges(i), is_lowest, "{}", i);
        }
    }
}
