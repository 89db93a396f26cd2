//! The answer does not depend on the tree: it equals brute force, bit for bit.

use proptest::prelude::*;
use slimbvh::{CodeBits, Mesh};
use slimbvh_core::{Hit, Ray};
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::random::Random;
use slimbvh_tests::rays::{RayRecipe, any_ray, some_rays};
use slimbvh_tests::scenes::real_meshes;
use slimbvh_tests::strategies::any_mesh;
use slimbvh_tests::{CODE_BITS, build, cases};

fn cook(recipes: &[RayRecipe], mesh: &Mesh) -> Vec<Ray> {
    recipes.iter().map(|recipe| recipe.cook(mesh)).collect()
}

/// Rays that are the same in every run.
fn fixed_rays(count: usize) -> Vec<RayRecipe> {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let strategy = any_ray();
    (0..count)
        .map(|_| match strategy.new_tree(&mut runner) {
            Ok(tree) => tree.current(),
            Err(reason) => panic!("{reason}"),
        })
        .collect()
}

proptest! {
    #![proptest_config(cases(700))]

    #[test]
    fn answer_does_not_depend_on_the_tree(mesh in any_mesh(), recipes in some_rays(48)) {
        let rays = cook(&recipes, &mesh);
        for code_bits in CODE_BITS {
            let bvh = build(&mesh, code_bits);
            let result = Parts::from(&bvh).compare(&rays);
            prop_assert!(result.is_ok(), "{:?}: {:#?}", code_bits, result);
        }
    }

    #[test]
    fn answer_does_not_depend_on_the_length_of_codes(mesh in any_mesh(), recipes in some_rays(32)) {
        let [short, long] = CODE_BITS.map(|code_bits| build(&mesh, code_bits));
        for ray in cook(&recipes, &mesh) {
            let (a, b) = (Parts::from(&short).ask_tree(&ray), Parts::from(&long).ask_tree(&ray));
            prop_assert!(a.same_bits(&b), "{:?} {:#?} {:#?}", ray, a, b);
        }
    }

    /// Of two equal triangles the one with the smaller index is hit, as if it were alone.
    #[test]
    fn triangles_that_are_there_twice_change_no_answer(mesh in any_mesh(), recipes in some_rays(32)) {
        let twice = Mesh {
            vertices: mesh.vertices.clone(),
            indices: [mesh.indices.as_slice(), &mesh.indices].concat(),
            ..Mesh::default()
        };
        let count = mesh.indices.len() as u32;
        for code_bits in CODE_BITS {
            let (once, twice) = (build(&mesh, code_bits), build(&twice, code_bits));
            for ray in cook(&recipes, &mesh) {
                let (a, b) = (once.closest_hit(ray), twice.closest_hit(ray));
                prop_assert_eq!(bytemuck::bytes_of(&a), bytemuck::bytes_of(&b), "{:?}", ray);
                prop_assert_eq!(once.any_hit(ray), twice.any_hit(ray), "{:?}", ray);
                let (a, b): ([Hit; 4], [Hit; 8]) = (once.nearest_hits(ray), twice.nearest_hits(ray));
                let firsts = b.iter().filter(|hit| hit.is_hit() && hit.primitive < count).count();
                let seconds = b.iter().filter(|hit| hit.is_hit() && hit.primitive >= count).count();
                prop_assert!(firsts >= seconds, "{:?} {:#?}", ray, b);
                prop_assert_eq!(a.iter().filter(|hit| hit.is_hit()).count().min(4), firsts.min(4), "{:?}", ray);
            }
        }
    }

    #[test]
    fn answer_does_not_depend_on_the_order(mesh in any_mesh(), recipes in some_rays(32), seed: u64) {
        // Triangle i of the shuffled mesh is triangle order[i] of the mesh.
        let mut order: Vec<u32> = (0..mesh.indices.len() as u32).collect();
        Random::new(seed).shuffle(&mut order);
        let shuffled = Mesh {
            indices: order.iter().map(|&i| mesh.indices[i as usize]).collect(),
            ..mesh.clone()
        };
        let (bvh, other) = (build(&mesh, CodeBits::Bits30), build(&shuffled, CodeBits::Bits30));
        for ray in cook(&recipes, &mesh) {
            let hit = bvh.closest_hit(ray);
            let mut moved = other.closest_hit(ray);
            // One of two hits at t = 0 may have t = -0.
            prop_assert_eq!(hit.t, moved.t);
            prop_assert_eq!(bvh.any_hit(ray), other.any_hit(ray));
            if moved.is_hit() {
                moved.primitive = order[moved.primitive as usize];
            }

            // Among equal t the smaller index comes first. The shuffle changes indices, so look for the hit in the list.
            let equals: [Hit; 64] = bvh.nearest_hits(ray);
            let is_full = equals[63].t == hit.t;
            prop_assert!(equals.contains(&moved) || is_full, "{:?} {:?} {:?}", ray, hit, moved);
        }
    }
}

#[test]
fn generated_meshes_answer_as_brute_force_does() {
    let recipes = fixed_rays(300);
    for (name, mesh) in crate::meshes::generated() {
        // Brute force over the default scene takes long.
        let count = (2_000_000 / mesh.indices.len()).clamp(30, 300);
        let rays = cook(&recipes[..count], &mesh);
        for code_bits in CODE_BITS {
            let bvh = build(&mesh, code_bits);
            match Parts::from(&bvh).compare(&rays) {
                Ok(hit_count) => {
                    assert!(10 * hit_count > count, "{name}: {hit_count} of {count}");
                }
                Err(disagreement) => panic!("{name}: {disagreement:#?}"),
            }
        }
    }
}

#[test]
fn real_meshes_answer_as_brute_force_does() {
    let names = [
        "dragon.ply",
        "armadillo.off",
        "sponza.obj",
        "bunny00.off",
        "refined_elephant.off",
    ];
    let recipes = fixed_rays(400);
    for (name, mesh) in real_meshes(&names) {
        let count = (20_000_000 / mesh.indices.len()).clamp(40, 400);
        let rays = cook(&recipes[..count], &mesh);
        for code_bits in CODE_BITS {
            let bvh = build(&mesh, code_bits);
            let shape = slimbvh_tests::validate::validate(&bvh, &mesh, code_bits);
            assert!(shape.is_ok(), "{name}: {shape:?}");
            let result = Parts::from(&bvh).compare(&rays);
            assert!(result.is_ok_and(|hit_count| hit_count > 10), "{name}");
        }
    }
}
