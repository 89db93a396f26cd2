//! What builds and renders while it is timed.

#[cfg(feature = "gpu")]
mod on_gpu;

use super::prepared::Prepared;
use super::setup::Setup;
use super::times::Times;
use anyhow::{Context, Result};
use rayon::{ThreadPool, ThreadPoolBuilder};
use slimbvh::Picture;
use slimbvh::animate::Action;
use slimbvh::reduce::Savings;
use slimbvh_cli::backend::Chosen;
use slimbvh_cli::reduce;
use slimbvh_cli::render::job::{self, Job};
use std::time::Instant;

/// A setup on a machine.
pub trait Machine {
    /// Makes a picture, from the mesh on.
    fn frame(&mut self) -> Result<Times>;

    /// The last one.
    fn picture(&self) -> &Picture;

    /// Bytes of all memory that was needed for it, the mesh included. Lists and buffers only grow, so that this is the most there
    /// ever was.
    fn peak_bytes(&self) -> usize;
}

/// Makes a setup ready on what was chosen.
pub fn open<'a>(chosen: &'a Chosen, prepared: &'a Prepared) -> Result<Box<dyn Machine + 'a>> {
    Ok(match chosen {
        Chosen::Cpu => Box::new(Cpu::new(prepared)?),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => Box::new(on_gpu::OnGpu::new(gpu, prepared)),
    })
}

/// Whether what was chosen has this setup.
pub fn has(chosen: &Chosen, setup: &Setup, usual: &Setup) -> bool {
    matches!(chosen, Chosen::Cpu) || setup.is_comparable(usual) && setup.has_kernels()
}

/// Its name in tables.
pub fn name(chosen: &Chosen) -> &'static str {
    match chosen {
        Chosen::Cpu => "cpu",
        #[cfg(feature = "gpu")]
        Chosen::Gpu(_) | Chosen::GpuIfItFits(_) => "gpu",
    }
}

/// This machine's cores.
struct Cpu<'a> {
    prepared: &'a Prepared<'a>,
    pool: ThreadPool,
    cpu: job::Cpu,
    picture: Picture,
}

impl<'a> Cpu<'a> {
    /// # Errors
    /// If there can be no such threads.
    pub fn new(prepared: &'a Prepared) -> Result<Self> {
        let threads = ThreadPoolBuilder::new().num_threads(prepared.setup.threads);
        Ok(Self {
            prepared,
            pool: threads.build().context("cannot start the threads")?,
            cpu: job::Cpu::new(prepared.config),
            picture: Picture::default(),
        })
    }
}

impl Machine for Cpu<'_> {
    fn frame(&mut self) -> Result<Times> {
        let Self {
            prepared,
            pool,
            cpu,
            picture,
        } = self;
        pool.install(|| frame(prepared, cpu, picture))
    }

    fn picture(&self) -> &Picture {
        &self.picture
    }

    fn peak_bytes(&self) -> usize {
        let mesh = slimbvh_cli::storage::mesh_bytes(&self.prepared.scene.mesh);
        mesh + self.cpu.held_bytes()
    }
}

fn frame(prepared: &Prepared, cpu: &mut job::Cpu, picture: &mut Picture) -> Result<Times> {
    let begin = Instant::now();
    let mut room = None;
    let asked = prepared.asked(Savings::ALL);
    let (plan, _) = reduce::plan(&asked, prepared.config, &mut room)?;
    let plan_ms = begin.elapsed().as_secs_f64() * 1e3;
    let mut action = Action::Rebuilt;
    if let Some(twisted) = &prepared.twisted {
        cpu.build(twisted, &plan)?;
        action = Action::Refitted;
    }
    let job = Job {
        scene: &prepared.scene,
        plan: &plan,
        config: prepared.config,
        settings: &prepared.settings,
    };
    let outcome = job.update_on_cpu(cpu, picture, action, |_| {})?;
    Ok(Times::new(plan_ms, &outcome.build, &outcome.report.stages))
}
