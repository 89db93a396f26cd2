//! Saved hierarchies: a tree that was read answers as the one that was written, and every built tree passes validation.

use crate::wide::wide_codecs;
use proptest::prelude::*;
use slimbvh::scene::slim::{FileError, read, read_hierarchy, write, write_hierarchy};
use slimbvh::{BuildConfig, Builder, Bvh, LatticeBits, Mesh, MeshCodec, NodeCodec, Scene, Subset};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, large_mesh};
use slimbvh_tests::{CODE_BITS, build_as, cases};

/// All valid pairs of codecs, with a lattice of this step.
fn codecs(step_exponent: i32) -> Vec<(NodeCodec, MeshCodec)> {
    let mut all = vec![
        (NodeCodec::F32, MeshCodec::F32),
        (NodeCodec::Paper10, MeshCodec::F32),
        (NodeCodec::Paper10, MeshCodec::Leaf10),
    ];
    for nodes in LatticeBits::ALL.map(NodeCodec::Lattice) {
        all.push((nodes, MeshCodec::F32));
        all.push((nodes, MeshCodec::Lattice { step_exponent }));
    }
    all.extend(wide_codecs(step_exponent));
    all
}

fn saved(scene: &Scene, bvh: &Bvh) -> Vec<u8> {
    let mut bytes = Vec::new();
    match write(scene, bvh, None, &mut bytes) {
        Ok(length) => assert_eq!(length, bytes.len() as u64),
        Err(error) => panic!("{error}"),
    }
    bytes
}

fn saved_alone(bvh: &Bvh) -> Vec<u8> {
    let mut bytes = Vec::new();
    match write_hierarchy(bvh, &mut bytes) {
        Ok(length) => assert_eq!(length, bytes.len() as u64),
        Err(error) => panic!("{error}"),
    }
    bytes
}

