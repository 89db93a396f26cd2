//! What is recorded together is submitted together.

use super::buffer::{Download, Range};
use super::timer::Timer;
use super::{Gpu, GpuError};
use crate::Stages;

/// Commands on their way to the GPU, in the order in which they are recorded: one submission.
#[derive(Debug)]
pub struct Frame<'g> {
    gpu: &'g Gpu,
    encoder: wgpu::CommandEncoder,
    timer: Option<Timer>,
}

impl<'g> Frame<'g> {
    pub(super) fn new(gpu: &'g Gpu) -> Self {
        let descriptor = wgpu::CommandEncoderDescriptor {
            label: Some("slimbvh frame"),
        };
        Self {
            gpu,
            encoder: gpu.device().create_command_encoder(&descriptor),
            timer: gpu.timers.take(gpu.device()),
        }
    }

    /// The GPU that this goes to.
    #[must_use]
    pub fn gpu(&self) -> &'g Gpu {
        self.gpu
    }

    /// The encoder, for own commands before, between and after ours.
    pub fn encoder(&mut self) -> &mut wgpu::CommandEncoder {
        &mut self.encoder
    }

    /// Begins a pass that is timed as part of a stage.
    pub(super) fn pass(&mut self, stage: &'static str) -> wgpu::ComputePass<'static> {
        let timestamp_writes = self.timer.as_mut().and_then(|timer| timer.pass(stage));
        let descriptor = wgpu::ComputePassDescriptor {
            label: Some(stage),
            timestamp_writes,
        };
        self.encoder
            .begin_compute_pass(&descriptor)
            .forget_lifetime()
    }

    /// Copies a range for the caller to read when the frame is done.
    pub(super) fn download(&mut self, range: &Range) -> Download {
        Download::record(self.gpu, &mut self.encoder, range)
    }

    /// Copies what a buffer holds at this point of the frame, to be read when the frame is done.
    ///
    /// # Errors
    /// If the buffer cannot be copied from.
    pub fn read_later(&mut self, slice: wgpu::BufferSlice) -> Result<Download, GpuError> {
        let gpu = self.gpu;
        gpu.checked(|| Ok(self.download(&Range::of_slice(slice))))
    }

    /// Sends all that was recorded.
    ///
    /// # Errors
    /// If a command is refused, memory is exhausted, or the device was lost.
    pub fn submit(mut self) -> Result<Submission<'g>, GpuError> {
        let gpu = self.gpu;
        if let Some(timer) = &self.timer {
            timer.resolve(&mut self.encoder);
        }
        let index = gpu.checked(|| Ok(gpu.queue().submit([self.encoder.finish()])))?;
        Ok(Submission {
            gpu,
            index,
            timer: self.timer,
        })
    }
}

/// A frame that the GPU has or is working on. Nothing needs to wait for it.
#[derive(Debug)]
pub struct Submission<'g> {
    gpu: &'g Gpu,
    index: wgpu::SubmissionIndex,
    timer: Option<Timer>,
}

impl Submission<'_> {
    /// Waits until it is done. Returns the time of each stage, or none where the adapter has no timestamps.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn wait(self) -> Result<Stages, GpuError> {
        self.gpu.wait(Some(self.index))?;
        match self.timer {
            Some(timer) => timer.read(self.gpu),
            None => Ok(Stages::default()),
        }
    }
}
