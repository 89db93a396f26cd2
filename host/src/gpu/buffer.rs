//! Reusable buffers, ranges of buffers, and downloads.

use super::signal::signal;
use super::work::Traffic;
use super::{Gpu, GpuError};
use bytemuck::AnyBitPattern;
use wgpu::BufferUsages;

/// Ranges begin at multiples of this. Every adapter accepts it.
pub const ALIGNMENT: u64 = 256;

/// A part of a buffer, and the bytes of it that a kernel accesses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Range {
    pub buffer: wgpu::Buffer,
    pub offset: u64,
    pub size: u64,
    pub traffic: Traffic,
}

impl Range {
    fn new(buffer: &wgpu::Buffer, offset: u64, size: u64) -> Self {
        Self {
            buffer: buffer.clone(),
            offset,
            size,
            traffic: Traffic {
                bytes: size,
                bytes_per_node: 0,
            },
        }
    }

    pub fn whole(buffer: &wgpu::Buffer) -> Self {
        Self::new(buffer, 0, buffer.size())
    }

    pub fn of_slice(slice: wgpu::BufferSlice) -> Self {
        Self::new(slice.buffer(), slice.offset(), slice.size())
    }

    /// A part of this range.
    pub fn part(&self, offset: u64, size: u64) -> Self {
        debug_assert!(offset + size <= self.size, "{offset} {size} {}", self.size);
        Self::new(&self.buffer, self.offset + offset, size)
    }

    /// The same range, of which a kernel accesses only this many bytes.
    pub fn touching(&self, bytes: u64) -> Self {
        Self {
            traffic: Traffic {
                bytes,
                bytes_per_node: 0,
            },
            ..self.clone()
        }
    }

    /// The same range, of which a kernel accesses this many bytes for each node.
    pub fn touching_nodes(&self, bytes_per_node: u64) -> Self {
        Self {
            traffic: Traffic {
                bytes: 0,
                bytes_per_node,
            },
            ..self.clone()
        }
    }

    /// The traffic of accessing the whole range.
    pub fn whole_traffic(&self) -> Traffic {
        if self.traffic.bytes_per_node > 0 {
            return self.traffic;
        }
        Traffic {
            bytes: self.size,
            bytes_per_node: 0,
        }
    }

    /// Whether both are the same part of the same buffer.
    pub fn is_same(&self, other: &Self) -> bool {
        self.buffer == other.buffer && (self.offset, self.size) == (other.offset, other.size)
    }

    pub fn binding(&self) -> wgpu::BufferBinding<'_> {
        wgpu::BufferBinding {
            buffer: &self.buffer,
            offset: self.offset,
            size: wgpu::BufferSize::new(self.size),
        }
    }
}

/// A buffer that is reused, and replaced by a larger one when needed.
#[derive(Clone, Debug)]
pub struct Slot {
    label: &'static str,
    usage: BufferUsages,
    buffer: Option<wgpu::Buffer>,
}

impl Slot {
    /// A slot for a storage buffer.
    pub const fn storage(label: &'static str) -> Self {
        Self::new(label, BufferUsages::STORAGE)
    }

    pub const fn new(label: &'static str, usage: BufferUsages) -> Self {
        Self {
            label,
            usage: usage.union(BufferUsages::COPY_SRC),
            buffer: None,
        }
    }

    /// A range of this many bytes with undefined contents. The caller checks sizes before.
    pub fn range(&mut self, gpu: &Gpu, bytes: u64) -> Range {
        let fits = self.buffer.as_ref().filter(|b| b.size() >= bytes).cloned();
        let buffer = fits.unwrap_or_else(|| {
            // The old buffer is freed first.
            self.buffer = None;
            gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some(self.label),
                size: bytes,
                usage: self.usage,
                mapped_at_creation: false,
            })
        });
        let range = Range::new(&buffer, 0, bytes);
        self.buffer = Some(buffer);
        range
    }

    /// A range of a new buffer of exactly this many bytes.
    pub fn renewed(&mut self, gpu: &Gpu, bytes: u64) -> Range {
        self.buffer = None;
        self.range(gpu, bytes)
    }

    /// The latest range, if it has this size.
    pub fn kept(&self, bytes: u64) -> Option<Range> {
        let buffer = self.buffer.as_ref().filter(|b| b.size() >= bytes)?;
        Some(Range::new(buffer, 0, bytes))
    }

    /// Frees the buffer.
    pub fn free(&mut self) {
        self.buffer = None;
    }

    pub const fn buffer(&self) -> Option<&wgpu::Buffer> {
        self.buffer.as_ref()
    }

    pub fn bytes(&self) -> u64 {
        self.buffer.as_ref().map_or(0, wgpu::Buffer::size)
    }
}

