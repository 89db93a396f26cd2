//! The invariants of every built tree.

use proptest::prelude::*;
use slimbvh::generate::soup;
use slimbvh::{CodeBits, Mesh};
use slimbvh_tests::strategies::{any_mesh, mesh_of};
use slimbvh_tests::validate::{Shape, validate};
use slimbvh_tests::{CODE_BITS, build, cases};

fn check(mesh: &Mesh, code_bits: CodeBits) -> Shape {
    let bvh = build(mesh, code_bits);
    match validate(&bvh, mesh, code_bits) {
        Ok(shape) => shape,
        Err(fault) => panic!("{} triangles, {code_bits:?}: {fault}", mesh.indices.len()),
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn tree_invariants(mesh in any_mesh()) {
        for code_bits in CODE_BITS {
            let bvh = build(&mesh, code_bits);
            let shape = validate(&bvh, &mesh, code_bits);
            prop_assert!(shape.is_ok(), "{:?}: {:?}", code_bits, shape);
        }
    }
}

#[test]
fn every_small_size_and_every_edge_of_a_block() {
    for code_bits in CODE_BITS {
        for count in (0..=70).chain([4095, 4096, 4097, 8191, 8192, 8193, 16_383, 16_385]) {
            check(&soup(count, 11), code_bits);
        }
    }
}

#[test]
fn generated_meshes_make_sound_trees() {
    for (name, mesh) in crate::meshes::generated() {
        for code_bits in CODE_BITS {
            let bvh = build(&mesh, code_bits);
            let shape = validate(&bvh, &mesh, code_bits);
            assert!(shape.is_ok(), "{name}, {code_bits:?}: {shape:?}");
        }
    }
}

#[test]
fn a_hundred_thousand_equal_codes_make_a_balanced_tree() {
    let small = [[0.0f32, 0.0, 0.0], [1e-3, 0.0, 0.0], [0.0, 1e-3, 1e-3]];
    let mesh = mesh_of(&vec![small; 100_000]);
    for code_bits in CODE_BITS {
        // 2^17 holds them, and leaves end the last levels.
        assert!((13..=17).contains(&check(&mesh, code_bits).depth));
    }
}

#[test]
fn unused_vertices_may_be_anything() {
    let mut mesh = soup(100, 3);
    let sound = build(&mesh, CodeBits::Bits30);
    mesh.vertices.push([f32::NAN, f32::INFINITY, 1e38]);
    let bvh = build(&mesh, CodeBits::Bits30);
    assert_eq!(bvh.nodes(), sound.nodes());
    assert_eq!(bvh.leaf_triangles(), sound.leaf_triangles());
}
