//! A frame: commands recorded together and submitted together.

use super::buffer::{Download, Range};
use super::signal::signal;
use super::timer::Timer;
use super::{Gpu, GpuError, Misfit};
use crate::Stages;

/// Commands for the GPU in the order of recording; one submission.
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
        // Errors from here on are returned when the frame is submitted.
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

    /// The GPU of this frame.
    #[must_use]
    pub fn gpu(&self) -> &'g Gpu {
        self.gpu
    }

    /// The encoder, for the caller's own commands before, between and after those of slimbvh.
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

    /// Copies a range, to be read when the frame is done.
    pub(super) fn download(&mut self, range: &Range) -> Download {
        Download::record(self.gpu, &mut self.encoder, range)
    }

    /// Copies a buffer's contents at this point of the frame, to be read when the frame is done.
    ///
    /// # Errors
    /// For a buffer without the usage `COPY_SRC`, and a slice whose ends are not multiples of 4 bytes.
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

    /// Submits all recorded commands.
    ///
    /// # Errors
    /// If the device refuses a command, memory is exhausted, or the device was lost.
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

/// A submitted frame. Waiting for it is optional.
#[derive(Debug)]
pub struct Submission<'g> {
    gpu: &'g Gpu,
    index: wgpu::SubmissionIndex,
    timer: Option<Timer>,
}

impl Submission<'_> {
    /// Waits until the frame is done. Returns the time of each stage; empty if the adapter has no timestamps. Passes after
    /// the first 1024 of a frame are not timed.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn wait(self) -> Result<Stages, GpuError> {
        let gpu = self.gpu;
        gpu.wait(Some(self.index.clone()))?;
        gpu.block_on(self.stages())
    }

    /// [`Self::wait`], without blocking. Waits also for what was submitted before the future is first polled.
    ///
    /// ```no_run
    /// # async fn run(gpu: &slimbvh::gpu::Gpu) -> Result<(), slimbvh::gpu::GpuError> {
    /// let frame = gpu.frame();
    /// println!("{}", frame.submit()?.wait_async().await?);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of all earlier calls.
    pub async fn wait_async(self) -> Result<Stages, GpuError> {
        let (sender, done) = signal();
        self.gpu
            .queue()
            .on_submitted_work_done(move || sender.send(()));
        let done = done.await;
        self.gpu.settle().await?;
        if done.is_none() {
            return Err(self.gpu.lost("its work did not end"));
        }
        self.stages().await
    }

    /// The time of each stage of a finished frame.
    async fn stages(mut self) -> Result<Stages, GpuError> {
        match self.timer.take() {
            Some(timer) => timer.read(self.gpu).await,
            None => Ok(Stages::default()),
        }
    }
}

impl Drop for Submission<'_> {
    /// Nothing read the times: the timer goes to the next frame, whose commands follow these.
    fn drop(&mut self) {
        if let Some(timer) = self.timer.take() {
            self.gpu.timers.give_back(timer);
        }
    }
}
