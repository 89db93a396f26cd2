//! What is recorded together is submitted together.

use super::buffer::{Download, Range};
use super::timer::Timer;
use super::{Gpu, GpuError, Misfit};
use crate::Stages;

/// Commands on their way to the GPU, in the order in which they are recorded: one submission.
#[derive(Debug)]
pub struct Frame<'g> {
    gpu: &'g Gpu,
    encoder: wgpu::CommandEncoder,
    timer: Option<Timer>,
    fault: Option<GpuError>,
}

impl<'g> Frame<'g> {
    pub(super) fn new(gpu: &'g Gpu) -> Self {
        let descriptor = wgpu::CommandEncoderDescriptor {
            label: Some("slimbvh frame"),
        };
        // What goes wrong here is told when the frame is submitted.
        let (mut timer, mut fault) = (None, None);
        let made = gpu.checked(|| {
            timer = gpu.timers.take(gpu.device());
            Ok(())
        });
        if let Err(error) = made {
            (timer, fault) = (None, Some(error));
        }
        Self {
            gpu,
            encoder: gpu.device().create_command_encoder(&descriptor),
            timer,
            fault,
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
    /// For a buffer without the usage `COPY_SRC`, and a slice that does not begin and end at multiples of 4 bytes.
    pub fn read_later(&mut self, slice: wgpu::BufferSlice) -> Result<Download, GpuError> {
        let (gpu, range) = (self.gpu, Range::of_slice(slice));
        let unfit = |fault: Misfit| Err(fault.of("the buffer to read"));
        if !range.buffer.usage().contains(wgpu::BufferUsages::COPY_SRC) {
            return unfit(Misfit::MissingUsage { usage: "COPY_SRC" });
        }
        if !(range.offset.is_multiple_of(4) && range.size.is_multiple_of(4)) {
            return unfit(Misfit::PartialWord {
                offset: range.offset,
                bytes: range.size,
            });
        }
        gpu.checked(|| Ok(self.download(&range)))
    }

    /// Sends all that was recorded.
    ///
    /// # Errors
    /// If a command is refused, memory is exhausted, or the device was lost.
    pub fn submit(mut self) -> Result<Submission<'g>, GpuError> {
        let gpu = self.gpu;
        if let Some(fault) = self.fault {
            return Err(fault);
        }
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
    /// Waits until it is done. Returns the time of each stage, or none where the adapter has no timestamps; passes after
    /// the first 1024 of a frame are not timed.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn wait(mut self) -> Result<Stages, GpuError> {
        self.gpu.wait(Some(self.index.clone()))?;
        match self.timer.take() {
            Some(timer) => timer.read(self.gpu),
            None => Ok(Stages::default()),
        }
    }
}

impl Drop for Submission<'_> {
    /// Nobody asked for the times: the next frame may have the timer, whose commands come after these.
    fn drop(&mut self) {
        if let Some(timer) = self.timer.take() {
            self.gpu.timers.give_back(timer);
        }
    }
}
