//! A refitted tree keeps all promises of a tree.

use proptest::prelude::*;
use slimbvh::generate::{icosphere, soup};
use slimbvh::{BuildConfig, Builder, CodeBits, Mesh};
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, placement};
use slimbvh_tests::validate::validate_shape;
use slimbvh_tests::{CODE_BITS, build, cases};

/// The same triangles with moved vertices.
fn moved(mesh: &Mesh, offsets: &[[f32; 3]]) -> Mesh {
    let mut mesh = mesh.clone();
    for (vertex, offset) in mesh.vertices.iter_mut().zip(offsets.iter().cycle()) {
        *vertex = [0, 1, 2].map(|axis| vertex[axis] + vertex[axis] * offset[axis]);
    }
    mesh
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn refitted_trees_answer_as_rebuilt_ones_do(
        mesh in any_mesh(),
        offsets in proptest::collection::vec(proptest::array::uniform3(-2f32..2.0), 7),
        placement in placement(),
        recipes in some_rays(24),
    ) {
        let moved = placement.apply(moved(&mesh, &offsets));
        prop_assume!(moved.validate().is_ok());
        for code_bits in CODE_BITS {
            let mut builder = Builder::new(BuildConfig::from(code_bits));
            let mut bvh = build(&mesh, code_bits);
            prop_assert!(builder.refit(&moved, &mut bvh).is_ok());
            let shape = validate_shape(bvh.nodes(), bvh.leaf_triangles(), bvh.depth_bound());
            prop_assert!(shape.is_ok(), "{:?}", shape);
            let rebuilt = build(&moved, code_bits);
            prop_assert_eq!(bvh.bounds(), rebuilt.bounds());
            for recipe in &recipes {
                let ray = recipe.cook(&moved);
                let (a, b) = (Parts::from(&bvh).ask_tree(&ray), Parts::from(&rebuilt).ask_tree(&ray));
                prop_assert!(a.same_bits(&b), "{:?} {:#?} {:#?}", ray, a, b);
            }
        }
    }
}

#[test]
fn refitting_to_the_same_mesh_changes_no_bit() {
    for mesh in [soup(5000, 1), soup(3, 2), Mesh::default()] {
        for code_bits in CODE_BITS {
            let built = build(&mesh, code_bits);
            let mut refitted = built.clone();
            let result = Builder::new(BuildConfig::from(code_bits)).refit(&mesh, &mut refitted);
            assert!(result.is_ok());
            assert_eq!(built.nodes(), refitted.nodes());
            assert_eq!(built.leaf_triangles(), refitted.leaf_triangles());
        }
    }
}

#[test]
fn a_refused_refit_leaves_the_tree_as_it_was() {
    let mesh = icosphere(glam::Vec3::ONE, 2.0, 2);
    let built = build(&mesh, CodeBits::Bits30);
    let mut bvh = built.clone();
    let mut builder = Builder::new(BuildConfig::default());
    let mut broken = mesh.clone();
    broken.vertices[7][1] = f32::NAN;
    assert!(builder.refit(&broken, &mut bvh).is_err());
    assert!(builder.refit(&soup(10, 1), &mut bvh).is_err());
    assert_eq!(built.nodes(), bvh.nodes());
    assert_eq!(built.leaf_triangles(), bvh.leaf_triangles());
    assert_eq!(built.bounds(), bvh.bounds());
}
