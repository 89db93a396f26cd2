//! A device with its compiled kernels and its reported errors.

use super::buffer::Range;
use super::frame::COMPILE;
use super::kernel::{Kernel, Pipelines, compile};
use super::scopes::Unanswered;
use super::timer::TimerPool;
use super::trace::overflow::{Lists, Overflow};
use super::{AdapterChoice, Frame, GpuError, adapter};
use crate::Stages;
use std::future::Future;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::pin;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::task::{Context, Poll, Wake, Waker};
use std::thread::{self, Thread};
use std::time::Duration;

/// Whether a thread may wait for the GPU. On a web page it would keep the browser from going on.
const CAN_BLOCK: bool = cfg!(not(all(target_family = "wasm", target_os = "unknown")));

/// The interval between polls of the GPU.
const PAUSE: Duration = Duration::from_micros(50);

/// An open GPU: its own device, or one that the caller opened.
///
/// A kernel is compiled at its first use. All methods that record or submit work return the driver's errors as
/// [`GpuError`]; none panics or reaches wgpu's own handler.
///
/// Methods that wait have twins that end in `_async`. A browser allows only these, and tells the errors of a call later:
/// the next `wait_async` or `read_async` returns them, or any later call that records or submits. After such an error,
/// build anew.
#[derive(Debug)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    name: String,
    limits: wgpu::Limits,
    pipelines: Pipelines,
    pub(super) timers: TimerPool,
    /// The lists of [`super::Bvh::trace`].
    lists: Mutex<Lists>,
    lost: Arc<OnceLock<String>>,
    late: Arc<Mutex<Option<String>>>,
    unanswered: Unanswered,
}

impl Gpu {
    /// Opens an adapter with all its limits.
    ///
    /// # Errors
    /// If there is no such adapter, the driver refuses to open it, or its limits are too small for the kernels.
    pub fn open(choice: &AdapterChoice) -> Result<Self, GpuError> {
        if !CAN_BLOCK {
            return Err(GpuError::CannotBlock);
        }
        pollster::block_on(Self::open_async(choice))
    }

    /// [`Self::open`], without blocking: for browsers. A browser has one adapter, of the name "WebGPU".
    ///
    /// ```no_run
    /// use slimbvh::gpu::{AdapterChoice, Gpu};
    /// # async fn run() -> Result<(), slimbvh::gpu::GpuError> {
    /// let gpu = Gpu::open_async(&AdapterChoice::Any).await?;
    /// println!("{}", gpu.name());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::open`].
    pub async fn open_async(choice: &AdapterChoice) -> Result<Self, GpuError> {
        let adapter = adapter::choose(choice).await?;
        let name = adapter::name_of(adapter.get_info());
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("slimbvh"),
            required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
            required_limits: adapter.limits(),
            memory_hints: wgpu::MemoryHints::MemoryUsage,
            ..wgpu::DeviceDescriptor::default()
        };
        let opened = adapter.request_device(&descriptor).await;
        let (device, queue) = opened.map_err(|error| GpuError::Refused {
            adapter: name,
            reason: one_line(&error.to_string()),
        })?;
        let gpu = Self::from_device(device, queue)?;

