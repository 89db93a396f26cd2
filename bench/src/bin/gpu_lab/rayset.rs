//! Rays in the GPU's memory, with room for their answers, and the time that a trace of them takes.

use anyhow::{Context, Result};
use slimbvh::gpu::{Bvh, Frame, Gpu, Query, wgpu};
use slimbvh::{BuildConfig, Mesh, MeshCodec, NodeCodec, Stages, WideStore};
use slimbvh_bench::rays::{PICTURE, RayOrder, Surfaces, primary_rays};
use slimbvh_bench::tracers::Question;
use slimbvh_core::{Hit, Ray};
use std::time::{Duration, Instant};

/// Width and height of the picture with `--quick`.
const QUICK_PICTURE: [u32; 2] = [256, 144];

/// How trees are stored, by name. Triangles are in full.
pub const STORED: [(&str, NodeCodec); 4] = [
    ("plain", NodeCodec::F32),
    ("w4-64", NodeCodec::Wide(WideStore::Exact)),
    ("w4", NodeCodec::Wide(WideStore::Full)),
    ("paper10", NodeCodec::Paper10),
];

/// The build with this codec.
pub fn config(nodes: NodeCodec) -> BuildConfig {
    BuildConfig {
        nodes,
        mesh: MeshCodec::F32,
        ..BuildConfig::default()
    }
}

/// The size of pictures.
pub fn picture(is_quick: bool) -> [u32; 2] {
    if is_quick { QUICK_PICTURE } else { PICTURE }
}

/// Rays of one kind.
pub struct RaySet {
    /// eye, shadow or bounce.
    pub name: &'static str,
    /// What is asked.
    pub question: Question,
    /// The rays.
    pub list: Vec<Ray>,
    /// The rays in the GPU's memory.
    pub rays: wgpu::Buffer,
    /// Room for the answers.
    pub answers: wgpu::Buffer,
}

impl RaySet {
    fn new(gpu: &Gpu, name: &'static str, question: Question, list: Vec<Ray>) -> Self {
        let buffer = |label, bytes: u64| {
            gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: bytes,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_SRC
                    | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let count = list.len() as u64;
        let rays = buffer("rays", size_of_val(list.as_slice()) as u64);
        gpu.queue()
            .write_buffer(&rays, 0, bytemuck::cast_slice(&list));
        Self {
            name,
            question,
            rays,
            answers: buffer("answers", count * query(question).answer_bytes()),
            list,
        }
    }

    /// Records a trace.
    pub fn trace(&self, frame: &mut Frame, bvh: &Bvh) -> Result<()> {
        let (rays, answers) = (self.rays.slice(..), self.answers.slice(..));
        Ok(bvh.trace(frame, query(self.question), rays, answers)?)
    }

    /// Traces, and returns the time: the GPU's, or without timestamps the host's.
    pub fn time(&self, gpu: &Gpu, bvh: &Bvh) -> Result<Duration> {
        let begin = Instant::now();
        let mut frame = gpu.frame();
        self.trace(&mut frame, bvh)?;
        let stages = frame.submit()?.wait()?;
        Ok(time_or(&stages, begin))
    }

    /// Traces, and returns the answers as words: [`Hit`]s, or 1 and 0.
    pub fn ask(&self, gpu: &Gpu, bvh: &Bvh) -> Result<Vec<u32>> {
        let mut frame = gpu.frame();
        self.trace(&mut frame, bvh)?;
        let answers = frame.read_later(self.answers.slice(..))?;
        frame.submit()?.wait()?;
        Ok(answers.read(gpu)?)
    }

    /// Rays in millions a second.
    pub fn rate(&self, seconds: f64) -> f64 {
        self.list.len() as f64 / seconds / 1e6
    }
}

/// The GPU's time, or without timestamps that since `begin`.
pub fn time_or(stages: &Stages, begin: Instant) -> Duration {
    match stages.total() {
        Duration::ZERO => begin.elapsed(),
        timed => timed,
    }
}

/// Eye rays of a mesh, and shadow and bounce rays from the hits that a trace of the eye rays through `bvh` finds. Kinds without
/// rays are left out.
pub fn ray_sets(
    gpu: &Gpu,
    mesh: &Mesh,
    bvh: &Bvh,
    size: [u32; 2],
    seed: u64,
) -> Result<Vec<RaySet>> {
    let bounds = mesh.bounds().context("the mesh has no vertices")?;
    let primary = primary_rays(&bounds, size, RayOrder::Tiles)?;
    let eye = RaySet::new(gpu, "eye", Question::Closest, primary);
    let hits: Vec<Hit> = bytemuck::allocation::pod_collect_to_vec(&eye.ask(gpu, bvh)?);
    let surfaces = Surfaces::new(mesh, &bounds, &eye.list, &hits);
    let (shadow, bounce) = (surfaces.shadow_rays(), surfaces.bounce_rays(seed));
    let mut sets = vec![eye];
    for (name, question, list) in [
        ("shadow", Question::Any, shadow),
        ("bounce", Question::Closest, bounce),
    ] {
        if !list.is_empty() {
            sets.push(RaySet::new(gpu, name, question, list));
        }
    }
    Ok(sets)
}

const fn query(question: Question) -> Query {
    match question {
        Question::Closest => Query::Closest,
        Question::Any => Query::Any,
    }
}
