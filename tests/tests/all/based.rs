//! A tree that begins anywhere in lists of nodes and triangles has its own answers.

use glam::Vec3;
use proptest::prelude::*;
use slimbvh::generate::soup;
use slimbvh::{BuildConfig, Builder, Bvh, Hit, Ray};
use slimbvh_core::trace::{Based, LeafTriangles, PlainNodes, Skip, closest_hit};
use slimbvh_core::{LeafTriangle, Node};
use slimbvh_tests::gpu::done;
use slimbvh_tests::random::Random;

/// Trees in the same lists, each behind gaps.
struct Shared {
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
    /// Where each tree's nodes and triangles begin.
    first: Vec<[u32; 2]>,
}

impl Shared {
    fn new(trees: &[Bvh], gaps: &[u32]) -> Self {
        let (mut nodes, mut triangles, mut first) = (Vec::new(), Vec::new(), Vec::new());
        for (tree, &gap) in trees.iter().zip(gaps) {
            nodes.resize(nodes.len() + gap as usize, Node::default());
            triangles.resize(triangles.len() + 2 * gap as usize, LeafTriangle::default());
            first.push([nodes.len() as u32, triangles.len() as u32]);
            nodes.extend_from_slice(tree.nodes());
            triangles.extend_from_slice(tree.leaf_triangles());
        }
        Self {
            nodes,
            triangles,
            first,
        }
    }

    fn hit(&self, ray: &Ray, [first_node, first_triangle]: [u32; 2], exponent: i32) -> Hit {
        let nodes = Based {
            list: PlainNodes(&self.nodes),
            first_node,
            first_triangle,
        };
        let triangles = LeafTriangles(&self.triangles);
        closest_hit(&nodes, &triangles, ray, exponent, &Skip(u32::MAX))
    }
}

fn rays() -> Vec<Ray> {
    let mut random = Random::new(3);
    let ray = |_| {
        // Soups fill the cube from 0 to 1.
        let from = Vec3::splat(0.5) + random.point();
        let to = Vec3::splat(0.5) + 0.5 * random.point();
        Ray::new(from.to_array(), (to - from).to_array())
    };
    (0..200).map(ray).collect()
}

proptest! {
    #[test]
    fn a_tree_may_begin_anywhere_in_a_list(
        counts in [0u32..200, 0..200, 1..200],
        gaps in [0u32..9, 0..9, 0..9],
    ) {
        let trees: Vec<Bvh> = counts
            .iter()
            .zip(1..)
            .map(|(&count, seed)| done(Builder::new(BuildConfig::default()).build(&soup(count, seed))))
            .collect();
        let shared = Shared::new(&trees, &gaps);
        for (tree, first) in trees.iter().zip(&shared.first) {
            for ray in rays() {
                let found = shared.hit(&ray, *first, tree.scene_exponent());
                prop_assert_eq!(found, tree.closest_hit(ray));
            }
        }
    }
}

/// The negative control: one node or one triangle beside the beginning, answers differ.
#[test]
fn a_tree_that_begins_elsewhere_has_other_answers() {
    let trees =
        [1, 2].map(|seed| done(Builder::new(BuildConfig::default()).build(&soup(300, seed))));
    let shared = Shared::new(&trees, &[3, 5]);
    let hits = rays()
        .into_iter()
        .filter(|ray| trees[1].closest_hit(ray).is_hit());
    let count = hits.count();
    assert!(count > 20, "{count}");
    let [node, triangle] = shared.first[1];
    for wrong in [[node + 1, triangle], [node, triangle + 1], [0, 0]] {
        let differ = rays().iter().any(|ray| {
            let found = shared.hit(ray, wrong, trees[1].scene_exponent());
            found != trees[1].closest_hit(ray)
        });
        assert!(differ, "{wrong:?}");
    }
}
