//! The walks over peers' trees on the GPU find what slimbvh finds on the CPU, up to rays that pass close to edges. Skipped without
//! a GPU, not even in software; `REQUIRE_GPU=1` makes that a failure.

use anyhow::Result;
use glam::Vec3;
use slimbvh::generate;
use slimbvh::gpu::{AdapterChoice, AdapterError, Gpu, GpuError, wgpu};
use slimbvh::internals::Random;
use slimbvh::{Builder, Mesh};
use slimbvh_bench::gpu_peers::{GpuPeer, PeerTree, Stopwatch, Walk};
use slimbvh_bench::tracers::{Question, triangles};
use slimbvh_bench::{Agreement, Answer};
use slimbvh_core::{Hit, Ray};
use std::time::Duration;

/// The share of rays that may have another answer: those whose hit is within rounding of an edge or of the next triangle.
const LEEWAY: f64 = 1e-3;

fn gpu() -> Result<Option<Gpu>> {
    match Gpu::open(&AdapterChoice::Any) {
        Ok(gpu) => Ok(Some(gpu)),
        Err(GpuError::NoAdapter(AdapterError::None)) => {
            let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
            assert!(!is_required, "there is no GPU, and REQUIRE_GPU is set");
            eprintln!("SKIPPED: there is no GPU, not even in software");
            Ok(None)
        }
        Err(error) => Err(error.into()),
    }
}

/// Answers of a walk, one a ray.
fn ask<T: bytemuck::Pod>(
    gpu: &Gpu,
    tree: &PeerTree,
    question: Question,
    rays: &[Ray],
) -> Result<Vec<T>> {
    let peer = GpuPeer::new(gpu, tree)?;
    let buffer = |bytes: usize| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: bytes as u64,
            usage: wgpu::BufferUsages::STORAGE
                | wgpu::BufferUsages::COPY_SRC
                | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    };
    let (from, to) = (
        buffer(size_of_val(rays)),
        buffer(rays.len() * size_of::<T>()),
    );
    gpu.queue()
        .write_buffer(&from, 0, bytemuck::cast_slice(rays));
    let mut frame = gpu.frame();
    peer.trace(&mut frame, question, &from, &to, None);
    let answers = frame.read_later(to.slice(..))?;
    frame.submit()?.wait()?;
    Ok(answers.read(gpu)?)
}

fn answers(hits: &[Hit]) -> Vec<Answer> {
    hits.iter().map(Answer::from).collect()
}

/// Rays between points of a cube that is larger than the scene's.
fn random_rays(count: usize, side: f32, seed: u64) -> Vec<Ray> {
    let mut random = Random::new(seed);
    let rays = (0..count).map(|_| {
        let [from, to] = [random.point(), random.point()].map(|p| (p - 0.5) * side);
        Ray::new(from.to_array(), (to - from).to_array())
    });
    rays.collect()
}

/// Scenes with rays that hit about as often as they miss.
fn scenes() -> Vec<(&'static str, Mesh, Vec<Ray>)> {
    let sphere = generate::icosphere(Vec3::ZERO, 1.0, 3);
    let spheres = generate::grid_of_objects(&sphere, [3, 2, 4], Vec3::new(2.5, 3.0, 2.2));
    let soup = generate::soup(3000, 5);
    let terrain = generate::terrain(10.0, 48, 7);
    vec![
        ("spheres", spheres, random_rays(20_000, 16.0, 1)),
        ("soup", soup, random_rays(20_000, 3.0, 2)),
        ("terrain", terrain, random_rays(20_000, 12.0, 3)),
    ]
}

#[test]
fn gpu_walks_find_the_closest_hits() -> Result<()> {
    let Some(gpu) = gpu()? else { return Ok(()) };
    for (name, mesh, rays) in scenes() {
        let bvh = Builder::default().build(&mesh)?;
        let mut expected = Vec::new();
        bvh.closest_hits(&rays, &mut expected);
        for walk in Walk::ALL {
            let mut tree = PeerTree::build(walk, &triangles(&mesh))?;
            let hits: Vec<Hit> = ask(&gpu, &tree, Question::Closest, &rays)?;
            let agreement = Agreement::of_closest(&answers(&expected), &answers(&hits));
            let share = agreement.disagreements() as f64 / rays.len() as f64;
            println!("{name}, {walk}: {agreement:?}, {:.4} %", 100.0 * share);
            assert!(
                agreement.expected_hits * 10 > rays.len(),
                "{name}: few hits"
            );
            assert!(share <= LEEWAY, "{name}, {walk}: {agreement:?}");
            let mut same = 0;
            for (a, b) in expected.iter().zip(&hits) {
                if a.is_hit() && a.primitive == b.primitive {
                    same += 1;
                    let apart = (a.u - b.u).abs().max((a.v - b.v).abs());
                    assert!(apart < 1e-2, "{name}, {walk}: {a:?}, {b:?}");
                }
            }
            let other = agreement.expected_hits - same;
            assert!(other as f64 <= LEEWAY * rays.len() as f64, "{name}, {walk}");

            // The comparison is not blind: triangles that change places are found.
            tree.triangles.rotate_left(3);
            let hits: Vec<Hit> = ask(&gpu, &tree, Question::Closest, &rays)?;
            let agreement = Agreement::of_closest(&answers(&expected), &answers(&hits));
            let share = agreement.disagreements() as f64 / rays.len() as f64;
            assert!(share > 10.0 * LEEWAY, "{name}, {walk}: {agreement:?}");
        }
    }
    Ok(())
}

