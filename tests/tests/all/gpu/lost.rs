//! A lost device is an error: no panic, and no endless wait.

use slimbvh::generate::{default_scene, soup};
use slimbvh::gpu::{self, Gpu, GpuError, Query};
use slimbvh::{BuildConfig, Change, Output, RenderSettings};
use slimbvh_core::{Hit, Ray};
use slimbvh_tests::gpu::{done, gpu_with_limits, own_gpu, storage, whole_tree};
use std::sync::mpsc;
use std::time::Duration;

/// Runs an operation with a time limit.
fn in_time<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> T {
    let (sender, result) = mpsc::channel();
    std::thread::spawn(move || sender.send(work()));
    match result.recv_timeout(Duration::from_secs(120)) {
        Ok(value) => value,
        Err(error) => panic!("it does not come to an end: {error}"),
    }
}

/// The result of each operation after the device was destroyed between frames.
fn errors_after_destruction(gpu: &Gpu) -> Vec<(&'static str, Result<(), GpuError>)> {
    let scene = slimbvh::Scene {
        mesh: soup(100, 1),
        ..default_scene()
    };
    let settings = RenderSettings {
        size: [16, 16],
        ..RenderSettings::default()
    };
    let uploaded = done(gpu::Scene::upload(gpu, &scene));
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let (mut bvh, mut renderer) = (gpu::Bvh::new(), gpu::Renderer::new());
    let rays = storage(gpu, &[Ray::EMPTY; 8]);
    let hits = storage(gpu, &[Hit::MISS; 8]);
    let mut whole = |frame: &mut gpu::Frame| {
        builder.build(frame, &uploaded.mesh, &mut bvh)?;
        bvh.trace(frame, Query::Closest, rays.slice(..), hits.slice(..))?;
        let (camera, lights) = (&scene.cameras[0], &scene.lights);
        renderer.render(frame, &uploaded, &bvh, camera, lights, &settings)
    };
    let mut frame = gpu.frame();
    done(whole(&mut frame));
    done(done(frame.submit()).wait());

    // One frame is recorded before the loss, the other after it.
    let mut frame = gpu.frame();
    done(whole(&mut frame));
    gpu.device().destroy();
    let submitted = frame
        .submit()
        .and_then(|submission| submission.wait().map(|_| ()));
    let mut frame = gpu.frame();
    let built = whole(&mut frame).and_then(|()| frame.submit()?.wait().map(|_| ()));
    vec![
        ("submit", submitted),
        ("build", built),
        ("download", bvh.download(gpu).map(|_| ())),
        ("count", bvh.read_counts(gpu).map(|_| ())),
        ("upload", gpu::Mesh::upload(gpu, &scene.mesh).map(|_| ())),
    ]
}

#[test]
fn a_device_destroyed_between_frames_is_an_error() {
    let Some(gpu) = own_gpu() else { return };
    for (what, result) in in_time(move || errors_after_destruction(&gpu)) {
        assert!(
            matches!(result, Err(GpuError::Lost { .. })),
            "{what}: {result:?}"
        );
    }
}

#[test]
fn a_device_of_the_caller_destroyed_between_frames_is_an_error() {
    let Some(gpu) = gpu_with_limits(|_| {}) else {
        return;
    };
    for (what, result) in in_time(move || errors_after_destruction(&gpu)) {
        assert!(result.is_err(), "{what} says nothing");
    }
}

#[test]
fn a_picture_cut_short_by_the_loss_of_the_device_is_an_error() {
    let Some(gpu) = own_gpu() else { return };
    let result = in_time(move || {
        let scene = slimbvh::Scene {
            mesh: soup(1000, 1),
            ..default_scene()
        };
        let mut picture = slimbvh::Picture::default();
        let mut frames = whole_tree(&gpu, BuildConfig::default());
        // Several waves; the device is destroyed at the end of the first.
        let settings = RenderSettings {
            size: [64, 64],
            sample_count: 512,
            ..RenderSettings::default()
        };
        let mut destroy = |_| gpu.device().destroy();
        let output = Output {
            picture: &mut picture,
            progress: Some(&mut destroy),
        };
        let rendered = frames.render(&scene, &settings, Change::Scene, output);
        rendered.map(|_| ())
    });
    assert!(matches!(result, Err(GpuError::Lost { .. })), "{result:?}");
}
