//! Whole builds and refits equal the CPU's to the bit, after any other build.

use super::SIZES;
use proptest::prelude::*;
use slimbvh::generate::soup;
use slimbvh::gpu::{self, GpuError};
use slimbvh::{BuildConfig, CodeBits, Mesh, RefitError};
use slimbvh_tests::gpu::{done, gpu};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::strategies::{any_mesh, large_mesh, mesh_of};
use slimbvh_tests::{CODE_BITS, build, cases};

/// Records builds of all meshes into one frame, waits for it, and downloads the hierarchies.
pub fn build_all(gpu: &gpu::Gpu, meshes: &[Mesh], code_bits: CodeBits) -> Vec<slimbvh::Bvh> {
    let mut builder = gpu::Builder::new(BuildConfig::from(code_bits));
    let mut frame = gpu.frame();
    let mut hierarchies = Vec::new();
    for mesh in meshes {
        let mesh = done(gpu::Mesh::upload(gpu, mesh));
        let mut bvh = gpu::Bvh::new();
        done(builder.build(&mut frame, &mesh, &mut bvh));
        hierarchies.push(bvh);
    }
    done(done(frame.submit()).wait());
    let download = |bvh: &gpu::Bvh| done(bvh.download(gpu));
    hierarchies.iter().map(download).collect()
}

/// Compares all lists of a hierarchy.
pub fn same_tree(gpu: &slimbvh::Bvh, cpu: &slimbvh::Bvh) -> Result<(), String> {
    same_bits(gpu.nodes(), cpu.nodes())?;
    same_bits(gpu.leaf_triangles(), cpu.leaf_triangles())?;
    let bounds = |bvh: &slimbvh::Bvh| bvh.bounds().map(|b| super::chain::numbers(&b));
    same_bits(bounds(gpu).as_slice(), bounds(cpu).as_slice())?;
    let numbers = |bvh: &slimbvh::Bvh| [bvh.scene_exponent(), bvh.depth_bound() as i32];
    same_bits(&numbers(gpu), &numbers(cpu))
}

fn check(gpu: &gpu::Gpu, meshes: &[Mesh], code_bits: CodeBits) -> Result<(), String> {
    for (built, mesh) in build_all(gpu, meshes, code_bits).iter().zip(meshes) {
        let count = mesh.indices.len();
        same_tree(built, &build(mesh, code_bits))
            .map_err(|fault| format!("{count} triangles, {code_bits:?}: {fault}"))?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn hierarchies_are_those_of_the_cpu(meshes in proptest::collection::vec(any_mesh(), 8)) {
        let Some(gpu) = gpu() else { return Ok(()) };
        for code_bits in CODE_BITS {
            prop_assert_eq!(check(gpu, &meshes, code_bits), Ok(()));
        }
    }

    #[test]
    fn refitted_hierarchies_are_those_of_the_cpu(mesh in large_mesh(), factors in proptest::array::uniform3(-3f32..3.0)) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let mut moved = mesh.clone();
        for (vertex, i) in moved.vertices.iter_mut().zip(0..) {
            *vertex = [0, 1, 2].map(|axis| vertex[axis] * factors[(axis + i) % 3]);
        }
        for code_bits in CODE_BITS {
            let mut builder = gpu::Builder::new(BuildConfig::from(code_bits));
            let mut bvh = gpu::Bvh::new();
            let mut frame = gpu.frame();
            let places = [&mesh, &moved].map(|mesh| done(gpu::Mesh::upload(gpu, mesh)));
            done(builder.build(&mut frame, &places[0], &mut bvh));
            done(builder.refit(&mut frame, &places[1], &mut bvh));
            done(frame.submit());
            let mut expected = build(&mesh, code_bits);
            done(slimbvh::Builder::new(BuildConfig::from(code_bits)).refit(&moved, &mut expected));
            prop_assert_eq!(same_tree(&done(bvh.download(gpu)), &expected), Ok(()));
        }
    }
}

#[test]
fn hierarchies_of_any_size_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let mut meshes = vec![Mesh::default()];
    meshes.extend(SIZES.map(|count| soup(count, 3)));
    for code_bits in CODE_BITS {
        done(check(gpu, &meshes, code_bits));
    }
}

#[test]
fn generated_meshes_have_the_hierarchies_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let meshes: Vec<Mesh> = crate::meshes::generated()
        .into_iter()
        .map(|m| m.1)
        .collect();
    for code_bits in CODE_BITS {
        done(check(gpu, &meshes, code_bits));
    }
}