/// A new buffer with these contents, or with one zeroed element if there are none: no binding can be empty.
pub fn upload<T: bytemuck::NoUninit>(
    gpu: &Gpu,
    label: &'static str,
    usage: BufferUsages,
    items: &[T],
) -> wgpu::Buffer {
    let bytes: &[u8] = bytemuck::cast_slice(items);
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes.len().max(size_of::<T>()).next_multiple_of(4) as u64,
        usage: usage | BufferUsages::COPY_DST | BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    if !bytes.is_empty() {
        gpu.queue().write_buffer(&buffer, 0, bytes);
    }
    buffer
}

/// A copy made by a submitted frame, to be read when the frame is done.
#[derive(Debug)]
#[must_use]
pub struct Download(wgpu::Buffer);

impl Download {
    /// Records the copy of a range.
    pub(super) fn record(gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, from: &Range) -> Self {
        let to = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("slimbvh download"),
            size: from.size,
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        encoder.copy_buffer_to_buffer(&from.buffer, from.offset, &to, 0, from.size);
        Self(to)
    }

    /// Waits for the copy, and reads it.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read<T: AnyBitPattern + bytemuck::NoUninit>(
        self,
        gpu: &Gpu,
    ) -> Result<Vec<T>, GpuError> {
        gpu.block_on(self.read_async(gpu))
    }

    /// [`Self::read`], without blocking.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError};
    /// # async fn run(gpu: &Gpu, hits: &wgpu::Buffer) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// let download = frame.read_later(hits.slice(..))?;
    /// let stages = frame.submit()?.wait_async().await?;
    /// let hits: Vec<slimbvh::Hit> = download.read_async(gpu).await?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_async<T: AnyBitPattern + bytemuck::NoUninit>(
        self,
        gpu: &Gpu,
    ) -> Result<Vec<T>, GpuError> {
        self.map(gpu).await?.read()
    }

    /// Waits for the copy.
    pub(super) async fn map(self, gpu: &Gpu) -> Result<Mapped<'_>, GpuError> {
        Mapped::new(gpu, self.0).await
    }
}

/// A buffer that the host can read. It is unmapped when it is dropped.
#[derive(Debug)]
pub struct Mapped<'g> {
    gpu: &'g Gpu,
    buffer: wgpu::Buffer,
}

impl<'g> Mapped<'g> {
    /// Maps a buffer.
    pub async fn new(gpu: &'g Gpu, buffer: wgpu::Buffer) -> Result<Self, GpuError> {
        let (sender, mapped) = signal();
        gpu.checked(|| {
            buffer.map_async(wgpu::MapMode::Read, .., |result| sender.send(result));
            Ok(())
        })?;
        let result = mapped.await;
        gpu.settle().await?;
        if !matches!(result, Some(Ok(()))) {
            return Err(gpu.lost("its memory cannot be read"));
        }
        Ok(Self { gpu, buffer })
    }

    /// The buffer's contents.
    pub fn read<T: AnyBitPattern + bytemuck::NoUninit>(self) -> Result<Vec<T>, GpuError> {
        let gpu = self.gpu;
        gpu.checked(move || {
            // Unmapped at the end of this block, so that errors of that come back as well.
            let mapped = self;
            let view = mapped.buffer.get_mapped_range(..);
            let view = view.map_err(|error| gpu.lost(&error.to_string()))?;
            Ok(bytemuck::pod_collect_to_vec(&view))
        })
    }
}

impl Drop for Mapped<'_> {
    fn drop(&mut self) {
        self.buffer.unmap();
    }
}
