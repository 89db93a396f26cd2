//! Measures builds and traces on the GPU.

use crate::decide::{Deciding, decide};
use anyhow::Result;
use slimbvh::gpu::wgpu::BufferUsages;
use slimbvh::gpu::{Builder, Bvh, Gpu, GpuError, Mesh as GpuMesh, Query, Work, wgpu};
use slimbvh::{BuildConfig, CodeBits, Hit, Mesh, Ray};
use slimbvh_bench::{RayLists, RayOrder};
use slimbvh_lab::measure::rounds;
use std::time::{Duration, Instant};

/// The measurements of one mesh.
pub struct MeshRecord {
    /// The name in tables.
    pub name: String,
    /// The number of its triangles.
    pub triangle_count: usize,
    /// Times and counts, or the reason of a refusal by the GPU.
    pub outcome: Result<Measured, GpuError>,
    /// The number of answers that differ from the CPU's.
    pub wrong_answers: usize,
}

/// Times and counts.
pub struct Measured {
    /// Builds with each length of codes.
    pub builds: Vec<Build>,
    /// Stage `decide`, which runs after vertices moved.
    pub deciding: Deciding,
    /// Traces of each list of rays.
    pub traces: Vec<Trace>,
    /// Bytes of the hierarchy's buffers.
    pub bvh_bytes: u64,
    /// The number of nodes.
    pub node_count: u64,
    /// Bytes of the buffers between the stages.
    pub scratch_bytes: u64,
}

/// Builds with one length of codes.
pub struct Build {
    /// 30 or 63.
    pub code_bits: u32,
    /// The dispatches and bytes of each stage.
    pub work: Vec<Work>,
    /// The median time of each stage, in the order of `work`; zero without timestamps.
    pub times: Vec<Duration>,
    /// The median wall-clock time on the host, from submission to the end.
    pub wall: Duration,
}

/// Rays of one kind.
pub struct Trace {
    /// Primary or shadow.
    pub name: &'static str,
    /// The number of rays.
    pub ray_count: usize,
    /// The median time.
    pub time: Duration,
    /// Bytes of all nodes and triangles that the rays touch, if they are counted.
    pub touched_bytes: Option<u64>,
}

/// Measures one mesh.
pub fn measure(
    gpu: &Gpu,
    name: &str,
    mesh: &Mesh,
    (rounds, order): (usize, RayOrder),
) -> Result<MeshRecord> {
    let mut record = MeshRecord {
        name: name.into(),
        triangle_count: mesh.indices.len(),
        outcome: Err(GpuError::OutOfMemory {
            adapter: gpu.name().into(),
        }),
        wrong_answers: 0,
    };
    let rays = RayLists::new(mesh, order)?;
    record.outcome = match measured(gpu, mesh, &rays, rounds) {
        Ok((measured, hits)) => {
            let bvh = slimbvh::Builder::default().build(mesh)?;
            let mut expected = Vec::new();
            bvh.closest_hits(&rays.primary, &mut expected);
            let pairs = hits.iter().zip(&expected);
            record.wrong_answers = pairs.filter(|(a, b)| a.primitive != b.primitive).count();
            Ok(measured)
        }
        Err(error @ GpuError::TooLarge { .. }) => Err(error),
        Err(error) => return Err(error.into()),
    };
    Ok(record)
}

fn measured(
    gpu: &Gpu,
    mesh: &Mesh,
    rays: &RayLists,
    rounds: usize,
) -> Result<(Measured, Vec<Hit>), GpuError> {
    let uploaded = GpuMesh::upload(gpu, mesh)?;
    let mut bvh = Bvh::new();
    let mut builds = Vec::new();
    let mut scratch_bytes = 0;
    for (code_bits, bits) in [(CodeBits::Bits63, 63), (CodeBits::Bits30, 30)] {
        let mut builder = Builder::new(BuildConfig::from(code_bits));
        builds.push(build(gpu, &mut builder, &uploaded, &mut bvh, bits, rounds)?);
        scratch_bytes = builder.scratch_bytes();
    }
    builds.reverse();
    let deciding = decide(gpu, mesh, &uploaded, rounds)?;
    let mut hits = Vec::new();
    let traces = vec![
        trace(gpu, &bvh, Query::Closest, &rays.primary, rounds, &mut hits)?,
        trace(gpu, &bvh, Query::Any, &rays.shadow, rounds, &mut Vec::new())?,
    ];
    let [node_count, _] = bvh.read_counts(gpu)?.map(u64::from);
    Ok((
        Measured {
            builds,
            deciding,
            traces,
            bvh_bytes: bvh.bytes(),
            node_count,
            scratch_bytes,
        },
        hits,
    ))
}

