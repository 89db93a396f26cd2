//! A setup under measurement: frames on a backend, with their times.

use super::prepared::Prepared;
use super::setup::{Setup, Update};
use super::times::Times;
use anyhow::{Context, Result};
use rayon::{ThreadPool, ThreadPoolBuilder};
use slimbvh::animate;
use slimbvh::reduce::Savings;
use slimbvh::{Backend, Change, FrameConfig, FrameRequest, Frames, Output, Picture};
use slimbvh_cli::backend::Chosen;
use slimbvh_cli::storage::mesh_bytes;
use std::time::Instant;

/// A setup on a backend, with the setup's number of threads.
pub struct Trial<'a, B: Backend> {
    prepared: &'a Prepared<'a>,
    pool: ThreadPool,
    frames: Frames<B>,
    /// The last picture.
    pub picture: Picture,
}

impl<'a, B: Backend> Trial<'a, B>
where
    Frames<B>: Send,
{
    /// # Errors
    /// If the threads cannot be started.
    pub fn new(backend: B, prepared: &'a Prepared) -> Result<Self> {
        let threads = ThreadPoolBuilder::new().num_threads(prepared.setup.threads);
        let config = FrameConfig {
            build: prepared.config,
            update: match prepared.setup.update {
                Update::Rebuild => animate::Update::Rebuild,
                Update::Refit => animate::Update::Refit,
            },
            ..FrameConfig::default()
        };
        Ok(Self {
            prepared,
            pool: threads.build().context("cannot start the threads")?,
            frames: Frames::new(backend, config),
            picture: Picture::default(),
        })
    }

    /// Renders a picture, from the mesh on. Uploading the scene to a GPU is not timed.
    pub fn frame(&mut self) -> Result<Times> {
        let Self {
            prepared,
            pool,
            frames,
            picture,
        } = self;
        pool.install(|| frame(prepared, frames, picture))
    }

    /// Bytes of all memory for the picture, the mesh included. Lists and buffers only grow, so this is the peak.
    pub fn peak_bytes(&self) -> usize {
        mesh_bytes(&self.prepared.scene.mesh) + self.frames.held_bytes()
    }
}

fn frame<B: Backend>(
    prepared: &Prepared,
    frames: &mut Frames<B>,
    picture: &mut Picture,
) -> Result<Times> {
    let (scene, settings) = (&*prepared.scene, &prepared.settings);
    let begin = Instant::now();
    let plan = prepared.plan(Savings::ALL)?;
    let plan_ms = begin.elapsed().as_secs_f64() * 1e3;
    let mut change = Change::Scene;
    if let Some(twisted) = &prepared.twisted {
        frames.build(twisted, &plan)?;
        change = Change::Vertices;
    }
    let request = FrameRequest {
        scene,
        plan: &plan,
        settings,
        change,
    };
    let output = Output {
        picture,
        progress: Some(&mut |_| {}),
    };
    let report = frames.render_planned(&request, output)?;
    Ok(Times::new(plan_ms, &report.build, &report.render.stages))
}

/// Whether the chosen backend supports this setup.
pub fn has(chosen: &Chosen, setup: &Setup, usual: &Setup) -> bool {
    matches!(chosen, Chosen::Cpu) || setup.is_comparable(usual) && setup.has_kernels()
}
