//! Kernels from `bounds` to `snap`, each alone: its outputs equal the results of core's function, to the bit.

use super::chain::{Chain, is_short};
use super::kernels::groups;
use bytemuck::{Zeroable, bytes_of, cast_slice};
use proptest::prelude::*;
use slimbvh::gpu::{Gpu, Kernel};
use slimbvh::{CodeBits, Mesh};
use slimbvh_core::LeafTriangle;
use slimbvh_core::morton::MortonGrid;
use slimbvh_tests::gpu::{Dispatch, answers, done, gpu};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::large_mesh;
use slimbvh_tests::{CODE_BITS, cases};

fn check_bounds(gpu: &Gpu, mesh: &Mesh, chain: &Chain, code_bits: CodeBits) -> Result<(), String> {
    let (vertices, indices) = (cast_slice(&mesh.vertices), cast_slice(&mesh.indices));
    let nothing = vec![[0f32; 6]; chain.blocks.len()];
    let stored = Dispatch {
        kernel: Kernel::bounds,
        group_count: chain.blocks.len() as u32,
        uniforms: &[],
        reads: &[vertices, indices],
        outputs: &[cast_slice(&nothing)],
    }
    .run(gpu);
    same_bits(&answers::<[f32; 6]>(&stored[0]), &chain.blocks)?;
    let cell_bits = if is_short(code_bits) { 10 } else { 21 };
    let stored = Dispatch {
        kernel: Kernel::bounds_grid,
        group_count: 1,
        uniforms: &[&[cell_bits, 0, 0, 0]],
        reads: &[&stored[0]],
        outputs: &[&[0; size_of::<MortonGrid>()], &[0; 4], &[0; 24]],
    }
    .run(gpu);
    same_bits(&answers::<MortonGrid>(&stored[0]), &[chain.grid])?;
    same_bits(&answers::<i32>(&stored[1]), &[chain.exponent])?;
    same_bits(&answers::<[f32; 6]>(&stored[2]), &[chain.scene])
}

fn check_codes(gpu: &Gpu, mesh: &Mesh, chain: &Chain, code_bits: CodeBits) -> Result<(), String> {
    let (vertices, indices) = (cast_slice(&mesh.vertices), cast_slice(&mesh.indices));
    let (morton, snap) = if is_short(code_bits) {
        (Kernel::morton_30, Kernel::snap_30)
    } else {
        (Kernel::morton_63, Kernel::snap_63)
    };
    let group_count = groups(mesh.indices.len());
    let stored = Dispatch {
        kernel: morton,
        group_count,
        uniforms: &[],
        reads: &[bytes_of(&chain.grid), vertices, indices],
        outputs: &[&vec![0; 4 * chain.items.len()]],
    }
    .run(gpu);
    same_bits(&answers::<u32>(&stored[0]), &chain.items)?;
    let leaves = vec![LeafTriangle::zeroed(); chain.triangles.len()];
    let stored = Dispatch {
        kernel: snap,
        group_count,
        uniforms: &[&chain.exponent_uniform()],
        reads: &[vertices, indices, cast_slice(&chain.sorted)],
        outputs: &[cast_slice(&leaves), &vec![0; 4 * chain.codes.len()]],
    }
    .run(gpu);
    same_bits(&answers::<LeafTriangle>(&stored[0]), &chain.triangles)?;
    same_bits(&answers::<u32>(&stored[1]), &chain.codes)
}

/// Snaps triangles that are already in leaf order and have new corners.
fn check_again(gpu: &Gpu, mesh: &Mesh, chain: &Chain, seed: u64) -> Result<(), String> {
    let mut expected = chain.triangles.clone();
    Random::new(seed).shuffle(&mut expected);
    let moved: Vec<LeafTriangle> = expected
        .iter()
        .map(|leaf| LeafTriangle {
            vertices: [7.0; 9],
            ..*leaf
        })
        .collect();
    let stored = Dispatch {
        kernel: Kernel::snap_again,
        group_count: groups(mesh.indices.len()),
        uniforms: &[&chain.exponent_uniform()],
        reads: &[cast_slice(&mesh.vertices), cast_slice(&mesh.indices)],
        outputs: &[cast_slice(&moved)],
    }
    .run(gpu);
    same_bits(&answers::<LeafTriangle>(&stored[0]), &expected)
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn bounds_codes_and_leaves_are_those_of_core(mesh in large_mesh(), seed: u64) {
        let Some(gpu) = gpu() else { return Ok(()) };
        for code_bits in CODE_BITS {
            let Some(chain) = Chain::new(&mesh, code_bits) else { continue };
            prop_assert_eq!(check_bounds(gpu, &mesh, &chain, code_bits), Ok(()));
            prop_assert_eq!(check_codes(gpu, &mesh, &chain, code_bits), Ok(()));
            prop_assert_eq!(check_again(gpu, &mesh, &chain, seed), Ok(()));
        }
    }
}

#[test]
fn one_moved_corner_is_found() {
    let Some(gpu) = gpu() else { return };
    let sound = slimbvh::generate::soup(3000, 3);
    for code_bits in CODE_BITS {
        let chain = Chain::new(&sound, code_bits).unwrap();
        done(check_bounds(gpu, &sound, &chain, code_bits));
        done(check_codes(gpu, &sound, &chain, code_bits));
        done(check_again(gpu, &sound, &chain, 1));

        // The negative control: a box grows, a triangle changes by one bit.
        let mut moved = sound.clone();
        moved.vertices[500][1] += 10.0;
        assert!(check_bounds(gpu, &moved, &chain, code_bits).is_err());
        assert!(check_codes(gpu, &moved, &chain, code_bits).is_err());
        let x = &mut moved.vertices[500][1];
        *x = f32::from_bits(sound.vertices[500][1].to_bits() ^ 1);
        assert!(check_codes(gpu, &moved, &chain, code_bits).is_err());
        assert!(check_again(gpu, &moved, &chain, 1).is_err());
    }
}
