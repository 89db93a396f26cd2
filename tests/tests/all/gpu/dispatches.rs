//! How many dispatches a build takes. Each costs a few microseconds even where it has little to do.

use slimbvh::gpu::{self, Gpu};
use slimbvh::{BuildConfig, CodeBits, Mesh, MeshCodec, NodeCodec, WideStore};
use slimbvh_tests::CODE_BITS;
use slimbvh_tests::gpu::{done, gpu};

/// The dispatches of each stage of a build, or of a build and a refit, over equal triangles. They are recorded only.
fn dispatches(
    gpu: &Gpu,
    triangle_count: u32,
    config: impl Into<BuildConfig>,
    refits: bool,
) -> Vec<(&'static str, u32)> {
    let mesh = Mesh {
        vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 3.0]],
        indices: vec![[0, 1, 2]; triangle_count as usize],
        ..Mesh::default()
    };
    let mesh = done(gpu::Mesh::upload(gpu, &mesh));
    let mut builder = gpu::Builder::new(config.into());
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    // The first build grows buffers, which drops the program of its sort.
    done(builder.build(&mut frame, &mesh, &mut bvh));
    done(builder.build(&mut frame, &mesh, &mut bvh));
    let built = builder.work().count();
    if refits {
        done(builder.refit(&mut frame, &mesh, &mut bvh));
    }
    let work = builder.work().skip(if refits { built } else { 0 });
    work.map(|work| (work.stage, work.dispatch_count)).collect()
}

fn sum(stages: &[(&str, u32)]) -> u32 {
    stages.iter().map(|stage| stage.1).sum()
}

#[test]
fn a_gpu_build_of_871_414_triangles_takes_24_dispatches() {
    let Some(gpu) = gpu() else { return };
    let stages = |sort| {
        [
            ("bounds", 2),
            ("morton", 1),
            ("sort", sort),
            ("snap", 1),
            ("topology", 4),
            ("refit", 4),
        ]
    };
    let short = dispatches(gpu, 871_414, CodeBits::Bits30, false);
    assert_eq!((short.as_slice(), sum(&short)), (&stages(12)[..], 24));
    let long = dispatches(gpu, 871_414, CodeBits::Bits63, false);
    assert_eq!((long.as_slice(), sum(&long)), (&stages(24)[..], 36));
}

#[test]
fn a_gpu_refit_of_871_414_triangles_takes_8_dispatches() {
    let Some(gpu) = gpu() else { return };
    for code_bits in CODE_BITS {
        let stages = dispatches(gpu, 871_414, code_bits, true);
        assert_eq!(stages, [("bounds", 2), ("snap", 1), ("refit", 5)]);
    }
}

/// Wide nodes cost five dispatches more than plain ones, over triangles on the lattice seven, and eight where these share corners;
/// refits one, and five or six.
#[test]
fn wide_nodes_take_5_dispatches_more_and_over_triangles_on_the_lattice_7_or_8() {
    let Some(gpu) = gpu() else { return };
    let lattice = MeshCodec::Lattice { step_exponent: -20 };
    for (store, mesh, [wide, encode], [wide_again, encode_again]) in [
        (WideStore::Full, MeshCodec::F32, [4, 1], [0, 1]),
        (WideStore::Exact, MeshCodec::F32, [4, 1], [0, 1]),
        (WideStore::Exact, lattice, [5, 2], [3, 2]),
        (WideStore::Packed, lattice, [6, 2], [4, 2]),
    ] {
        let config = BuildConfig {
            nodes: NodeCodec::Wide(store),
            mesh,
            ..BuildConfig::from(CodeBits::Bits30)
        };
        let stages = dispatches(gpu, 871_414, config, false);
        assert_eq!(
            stages[stages.len() - 2..],
            [("wide", wide), ("encode", encode)]
        );
        assert_eq!(sum(&stages), 24 + wide + encode);
        let stages = dispatches(gpu, 871_414, config, true);
        assert_eq!(sum(&stages), 8 + wide_again + encode_again);
        assert_eq!(stages.last(), Some(&("encode", encode_again)));
    }
}

/// Both the pyramid and the scan take more dispatches where a workgroup or a dispatch cannot hold all.
#[test]
fn dispatches_of_a_gpu_build_grow_with_the_logarithm_of_its_size() {
    let Some(gpu) = gpu() else { return };
    for (triangle_count, short, long) in [
        (1, 21, 33),
        (512, 21, 33),
        (513, 22, 34),
        (32 * 256 + 1, 22, 34),
        (32 * 256 + 2, 23, 35),
        (512 * 128, 23, 35),
        (512 * 128 + 1, 24, 36),
        (1 << 20, 24, 36),
    ] {
        let sums = CODE_BITS.map(|bits| sum(&dispatches(gpu, triangle_count, bits, false)));
        assert_eq!(sums, [short, long], "{triangle_count} triangles");
    }
}
