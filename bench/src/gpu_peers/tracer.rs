//! A peer's tree in the GPU's memory, and its kernels.

use super::{PeerTree, Walk};
use crate::tracers::Question;
use anyhow::{Context, Result, ensure};
use slimbvh::gpu::wgpu::util::{BufferInitDescriptor, DeviceExt};
use slimbvh::gpu::{Frame, Gpu, wgpu};
use slimbvh_core::{Ray, launch};

/// A peer's tree in the GPU's memory.
#[derive(Debug)]
pub struct GpuPeer {
    walk: Walk,
    closest: wgpu::ComputePipeline,
    any: wgpu::ComputePipeline,
    nodes: wgpu::Buffer,
    triangles: wgpu::Buffer,
    numbers: wgpu::Buffer,
}

impl GpuPeer {
    /// Uploads a tree, and compiles its kernels with the checks that slimbvh's have.
    ///
    /// # Errors
    /// If a buffer or the stack is too large for the device, or the driver refuses a kernel.
    pub fn new(gpu: &Gpu, tree: &PeerTree) -> Result<Self> {
        let device = gpu.device();
        let limits = gpu.limits();
        let stack_bytes = tree.stack_rows * tree.walk.row_bytes();
        ensure!(
            stack_bytes <= limits.max_compute_workgroup_storage_size,
            "{}: a stack of {} rows takes {stack_bytes} bytes of workgroup memory, and the device has {}",
            tree.walk,
            tree.stack_rows,
            limits.max_compute_workgroup_storage_size
        );
        let buffer = |what: &'static str, contents: &[u8]| {
            let bytes = contents.len() as u64;
            let most = limits
                .max_storage_buffer_binding_size
                .min(limits.max_buffer_size);
            ensure!(
                bytes <= most,
                "{}: the {what} take {bytes} bytes, and the device allows {most}",
                tree.walk
            );
            Ok(device.create_buffer_init(&BufferInitDescriptor {
                label: Some(what),
                contents,
                usage: wgpu::BufferUsages::STORAGE,
            }))
        };
        let scope = device.push_error_scope(wgpu::ErrorFilter::Validation);
        let label = tree.walk.to_string();
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(&label),
            source: wgpu::ShaderSource::Wgsl(tree.walk.wgsl(tree.stack_rows).into()),
        });
        let kernel = |entry_point| {
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(&label),
                layout: None,
                module: &module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions {
                    // As for slimbvh's kernels: the stack is written before it is read.
                    zero_initialize_workgroup_memory: false,
                    ..wgpu::PipelineCompilationOptions::default()
                },
                cache: None,
            })
        };
        let (closest, any) = (kernel("closest"), kernel("any"));
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(error).with_context(|| format!("cannot compile {label}"));
        }
        Ok(Self {
            walk: tree.walk,
            closest,
            any,
            nodes: buffer("nodes", bytemuck::cast_slice(&tree.nodes))?,
            triangles: buffer("triangles", bytemuck::cast_slice(&tree.triangles))?,
            numbers: buffer("numbers", bytemuck::cast_slice(&tree.numbers))?,
        })
    }

    /// The walk.
    #[must_use]
    pub fn walk(&self) -> Walk {
        self.walk
    }

    /// Bytes of nodes and triangles.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.nodes.size() + self.triangles.size() + self.numbers.size()
    }

    /// Records the trace of all rays of a buffer, in slimbvh's layout, as one pass. Answers are as slimbvh's: a
    /// [`Hit`](slimbvh_core::Hit) or a `u32` a ray, but a miss has the ray's end as its t.
    pub fn trace(
        &self,
        frame: &mut Frame,
        question: Question,
        rays: &wgpu::Buffer,
        answers: &wgpu::Buffer,
        timestamp_writes: Option<wgpu::ComputePassTimestampWrites>,
    ) {
        let (pipeline, binding) = match question {
            Question::Closest => (&self.closest, 4),
            Question::Any => (&self.any, 5),
        };
        let mut bound = vec![
            (0, &self.nodes),
            (1, &self.triangles),
            (3, rays),
            (binding, answers),
        ];
        if question == Question::Closest {
            bound.push((2, &self.numbers));
        }
        let entries = bound.iter().map(|&(binding, buffer)| wgpu::BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        });
        let entries: Vec<_> = entries.collect();
        let group = frame
            .gpu()
            .device()
            .create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(0),
                entries: &entries,
            });
        let mut pass = frame
            .encoder()
            .begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some("peer"),
                timestamp_writes,
            });
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        let ray_count = rays.size() / size_of::<Ray>() as u64;
        let groups = ray_count.div_ceil(launch::LANES as u64);
        let [x, y, z] = launch::dispatch(groups as u32);
        pass.dispatch_workgroups(x, y, z);
    }
}
