//! Timing of frames on a GPU.

use super::{Bench, GpuRecord, Timed, likeness};
use crate::reproduce::compressed::frames::take_turns;
use crate::reproduce::compressed::machine::{Cpu, Machine, OnGpu};
use crate::reproduce::compressed::methods::Prepared;
use anyhow::Result;
use slimbvh::RenderSettings;
use slimbvh::gpu::{Gpu, GpuError};
use std::time::{Duration, Instant};

/// The plain tree on the GPU. All other trees are timed in turn with it.
pub struct GpuBench<'a>(OnGpu<'a>);

impl<'a> GpuBench<'a> {
    /// Uploads a scene, and builds the plain tree.
    pub fn new(gpu: &'a Gpu, plain: &'a Prepared) -> Result<Self> {
        let mut machine = OnGpu::new(gpu, plain)?;
        machine.build()?;
        Ok(Self(machine))
    }
}

impl Bench for GpuBench<'_> {
    fn plain(&mut self, reference: &Cpu, settings: &RenderSettings) -> Result<Option<GpuRecord>> {
        self.0.render(settings)?;
        likeness::record(&mut self.0, reference, settings).map(Some)
    }

    fn time(
        &mut self,
        (_, on_cores): (&mut Cpu, &mut Cpu),
        prepared: &Prepared,
        settings: &RenderSettings,
        round_count: u32,
    ) -> Result<Timed> {
        let plain = &mut self.0;
        let mut own = OnGpu::new(plain.gpu(), prepared)?;
        match own.build() {
            Err(error) if is_codec(&error) => return Ok(Timed::default()),
            built => built?,
        };
        raise_clock(plain, settings)?;
        Ok(Timed {
            rounds: take_turns((plain, &mut own), settings, round_count)?,
            on_gpu: Some(likeness::record(&mut own, on_cores, settings)?),
        })
    }
}

/// Keeps a hardware GPU busy until its clock is up: an idle GPU is a few times slower at first.
fn raise_clock(machine: &mut OnGpu, settings: &RenderSettings) -> Result<()> {
    let start = Instant::now();
    while !machine.is_software() && start.elapsed() < Duration::from_millis(500) {
        machine.render(settings)?;
    }
    Ok(())
}

/// Whether the GPU has no kernels for this codec.
fn is_codec(error: &anyhow::Error) -> bool {
    matches!(error.downcast_ref(), Some(GpuError::Codec { .. }))
}
