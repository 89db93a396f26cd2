//! A frame: commands recorded together and submitted together.

use super::buffer::{Download, Range};
use super::signal::signal;
use super::timer::Timer;
use super::{Gpu, GpuError, Misfit};
use crate::Stages;

/// The stage of compiling kernels, which takes the host's time.
pub const COMPILE: &str = "compile";

/// Commands for the GPU in the order of recording: one submission of its own ([`Gpu::frame`]), or a part of the caller's
/// ([`Gpu::frame_in`]).
///
/// Frames run in the order in which they were recorded, so command buffers are submitted in that order.
///
/// ```no_run
/// use slimbvh::gpu::{Builder, Bvh, Frame, Gpu, GpuError, Mesh, Query, Rays, wgpu};
/// # fn run(
/// #     gpu: &Gpu, builder: &mut Builder, mesh: &Mesh, bvh: &mut Bvh, rays: Rays, hits: &wgpu::Buffer,
/// # ) -> Result<(), GpuError> {
/// let mut frame: Frame = gpu.frame();
/// builder.build(&mut frame, mesh, bvh)?;
/// bvh.trace(&mut frame, Query::Closest, rays, hits.slice(..))?;
/// frame.submit()?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Frame<'g> {
    gpu: &'g Gpu,
    encoder: wgpu::CommandEncoder,
    timer: Option<Timer>,
    fault: Option<GpuError>,
    /// Stage `compile`, if kernels were compiled for this frame.
    compiling: Stages,
}

impl<'g> Frame<'g> {
    pub(super) fn new(gpu: &'g Gpu) -> Self {
        let descriptor = wgpu::CommandEncoderDescriptor {
            label: Some("slimbvh frame"),
        };
        let encoder = gpu.device().create_command_encoder(&descriptor);
        Self::within(gpu, encoder)
    }

    pub(super) fn within(gpu: &'g Gpu, encoder: wgpu::CommandEncoder) -> Self {
        // Errors from here on are returned when the frame ends.
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
            encoder,
            timer,
            fault,
            compiling: Stages::default(),
        }
    }

    /// The GPU of this frame.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Frame, Gpu, GpuError, wgpu};
    /// # fn run(frame: &mut Frame) -> Result<(), GpuError> {
    /// // A function that records needs the frame alone.
    /// fn record(frame: &mut Frame) -> Result<(), GpuError> {
    ///     let limits = frame.gpu().limits();
    ///     println!("at most {} bytes a binding", limits.max_storage_buffer_binding_size);
    ///     Ok(())
    /// }
    /// # record(frame)?;
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn gpu(&self) -> &'g Gpu {
        self.gpu
    }

    /// The encoder, for the caller's own commands before, between and after those of slimbvh.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Builder, Bvh, Gpu, GpuError, Mesh, wgpu};
    /// # fn run(
    /// #     gpu: &Gpu, pipeline: &wgpu::ComputePipeline, builder: &mut Builder, mesh: &Mesh,
    /// #     bvh: &mut Bvh,
    /// # ) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// let mut pass = frame.encoder().begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    /// pass.set_pipeline(pipeline);
    /// pass.dispatch_workgroups(64, 1, 1);
    /// drop(pass);
    /// builder.build(&mut frame, mesh, bvh)?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn encoder(&mut self) -> &mut wgpu::CommandEncoder {
        &mut self.encoder
    }

    /// Adds to stage `compile`.
    pub(super) fn compiled(&mut self, compiling: &Stages) {
        self.compiling.merge(compiling);
    }

    /// Begins a pass that is timed as part of a stage.
    pub(super) fn pass(&mut self, stage: &'static str) -> wgpu::ComputePass<'static> {
        let timestamp_writes = self.timer.as_mut().and_then(|timer| timer.pass(stage));
        let descriptor = wgpu::ComputePassDescriptor {
            label: Some(stage),
            timestamp_writes,
        };
        let pass = self.encoder.begin_compute_pass(&descriptor);
        pass.forget_lifetime()
    }

    /// Copies a range, to be read when the frame is done.
    pub(super) fn download(&mut self, range: &Range) -> Download {
        Download::record(self.gpu, self.encoder(), range)
    }

    /// Copies a buffer's contents at this point of the frame, to be read when the frame is done.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Gpu, GpuError, Query, Rays, wgpu};
    /// # fn run(gpu: &Gpu, bvh: &Bvh, rays: Rays, found: &wgpu::Buffer) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// bvh.trace(&mut frame, Query::Any, rays, found.slice(..))?;
    /// let download = frame.read_later(found.slice(..))?;
    /// frame.submit()?;
    /// let found: Vec<u32> = download.read(gpu)?;
    /// # Ok(())
    /// # }
    /// ```
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
    /// ```no_run
    /// # use slimbvh::gpu::{Builder, Bvh, Gpu, GpuError, Mesh};
    /// # fn run(gpu: &Gpu, builder: &mut Builder, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// builder.refit(&mut frame, mesh, bvh)?;
    /// // Nothing waits; later submissions find the tree.
    /// frame.submit()?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device refuses a command, memory is exhausted, or the device was lost.
    pub fn submit(self) -> Result<Submission<'g>, GpuError> {
        let gpu = self.gpu;
        let (commands, recorded) = self.finish()?;
        let index = gpu.checked(|| Ok(gpu.queue().submit([commands])))?;
        Ok(recorded.submitted(gpu, index))
    }

    /// Ends recording: the caller submits the commands, alone or with others.
    ///
    /// ```no_run
    /// use slimbvh::gpu::{Bvh, Gpu, GpuError, Query, wgpu};
    /// # fn run(gpu: &Gpu, bvh: &Bvh, rays: &wgpu::Buffer, hits: &wgpu::Buffer, others: wgpu::CommandBuffer) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// bvh.trace(&mut frame, Query::Closest, rays.slice(..), hits.slice(..))?;
    /// let (commands, recorded) = frame.finish()?;
    /// let index = gpu.queue().submit([commands, others]);
    /// println!("{}", recorded.submitted(gpu, index).wait()?);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device refuses a command, memory is exhausted, or the device was lost.
    pub fn finish(self) -> Result<(wgpu::CommandBuffer, Recorded), GpuError> {
        let gpu = self.gpu;
        let (encoder, recorded) = self.end()?;
        Ok((gpu.checked(|| Ok(encoder.finish()))?, recorded))
    }

    /// Ends recording, and gives the encoder back for the caller's further commands: see [`Gpu::frame_in`]. What the device objects to
    /// in the commands, wgpu reports where the caller finishes the encoder.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Gpu, GpuError, Query, Rays, wgpu};
    /// # fn run(
    /// #     gpu: &Gpu, encoder: wgpu::CommandEncoder, bvh: &Bvh, rays: Rays, hits: &wgpu::Buffer,
    /// # ) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame_in(encoder);
    /// bvh.trace(&mut frame, Query::Closest, rays, hits.slice(..))?;
    /// let (encoder, _) = frame.end()?;
    /// gpu.queue().submit([encoder.finish()]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If memory is exhausted, or the device was lost.
    pub fn end(mut self) -> Result<(wgpu::CommandEncoder, Recorded), GpuError> {
        if let Some(fault) = self.fault {
            return Err(fault);
        }
        if let Some(timer) = &self.timer {
            timer.resolve(&mut self.encoder);
        }
        let recorded = Recorded {
            timer: self.timer,
            compiling: self.compiling,
        };
        Ok((self.encoder, recorded))
    }
}

