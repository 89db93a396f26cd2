//! Frames in the caller's encoder, and as finished command buffers.

use super::builds::same_tree;
use slimbvh::generate::soup;
use slimbvh::gpu::{self, Frame, Gpu, GpuError, Query, wgpu};
use slimbvh::{BuildConfig, Change, CodeBits, FrameConfig, Hit, Mesh, Ray, ViewSets, ViewTarget};
use slimbvh_tests::build;
use slimbvh_tests::gpu::{contents, done, gpu, storage};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;

/// A mesh whose vertices the caller's commands put in place, and rays.
struct Work {
    host: Mesh,
    mesh: gpu::Mesh,
    vertices: wgpu::Buffer,
    rays: Vec<Ray>,
    ray_buffer: wgpu::Buffer,
    hits: wgpu::Buffer,
    builder: gpu::Builder,
    bvh: gpu::Bvh,
}

impl Work {
    fn new(gpu: &Gpu) -> Self {
        let host = soup(1111, 3);
        let mut flat = host.clone();
        flat.vertices.fill([0.0; 3]);
        let mut random = Random::new(5);
        let rays: Vec<Ray> = (0..300)
            .map(|_| Ray {
                origin: random.point().to_array(),
                t_min: 0.0,
                direction: random.direction().to_array(),
                t_max: f32::MAX,
            })
            .collect();
        Self {
            mesh: done(gpu::Mesh::upload(gpu, &flat)),
            vertices: storage(gpu, &host.vertices),
            ray_buffer: storage(gpu, &rays),
            hits: storage(gpu, &vec![Hit::MISS; rays.len()]),
            builder: gpu::Builder::new(BuildConfig::default()),
            bvh: gpu::Bvh::new(),
            host,
            rays,
        }
    }

    /// The caller's own command.
    fn place(&self, encoder: &mut wgpu::CommandEncoder) {
        let to = self.mesh.vertex_buffer();
        encoder.copy_buffer_to_buffer(&self.vertices, 0, to, 0, self.vertices.size());
    }

    fn record(&mut self, frame: &mut Frame) {
        done(self.builder.build(frame, &self.mesh, &mut self.bvh));
        let (rays, hits) = (self.ray_buffer.slice(..), self.hits.slice(..));
        done(self.bvh.trace(frame, Query::Closest, rays, hits));
    }

    /// Compares the tree and the hits with the CPU's.
    fn check(&self, gpu: &Gpu) -> Result<(), String> {
        let expected = build(&self.host, CodeBits::Bits30);
        same_tree(&done(self.bvh.download(gpu)), &expected)?;
        let hits: Vec<Hit> = contents(gpu, &self.hits);
        let primitives = |hits: &[Hit]| hits.iter().map(|hit| hit.primitive).collect::<Vec<_>>();
        let cpu: Vec<Hit> = self
            .rays
            .iter()
            .map(|ray| expected.closest_hit(ray))
            .collect();
        assert!(cpu.iter().any(Hit::is_hit));
        same_bits(&primitives(&hits), &primitives(&cpu))
    }
}

fn encoder(gpu: &Gpu) -> wgpu::CommandEncoder {
    gpu.device().create_command_encoder(&Default::default())
}

#[test]
fn a_frame_between_the_callers_commands_sees_what_is_before_it() {
    let Some(gpu) = gpu() else { return };
    let mut work = Work::new(gpu);
    let mut encoder = encoder(gpu);
    work.place(&mut encoder);
    let mut frame = gpu.frame_in(encoder);
    work.record(&mut frame);
    let kept = done(frame.read_later(work.hits.slice(..)));
    let (mut encoder, recorded) = done(frame.end());
    // The caller's command behind it: the frame has read the hits before.
    encoder.clear_buffer(&work.hits, 0, None);
    // The negative control: nothing has run before the caller submits.
    assert_eq!(contents::<Hit>(gpu, &work.hits)[0], Hit::MISS);
    let index = gpu.queue().submit([encoder.finish()]);
    let stages = done(recorded.submitted(gpu, index).wait());
    let has_times = gpu
        .device()
        .features()
        .contains(wgpu::Features::TIMESTAMP_QUERY);
    assert_eq!(stages.iter().any(|(stage, _)| stage == "bounds"), has_times);
    let hits: Vec<Hit> = done(kept.read(gpu));
    assert!(
        contents::<u8>(gpu, &work.hits)
            .iter()
            .all(|&byte| byte == 0)
    );
    gpu.queue()
        .write_buffer(&work.hits, 0, bytemuck::cast_slice(&hits));
    assert_eq!(work.check(gpu), Ok(()));
}

#[test]
fn a_finished_frame_runs_where_the_caller_submits_it() {
    let Some(gpu) = gpu() else { return };
    let mut work = Work::new(gpu);
    let mut before = encoder(gpu);
    work.place(&mut before);
    let mut frame = gpu.frame();
    work.record(&mut frame);
    let (commands, recorded) = done(frame.finish());
    let index = gpu.queue().submit([before.finish(), commands]);
    done(recorded.submitted(gpu, index).wait());
    assert_eq!(work.check(gpu), Ok(()));

    // The negative control: in the other order the tree is that of the vertices before.
    let mut other = Work::new(gpu);
    let mut behind = encoder(gpu);
    other.place(&mut behind);
    let mut frame = gpu.frame();
    other.record(&mut frame);
    let (commands, _) = done(frame.finish());
    gpu.queue().submit([commands, behind.finish()]);
    assert!(other.check(gpu).is_err());
}

/// View sets outlive the encoders of their frames.
#[test]
fn view_sets_are_updated_in_an_encoder_a_frame() {
    let Some(gpu) = gpu() else { return };
    let work = Work::new(gpu);
    let mut views = ViewSets::new(gpu, FrameConfig::default());
    let targets = [ViewTarget::other_rays()];
    for change in [Change::Scene, Change::Vertices, Change::View] {
        let mut encoder = encoder(gpu);
        work.place(&mut encoder);
        let mut frame = gpu.frame_in(encoder);
        done(views.update(&mut frame, &work.mesh, &targets, change));
        let (rays, hits) = (work.ray_buffer.slice(..), work.hits.slice(..));
        done(views.trees()[0].trace(&mut frame, Query::Closest, rays, hits));
        let (encoder, _) = done(frame.end());
        gpu.queue().submit([encoder.finish()]);
        let expected = build(&work.host, CodeBits::Bits30);
        let hits: Vec<Hit> = contents(gpu, &work.hits);
        let primitives = hits.iter().map(|hit| hit.primitive);
        let cpu = work
            .rays
            .iter()
            .map(|ray| expected.closest_hit(ray).primitive);
        // The mesh is read where the caller's commands have put it.
        assert!(primitives.eq(cpu), "{change:?}");
    }
}

/// A command that the device refuses is told where the frame is finished.
#[test]
fn errors_of_recording_come_back_from_finish() {
    let Some(gpu) = gpu() else { return };
    let small = storage(gpu, &[0u32; 4]);
    let mut frame = gpu.frame();
    frame.encoder().clear_buffer(&small, 0, Some(1024));
    match frame.finish() {
        Err(GpuError::Invalid { reason, .. }) => assert!(reason.contains("1024"), "{reason}"),
        other => panic!("{other:?}"),
    }
    done(gpu.frame().finish());
}
