//! Clustered trees keep the promises of all trees.

use proptest::prelude::*;
use slimbvh::generate::{soup, terrain};
use slimbvh::{
    BuildConfig, Builder, Bvh, CodeBits, LatticeBits, Mesh, NodeCodec, Subset, TreeKind,
};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::cluster::depth_bound;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::orientation::Target;
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, mesh_of};
use slimbvh_tests::validate::{Fault, Shape, validate_shape};
use slimbvh_tests::{CODE_BITS, build, build_as, cases};

fn config(code_bits: CodeBits) -> BuildConfig {
    BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::from(code_bits)
    }
}

fn clustered(mesh: &Mesh, code_bits: CodeBits) -> Bvh {
    build_as(mesh, config(code_bits))
}

/// Checks a tree's shape, and that it holds each triangle once.
fn check(bvh: &Bvh, mesh: &Mesh) -> Result<Shape, Fault> {
    let shape = validate_shape(bvh.nodes(), bvh.leaf_triangles(), bvh.depth_bound())?;
    assert_eq!(bvh.depth_bound(), depth_bound(bvh.triangle_count() as u32));
    assert_eq!(bvh.validate(), Ok(()));
    let mut primitives: Vec<u32> = bvh.leaf_triangles().iter().map(|t| t.primitive).collect();
    primitives.sort_unstable();
    assert!(primitives.into_iter().eq(0..mesh.indices.len() as u32));
    Ok(shape)
}

fn bytes(bvh: &Bvh) -> (&[u8], &[u8]) {
    (
        bytemuck::cast_slice(bvh.nodes()),
        bytemuck::cast_slice(bvh.leaf_triangles()),
    )
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn tree_invariants(mesh in any_mesh()) {
        for code_bits in CODE_BITS {
            let shape = check(&clustered(&mesh, code_bits), &mesh);
            prop_assert!(shape.is_ok(), "{:?}: {:?}", code_bits, shape);
        }
    }

    #[test]
    fn answer_does_not_depend_on_the_tree(mesh in any_mesh(), recipes in some_rays(48)) {
        let rays: Vec<_> = recipes.iter().map(|recipe| recipe.cook(&mesh)).collect();
        for code_bits in CODE_BITS {
            let bvh = clustered(&mesh, code_bits);
            let result = Parts::from(&bvh).compare(&rays);
            prop_assert!(result.is_ok(), "{:?}: {:#?}", code_bits, result);
            let radix = build(&mesh, code_bits);
            for ray in &rays {
                let (a, b) = (Parts::from(&bvh).ask_tree(ray), Parts::from(&radix).ask_tree(ray));
                prop_assert!(a.same_bits(&b), "{:?} {:#?} {:#?}", ray, a, b);
            }
        }
    }

    #[test]
    fn coded_nodes_answer_as_plain_ones_do(mesh in any_mesh(), recipes in some_rays(16)) {
        let plain = clustered(&mesh, CodeBits::Bits30);
        for nodes in [NodeCodec::Paper10, NodeCodec::Lattice(LatticeBits::Q4), NodeCodec::Lattice(LatticeBits::Q10)] {
            let coded = build_as(&mesh, BuildConfig { nodes, ..config(CodeBits::Bits30) });
            let decoded = coded.decoded();
            prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
            prop_assert_eq!(coded.validate(), Ok(()));
            for recipe in &recipes {
                let ray = recipe.cook(&mesh);
                let (a, b) = (coded.closest_hit(ray), plain.closest_hit(ray));
                prop_assert_eq!(bytemuck::bytes_of(&a), bytemuck::bytes_of(&b), "{:?} {:?}", nodes, ray);
                prop_assert_eq!(coded.any_hit(ray), plain.any_hit(ray));
            }
        }
    }
}

#[test]
fn every_small_size_and_every_edge_of_a_block() {
    for count in (0..=70).chain([4095, 4096, 4097, 8191, 8193, 16_385]) {
        let mesh = soup(count, 11);
        let shape = check(&clustered(&mesh, CodeBits::Bits30), &mesh);
        assert!(shape.is_ok(), "{count}: {shape:?}");
    }
}

#[test]
fn thread_count_changes_no_bit() {
    let equal = mesh_of(&vec![[[0.5f32; 3], [1.0; 3], [0.75; 3]]; 20_000]);
    for mesh in [soup(50_000, 1), terrain(1.0, 100, 2), equal, soup(3, 3)] {
        let build_with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.map(|pool| pool.install(|| clustered(&mesh, CodeBits::Bits30)))
        };
        let (Ok(one), Ok(more), Ok(many)) = (build_with(1), build_with(2), build_with(7)) else {
            panic!("no threads");
        };
        assert!(bytes(&one) == bytes(&more) && bytes(&one) == bytes(&many));
    }
}