/// What remains of a frame whose commands the caller submits: its times. Who drops it does without them.
///
/// ```no_run
/// use slimbvh::gpu::{Frame, Gpu, GpuError, Recorded, wgpu};
/// # fn run(gpu: &Gpu, frame: Frame, wants_times: bool) -> Result<(), GpuError> {
/// let (commands, recorded): (wgpu::CommandBuffer, Recorded) = frame.finish()?;
/// let index = gpu.queue().submit([commands]);
/// if wants_times {
///     println!("{}", recorded.submitted(gpu, index).wait()?);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Recorded {
    timer: Option<Timer>,
    compiling: Stages,
}

impl Recorded {
    /// Stage `compile`, if kernels were compiled for the frame.
    pub(super) fn into_compiling(self) -> Stages {
        self.compiling
    }

    /// The submission of the frame's commands, on the GPU that recorded them.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Frame, Gpu, GpuError};
    /// # fn run(gpu: &Gpu, build: Frame, trace: Frame) -> Result<(), GpuError> {
    /// let ((first, build), (second, trace)) = (build.finish()?, trace.finish()?);
    /// // Both in one submission.
    /// let index = gpu.queue().submit([first, second]);
    /// let build = build.submitted(gpu, index.clone()).wait()?;
    /// let trace = trace.submitted(gpu, index).wait()?;
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn submitted(self, gpu: &Gpu, index: wgpu::SubmissionIndex) -> Submission<'_> {
        Submission {
            gpu,
            index,
            timer: self.timer,
            compiling: self.compiling,
        }
    }
}

/// A submitted frame. Waiting for it is optional.
///
/// ```no_run
/// use slimbvh::gpu::{Frame, Gpu, GpuError, Submission};
/// # fn run(gpu: &Gpu, frame: Frame) -> Result<(), GpuError> {
/// let submission: Submission = frame.submit()?;
/// // The host works meanwhile.
/// println!("{}", submission.wait()?);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Submission<'g> {
    gpu: &'g Gpu,
    index: wgpu::SubmissionIndex,
    timer: Option<Timer>,
    compiling: Stages,
}

impl Submission<'_> {
    /// Waits until the frame is done. Returns the time of each stage, if the adapter has timestamps; passes after the first 1024 of a
    /// frame are not timed. Where kernels were compiled for the frame, the host's time for that is stage `compile`:
    /// [`Gpu::warm_up`] compiles them before.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Builder, Bvh, Gpu, GpuError, Mesh};
    /// # fn run(gpu: &Gpu, builder: &mut Builder, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// builder.build(&mut frame, mesh, bvh)?;
    /// let stages = frame.submit()?.wait()?;
    /// println!("{stages}, in all {:?}", stages.total());
    /// # Ok(())
    /// # }
    /// ```
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
        let mut stages = std::mem::take(&mut self.compiling);
        if let Some(timer) = self.timer.take() {
            stages.merge(&timer.read(self.gpu).await?);
        }
        Ok(stages)
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
