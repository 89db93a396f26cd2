//! Hierarchies that were built on the CPU or read from a file, and uploaded to the GPU.

use super::builds::same_tree;
use super::codecs::{configs, same_stored, snapped};
use super::limits::short_sighted;
use super::pictures::{MOST, SHARE, hall_of_mirrors, of_cpu_as, of_gpu_as, settings};
use super::trace::{Answers, rays_at};
use glam::Vec3;
use proptest::prelude::*;
use slimbvh::generate::{icosphere, soup};
use slimbvh::gpu::{self, Gpu, GpuError, Subset};
use slimbvh::{BuildConfig, CodeBits, LatticeBits, Mesh, NodeCodec, Picture, RefitError, View};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_tests::gpu::{done, gpu, is_software};
use slimbvh_tests::parity::alike;
use slimbvh_tests::strategies::{any_mesh, large_mesh};
use slimbvh_tests::{build_as, cases};

/// All codecs of the GPU, full precision first.
fn all(code_bits: CodeBits, step_exponent: i32) -> impl Iterator<Item = BuildConfig> {
    let coded = configs(code_bits, step_exponent);
    [BuildConfig::from(code_bits)].into_iter().chain(coded)
}

/// Compares all lists of two hierarchies.
fn same(a: &slimbvh::Bvh, b: &slimbvh::Bvh) -> Result<(), String> {
    same_stored(a, b)?;
    same_tree(a, b)
}

/// Uploads and downloads a hierarchy, and compares.
fn check(gpu: &Gpu, bvh: &slimbvh::Bvh) -> Result<(), String> {
    let uploaded = done(gpu::Bvh::upload(gpu, bvh));
    same(&done(uploaded.download(gpu)), bvh)?;
    let bytes = [bvh.node_bytes(), bvh.triangle_bytes()].map(|bytes| bytes as u64);
    let counts = [bvh.node_count(), bvh.triangle_count()].map(|count| count as u32);
    let read = (
        done(uploaded.read_bytes(gpu)),
        done(uploaded.read_counts(gpu)),
    );
    if read != (bytes, counts) {
        return Err(format!("{read:?} instead of {bytes:?}, {counts:?}"));
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn hierarchies_come_back_as_they_were_uploaded(mesh in any_mesh(), coarser in 0i32..20) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let (mesh, step_exponent) = snapped(&mesh, coarser);
        for config in all(CodeBits::Bits63, step_exponent) {
            prop_assert_eq!(check(gpu, &build_as(&mesh, config)), Ok(()), "{:?}", config);
        }
    }
}

proptest! {
    #![proptest_config(cases(4))]

    /// Only for full precision: the plain tree of a coded hierarchy belongs to its builder.
    #[test]
    fn uploaded_hierarchies_are_refitted_like_those_of_the_cpu(mesh in large_mesh(), factors in proptest::array::uniform3(-3f32..3.0)) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let mut moved = mesh.clone();
        for (vertex, i) in moved.vertices.iter_mut().zip(0..) {
            *vertex = [0, 1, 2].map(|axis| vertex[axis] * factors[(axis + i) % 3]);
        }
        let config = BuildConfig::default();
        let mut expected = build_as(&mesh, config);
        let mut bvh = done(gpu::Bvh::upload(gpu, &expected));
        let place = done(gpu::Mesh::upload(gpu, &moved));
        let mut frame = gpu.frame();
        done(gpu::Builder::new(config).refit(&mut frame, &place, &mut bvh));
        done(frame.submit());
        done(slimbvh::Builder::new(config).refit(&moved, &mut expected));
        prop_assert_eq!(same(&done(bvh.download(gpu)), &expected), Ok(()));
    }
}

#[test]
fn uploaded_hierarchies_answer_as_on_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for mesh in [soup(0, 1), soup(3, 2), soup(4000, 3)] {
        let (mesh, step_exponent) = snapped(&mesh, 8);
        let rays = rays_at(&mesh, 500, 7);
        for config in all(CodeBits::Bits30, step_exponent) {
            let bvh = build_as(&mesh, config);
            let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
            let answers = Answers::in_frame(gpu.frame(), &uploaded, &rays);
            let expected = Answers::of_cpu(&bvh, &rays);
            let result = answers.compare(&expected, is_software(gpu));
            assert_eq!(result, Ok(()), "{config:?}");
        }
    }
}

/// Hierarchies that the GPU built have the same bytes.
#[test]
fn pictures_through_uploaded_hierarchies_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let scene = hall_of_mirrors();
    let (mesh, step_exponent) = snapped(&scene.mesh, 6);
    let scene = slimbvh::Scene { mesh, ..scene };
    let settings = settings(View::Color);
    for config in all(CodeBits::Bits30, step_exponent) {
        let bvh = build_as(&scene.mesh, config);
        let render = |bvh: &slimbvh::Bvh| {
            let uploaded = done(gpu::Bvh::upload(gpu, bvh));
            let mut picture = Picture::default();
            let mut renderer = gpu::Renderer::new();
            let both = (&scene, &uploaded);
            let rendered = renderer.render_image(gpu, both, &settings, &mut picture, |_| {});
            assert!(done(rendered).primary_hit_count > 0);
            picture
        };
        let picture = render(&bvh);
        let (built_there, _) = of_gpu_as(gpu, &scene, &settings, config);
        assert!(picture == built_there, "{config:?}");
        let (expected, _) = of_cpu_as(&scene, &settings, config);
        done(alike(&picture, &expected, SHARE, MOST));
        // The negative control: a hierarchy over slightly moved triangles makes another picture.
        let mut moved = scene.mesh.clone();
        for vertex in &mut moved.vertices {
            vertex[1] += 64.0 * 2f32.powi(step_exponent.max(-10));
        }
        let other = render(&build_as(&moved, config));
        assert!(alike(&other, &expected, SHARE, MOST).is_err(), "{config:?}");
    }
}

