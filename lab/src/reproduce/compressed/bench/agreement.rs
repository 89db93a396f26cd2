//! Checks that the GPU timed what the CPU counted: trees of equal bytes, rays that touch the same nodes, similar pictures.

use super::{Agreement, Buffers, GpuRecord};
use crate::measure::pictures::changed;
use crate::reproduce::steps::Steps;
use anyhow::{Context, Result, ensure};
use slimbvh::gpu::{Bvh, Gpu, Query, wgpu};
use slimbvh::{Cpu, Ray, RenderSettings, Scene};
use slimbvh_core::RayEnds;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{ClosestHit, Counted};
use wgpu::BufferUsages;

/// The least number of rays whose counts are compared, if the picture has as many. At most three times as many are compared.
const SAMPLED_RAYS: u32 = 2048;

/// One ray in this many may be counted differently on a hardware GPU, whose last bits differ.
const GRAZING: usize = 100;

/// The GPU's record of a method after its last round, compared with the same method on the CPU.
///
/// # Errors
/// If the trees differ in bytes, or if rays touch other nodes and triangles: any ray on a software adapter, more than one in a
/// hundred on a hardware GPU.
pub fn record(
    steps: &Steps<&Gpu>,
    own: &Steps<Cpu>,
    settings: &RenderSettings,
) -> Result<GpuRecord> {
    let (gpu, bvh) = (steps.backend, own.tree(0));
    let bytes = steps.tree(0).read_bytes(gpu)?;
    let expected = [bvh.node_bytes(), bvh.triangle_bytes()].map(|bytes| bytes as u64);
    ensure!(
        bytes == expected,
        "nodes and triangles take {bytes:?} bytes on the GPU, {expected:?} on the CPU"
    );

    let rays = sample(own.scene, settings)?;
    let on_gpu = count_on_gpu(gpu, steps.tree(0), &rays)?;
    let counted_otherwise = unlike(&on_gpu, &count(bvh, &rays));
    let most = if is_software(gpu) {
        0
    } else {
        rays.len() / GRAZING
    };
    ensure!(
        counted_otherwise <= most,
        "the GPU and the CPU count different nodes or triangles for {counted_otherwise} of {} rays",
        rays.len()
    );

    let picture = &steps.picture;
    let likeness = Agreement {
        rays: rays.len(),
        counted_otherwise,
        pixels: picture.pixels.len(),
        pixels_unlike: changed(picture, &own.picture, 1),
    };
    Ok(GpuRecord {
        buffers: Buffers {
            tree: steps.tree(0).bytes(),
            builder: steps.builder.scratch_bytes(),
            renderer: steps.renderer.scratch_bytes(),
            scene: steps.held.scene()?.bytes(),
        },
        likeness,
    })
}

/// Whether this is a software adapter.
pub fn is_software(gpu: &Gpu) -> bool {
    gpu.device().adapter_info().device_type == wgpu::DeviceType::Cpu
}

/// A sample of the picture's rays from the eye, evenly spaced.
fn sample(scene: &Scene, settings: &RenderSettings) -> Result<Vec<Ray>> {
    let camera = scene.cameras.first().context("the scene has no camera")?;
    let camera = camera.to_core(settings.size, settings.sample_count)?;
    let [width, height] = settings.size;
    let count = width * height * settings.sample_count;
    // An odd step visits all columns of a picture whose width is even.
    let step = ((count / SAMPLED_RAYS).max(1) - 1) | 1;
    let samples = (0..count).step_by(step as usize);
    Ok(samples.map(|sample| camera.ray(sample)).collect())
}

/// The numbers of nodes and triangles that the search for each ray's closest hit touches.
fn count(bvh: &slimbvh::Bvh, rays: &[Ray]) -> Vec<[u32; 2]> {
    let count = |ray: &Ray| {
        let ray = PreparedRay::new(ray, bvh.scene_exponent());
        let mut counted = Counted::new(ClosestHit::new(ray.t_max));
        bvh.collect(&ray, &RayEnds::NONE, &mut counted);
        [counted.node_count, counted.triangle_count]
    };
    rays.iter().map(count).collect()
}

/// [`count`], on the GPU.
fn count_on_gpu(gpu: &Gpu, bvh: &Bvh, rays: &[Ray]) -> Result<Vec<[u32; 2]>> {
    let buffer = |label, bytes| {
        let usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes,
            usage,
            mapped_at_creation: false,
        })
    };
    let asked = buffer("slimbvh sampled rays", size_of_val(rays) as u64);
    let answer_bytes = Query::Counted.answer_bytes() * rays.len() as u64;
    let answers = buffer("slimbvh counts", answer_bytes);
    gpu.queue()
        .write_buffer(&asked, 0, bytemuck::cast_slice(rays));
    let mut frame = gpu.frame();
    bvh.trace(
        &mut frame,
        Query::Counted,
        asked.slice(..),
        answers.slice(..),
    )?;
    let counts = frame.read_later(answers.slice(..))?;
    frame.submit()?.wait()?;
    Ok(counts.read(gpu)?)
}

/// The number of counts that differ.
fn unlike(a: &[[u32; 2]], b: &[[u32; 2]]) -> usize {
    let pairs = a.iter().zip(b);
    pairs.filter(|(a, b)| a != b).count() + a.len().abs_diff(b.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::{BuildConfig, LatticeBits, NodeCodec};

    #[test]
    fn one_count_that_differs_is_found() {
        let sound: Vec<[u32; 2]> = (0..40).map(|i| [i, 3 * i]).collect();
        assert_eq!(unlike(&sound, &sound), 0);
        assert_eq!(unlike(&sound[1..], &sound[..39]), 39);
        assert_eq!(unlike(&sound, &sound[..38]), 2);
        for place in 0..40 {
            for number in 0..2 {
                let mut off = sound.clone();
                off[place][number] ^= 1;
                assert_eq!(unlike(&off, &sound), 1);
            }
        }
    }

    /// The sampled rays distinguish trees with nodes of other bits.
    #[test]
    fn counts_of_sampled_rays_tell_codecs_apart() {
        let mut scene = crate::scenes::shiny();
        scene.complete(scene.mesh.bounds(), [192, 108]);
        let settings = RenderSettings {
            size: [192, 108],
            ..RenderSettings::default()
        };
        let rays = sample(&scene, &settings).unwrap();
        assert!((2048..=6144).contains(&rays.len()), "{}", rays.len());
        let counts = [LatticeBits::Q4, LatticeBits::Q10].map(|bits| {
            let nodes = NodeCodec::Lattice(bits);
            let mut bvh = slimbvh::Bvh::default();
            let mut builder = slimbvh::Builder::new(BuildConfig {
                nodes,
                ..BuildConfig::default()
            });
            builder.build_into(&scene.mesh, &mut bvh).unwrap();
            count(&bvh, &rays)
        });
        let differ = unlike(&counts[0], &counts[1]);
        assert!(differ > rays.len() / GRAZING, "{differ}");
    }
}
