//! One dispatch of one kernel, with bytes as inputs and outputs.

use super::done;
use bytemuck::{AnyBitPattern, NoUninit, Pod, cast_slice};
use slimbvh::gpu::{Gpu, Kernel, wgpu};
use slimbvh_core::launch;
use wgpu::BufferUsages;

/// A dispatch. Bindings are numbered in the order of the fields; none may be empty.
#[derive(Clone, Copy, Debug)]
pub struct Dispatch<'a> {
    /// The kernel.
    pub kernel: Kernel,
    /// Workgroups.
    pub group_count: u32,
    /// Uniforms, of at least four words each.
    pub uniforms: &'a [&'a [u32]],
    /// Contents of buffers that the kernel reads.
    pub reads: &'a [&'a [u8]],
    /// Contents, before the dispatch, of buffers that the kernel writes.
    pub outputs: &'a [&'a [u8]],
}

impl Dispatch<'_> {
    /// Runs the kernel and waits for it. Returns the contents of the outputs.
    ///
    /// # Panics
    /// If the GPU reports an error.
    #[must_use]
    pub fn run(&self, gpu: &Gpu) -> Vec<Vec<u8>> {
        let usages = [BufferUsages::UNIFORM, BufferUsages::STORAGE];
        let uniforms = self.uniforms.iter().map(|words| cast_slice(words));
        let uniforms = uniforms.map(|bytes| buffer(gpu, usages[0], bytes));
        let storage = self.reads.iter().chain(self.outputs);
        let storage = storage.map(|bytes| buffer(gpu, usages[1], bytes));
        let buffers: Vec<wgpu::Buffer> = uniforms.chain(storage).collect();
        let entries: Vec<_> = buffers
            .iter()
            .zip(0..)
            .map(|(buffer, binding)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let pipeline = done(gpu.pipeline(self.kernel));
        let bindings = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(self.kernel.name()),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        let mut frame = gpu.frame();
        let mut pass = frame.encoder().begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bindings, &[]);
        let [x, y, z] = launch::dispatch(self.group_count);
        pass.dispatch_workgroups(x, y, z);
        drop(pass);
        let outputs = &buffers[buffers.len() - self.outputs.len()..];
        let downloads: Vec<_> = outputs
            .iter()
            .map(|output| done(frame.read_later(output.slice(..))))
            .collect();
        done(done(frame.submit()).wait());
        let read = |download: slimbvh::gpu::Download| done(download.read(gpu));
        downloads.into_iter().map(read).collect()
    }
}

/// A buffer that kernels read and write.
#[must_use]
pub fn storage<T: NoUninit>(gpu: &Gpu, items: &[T]) -> wgpu::Buffer {
    buffer(gpu, BufferUsages::STORAGE, cast_slice(items))
}

/// Downloads a buffer.
///
/// # Panics
/// If the GPU reports an error.
#[must_use]
pub fn contents<T: AnyBitPattern + NoUninit>(gpu: &Gpu, buffer: &wgpu::Buffer) -> Vec<T> {
    let mut frame = gpu.frame();
    let download = done(frame.read_later(buffer.slice(..)));
    done(done(frame.submit()).wait());
    done(download.read(gpu))
}

/// Casts bytes to values.
#[must_use]
pub fn answers<T: Pod>(bytes: &[u8]) -> Vec<T> {
    bytemuck::pod_collect_to_vec(bytes)
}

fn buffer(gpu: &Gpu, usage: BufferUsages, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("slimbvh tests"),
        size: bytes.len() as u64,
        usage: usage | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue().write_buffer(&buffer, 0, bytes);
    buffer
}
