//! The picture is the same for any number of samples in flight.

use super::limits::short_sighted;
use super::pictures::{VIEWS, of_gpu, settings};
use slimbvh::generate::{default_scene, sphere_flake};
use slimbvh::{BuildConfig, Picture, RenderSettings, Scene, View, gpu};
use slimbvh_tests::gpu::{done, gpu};
use slimbvh_tests::parity::same_bits;

fn scene() -> Scene {
    let mut scene = Scene {
        mesh: sphere_flake(2, 1),
        ..default_scene()
    };
    // Mirrors, so that paths are of different lengths.
    for material in &mut scene.materials {
        material.mirror = 0.5;
    }
    scene
}

#[test]
fn waves_change_no_bit() {
    let (Some(gpu), Some(short_sighted)) = (gpu(), short_sighted()) else {
        return;
    };
    let scene = scene();
    // 1, 4 and 8 waves of 16384 samples, and waves that do not end with a row or a workgroup.
    for (size, sample_count) in [
        ([128, 64], 1),
        ([160, 90], 4),
        ([160, 90], 9),
        ([37, 5], 200),
    ] {
        for view in VIEWS {
            let settings = RenderSettings {
                size,
                sample_count,
                ..settings(view)
            };
            let (one, one_report) = of_gpu(gpu, &scene, &settings);
            let (many, many_report) = of_gpu(&short_sighted, &scene, &settings);
            let result = same_bits(&many.pixels, &one.pixels);
            assert_eq!(result, Ok(()), "{size:?}, {sample_count} samples, {view:?}");
            assert_eq!(one_report.ray_count(), many_report.ray_count());
            assert_eq!(one_report.node_visit_count, many_report.node_visit_count);
        }
    }
}

#[test]
fn a_renderer_makes_each_picture_as_a_new_one_does() {
    let Some(gpu) = short_sighted() else { return };
    let scene = scene();
    let uploaded = done(gpu::Scene::upload(&gpu, &scene));
    let mut bvh = gpu::Bvh::new();
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let mut renderer = gpu::Renderer::new();
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &uploaded.mesh, &mut bvh));
    done(frame.submit());
    let wishes = [
        ([96, 64], 1, View::Color),
        ([160, 90], 9, View::Color),
        ([96, 64], 1, View::Heatmap),
        ([20, 10], 2, View::Depth),
        ([160, 90], 2, View::Depth),
        ([96, 64], 1, View::Color),
        ([96, 64], 1, View::Color),
    ];
    for (size, sample_count, view) in wishes {
        let settings = RenderSettings {
            size,
            sample_count,
            ..settings(view)
        };
        let (camera, lights) = (&scene.cameras[0], &scene.lights);
        let mut frame = gpu.frame();
        done(renderer.render(&mut frame, &uploaded, &bvh, camera, lights, &settings));
        let download = done(renderer.read_later(&mut frame));
        let counters = done(renderer.count_later(&mut frame));
        done(frame.submit());
        let mut picture = Picture::default();
        done(download.read(&gpu, &mut picture));
        let (fresh, report) = of_gpu(&gpu, &scene, &settings);
        done(same_bits(&picture.pixels, &fresh.pixels));
        assert_eq!(done(counters.read(&gpu)).ray_count(), report.ray_count());
    }
}

#[test]
fn two_pictures_of_one_frame_are_those_of_two() {
    let Some(gpu) = gpu() else { return };
    let scene = scene();
    let uploaded = done(gpu::Scene::upload(gpu, &scene));
    let mut bvh = gpu::Bvh::new();
    let mut renderer = gpu::Renderer::new();
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &uploaded.mesh, &mut bvh));
    let mut moved = scene.clone();
    moved.cameras[0].eye[0] += 1.0;
    moved.lights.truncate(1);
    let settings = settings(View::Color);
    let downloads = [&scene, &moved].map(|scene| {
        let (camera, lights) = (&scene.cameras[0], &scene.lights);
        done(renderer.render(&mut frame, &uploaded, &bvh, camera, lights, &settings));
        done(renderer.read_later(&mut frame))
    });
    done(frame.submit());
    let mut pictures = Vec::new();
    for (download, scene) in downloads.into_iter().zip([&scene, &moved]) {
        let mut picture = Picture::default();
        done(download.read(gpu, &mut picture));
        done(same_bits(
            &picture.pixels,
            &of_gpu(gpu, scene, &settings).0.pixels,
        ));
        pictures.push(picture);
    }
    assert!(same_bits(&pictures[0].pixels, &pictures[1].pixels).is_err());
}
