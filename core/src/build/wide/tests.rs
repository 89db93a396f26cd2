//! Laws of wide trees over random binary ones.

use super::*;
use crate::build::cluster::joint_area;
use crate::build::node::{Node, NodeRef};
use crate::build::refit::WideBox;
use crate::geometry::aabb::Aabb;
use glam::Vec3;
use proptest::collection::vec;
use proptest::prelude::*;
use std::vec::Vec;

/// A binary tree: runs of triangles are split at random, boxes are random ones and their unions.
fn tree() -> impl Strategy<Value = Vec<Node>> {
    let size = prop_oneof![1 => Just(0.0f32), 3 => 0.0..1.0f32];
    let leaf = (
        1..=6u32,
        [-1.0..1.0f32, -1.0..1.0, -1.0..1.0],
        [size.clone(), size.clone(), size],
    );
    (vec(leaf, 2..60), vec(any::<u32>(), 64)).prop_map(|(leaves, splits)| {
        let mut first = 0;
        let leaves: Vec<WideChild> = leaves
            .into_iter()
            .map(|(count, min, size)| {
                let node = NodeRef::leaf(first, count);
                first += count;
                let min = Vec3::from_array(min);
                let bounds = Aabb {
                    min,
                    max: min + Vec3::from_array(size),
                };
                WideChild::new(node, bounds)
            })
            .collect();
        let mut nodes = vec_of(leaves.len() - 1);
        grow(&leaves, &splits, 0, Side::Right, &mut nodes);
        nodes
    })
}

fn vec_of(count: usize) -> Vec<Node> {
    std::vec![Node::EMPTY; count]
}

#[derive(Clone, Copy, PartialEq)]
enum Side {
    Left,
    Right,
}

/// Stores the tree over leaves from a place on, numbered as `topology` numbers it: a left child is the last of its nodes, a right
/// one and the root the first. Runs are split where `splits` say. Returns its topmost.
fn grow(
    leaves: &[WideChild],
    splits: &[u32],
    begin: usize,
    side: Side,
    nodes: &mut [Node],
) -> WideChild {
    if let [leaf] = leaves {
        return *leaf;
    }
    let split = 1 + splits[(7 * begin + leaves.len()) % splits.len()] as usize % (leaves.len() - 1);
    let (index, below) = match side {
        Side::Left => (begin + leaves.len() - 2, begin),
        Side::Right => (begin, begin + 1),
    };
    let left = grow(&leaves[..split], splits, below, Side::Left, nodes);
    let right = grow(
        &leaves[split..],
        splits,
        below + split - 1,
        Side::Right,
        nodes,
    );
    let end = |leaf: &WideChild| leaf.node.first() + leaf.node.count();
    nodes[index] = Node {
        left: left.node,
        right: right.node,
        first: leaves[0].node.first(),
        last: end(&leaves[leaves.len() - 1]) - 1,
        ..Node::EMPTY
    }
    .with_boxes(left.bounds(), right.bounds());
    WideChild::new(
        NodeRef::inner(index as u32),
        left.bounds().union(right.bounds()),
    )
}

fn children_of(i: u32, nodes: &[Node]) -> WideChildren {
    let node = nodes[i as usize];
    wide_children(&node, collapse(&node, nodes, 0), nodes)
}

/// The run of triangles below a child.
fn run(child: NodeRef, nodes: &[Node]) -> [u32; 2] {
    if child.is_leaf() {
        [child.first(), child.first() + child.count() - 1]
    } else {
        let node = nodes[child.index() as usize];
        [node.first, node.last]
    }
}

/// The collapse of each binary node.
fn collapses(nodes: &[Node]) -> Vec<u32> {
    let words = nodes.iter().map(|node| collapse(node, nodes, 0).0);
    words.collect()
}

/// The origin of each binary node.
fn origins(nodes: &[Node], collapses: &[u32]) -> Vec<Origin> {
    let all = 0..nodes.len() as u32;
    all.map(|i| wide_origin(i, nodes, collapses)).collect()
}

/// The exclusive prefix sums of the numbers of inner children.
fn sums(origins: &[Origin], collapses: &[u32]) -> Vec<u32> {
    let counts = origins.iter().zip(collapses);
    let counts = counts.map(|(origin, word)| origin.inner_count(Collapse(*word)));
    let sums = counts.scan(0, |sum, count| {
        *sum += count;
        Some(*sum - count)
    });
    sums.collect()
}

