//! Same input, same bits, for any number of threads and after any other build.

use proptest::prelude::*;
use slimbvh::generate::{soup, sphere_flake, terrain};
use slimbvh::{BuildConfig, Builder, Bvh, CodeBits, Mesh};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_tests::strategies::{any_mesh, mesh_of};
use slimbvh_tests::{CODE_BITS, build, cases};

fn bytes(bvh: &Bvh) -> (Vec<u8>, Vec<u8>) {
    (
        bytemuck::cast_slice(bvh.nodes()).to_vec(),
        bytemuck::cast_slice(bvh.leaf_triangles()).to_vec(),
    )
}

fn build_with_threads(mesh: &Mesh, code_bits: CodeBits, thread_count: usize) -> Bvh {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(thread_count)
        .build();
    match pool {
        Ok(pool) => pool.install(|| build(mesh, code_bits)),
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn thread_count_changes_no_bit() {
    let equal = mesh_of(&vec![[[0.5f32; 3], [1.0; 3], [0.75; 3]]; 40_000]);
    for mesh in [
        soup(50_000, 1),
        terrain(1.0, 100, 2),
        equal,
        soup(3, 3),
        Mesh::default(),
    ] {
        for code_bits in CODE_BITS {
            let one = bytes(&build_with_threads(&mesh, code_bits, 1));
            for thread_count in [2, 3, 7] {
                let more = bytes(&build_with_threads(&mesh, code_bits, thread_count));
                assert!(one == more, "{thread_count} threads, {code_bits:?}");
            }
        }
    }
}

#[test]
fn builder_buffers_are_reused() {
    let meshes = [
        soup(30_000, 1),
        soup(LEAF_SIZE + 1, 2),
        Mesh::default(),
        sphere_flake(2, 2),
        soup(1, 4),
        soup(40_000, 5),
        soup(7000, 6),
    ];
    for code_bits in CODE_BITS {
        let mut builder = Builder::new(BuildConfig::from(code_bits));
        let mut bvh = Bvh::default();
        for mesh in &meshes {
            assert!(builder.build_into(mesh, &mut bvh).is_ok());
            let fresh = build(mesh, code_bits);
            assert!(
                bytes(&bvh) == bytes(&fresh),
                "{} triangles",
                mesh.indices.len()
            );
            assert_eq!(bvh.bounds(), fresh.bounds());
            assert_eq!(bvh.scene_exponent(), fresh.scene_exponent());
            assert_eq!(bvh.depth_bound(), fresh.depth_bound());
        }

        // After a refused mesh the last tree is unchanged.
        let before = bytes(&bvh);
        let mut broken = soup(10, 1);
        broken.vertices[4][1] = f32::NAN;
        assert!(builder.build_into(&broken, &mut bvh).is_err());
        broken = soup(10, 1);
        broken.indices[3][2] = 30;
        assert!(builder.build_into(&broken, &mut bvh).is_err());
        assert!(bytes(&bvh) == before);
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn building_again_changes_no_bit(a in any_mesh(), b in any_mesh()) {
        for code_bits in CODE_BITS {
            let mut builder = Builder::new(BuildConfig::from(code_bits));
            let first = builder.build(&a).map(|bvh| bytes(&bvh));
            prop_assert!(builder.build(&b).is_ok());
            prop_assert!(first == builder.build(&a).map(|bvh| bytes(&bvh)));
        }
    }
}

#[test]
fn batches_answer_as_single_rays_do() {
    let bvh = build(&soup(3000, 2), CodeBits::Bits30);
    let mut random = slimbvh_tests::random::Random::new(6);
    let mut hits = vec![slimbvh_core::Hit::MISS; 7];
    let mut found = vec![true; 3];
    for count in [0, 1, 511, 512, 513, 5000] {
        let rays: Vec<_> = (0..count)
            .map(|_| slimbvh_core::Ray::new(random.point().to_array(), random.point().to_array()))
            .collect();
        bvh.closest_hits(&rays, &mut hits);
        let expected: Vec<_> = rays.iter().map(|ray| bvh.closest_hit(ray)).collect();
        assert_eq!(
            bytemuck::cast_slice::<_, u8>(&hits),
            bytemuck::cast_slice::<_, u8>(&expected)
        );
        bvh.any_hits(&rays, &mut found);
        assert!(
            expected
                .iter()
                .map(slimbvh_core::Hit::is_hit)
                .eq(found.iter().copied())
        );
    }
}
