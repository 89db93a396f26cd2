//! Methods that end in `_async` give what their blocking twins give, and end.

use pollster::block_on;
use slimbvh::generate::default_scene;
use slimbvh::gpu::{self, AdapterChoice, Download, Gpu, GpuError, Query, wgpu};
use slimbvh::{BuildConfig, Hit, Picture, Ray, RenderSettings, Stages, Stopwatch};
use slimbvh_core::Node;
use slimbvh_tests::gpu::{done, gpu, own_gpu, storage};
use std::future::Future;
use std::pin::pin;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll, Waker};
use std::time::Duration;

/// The answers of rays, and the tree as it is on the host.
type Answers = (Vec<Hit>, Vec<Node>, [u32; 2], [u64; 2]);

/// Runs a future while another thread polls the device.
fn awaited<T>(gpu: &Gpu, work: impl Future<Output = T>) -> T {
    let is_done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !is_done.load(Ordering::Relaxed) {
                // An error is the future's, too.
                let _ = gpu.poll();
                std::thread::sleep(Duration::from_micros(200));
            }
        });
        let result = block_on(work);
        is_done.store(true, Ordering::Relaxed);
        result
    })
}

fn rays() -> Vec<Ray> {
    let ray = |i: u32| {
        let [x, z] = [i % 16, i / 16].map(|at| 2.0 * at as f32 - 15.0);
        let origin = [x, 4.0, z];
        Ray::new(
            origin,
            [
                0.1 * x,
                if i.is_multiple_of(3) { 1.0 } else { -1.0 },
                0.1 * z,
            ],
        )
    };
    (0..256).map(ray).collect()
}

/// A frame that builds a tree and traces rays, submitted; its hits are being copied.
fn frame<'g>(gpu: &'g Gpu, bvh: &mut gpu::Bvh) -> (gpu::Submission<'g>, Download) {
    let mesh = done(gpu::Mesh::upload(gpu, &default_scene().mesh));
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let (rays, hits) = (storage(gpu, &rays()), storage(gpu, &[Hit::MISS; 256]));
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &mesh, bvh));
    done(bvh.trace(&mut frame, Query::Closest, rays.slice(..), hits.slice(..)));
    let download = done(frame.read_later(hits.slice(..)));
    (done(frame.submit()), download)
}

fn blocking(gpu: &Gpu) -> Result<(Stages, Answers), GpuError> {
    let mut bvh = gpu::Bvh::new();
    let (submission, download) = frame(gpu, &mut bvh);
    let stages = submission.wait()?;
    let (hits, tree) = (download.read(gpu)?, bvh.download(gpu)?);
    let answers = (
        hits,
        tree.nodes().to_vec(),
        bvh.read_counts(gpu)?,
        bvh.read_bytes(gpu)?,
    );
    Ok((stages, answers))
}

async fn asynchronous(gpu: &Gpu) -> Result<(Stages, Answers), GpuError> {
    let mut bvh = gpu::Bvh::new();
    let (submission, download) = frame(gpu, &mut bvh);
    let stages = submission.wait_async().await?;
    let hits = download.read_async(gpu).await?;
    let tree = bvh.download_async(gpu).await?;
    let counts = bvh.read_counts_async(gpu).await?;
    Ok((
        stages,
        (
            hits,
            tree.nodes().to_vec(),
            counts,
            bvh.read_bytes_async(gpu).await?,
        ),
    ))
}

#[test]
fn the_twins_give_the_same() {
    let Some(gpu) = gpu() else { return };
    let (stages, expected) = done(blocking(gpu));
    let (stages_async, answers) = done(awaited(gpu, asynchronous(gpu)));
    assert!(answers == expected, "the answers differ");
    assert!(!expected.1.is_empty(), "there is no tree");
    assert!(expected.0.iter().any(Hit::is_hit) && expected.0.iter().any(|hit| !hit.is_hit()));
    // Only the first frame that asks for a kernel compiles it.
    let names = |stages: &Stages| -> Vec<&str> {
        let names = stages.iter().map(|(name, _)| name);
        names.filter(|name| *name != "compile").collect()
    };
    assert_eq!(names(&stages), names(&stages_async));
}

/// A picture of the default scene, recorded.
fn picture<'g>(gpu: &'g Gpu, renderer: &mut gpu::Renderer) -> gpu::Frame<'g> {
    let scene = default_scene();
    let settings = RenderSettings {
        size: [48, 27],
        ..RenderSettings::default()
    };
    let uploaded = done(gpu::Scene::upload(gpu, &scene));
    let (mut builder, mut bvh) = (gpu::Builder::new(BuildConfig::default()), gpu::Bvh::new());
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &uploaded.mesh, &mut bvh));
    let (camera, lights) = (&scene.cameras[0], &scene.lights);
    done(renderer.render(&mut frame, &uploaded, &bvh, camera, lights, &settings));
    frame
}

