//! Memory: repeated builds do not grow it, and meshes that are too large are errors before any allocation.

use crate::wide::wide_codecs;
use slimbvh::generate::{icosphere, soup, terrain};
use slimbvh::{BuildConfig, Builder, Bvh, LatticeBits, Mesh, MeshCodec, MeshError, NodeCodec};
use slimbvh_core::{MAX_TRIANGLES, Ray};

/// A builder and a hierarchy hold the same memory each time that they return to the same mesh.
#[test]
fn thousands_of_builds_in_a_row_take_no_more_memory() {
    let step_exponent = -12;
    let mut meshes = vec![soup(300, 1), icosphere(glam::Vec3::ONE, 2.0, 2), soup(7, 2)];
    meshes.push(Mesh::default());
    for mesh in &mut meshes {
        mesh.snap(step_exponent);
        mesh.normals.clear();
    }
    let lattice = MeshCodec::Lattice { step_exponent };
    let others = [
        (NodeCodec::F32, MeshCodec::F32),
        (NodeCodec::Paper10, MeshCodec::Leaf10),
        (NodeCodec::Lattice(LatticeBits::Q10), MeshCodec::F32),
        (NodeCodec::Lattice(LatticeBits::Q10), lattice),
    ];
    for (nodes, mesh) in others.into_iter().chain(wide_codecs(step_exponent)) {
        let mut builder = Builder::new(BuildConfig {
            nodes,
            mesh,
            ..BuildConfig::default()
        });
        let mut bvh = Bvh::default();
        // Bytes of the builder and of the hierarchy, by mesh.
        let mut held = vec![[0; 2]; meshes.len()];
        for build in 0..2000 {
            let which = build % meshes.len();
            assert!(builder.build_into(&meshes[which], &mut bvh).is_ok());
            assert!(builder.refit(&meshes[which], &mut bvh).is_ok());
            let now = [builder.scratch_bytes(), bvh.held_bytes()];
            if build < 2 * meshes.len() {
                held[which] = now;
            }
            assert_eq!(now, held[which], "build {build}, {nodes:?}, {mesh:?}");
        }
    }
}

/// Run by hand: `cargo test --release -p slimbvh-tests --test all -- --ignored fifty_million`.
#[test]
#[ignore = "takes 10 GB and a minute"]
fn fifty_million_triangles_are_built_and_traced() {
    let mesh = terrain(10.0, 5000, 3);
    assert_eq!(mesh.indices.len(), 50_000_000);
    let built = Builder::new(BuildConfig::default()).build(&mesh);
    let bvh = match built {
        Ok(bvh) => bvh,
        Err(error) => panic!("{error}"),
    };
    assert_eq!(bvh.validate(), Ok(()));
    assert_eq!(bvh.triangle_count(), mesh.indices.len());
    for i in 0..10_000u16 {
        let [x, z] = [i % 100, i / 100].map(|i| 0.0987 * f32::from(i) - 4.9);
        let hit = bvh.closest_hit(Ray::new([x, 100.0, z], [0.0, -1.0, 0.0]));
        assert!(hit.is_hit() && (97.5..=100.0).contains(&hit.t), "{hit:?}");
    }
}

#[test]
fn a_mesh_beyond_the_limit_is_refused_before_memory_is_taken() {
    let limit = MAX_TRIANGLES as usize;
    let triangle_count = limit + 1;
    // Untouched zero pages take no memory.
    let mesh = Mesh {
        vertices: vec![[0.0; 3]],
        indices: vec![[0; 3]; triangle_count],
        ..Mesh::default()
    };
    let refused = Err(MeshError::TooManyTriangles {
        triangle_count,
        limit,
    });
    assert_eq!(mesh.validate(), refused);
    let mut builder = Builder::new(BuildConfig::default());
    let mut bvh = Bvh::default();
    assert_eq!(builder.build_into(&mesh, &mut bvh).map(drop), refused);
    assert_eq!((builder.scratch_bytes(), bvh.held_bytes()), (0, 0));
}