/// A wide tree by places: the binary node at which each wide node begins, and its children. An error where two have a place, or
/// none has.
fn placed(
    nodes: &[Node],
    origins: &[Origin],
    sums: &[u32],
) -> Result<Vec<(u32, [NodeRef; WIDTH])>, u32> {
    let begins = Begins(sums);
    let mut tree = std::vec![None; origins.iter().filter(|origin| origin.is_there()).count()];
    for (i, origin) in (0..).zip(origins) {
        if origin.is_there() {
            let wide = children_of(i, nodes);
            let refs = super::placed(wide.nodes(), wide.count, begins.first_child(i));
            let place = begins.place(*origin);
            match tree.get_mut(place as usize) {
                Some(slot @ None) => *slot = Some((i, refs)),
                _ => return Err(place),
            }
        }
    }
    let missing = tree.len() as u32;
    tree.into_iter().collect::<Option<_>>().ok_or(missing)
}

/// The binary node and the children of each wide node, from the root down: a plain enumeration.
fn enumerated(nodes: &[Node]) -> Vec<(u32, Vec<NodeRef>)> {
    let of = |i: u32| {
        let wide = children_of(i, nodes);
        let there = &wide.children()[..wide.count as usize];
        (i, there.iter().map(|child| child.node).collect::<Vec<_>>())
    };
    begun(nodes).into_iter().map(of).collect()
}

/// Whether a tree by places is the enumerated one: below each place the same leaves, and inner children where the parent says.
fn is_enumerated(tree: &[(u32, [NodeRef; WIDTH])], nodes: &[Node]) -> bool {
    let expected = enumerated(nodes);
    let is_same = |place: usize, i: u32| {
        let (begun, refs) = &tree[place];
        let children = expected
            .iter()
            .find(|(at, _)| *at == i)
            .map(|(_, children)| children);
        let children = children.expect("it begins a wide node");
        let there = refs.iter().zip(children).all(|(found, child)| {
            if child.is_leaf() {
                found == child
            } else {
                let at = tree.get(found.index() as usize);
                !found.is_leaf() && at.is_some_and(|(begun, _)| *begun == child.index())
            }
        });
        let absent = refs[children.len()..]
            .iter()
            .all(|child| *child == NodeRef::EMPTY_LEAF);
        *begun == i && there && absent
    };
    tree.len() == expected.len()
        && tree[0].0 == 0
        && (0..tree.len()).all(|place| is_same(place, tree[place].0))
}

/// The nodes at which wide nodes begin, from the root down.
fn begun(nodes: &[Node]) -> Vec<u32> {
    let mut found = Vec::from([0]);
    let mut next = 0;
    while next < found.len() {
        let wide = children_of(found[next], nodes);
        let there = &wide.children()[..wide.count as usize];
        let inner = there.iter().filter(|child| !child.node.is_leaf());
        found.extend(inner.map(|child| child.node.index()));
        next += 1;
    }
    found
}

fn area(bounds: Aabb) -> f32 {
    let wide = WideBox::around(bounds);
    joint_area(&wide, &wide, 0)
}