#[test]
fn a_picture_without_blocking_is_the_same() {
    let Some(gpu) = gpu() else { return };
    let mut pictures = [Picture::default(), Picture::default()];
    let mut renderer = gpu::Renderer::new();
    let begin = Stopwatch::start();
    let [first, second] = &mut pictures;
    let frame = picture(gpu, &mut renderer);
    let (_, expected) = done(renderer.finish(frame, Stages::default(), begin, first));
    let frame = picture(gpu, &mut renderer);
    let work = renderer.finish_async(frame, Stages::default(), begin, second);
    let (_, report) = done(awaited(gpu, work));
    assert!(pictures[0] == pictures[1], "the pictures differ");
    assert_eq!(report.ray_count(), expected.ray_count());
    assert!(
        pictures[0]
            .pixels
            .iter()
            .any(|pixel| *pixel != pictures[0].pixels[0])
    );
}

#[test]
fn a_gpu_opened_without_blocking_is_the_same() {
    let Some(gpu) = gpu() else { return };
    let choice = AdapterChoice::Named(gpu.name().to_owned());
    let opened = done(block_on(Gpu::open_async(&choice)));
    assert_eq!((opened.name(), opened.limits()), (gpu.name(), gpu.limits()));
    assert_eq!(block_on(gpu::adapters_async()), gpu::adapters());
    let nowhere = AdapterChoice::Named("no such GPU".into());
    let error = block_on(Gpu::open_async(&nowhere)).map(|_| ());
    assert!(matches!(error, Err(GpuError::NoAdapter(_))), "{error:?}");
}

/// Futures can move between threads, as executors with many of them ask for.
#[test]
fn a_future_moves_to_another_thread() {
    let Some(gpu) = gpu() else { return };
    let (submission, download) = frame(gpu, &mut gpu::Bvh::new());
    let work = async move {
        submission.wait_async().await?;
        download.read_async::<Hit>(gpu).await
    };
    let hits = std::thread::spawn(move || awaited(gpu, work)).join();
    assert_eq!(done(hits.expect("it ends")).len(), 256);
}

/// Nothing waits in a poll: while the device is not polled, so that no callback runs, the future is pending.
#[test]
fn a_future_does_not_block() {
    let Some(gpu) = own_gpu() else { return };
    let (submission, _) = frame(&gpu, &mut gpu::Bvh::new());
    let mut work = pin!(submission.wait_async());
    let mut context = Context::from_waker(Waker::noop());
    for _ in 0..3 {
        assert!(work.as_mut().poll(&mut context).is_pending());
    }
    let ended = std::iter::repeat_with(|| {
        done(gpu.poll());
        std::thread::sleep(Duration::from_millis(1));
        work.as_mut().poll(&mut context)
    });
    let ended = ended.take(120_000).find_map(|poll| match poll {
        Poll::Ready(result) => Some(result),
        Poll::Pending => None,
    });
    done(ended.expect("it ends once the device is polled"));
}

#[test]
fn a_lost_device_ends_the_futures() {
    let Some(gpu) = own_gpu() else { return };
    let (submission, download) = frame(&gpu, &mut gpu::Bvh::new());
    gpu.device().destroy();
    let waited = awaited(&gpu, submission.wait_async()).map(|_| ());
    let read = awaited(&gpu, download.read_async::<Hit>(&gpu)).map(|_| ());
    let uploaded = gpu::Mesh::upload(&gpu, &default_scene().mesh).map(|_| ());
    // The work may have ended before the loss.
    assert!(
        matches!(waited, Ok(()) | Err(GpuError::Lost { .. })),
        "{waited:?}"
    );
    for result in [read, uploaded] {
        assert!(matches!(result, Err(GpuError::Lost { .. })), "{result:?}");
    }
}

/// A command that the device refuses is an error of the call itself, where the driver answers at once.
#[test]
fn errors_come_back_with_their_call() {
    let Some(gpu) = gpu() else { return };
    let buffer = storage(gpu, &[0_u32; 4]);
    let mut frame = gpu.frame();
    let download = done(frame.read_later(buffer.slice(..)));
    // The copy's source is larger than its buffer.
    let encoder = frame.encoder();
    let to = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 16,
        usage: wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    encoder.copy_buffer_to_buffer(&buffer, 0, &to, 0, 64);
    let submitted = frame.submit().map(|_| ());
    assert!(
        matches!(submitted, Err(GpuError::Invalid { .. })),
        "{submitted:?}"
    );
    let _ = download;
    done(done(gpu.frame().submit()).wait());
}
