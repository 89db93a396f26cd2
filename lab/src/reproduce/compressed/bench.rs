//! Where frames are timed: on cores, or on a GPU beside which the cores count.

#[cfg(feature = "gpu")]
pub mod likeness;
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

/// What kind of machine times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    not(feature = "gpu"),
    expect(dead_code, reason = "without the feature there are only cores")
)]
pub enum Place {
    Cores,
    /// A GPU that computes in software.
    Software,
    Gpu,
}

/// What times a scene's methods.
pub trait Bench {
    /// What there is of the plain tree beside the times; the reference is the same on cores, with its picture.
    fn plain(
        &mut self,
        reference: &Steps<Cpu>,
        settings: &RenderSettings,
    ) -> Result<Option<GpuRecord>>;

    /// Times a method in turn with the plain tree; both are on cores already.
    fn time(
        &mut self,
        both: (&mut Steps<Cpu>, &mut Steps<Cpu>),
        prepared: &Prepared,
        settings: &RenderSettings,
        round_count: u32,
    ) -> Result<Timed>;
}

/// Brings the plain tree to what was chosen, so that what is too large for it is told at once.
pub fn open<'a>(chosen: &'a Chosen, plain: &'a Prepared) -> Result<Box<dyn Bench + 'a>> {
    #[cfg(not(feature = "gpu"))]
    let _ = plain;
    Ok(match chosen {
        Chosen::Cpu => Box::new(Cores),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => Box::new(on_gpu::GpuBench::new(gpu, plain)?),
    })
}

/// The trees that counts are taken from.
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

/// What was timed of a method, and where.
#[derive(Default)]
pub struct Timed {
    /// None where the GPU does not have the codecs.
    pub rounds: Rounds<Round>,
    pub on_gpu: Option<GpuRecord>,
}

/// What is on the GPU beside the times.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct GpuRecord {
    pub buffers: Buffers,
    pub likeness: Likeness,
}

/// Bytes of buffers. They are kept and only grow, so that these are the most there ever were; parameters, the view, and what is
/// read back are not among them.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Buffers {
    /// The tree and its triangles, with room for as many nodes and as long triangles as there could be.
    pub tree: u64,
    /// Of what is between the stages of a build; with a codec also nodes and triangles in full.
    pub builder: u64,
    pub renderer: u64,
    /// The caller's mesh, and its materials.
    pub scene: u64,
}

/// How like the CPU's all is that the GPU made.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Likeness {
    /// Rays whose nodes and triangles were counted on both.
    pub rays: usize,
    pub counted_otherwise: usize,
    pub pixels: usize,
    /// By more than one of 255 in any channel.
    pub pixels_unlike: usize,
}

impl Buffers {
    pub fn together(&self) -> u64 {
        self.tree + self.builder + self.renderer + self.scene
    }
}

impl Place {
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