proptest! {
    #[test]
    fn children_are_parts_of_their_nodes_run_in_order(nodes in tree()) {
        for i in begun(&nodes) {
            let wide = children_of(i, &nodes);
            prop_assert!((2..=4).contains(&wide.count));
            let mut next = nodes[i as usize].first;
            for child in &wide.children()[..wide.count as usize] {
                let [first, last] = run(child.node, &nodes);
                prop_assert_eq!(first, next);
                next = last + 1;
            }
            prop_assert_eq!(next, nodes[i as usize].last + 1);
            for child in &wide.children()[wide.count as usize..] {
                prop_assert_eq!(child.node, NodeRef::EMPTY_LEAF);
            }
        }
    }

    #[test]
    fn boxes_are_those_of_the_binary_tree(nodes in tree()) {
        for i in begun(&nodes) {
            let wide = children_of(i, &nodes);
            let there = &wide.children()[..wide.count as usize];
            for child in there {
                let parent = nodes.iter().find(|node| node.left == child.node || node.right == child.node);
                let parent = parent.expect("each child has a parent");
                let bounds = if parent.left == child.node { parent.left_box() } else { parent.right_box() };
                prop_assert_eq!(child.bounds(), bounds);
            }
        }
    }

    #[test]
    fn a_walk_from_the_root_finds_which_nodes_begin_wide_ones(nodes in tree()) {
        let (begun, collapses) = (begun(&nodes), collapses(&nodes));
        for i in 0..nodes.len() as u32 {
            let origin = wide_origin(i, &nodes, &collapses);
            prop_assert_eq!(origin.is_there(), begun.contains(&i), "{}", i);
        }
        prop_assert_eq!(wide_origin(nodes.len() as u32, &nodes, &collapses), Origin::ABSENT);
    }

    #[test]
    fn an_origin_is_the_parent_and_the_rank_among_its_inner_children(nodes in tree()) {
        let collapses = collapses(&nodes);
        prop_assert_eq!(wide_origin(0, &nodes, &collapses), Origin::ROOT);
        for (i, children) in enumerated(&nodes) {
            let inner = children.iter().filter(|child| !child.is_leaf());
            for (rank, child) in (0..).zip(inner) {
                let origin = wide_origin(child.index(), &nodes, &collapses);
                prop_assert_eq!(origin.0, i << 2 | rank);
            }
        }
    }

    #[test]
    fn a_collapse_counts_the_inner_children(nodes in tree()) {
        for i in 0..nodes.len() as u32 {
            let wide = children_of(i, &nodes);
            let word = collapse(&nodes[i as usize], &nodes, 0);
            let is_inner = |child: &&WideChild| !child.node.is_leaf();
            for end in 0..=WIDTH {
                let expected = wide.children()[..end.min(wide.count as usize)].iter().filter(is_inner).count();
                prop_assert_eq!(word.inner_before(end as u32) as usize, expected);
            }
            prop_assert_eq!(word.inner_count(), word.inner_before(4));
        }
    }

    #[test]
    fn each_wide_node_has_one_place_and_children_are_where_parents_link_them(nodes in tree()) {
        let collapses = collapses(&nodes);
        let origins = origins(&nodes, &collapses);
        let tree = placed(&nodes, &origins, &sums(&origins, &collapses));
        prop_assert!(tree.is_ok_and(|tree| is_enumerated(&tree, &nodes)));
    }

    /// The negative control: an origin and a sum that are another's are found.
    #[test]
    fn spoilt_words_are_found(nodes in tree(), at: prop::sample::Index) {
        let collapses = collapses(&nodes);
        let origins = origins(&nodes, &collapses);
        let sums = sums(&origins, &collapses);
        let inner: Vec<usize> = (1..nodes.len()).filter(|i| origins[*i].is_there()).collect();
        prop_assume!(!inner.is_empty());
        let i = inner[at.index(inner.len())];
        let is_found = |origins: &[Origin], sums: &[u32]| {
            !placed(&nodes, origins, sums).is_ok_and(|tree| is_enumerated(&tree, &nodes))
        };
        prop_assert!(!is_found(&origins, &sums));
        for word in [Origin(origins[i].0 ^ 1), Origin::ABSENT] {
            let mut spoilt = origins.clone();
            spoilt[i] = word;
            prop_assert!(is_found(&spoilt, &sums));
        }
        let mut spoilt = sums;
        spoilt[(origins[i].0 >> 2) as usize] += 1;
        prop_assert!(is_found(&origins, &spoilt));
    }

    #[test]
    fn no_child_is_larger_than_what_gave_way(nodes in tree()) {
        for i in begun(&nodes) {
            let node = nodes[i as usize];
            let shape = collapse(&node, &nodes, 0);
            let mut wide = WideChildren::of(&node);
            for step in 0..2 {
                let place = shape.place(step);
                let there = &wide.children()[..wide.count as usize];
                let mut inner = there.iter().filter(|child| !child.node.is_leaf());
                if place == 0 {
                    prop_assert_eq!(inner.next().map(|child| child.node), None);
                } else {
                    let chosen = there[place as usize - 1];
                    prop_assert!(!chosen.node.is_leaf());
                    prop_assert!(inner.all(|child| area(child.bounds()) <= area(chosen.bounds())));
                }
                wide = wide.opened(place, &nodes);
            }
        }
    }
}

#[test]
fn trees_of_one_leaf_and_of_none_have_a_root() {
    let leaf = Node {
        left: NodeRef::leaf(0, 3),
        last: 2,
        ..Node::EMPTY
    };
    for (node, count) in [(leaf, 1), (Node::EMPTY, 0)] {
        let nodes = [node];
        assert_eq!(children_of(0, &nodes).count, count);
        let word = collapse(&node, &nodes, 0);
        assert_eq!(
            (word, wide_origin(0, &nodes, &[word.0])),
            (Collapse::NONE, Origin::ROOT)
        );
        assert_eq!(
            super::placed(children_of(0, &nodes).nodes(), count, 1)[0],
            node.left
        );
    }
    assert_eq!(wide_origin(0, &[], &[]), Origin::ABSENT);
    assert_eq!(Begins(&[]).place(Origin::ABSENT), u32::MAX);
}