/// The negative control: one vertex is moved by one step.
#[test]
fn one_moved_vertex_is_found_in_what_comes_back() {
    let Some(gpu) = gpu() else { return };
    let step_exponent = -4;
    let mut sound = soup(900, 2);
    sound.snap(step_exponent);
    let mut moved = sound.clone();
    moved.vertices[1000][1] += 2f32.powi(step_exponent);
    for config in all(CodeBits::Bits30, step_exponent) {
        let uploaded = done(gpu::Bvh::upload(gpu, &build_as(&moved, config)));
        let back = done(uploaded.download(gpu));
        done(same(&back, &build_as(&moved, config)));
        assert!(
            same(&back, &build_as(&sound, config)).is_err(),
            "{config:?}"
        );
    }
}

/// A builder can build into an uploaded hierarchy, and an upload can replace a built one.
#[test]
fn uploads_and_builds_follow_each_other() {
    let Some(gpu) = gpu() else { return };
    let (small, large) = (soup(300, 1), soup(5000, 2));
    for config in all(CodeBits::Bits30, -14) {
        let snapped = |mesh: &Mesh| {
            let mut mesh = mesh.clone();
            mesh.snap(-14);
            mesh
        };
        let (small, large) = (snapped(&small), snapped(&large));
        let mut bvh = done(gpu::Bvh::upload(gpu, &build_as(&small, config)));
        let mut builder = gpu::Builder::new(config);
        for mesh in [&large, &small] {
            let place = done(gpu::Mesh::upload(gpu, mesh));
            let mut frame = gpu.frame();
            done(builder.build(&mut frame, &place, &mut bvh));
            done(frame.submit());
            done(same(&done(bvh.download(gpu)), &build_as(mesh, config)));
        }
        let back = done(bvh.download(gpu));
        done(check(gpu, &back));

        // No builder can refit a coded upload, as its plain tree is missing.
        let mut again = done(gpu::Bvh::upload(gpu, &back));
        let place = done(gpu::Mesh::upload(gpu, &small));
        let refitted = builder.refit(&mut gpu.frame(), &place, &mut again);
        let is_coded = config.nodes != NodeCodec::F32;
        assert_eq!(
            matches!(refitted, Err(GpuError::Unfit { .. })),
            is_coded,
            "{config:?}"
        );
    }
}

/// A reduced hierarchy is uploaded as it is.
#[test]
fn reduced_hierarchies_come_back_reduced() {
    let Some(gpu) = gpu() else { return };
    let mut mesh = icosphere(Vec3::new(0.3, -0.2, 0.1), 1.5, 4);
    mesh.snap(-12);
    let components = vec![0; mesh.indices.len()];
    let reach = VisibleSet {
        sides: Sides {
            components: &components,
            sides: &[1],
        },
        target: Target::position([5.0, 1.0, 2.0]),
        frustum: Frustum::EVERYWHERE,
    };
    for config in all(CodeBits::Bits30, -12) {
        let mut bvh = slimbvh::Bvh::default();
        let subset = slimbvh::Subset::Of(reach);
        done(slimbvh::Builder::new(config).build_subset(&mesh, subset, &mut bvh));
        assert!(bvh.triangle_count() < mesh.indices.len());
        done(check(gpu, &bvh));
        let mut uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        if config.nodes == NodeCodec::F32 {
            let place = done(gpu::Mesh::upload(gpu, &mesh));
            let mut builder = gpu::Builder::new(config);
            let refitted = builder.refit(&mut gpu.frame(), &place, &mut uploaded);
            assert_eq!(refitted, Err(GpuError::Refit(RefitError::Reduced)));
            let mut frame = gpu.frame();
            done(builder.sort(&mut frame, &place));
            done(builder.build_sorted(&mut frame, &place, Subset::All, &mut uploaded));
            done(frame.submit());
            done(same(
                &done(uploaded.download(gpu)),
                &build_as(&mesh, config),
            ));
        }
    }
}

#[test]
fn what_the_gpu_has_no_place_for_is_refused() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(10, 1);
    for bits in LatticeBits::ALL {
        let nodes = NodeCodec::Lattice(bits);
        let config = BuildConfig {
            nodes,
            ..BuildConfig::default()
        };
        let refused = gpu::Bvh::upload(gpu, &build_as(&mesh, config)).err();
        let nodes = nodes.name();
        assert_eq!(refused, Some(GpuError::Codec { nodes }));
    }
    let never_built = gpu::Bvh::upload(gpu, &slimbvh::Bvh::default()).err();
    let said = never_built.map_or_else(String::new, |error| error.to_string());
    assert_eq!(said, "the hierarchy is empty; build it first");
}

#[test]
fn hierarchies_too_large_for_the_device_are_refused_and_smaller_ones_uploaded() {
    let Some(gpu) = short_sighted() else { return };
    let build = |count| build_as(&soup(count, 1), BuildConfig::default());
    // 40 bytes a triangle, in a mebibyte.
    let refused = gpu::Bvh::upload(&gpu, &build(26_215)).err();
    let said = refused.map_or_else(String::new, |error| error.to_string());
    for part in [
        "the triangles of the hierarchy would take 1048600 bytes",
        "max_storage_buffer_binding_size",
        "1048576",
        "or the CPU",
    ] {
        assert!(said.contains(part), "{part:?} is not in {said}");
    }
    done(check(&gpu, &build(26_214)));
}
