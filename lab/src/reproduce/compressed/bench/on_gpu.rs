//! Timing of frames on a GPU.

use super::{Bench, GpuRecord, Timed, agreement};
use crate::reproduce::compressed::frames::take_turns;
use crate::reproduce::compressed::methods::Prepared;
use crate::reproduce::steps::Steps;
use anyhow::Result;
use slimbvh::gpu::Gpu;
use slimbvh::{Cpu, RenderSettings};
use std::time::{Duration, Instant};

/// The plain tree on the GPU. All other trees are timed in turn with it.
pub struct GpuBench<'a>(Steps<'a, &'a Gpu>);

impl<'a> GpuBench<'a> {
    /// Uploads a scene, and builds the plain tree.
    pub fn new(gpu: &'a Gpu, plain: &'a Prepared) -> Result<Self> {
        let mut steps = Steps::new(gpu, plain.config, &plain.scene, None)?;
        steps.build_all()?;
        Ok(Self(steps))
    }
}

impl Bench for GpuBench<'_> {
    fn plain(
        &mut self,
        reference: &Steps<Cpu>,
        settings: &RenderSettings,
    ) -> Result<Option<GpuRecord>> {
        self.0.render_all(settings)?;
        agreement::record(&self.0, reference, settings).map(Some)
    }

    fn time(
        &mut self,
        (_, on_cores): (&mut Steps<Cpu>, &mut Steps<Cpu>),
        prepared: &Prepared,
        settings: &RenderSettings,
        round_count: u32,
    ) -> Result<Timed> {
        let plain = &mut self.0;
        let mut own = Steps::new(plain.backend, prepared.config, &prepared.scene, None)?;
        raise_clock(plain, settings)?;
        Ok(Timed {
            rounds: take_turns((plain, &mut own), settings, round_count)?,
            on_gpu: Some(agreement::record(&own, on_cores, settings)?),
        })
    }
}

/// Keeps a hardware GPU busy until its clock is up: an idle GPU is a few times slower at first.
fn raise_clock(steps: &mut Steps<&Gpu>, settings: &RenderSettings) -> Result<()> {
    let start = Instant::now();
    while !agreement::is_software(steps.backend) && start.elapsed() < Duration::from_millis(500) {
        steps.render_all(settings)?;
    }
    Ok(())
}