        // slimbvh opened this device, so it sets the handlers.
        let lost = Arc::clone(&gpu.lost);
        gpu.device.set_device_lost_callback(move |_, message| {
            // Only the first reason is kept.
            let _ = lost.set(one_line(&message));
        });
        let late = Arc::clone(&gpu.late);
        gpu.device.on_uncaptured_error(Arc::new(move |error| {
            *late.lock().unwrap_or_else(PoisonError::into_inner) =
                Some(one_line(&error.to_string()));
        }));
        Ok(gpu)
    }

    /// Uses a device that the caller opened, with its limits. With the feature `TIMESTAMP_QUERY`, stages are timed. The
    /// caller's handlers of errors and of device loss stay in place; a lost device is reported by the next call that waits.
    ///
    /// The kernels need 8 storage buffers a stage, workgroups of 64 invocations with 16 KiB of memory, and 32,768 workgroups a
    /// dimension. WebGPU promises as much.
    ///
    /// # Errors
    /// If the device's limits are smaller.
    pub fn from_device(device: wgpu::Device, queue: wgpu::Queue) -> Result<Self, GpuError> {
        let (limits, name) = (device.limits(), adapter::name_of(device.adapter_info()));
        let needs: [(&'static str, u64, u64); 4] = [
            (
                "max_storage_buffers_per_shader_stage",
                limits.max_storage_buffers_per_shader_stage.into(),
                8,
            ),
            (
                "max_compute_workgroup_storage_size",
                limits.max_compute_workgroup_storage_size.into(),
                16_384,
            ),
            (
                "max_compute_invocations_per_workgroup",
                limits.max_compute_invocations_per_workgroup.into(),
                slimbvh_core::launch::LANES as u64,
            ),
            (
                "max_compute_workgroups_per_dimension",
                limits.max_compute_workgroups_per_dimension.into(),
                slimbvh_core::launch::GROUPS_PER_ROW.into(),
            ),
        ];
        for (limit, has, needs) in needs {
            if has < needs {
                return Err(GpuError::TooSmall {
                    adapter: name,
                    limit,
                    has,
                    needs,
                });
            }
        }
        Ok(Self {
            timers: TimerPool::new(&device),
            lists: Mutex::default(),
            device,
            queue,
            name,
            limits,
            pipelines: Pipelines::default(),
            lost: Arc::default(),
            late: Arc::default(),
            unanswered: Unanswered::default(),
        })
    }

    /// The device, for the caller's own work.
    #[must_use]
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// The queue, for the caller's own work.
    #[must_use]
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// The adapter's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The device's limits.
    #[must_use]
    pub fn limits(&self) -> &wgpu::Limits {
        &self.limits
    }

    /// Begins a frame. All commands recorded into it form one submission.
    #[must_use]
    pub fn frame(&self) -> Frame<'_> {
        Frame::new(self)
    }

    /// Begins a frame in the caller's encoder, between the caller's own commands. [`Frame::end`] gives the encoder back.
    ///
    /// ```no_run
    /// use slimbvh::gpu::{Builder, Bvh, Gpu, GpuError, Mesh, wgpu};
    /// # fn run(gpu: &Gpu, builder: &mut Builder, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
    /// let encoder = gpu.device().create_command_encoder(&Default::default());
    /// // Here the caller's compute pass may move the mesh's vertices.
    /// let mut frame = gpu.frame_in(encoder);
    /// builder.build(&mut frame, mesh, bvh)?;
    /// let (encoder, recorded) = frame.end()?;
    /// // Here the caller's passes may trace the tree.
    /// let index = gpu.queue().submit([encoder.finish()]);
    /// println!("{}", recorded.submitted(gpu, index).wait()?);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn frame_in(&self, encoder: wgpu::CommandEncoder) -> Frame<'_> {
        Frame::within(self, encoder)
    }

    /// A compiled kernel, for the caller's own dispatches; see [`Kernel`].
    ///
    /// # Errors
    /// Those of the driver's compiler, and if the kernel is not compiled in ([`Kernel`]).
    pub fn pipeline(&self, kernel: Kernel) -> Result<wgpu::ComputePipeline, GpuError> {
        self.pipeline_in(kernel, &mut Stages::default())
    }

    /// [`Self::pipeline`], with the time of compiling added to stage `compile`.
    pub(super) fn pipeline_in(
        &self,
        kernel: Kernel,
        stages: &mut Stages,
    ) -> Result<wgpu::ComputePipeline, GpuError> {
        if let Some(pipeline) = self.pipelines.compiled(kernel) {
            return Ok(pipeline);
        }
        // Kept only if compilation reported no error.
        let compiled = || self.checked(|| compile(&self.device, kernel));
        let pipeline = stages.time(COMPILE, compiled)?;
        self.pipelines.keep(kernel, &pipeline);
        Ok(pipeline)
    }

    /// The list of a trace of this many rays, which is recorded next.
    pub(super) fn overflow(&self, ray_count: u64) -> Overflow {
        self.lists().overflow(self, ray_count)
    }

    /// [`Lists::ray_groups`].
    pub(super) fn ray_groups(&self) -> Range {
        self.lists().ray_groups(self)
    }

    /// [`Lists::no_ends`].
    pub(super) fn no_ends(&self) -> wgpu::Buffer {
        self.lists().no_ends(self)
    }

    fn lists(&self) -> MutexGuard<'_, Lists> {
        self.lists.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs commands, and turns what the driver objects to into an error.
    pub(super) fn checked<R>(
        &self,
        work: impl FnOnce() -> Result<R, GpuError>,
    ) -> Result<R, GpuError> {
        self.check_alive()?;
        let late = self
            .late
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        if let Some(reason) = late {
            return Err(GpuError::Invalid {
                adapter: self.name.clone(),
                reason,
            });
        }
        self.refused(self.unanswered.answered())?;
        let filters = [
            wgpu::ErrorFilter::OutOfMemory,
            wgpu::ErrorFilter::Internal,
            wgpu::ErrorFilter::Validation,
        ];
        let [memory, internal, validation] = filters.map(|f| self.device.push_error_scope(f));
        let result = work();
        // Scopes end in the order opposite to that in which they began.
        let (validation, internal, memory) = (validation.pop(), internal.pop(), memory.pop());
        let error = self.unanswered.error_of(async {
            let (validation, internal) = (validation.await, internal.await);
            memory.await.or(internal).or(validation)
        });
        if error.is_some() {
            // A loss is reported only when the device is polled, and after the errors that it causes.
            let _ = self.poll_device(wgpu::PollType::Poll);
        }
        self.check_alive()?;
        match error {
            Some(error) => Err(self.describe(&error)),
            None => result,
        }
    }

    /// Waits for the errors of all calls. Natively they are known already.
    pub(super) async fn settle(&self) -> Result<(), GpuError> {
        let error = self.unanswered.all().await;
        self.check_alive()?;
        self.refused(error)
    }

    /// An error that came after the call that caused it. What that call made is not kept.
    fn refused(&self, error: Option<wgpu::Error>) -> Result<(), GpuError> {
        let Some(error) = error else {
            return Ok(());
        };
        self.pipelines.clear();
        Err(self.describe(&error))
    }

    /// Fails once the device is lost.
    pub(super) fn check_alive(&self) -> Result<(), GpuError> {
        match self.lost.get() {
            Some(reason) => Err(self.lost(reason)),
            None => Ok(()),
        }
    }

    pub(super) fn lost(&self, reason: &str) -> GpuError {
        GpuError::Lost {
            adapter: self.name.clone(),
            reason: reason.into(),
        }
    }

    /// Waits for a submission, or for all.
    pub(super) fn wait(&self, submission: Option<wgpu::SubmissionIndex>) -> Result<(), GpuError> {
        if !CAN_BLOCK {
            return Err(GpuError::CannotBlock);
        }
        let waited = self.poll_device(wgpu::PollType::Wait {
            submission_index: submission,
            timeout: None,
        });
        self.check_alive()?;
        waited.map_err(|reason| self.lost(&reason))
    }

    /// Runs a future to its end on this thread.
    pub(super) fn block_on<R>(
        &self,
        work: impl Future<Output = Result<R, GpuError>>,
    ) -> Result<R, GpuError> {
        if !CAN_BLOCK {
            return Err(GpuError::CannotBlock);
        }
        let waker = Waker::from(Arc::new(Unpark(thread::current())));
        let mut context = Context::from_waker(&waker);
        let mut work = pin!(work);
        // `wait` would also wait for later submissions. Another thread that polls may run the callback.
        loop {
            if let Poll::Ready(result) = work.as_mut().poll(&mut context) {
                return result;
            }
            self.poll()?;
            thread::park_timeout(PAUSE);
        }
    }

    /// Runs the callbacks of finished work, which wake the futures of `_async` methods, and does not wait. Natively
    /// someone must poll while a future waits: this method, a method that blocks, or wgpu's own. Browsers need no polls.
    ///
    /// ```no_run
    /// use std::task::{Context, Waker};
    /// # fn run(gpu: &slimbvh::gpu::Gpu) -> Result<(), slimbvh::gpu::GpuError> {
    /// let mut stages = Box::pin(gpu.frame().submit()?.wait_async());
    /// // Once in each turn of an event loop:
    /// gpu.poll()?;
    /// let is_done = stages.as_mut().poll(&mut Context::from_waker(Waker::noop())).is_ready();
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device was lost.
    pub fn poll(&self) -> Result<(), GpuError> {
        let polled = self.poll_device(wgpu::PollType::Poll);
        self.check_alive()?;
        polled.map_err(|reason| self.lost(&reason))
    }

    /// Polls the device. wgpu 30 panics if the driver reports during a wait that the device is lost, after releasing all
    /// its locks.
    fn poll_device(&self, how: wgpu::PollType) -> Result<(), String> {
        match catch_unwind(AssertUnwindSafe(|| self.device.poll(how))) {
            Ok(Ok(_)) => Ok(()),
            Ok(Err(error)) => Err(one_line(&error.to_string())),
            Err(_) => Err("its driver failed".into()),
        }
    }

    /// Refuses sizes that exceed a buffer or a storage binding, before anything is allocated.
    pub(super) fn check_sizes(
        &self,
        sizes: &[(&'static str, u64)],
        advice: &'static str,
    ) -> Result<(), GpuError> {
        let limit_bytes = self.limits.max_storage_buffer_binding_size;
        for &(what, bytes) in sizes {
            self.check_buffer(what, bytes, advice)?;
            if bytes > limit_bytes {
                return Err(GpuError::TooLarge {
                    what,
                    bytes,
                    limit: "max_storage_buffer_binding_size",
                    limit_bytes,
                    adapter: self.name.clone(),
                    advice,
                });
            }
        }
        Ok(())
    }

    /// Refuses a size that exceeds a buffer.
    pub(super) fn check_buffer(
        &self,
        what: &'static str,
        bytes: u64,
        advice: &'static str,
    ) -> Result<(), GpuError> {
        let limit_bytes = self.limits.max_buffer_size;
        if bytes > limit_bytes {
            return Err(GpuError::TooLarge {
                what,
                bytes,
                limit: "max_buffer_size",
                limit_bytes,
                adapter: self.name.clone(),
                advice,
            });
        }
        Ok(())
    }

    fn describe(&self, error: &wgpu::Error) -> GpuError {
        let adapter = self.name.clone();
        match error {
            wgpu::Error::OutOfMemory { .. } => GpuError::OutOfMemory { adapter },
            wgpu::Error::Validation { description, .. }
            | wgpu::Error::Internal { description, .. } => GpuError::Invalid {
                adapter,
                reason: one_line(description),
            },
        }
    }
}

/// Wakes a thread that waits.
struct Unpark(Thread);

impl Wake for Unpark {
    fn wake(self: Arc<Self>) {
        self.0.unpark();
    }
}

/// One line of a message of the driver or of wgpu, which have many.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