#[test]
fn buffers_are_used_again_and_a_refit_keeps_the_tree() {
    let mut builder = Builder::new(config(CodeBits::Bits30));
    let mut bvh = Bvh::default();
    for mesh in [
        soup(30_000, 1),
        soup(LEAF_SIZE + 1, 2),
        Mesh::default(),
        soup(3, 4),
        soup(40_000, 5),
        soup(7000, 6),
    ] {
        assert!(builder.build_into(&mesh, &mut bvh).is_ok());
        let fresh = clustered(&mesh, CodeBits::Bits30);
        assert!(bytes(&bvh) == bytes(&fresh), "{}", mesh.indices.len());
        assert!(builder.refit(&mesh, &mut bvh).is_ok());
        assert!(bytes(&bvh) == bytes(&fresh), "{}", mesh.indices.len());
    }
}

#[test]
fn a_set_is_the_same_sorted_alone() {
    let mesh = slimbvh::generate::icosphere([0.5, 0.0, 0.0].into(), 1.0, 4);
    let components = vec![0; mesh.indices.len()];
    let reach = || VisibleSet {
        sides: Sides {
            components: &components,
            sides: &[1],
        },
        target: Target::position([3.0, 2.0, 1.0]),
        frustum: Frustum::EVERYWHERE,
    };
    let mut builder = Builder::new(config(CodeBits::Bits30));
    let (mut among_all, mut alone) = (Bvh::default(), Bvh::default());
    assert!(builder.sort(&mesh).is_ok());
    builder.build_sorted(&mesh, Subset::Of(reach()), &mut among_all);
    let built = builder.build_subset(&mesh, Subset::Of(reach()), &mut alone);
    assert!(built.is_ok());
    assert!(bytes(&among_all) == bytes(&alone));
    assert!(alone.triangle_count() < mesh.indices.len());
    let shape = validate_shape(alone.nodes(), alone.leaf_triangles(), alone.depth_bound());
    assert!(shape.is_ok(), "{shape:?}");
}

/// Triangles that grow along a line: only the first of all pairs is cheaper than its neighbours.
fn growing(factor: f32, count: i32) -> Mesh {
    let triangle = |i: i32| {
        let x = factor.powi(i);
        [[x, 0.0, 0.0], [x * factor, 0.0, 0.0], [x, x * 0.1, 0.0]]
    };
    mesh_of(&(0..count).map(triangle).collect::<Vec<_>>())
}

#[test]
fn sizes_that_grow_all_along_the_curve_keep_to_the_bound() {
    for (factor, count) in [(1.01, 3000), (1.001, 20_000), (1.5, 150), (2.0, 80)] {
        let mesh = growing(factor, count);
        for code_bits in CODE_BITS {
            let bvh = clustered(&mesh, code_bits);
            let shape = check(&bvh, &mesh);
            assert!(shape.is_ok(), "{factor}, {count}: {shape:?}");
        }
    }
}

#[test]
fn points_lines_and_copies_make_sound_trees() {
    let point = [[0.25f32; 3]; 3];
    let line = |i: i16| [[0.0; 3], [f32::from(i), 0.0, 0.0], [0.0; 3]];
    let far = [[1e30f32, 0.0, 0.0], [1e30, 1.0, 0.0], [1e30, 0.0, 1.0]];
    let mixed: Vec<_> = (0..3000)
        .map(|i| match i % 3 {
            0 => point,
            1 => line(i),
            _ => far,
        })
        .collect();
    for triangles in [vec![point; 5000], (0..2000).map(line).collect(), mixed] {
        let mesh = mesh_of(&triangles);
        let shape = check(&clustered(&mesh, CodeBits::Bits63), &mesh);
        assert!(shape.is_ok(), "{shape:?}");
    }
}

/// The negative control: the check that the tests above use finds planted faults.
#[test]
fn faults_are_found() {
    let mesh = soup(500, 9);
    let bvh = clustered(&mesh, CodeBits::Bits30);
    let mut nodes = bvh.nodes().to_vec();
    nodes[0].planes[1][2] = nodes[0].planes[1][2].next_down();
    let shape = validate_shape(&nodes, bvh.leaf_triangles(), bvh.depth_bound());
    assert!(matches!(shape, Err(Fault::BoxTooSmall { .. })), "{shape:?}");
    let shallow = validate_shape(bvh.nodes(), bvh.leaf_triangles(), 4);
    assert!(matches!(shallow, Err(Fault::TooDeep { bound: 4 })));
    let mut triangles = bvh.leaf_triangles().to_vec();
    triangles.swap(0, 499);
    assert!(validate_shape(bvh.nodes(), &triangles, bvh.depth_bound()).is_err());
}

/// The purpose of clustered trees: rays are expected to meet fewer boxes.
#[test]
fn rays_are_expected_to_meet_less() {
    for (name, mesh) in crate::meshes::generated() {
        let cost = |bvh: &Bvh| bvh.sah_cost();
        let (radix, clustered) = (
            cost(&build(&mesh, CodeBits::Bits30)),
            cost(&clustered(&mesh, CodeBits::Bits30)),
        );
        assert!(
            clustered <= 1.02 * radix,
            "{name}: {clustered} against {radix}"
        );
    }
}