#[test]
fn a_hundred_thousand_equal_codes_are_told_apart_by_their_places() {
    let Some(gpu) = gpu() else { return };
    // Boxes of different sizes around one centre.
    let triangles: Vec<_> = (1..=100_000)
        .map(|i| i as f32 / 100_000.0)
        .map(|s| [[-s, -s, -s], [s, s, s], [0.0, s / 2.0, s / 4.0]])
        .collect();
    let meshes = [
        mesh_of(&triangles),
        mesh_of(&vec![[[0.5, 1.0, 2.0]; 3]; 100_000]),
    ];
    for code_bits in CODE_BITS {
        done(check(gpu, &meshes, code_bits));
    }
}

#[test]
fn what_was_built_before_changes_no_bit() {
    let Some(gpu) = gpu() else { return };
    let meshes = [
        soup(30_000, 1),
        soup(5, 2),
        Mesh::default(),
        soup(1, 4),
        soup(40_000, 5),
        soup(4, 8),
        soup(7000, 6),
        Mesh::default(),
    ];
    for code_bits in CODE_BITS {
        let mut builder = gpu::Builder::new(BuildConfig::from(code_bits));
        let mut bvh = gpu::Bvh::new();
        for mesh in &meshes {
            // One frame builds each mesh, builds it again, and refits it.
            let uploaded = done(gpu::Mesh::upload(gpu, mesh));
            let expected = build(mesh, code_bits);
            let mut frame = gpu.frame();
            done(builder.build(&mut frame, &uploaded, &mut bvh));
            done(frame.submit());
            done(same_tree(&done(bvh.download(gpu)), &expected));
            let mut frame = gpu.frame();
            done(builder.build(&mut frame, &uploaded, &mut bvh));
            done(builder.refit(&mut frame, &uploaded, &mut bvh));
            done(frame.submit());
            done(same_tree(&done(bvh.download(gpu)), &expected));
            let counts = [expected.node_count(), mesh.indices.len()];
            assert_eq!(
                done(bvh.read_counts(gpu)).map(|count| count as usize),
                counts
            );
            assert_eq!(bvh.mesh_triangle_count() as usize, mesh.indices.len());
        }
    }
}

#[test]
fn threads_share_a_gpu() {
    let Some(gpu) = gpu() else { return };
    std::thread::scope(|scope| {
        for seed in 0..4 {
            scope.spawn(move || {
                for count in [10, 300, 2000] {
                    let meshes: Vec<Mesh> = (0..8).map(|i| soup(count + i, seed)).collect();
                    done(check(gpu, &meshes, CODE_BITS[seed as usize % 2]));
                }
            });
        }
    });
}

#[test]
fn only_the_mesh_that_was_built_over_is_refitted() {
    let Some(gpu) = gpu() else { return };
    let [mesh, other] = [soup(100, 1), soup(101, 1)];
    let uploads = [&mesh, &other].map(|mesh| done(gpu::Mesh::upload(gpu, mesh)));
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    let unbuilt = builder.refit(&mut frame, &uploads[0], &mut bvh);
    assert!(
        matches!(unbuilt, Err(GpuError::Unfit { .. })),
        "{unbuilt:?}"
    );
    assert!(bvh.download(gpu).is_err() && bvh.read_counts(gpu).is_err());
    done(builder.build(&mut frame, &uploads[0], &mut bvh));
    let refused = builder.refit(&mut frame, &uploads[1], &mut bvh);
    let fault = RefitError::TriangleCount {
        triangle_count: 101,
        expected: 100,
    };
    assert_eq!(refused, Err(GpuError::Refit(fault)));

    // The frame continues as if the refused call had not been made.
    done(frame.submit());
    let expected = build(&mesh, CodeBits::Bits30);
    done(same_tree(&done(bvh.download(gpu)), &expected));
}

#[test]
fn one_moved_bit_of_a_mesh_is_found() {
    let Some(gpu) = gpu() else { return };
    let sound = soup(2000, 9);
    let mut moved = sound.clone();
    let x = &mut moved.vertices[3000][2];
    *x = f32::from_bits(x.to_bits() ^ 1);
    for code_bits in CODE_BITS {
        let built = build_all(gpu, &[moved.clone()], code_bits);
        done(same_tree(&built[0], &build(&moved, code_bits)));
        assert!(same_tree(&built[0], &build(&sound, code_bits)).is_err());
    }
}