#[test]
fn gpu_walks_find_whether_anything_is_hit() -> Result<()> {
    let Some(gpu) = gpu()? else { return Ok(()) };
    for (name, mesh, rays) in scenes() {
        let bvh = Builder::default().build(&mesh)?;
        let expected: Vec<bool> = rays.iter().map(|ray| bvh.any_hit(ray)).collect();
        for walk in Walk::ALL {
            let mut tree = PeerTree::build(walk, &triangles(&mesh))?;
            let found = |tree: &PeerTree| -> Result<Vec<bool>> {
                let words: Vec<u32> = ask(&gpu, tree, Question::Any, &rays)?;
                assert!(words.iter().all(|&word| word <= 1));
                Ok(words.into_iter().map(|word| word == 1).collect())
            };
            let agreement = Agreement::of_any(&expected, &found(&tree)?);
            let share = agreement.disagreements() as f64 / rays.len() as f64;
            println!("{name}, {walk}: {agreement:?}, {:.4} %", 100.0 * share);
            assert!(share <= LEEWAY, "{name}, {walk}: {agreement:?}");

            // One node's boxes are not where they were.
            let last_row = tree.nodes.len().min(5) - 2;
            tree.nodes[last_row] = [0; 4];
            let agreement = Agreement::of_any(&expected, &found(&tree)?);
            let share = agreement.disagreements() as f64 / rays.len() as f64;
            assert!(share > LEEWAY, "{name}, {walk}: {agreement:?}");
        }
    }
    Ok(())
}

#[test]
fn gpu_walks_heed_a_rays_range_and_length() -> Result<()> {
    let Some(gpu) = gpu()? else { return Ok(()) };
    let mesh = generate::icosphere(Vec3::ZERO, 1.0, 4);
    // Along z, of length 2.5, off the middle of a unit sphere, which they meet at z = ∓1.
    let ray = |z: f32, t_min: f32, t_max: f32| Ray {
        origin: [0.031, 0.02, z],
        t_min,
        direction: [0.0, 0.0, 2.5],
        t_max,
    };
    let rays = [
        (ray(-3.0, 0.0, f32::MAX), Some(0.8)),
        (ray(-3.0, 1.0, f32::MAX), Some(1.6)),
        (ray(-3.0, 0.0, 0.7), None),
        (ray(-3.0, 1.7, f32::MAX), None),
        (ray(-3.0, 1.0, 1.5), None),
        (ray(0.0, -1.0, f32::MAX), Some(-0.4)),
        (ray(3.0, -2.0, -1.0), Some(-1.6)),
        (ray(3.0, -0.5, f32::MAX), None),
    ];
    let list = rays.map(|(ray, _)| ray);
    for walk in Walk::ALL {
        let tree = PeerTree::build(walk, &triangles(&mesh))?;
        let hits: Vec<Hit> = ask(&gpu, &tree, Question::Closest, &list)?;
        let any: Vec<u32> = ask(&gpu, &tree, Question::Any, &list)?;
        for (i, (hit, any)) in hits.iter().zip(any).enumerate() {
            let expected: Option<f32> = rays[i].1;
            assert_eq!(hit.is_hit(), expected.is_some(), "{walk}, ray {i}");
            assert_eq!(any == 1, expected.is_some(), "{walk}, ray {i}");
            let apart = expected.map_or(0.0, |t| (hit.t - t).abs());
            assert!(apart < 0.002, "{walk}, ray {i}: {}", hit.t);
        }
    }
    Ok(())
}

/// A tree of one leaf, and one without an area.
#[test]
fn gpu_walks_take_the_smallest_meshes() -> Result<()> {
    let Some(gpu) = gpu()? else { return Ok(()) };
    let vertices = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.5], [0.5, 3.0, 0.0]];
    let rays = [
        Ray::new([0.6, 0.8, 4.0], [0.0, 0.0, -1.0]),
        Ray::new([1.9, 2.8, 4.0], [0.0, 0.0, -1.0]),
    ];
    for (indices, expected) in [([0, 1, 2], [true, false]), ([0, 1, 1], [false, false])] {
        let mesh = Mesh {
            vertices: vertices.clone(),
            indices: vec![indices],
            ..Mesh::default()
        };
        for walk in Walk::ALL {
            let tree = PeerTree::build(walk, &triangles(&mesh))?;
            let hits: Vec<Hit> = ask(&gpu, &tree, Question::Closest, &rays)?;
            let found: Vec<bool> = hits.iter().map(Hit::is_hit).collect();
            assert_eq!(found, expected, "{walk}");
        }
    }
    Ok(())
}

#[test]
fn gpu_passes_of_peers_are_timed() -> Result<()> {
    let Some(gpu) = gpu()? else { return Ok(()) };
    let Some(watch) = Stopwatch::new(gpu.device(), 2) else {
        eprintln!("SKIPPED: {} has no timestamps", gpu.name());
        return Ok(());
    };
    let mut frame = gpu.frame();
    for number in 0..2 {
        let pass = wgpu::ComputePassDescriptor {
            label: None,
            timestamp_writes: Some(watch.pass(number)),
        };
        drop(frame.encoder().begin_compute_pass(&pass));
    }
    watch.resolve(frame.encoder());
    frame.submit()?.wait()?;
    let times = watch.read(gpu.device(), gpu.queue())?;
    assert_eq!(times.len(), 2);
    assert!(times.iter().all(|&time| time < Duration::from_secs(1)));
    Ok(())
}
