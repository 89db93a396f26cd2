//! The cost of tracing a tree, by the surface area heuristic.

use slimbvh_core::{Node, NodeRef};

/// The expected cost of a ray that hits the root's box, at 1 for each opened node and 1 for each tested triangle: the
/// surface area heuristic (MacDonald and Booth, "Heuristics for ray tracing using space subdivision", 1990). Independent of
/// position and scale. 0 for a tree without triangles; infinite for one of several nodes without area, whose triangles are all in
/// one point or on one line along an axis, so that it says nothing about other positions of the same triangles. Large triangles
/// dominate the cost: with a wide ground plane, small objects on it count for little.
///
/// `nodes` are those of a [`crate::Bvh`], the root first.
#[must_use]
pub fn sah_cost(nodes: &[Node]) -> f64 {
    let Some(root) = nodes.first() else {
        return 0.0;
    };
    let weight = |child: NodeRef| {
        if child.is_leaf() {
            f64::from(child.count())
        } else {
            1.0
        }
    };
    let area = |node: &Node| {
        let (left, right) = (node.left_box(), node.right_box());
        weight(node.left) * f64::from(left.half_area())
            + weight(node.right) * f64::from(right.half_area())
    };
    let root_area = f64::from(root.left_box().union(root.right_box()).half_area());
    if root_area > 0.0 {
        1.0 + nodes.iter().map(area).sum::<f64>() / root_area
    } else if let [root] = nodes {
        // A ray that hits one node opens it, and tests what it holds.
        weight(root.left) + weight(root.right)
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Aabb, BuildConfig, Builder, Mesh};
    use glam::Vec3;

    fn aabb(min: [f32; 3], max: [f32; 3]) -> Aabb {
        Aabb {
            min: min.into(),
            max: max.into(),
        }
    }

    #[test]
    fn computed_by_hand() {
        // The root is 4 x 2 x 3: 8 + 6 + 12 = 26. Left, 1 x 2 x 3: 11, is a leaf of two. Right, 2 x 2 x 3: 16, is a node
        // with leaves of three, 1 x 1 x 1: 3, and one, 0 x 2 x 1: 2.
        let left = aabb([0.0, 0.0, 0.0], [1.0, 2.0, 3.0]);
        let right = aabb([2.0, 0.0, 0.0], [4.0, 2.0, 3.0]);
        let root = Node {
            left: NodeRef::leaf(0, 2),
            right: NodeRef::inner(1),
            ..Node::EMPTY
        };
        let child = Node {
            left: NodeRef::leaf(2, 3),
            right: NodeRef::leaf(5, 1),
            ..Node::EMPTY
        };
        let (small, flat) = (
            aabb([2.0, 0.0, 0.0], [3.0, 1.0, 1.0]),
            aabb([4.0, 0.0, 2.0], [4.0, 2.0, 3.0]),
        );
        let nodes = [root.with_boxes(left, right), child.with_boxes(small, flat)];
        let expected = 1.0 + (2.0 * 11.0 + 16.0 + 3.0 * 3.0 + 2.0) / 26.0;
        assert!((sah_cost(&nodes) - expected).abs() < 1e-12);
        assert_eq!(sah_cost(&[]), 0.0);
        let line = aabb([1.0, 2.0, 0.0], [1.0, 2.0, 3.0]);
        let flat = [root, child].map(|node| node.with_boxes(line, line));
        assert_eq!(sah_cost(&flat), f64::INFINITY);
    }

    /// Exchanged triangles make the boxes of a refitted tree large.
    #[test]
    fn scale_does_not_matter_and_disorder_does() {
        let strip = |scale: f32| {
            let mut mesh = Mesh::default();
            for i in 0..64_u32 {
                let x = scale * i as f32;
                mesh.vertices
                    .extend([[x, 0.0, 0.0], [x + scale, 0.0, 0.0], [x, scale, scale]]);
                mesh.indices.push([3 * i, 3 * i + 1, 3 * i + 2]);
            }
            mesh
        };
        let mut builder = Builder::new(BuildConfig::default());
        let mut mesh = strip(1.0);
        let mut bvh = builder.build(&mesh).unwrap();
        let built = sah_cost(bvh.nodes());
        assert!((4.0..16.0).contains(&built), "{built}");
        let larger = builder.build(&strip(1024.0)).unwrap();
        assert_eq!(sah_cost(larger.nodes()), built);
        for triangle in mesh.vertices.chunks_mut(3) {
            let place = (triangle[0][0] as u32).reverse_bits() >> 26;
            let offset = Vec3::X * (place as f32 - triangle[0][0]);
            for vertex in triangle {
                *vertex = (Vec3::from(*vertex) + offset).to_array();
            }
        }
        builder.refit(&mesh, &mut bvh).unwrap();
        assert!(sah_cost(bvh.nodes()) > 3.0 * built);
    }
}