fn scene(mesh: &Mesh) -> Scene {
    Scene {
        mesh: mesh.clone(),
        ..Scene::default()
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn what_is_saved_comes_back_in_every_codec(mesh in any_mesh(), recipes in some_rays(12), coarse in 0i32..20) {
        let step_exponent = mesh.finest_step() + coarse;
        let mut snapped = mesh.clone();
        snapped.snap(step_exponent);
        let scene = scene(&snapped);
        for (nodes, mesh) in codecs(step_exponent) {
            for code_bits in CODE_BITS {
                let config = BuildConfig { nodes, mesh, ..BuildConfig::from(code_bits) };
                let mut bvh = build_as(&snapped, config);
                prop_assert_eq!(bvh.validate_over(&snapped), Ok(()), "{:?}", config);
                let bytes = saved(&scene, &bvh);
                let mut back = match read(&bytes) {
                    Ok(back) => back,
                    Err(error) => return Err(TestCaseError::fail(format!("{config:?} {error}"))),
                };
                prop_assert_eq!(back.bvh.codecs(), bvh.codecs());
                prop_assert!(saved(&back.scene, &back.bvh) == bytes);
                for recipe in &recipes {
                    let ray = recipe.cook(&snapped);
                    prop_assert_eq!(back.bvh.closest_hit(ray), bvh.closest_hit(ray));
                    prop_assert_eq!(back.bvh.nearest_hits::<4>(&ray), bvh.nearest_hits::<4>(&ray));
                }

                // Both can be refitted.
                prop_assert!(Builder::new(config).refit(&snapped, &mut bvh).is_ok());
                prop_assert!(Builder::new(config).refit(&snapped, &mut back.bvh).is_ok());
                prop_assert_eq!(back.bvh.validate_over(&snapped), Ok(()));
                prop_assert!(saved(&scene, &back.bvh) == saved(&scene, &bvh));
            }
        }
    }

    /// A hierarchy alone comes back byte for byte, whole or reduced, and answers as the one that was written.
    #[test]
    fn a_hierarchy_alone_comes_back_in_every_codec(
        mesh in any_mesh(),
        recipes in some_rays(6),
        eye in proptest::array::uniform3(-9f32..9.0),
    ) {
        let step_exponent = mesh.finest_step();
        let mut snapped = mesh.clone();
        snapped.snap(step_exponent);
        let components = vec![0; mesh.indices.len()];
        let visible = VisibleSet {
            sides: Sides { components: &components, sides: &[1] },
            target: Target::position(eye),
            frustum: Frustum::EVERYWHERE,
        };
        for (nodes, mesh) in codecs(step_exponent) {
            let config = BuildConfig { nodes, mesh, ..BuildConfig::default() };
            let mut reduced = Bvh::default();
            prop_assert!(Builder::new(config).build_subset(&snapped, Subset::Of(visible), &mut reduced).is_ok());
            for bvh in [build_as(&snapped, config), reduced] {
                let bytes = saved_alone(&bvh);
                let back = match read_hierarchy(&bytes) {
                    Ok(back) => back,
                    Err(error) => return Err(TestCaseError::fail(format!("{config:?} {error}"))),
                };
                prop_assert!(saved_alone(&back) == bytes);
                prop_assert_eq!(back.validate_over(&snapped), Ok(()));
                for recipe in &recipes {
                    let ray = recipe.cook(&snapped);
                    prop_assert_eq!(back.closest_hit(ray), bvh.closest_hit(ray));
                }
                if !snapped.indices.is_empty() {
                    prop_assert_eq!(read(&bytes).err(), Some(FileError::NoScene));
                    let whole = saved(&scene(&snapped), &bvh);
                    prop_assert_eq!(read_hierarchy(&whole).err(), Some(FileError::HasScene));
                }
            }
        }
    }

    /// Refitted trees are sound, although their order is that of the old vertices.
    #[test]
    fn refitted_trees_are_sound(
        mesh in any_mesh(),
        offsets in proptest::collection::vec(proptest::array::uniform3(-2f32..2.0), 7),
    ) {
        let mut moved = mesh.clone();
        for (vertex, offset) in moved.vertices.iter_mut().zip(offsets.iter().cycle()) {
            *vertex = [0, 1, 2].map(|axis| vertex[axis] + vertex[axis] * offset[axis]);
        }
        prop_assume!(moved.validate().is_ok());
        for (nodes, codec) in codecs(0) {
            if matches!(codec, MeshCodec::Lattice { .. }) {
                continue;
            }
            let config = BuildConfig { nodes, mesh: codec, ..BuildConfig::default() };
            let mut bvh = build_as(&mesh, config);
            prop_assert!(Builder::new(config).refit(&moved, &mut bvh).is_ok());
            prop_assert_eq!(bvh.validate_over(&moved), Ok(()), "{:?}", config);
        }
    }

    /// A reduced tree is sound, too, over its part of the triangles.
    #[test]
    fn reduced_trees_are_sound(mesh in any_mesh(), eye in proptest::array::uniform3(-9f32..9.0)) {
        let components = vec![0; mesh.indices.len()];
        let reach = VisibleSet {
            sides: Sides { components: &components, sides: &[1] },
            target: Target::position(eye),
            frustum: Frustum::EVERYWHERE,
        };
        for (nodes, codec) in codecs(0) {
            if matches!(codec, MeshCodec::Lattice { .. }) {
                continue;
            }
            let config = BuildConfig { nodes, mesh: codec, ..BuildConfig::default() };
            let mut bvh = Bvh::default();
            prop_assert!(Builder::new(config).build_subset(&mesh, Subset::Of(reach), &mut bvh).is_ok());
            prop_assert_eq!(bvh.validate_over(&mesh), Ok(()), "{:?}", config);
            let bytes = saved(&scene(&mesh), &bvh);
            let back = read(&bytes).map(|back| back.bvh.triangle_count());
            prop_assert_eq!(back, Ok(bvh.triangle_count()));
        }
    }
}

proptest! {
    #![proptest_config(cases(8))]

    /// Enough triangles that several threads check them.
    #[test]
    fn large_trees_are_saved_like_small_ones(mesh in large_mesh()) {
        let mut snapped = mesh;
        let step_exponent = snapped.finest_step() + 9;
        snapped.snap(step_exponent);
        let scene = scene(&snapped);
        for (nodes, mesh) in codecs(step_exponent) {
            let config = BuildConfig { nodes, mesh, ..BuildConfig::default() };
            let bvh = build_as(&snapped, config);
            let bytes = saved(&scene, &bvh);
            let back = read(&bytes);
            prop_assert!(back.is_ok_and(|back| saved(&back.scene, &back.bvh) == bytes));
        }
    }
}