fn build(
    gpu: &Gpu,
    builder: &mut Builder,
    mesh: &GpuMesh,
    bvh: &mut Bvh,
    code_bits: u32,
    rounds: usize,
) -> Result<Build, GpuError> {
    let (mut stages, mut walls) = (Vec::new(), Vec::new());
    // The first round compiles and allocates.
    for round in 0..=rounds {
        let begin = Instant::now();
        let mut frame = gpu.frame();
        builder.build(&mut frame, mesh, bvh)?;
        let times = frame.submit()?.wait()?;
        if round > 0 {
            walls.push(begin.elapsed());
            stages.push(times);
        }
    }
    let work: Vec<Work> = builder.work().copied().collect();
    let times = work.iter().map(|work| {
        let of_stage = |stages: &slimbvh::Stages| {
            let time = stages.iter().find(|(stage, _)| *stage == work.stage);
            time.map_or(Duration::ZERO, |(_, time)| time)
        };
        median(&stages.iter().map(of_stage).collect::<Vec<_>>())
    });
    Ok(Build {
        code_bits,
        times: times.collect(),
        work,
        wall: median(&walls),
    })
}

fn trace(
    gpu: &Gpu,
    bvh: &Bvh,
    query: Query,
    rays: &[Ray],
    rounds: usize,
    hits: &mut Vec<Hit>,
) -> Result<Trace, GpuError> {
    let buffer = |label, bytes: u64| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes.max(16),
            usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    };
    let count = rays.len() as u64;
    let ray_buffer = buffer("rays", size_of_val(rays) as u64);
    let answers = buffer("answers", count * query.answer_bytes());
    let counts = buffer("counts", count * Query::Counted.answer_bytes());
    gpu.queue()
        .write_buffer(&ray_buffer, 0, bytemuck::cast_slice(rays));
    let mut times = Vec::new();
    for round in 0..=rounds {
        let begin = Instant::now();
        let mut frame = gpu.frame();
        bvh.trace(&mut frame, query, ray_buffer.slice(..), answers.slice(..))?;
        let stages = frame.submit()?.wait()?;
        if round > 0 {
            let timed = stages.total();
            times.push(if timed.is_zero() {
                begin.elapsed()
            } else {
                timed
            });
        }
    }
    let mut touched_bytes = None;
    if query == Query::Closest {
        let mut frame = gpu.frame();
        let counted = Query::Counted;
        bvh.trace(&mut frame, counted, ray_buffer.slice(..), counts.slice(..))?;
        let (counts, found) = (
            frame.read_later(counts.slice(..))?,
            frame.read_later(answers.slice(..))?,
        );
        frame.submit()?.wait()?;
        let counts: Vec<[u32; 2]> = counts.read(gpu)?;
        let node = size_of::<slimbvh::Node>() as u64;
        let triangle = size_of::<slimbvh_core::LeafTriangle>() as u64;
        let bytes = |[nodes, triangles]: &[u32; 2]| {
            u64::from(*nodes) * node + u64::from(*triangles) * triangle
        };
        touched_bytes = Some(counts.iter().map(bytes).sum());
        *hits = found.read(gpu)?;
    }
    Ok(Trace {
        name: if query == Query::Closest {
            "primary"
        } else {
            "shadow"
        },
        ray_count: rays.len(),
        time: median(&times),
        touched_bytes,
    })
}

/// The median of at least one time.
pub fn median(times: &[Duration]) -> Duration {
    let mut seconds: Vec<f64> = times.iter().map(Duration::as_secs_f64).collect();
    Duration::from_secs_f64(rounds::median(&mut seconds))
}
