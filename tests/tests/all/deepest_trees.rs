//! Trees as deep as codes allow: the depth bound holds, and rays lose no hit.

use slimbvh::{CodeBits, Mesh};
use slimbvh_core::Ray;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_tests::build;
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::{Corners, mesh_of};
use slimbvh_tests::validate::validate;

/// Triangles with the codes 0 (`equal_count` times), 1, 2, 4 … and all ones: every bit of the code splits one off. All their
/// boxes reach to the origin, so a ray there meets both children of every node.
pub fn ladder(bits_per_axis: u32, equal_count: usize) -> Mesh {
    let size = (1u32 << bits_per_axis) as f32;
    let around = |centre: [f32; 3]| -> Corners {
        let half = centre.map(|c| c.min(size - c));
        let low = [0, 1, 2].map(|axis| centre[axis] - half[axis]);
        let high = [0, 1, 2].map(|axis| centre[axis] + half[axis]);
        [low, high, [low[0], high[1], low[2]]]
    };
    let mut triangles = vec![[[0.0; 3]; 3], [[size; 3]; 3]];
    for bit in 0..bits_per_axis {
        for axis in 0..3 {
            let mut centre = [0.25f32; 3];
            centre[axis] += (1u32 << bit) as f32;
            triangles.push(around(centre));
        }
    }
    triangles.extend((0..equal_count).map(|_| around([0.25; 3])));
    mesh_of(&triangles)
}

#[test]
fn the_depth_bound_holds_for_the_deepest_trees_and_is_nearly_reached() {
    for (code_bits, bits_per_axis) in [(CodeBits::Bits30, 10), (CodeBits::Bits63, 21)] {
        for equal_count in [0, 1, 100, 2000, 1 << 15] {
            let mesh = ladder(bits_per_axis, equal_count);
            let bvh = build(&mesh, code_bits);
            let shape = validate(&bvh, &mesh, code_bits);
            let depth = shape.map_or_else(|fault| panic!("{fault}"), |shape| shape.depth);

            // Levels that a leaf saves at the bottom: one a triangle of the ladder; for equal codes their logarithm, rounded.
            let saved = if equal_count as u32 > LEAF_SIZE {
                LEAF_SIZE.ilog2() + 1
            } else {
                LEAF_SIZE - 1
            };
            let missing = bvh.depth_bound() - depth;
            let equal_levels = equal_count.max(1).ilog2();
            let key_levels = 3 * bits_per_axis;
            assert!(
                depth + saved >= key_levels + equal_levels,
                "{depth} {missing}"
            );
        }
    }
}

#[test]
fn the_deepest_trees_lose_no_hit() {
    let mut random = Random::new(1);
    for (code_bits, bits_per_axis) in [(CodeBits::Bits30, 10), (CodeBits::Bits63, 21)] {
        let mesh = ladder(bits_per_axis, 1500);
        let bvh = build(&mesh, code_bits);
        let size = (1u32 << bits_per_axis) as f32;
        let rays: Vec<Ray> = (0..150)
            .map(|i| {
                let near = [0, 1, 2].map(|_| random.between(0.0, 0.5));
                let from = random.point() * if i % 2 == 0 { 1.0 } else { size };
                let direction = [0, 1, 2].map(|axis| near[axis] - from[axis]);
                Ray::new(from.to_array(), direction)
            })
            .collect();
        match Parts::from(&bvh).compare(&rays) {
            Ok(hit_count) => assert!(hit_count > 10, "{hit_count}"),
            Err(disagreement) => panic!("{disagreement:#?}"),
        }
    }
}
