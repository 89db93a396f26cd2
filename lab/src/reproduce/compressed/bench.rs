//! The machines that time frames: the CPU, or a GPU. Counts come from the CPU in either case.

#[cfg(feature = "gpu")]
pub mod agreement;
#[cfg(feature = "gpu")]
mod on_gpu;

use super::frames::{Round, take_turns};
use super::methods::Prepared;
use crate::measure::rounds::Rounds;
use crate::reproduce::steps::Steps;
use anyhow::Result;
use serde::Serialize;
use slimbvh::{Cpu, RenderSettings};
use slimbvh_cli::backend::Chosen;

/// The kind of machine that times frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    not(feature = "gpu"),
    expect(dead_code, reason = "without the feature there are only cores")
)]
pub enum TimedOn {
    Cores,
    /// A software adapter.
    Software,
    Gpu,
}

/// A machine that times the methods on a scene.
pub trait Bench {
    /// The GPU's record of the plain tree, if a GPU times. `reference` is the same tree on the CPU, with its picture.
    fn plain(
        &mut self,
        reference: &Steps<Cpu>,
        settings: &RenderSettings,
    ) -> Result<Option<GpuRecord>>;

    /// Times a method, alternating with the plain tree. Both are on the CPU already.
    fn time(
        &mut self,
        both: (&mut Steps<Cpu>, &mut Steps<Cpu>),
        prepared: &Prepared,
        settings: &RenderSettings,
        round_count: u32,
    ) -> Result<Timed>;
}

/// Brings the plain tree to the chosen machine, so that a scene too large for it is reported at once.
pub fn open<'a>(chosen: &'a Chosen, plain: &'a Prepared) -> Result<Box<dyn Bench + 'a>> {
    #[cfg(not(feature = "gpu"))]
    let _ = plain;
    Ok(match chosen {
        Chosen::Cpu => Box::new(Cores),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => Box::new(on_gpu::GpuBench::new(gpu, plain)?),
    })
}

/// The CPU, which times the trees that it counts.
struct Cores;

impl Bench for Cores {
    fn plain(&mut self, _: &Steps<Cpu>, _: &RenderSettings) -> Result<Option<GpuRecord>> {
        Ok(None)
    }

    fn time(
        &mut self,
        (plain, own): (&mut Steps<Cpu>, &mut Steps<Cpu>),
        _: &Prepared,
        settings: &RenderSettings,
        round_count: u32,
    ) -> Result<Timed> {
        Ok(Timed {
            rounds: take_turns((plain, own), settings, round_count)?,
            on_gpu: None,
        })
    }
}

/// The times of a method, and its record on the GPU.
pub struct Timed {
    pub rounds: Rounds<Round>,
    pub on_gpu: Option<GpuRecord>,
}

/// Buffers on the GPU, and its agreement with the CPU.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct GpuRecord {
    pub buffers: Buffers,
    pub likeness: Agreement,
}

/// Bytes of buffers. Buffers are kept and only grow, so that these are their maxima. Parameters, the view and read-back
/// buffers are not included.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Buffers {
    /// The tree and its triangles, with room for the largest number of nodes and the largest triangles possible.
    pub tree: u64,
    /// Buffers between the stages of a build; with a codec also nodes and triangles in full precision.
    pub builder: u64,
    pub renderer: u64,
    /// The caller's mesh and materials.
    pub scene: u64,
}

/// Agreement of the GPU's results with the CPU's.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Agreement {
    /// Rays whose nodes and triangles were counted on both.
    pub rays: usize,
    pub counted_otherwise: usize,
    pub pixels: usize,
    /// Pixels that differ by more than 1 of 255 in any channel.
    pub pixels_unlike: usize,
}

impl Buffers {
    pub fn together(&self) -> u64 {
        self.tree + self.builder + self.renderer + self.scene
    }
}

impl TimedOn {
    pub fn of(chosen: &Chosen) -> Self {
        match chosen {
            Chosen::Cpu => Self::Cores,
            #[cfg(feature = "gpu")]
            Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => {
                match gpu.device().adapter_info().device_type {
                    wgpu::DeviceType::Cpu => Self::Software,
                    _ => Self::Gpu,
                }
            }
        }
    }

    pub fn is_gpu(self) -> bool {
        self != Self::Cores
    }
}
