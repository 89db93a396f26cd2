//! What an application with compute shaders has of its own: a device, buffers, pipelines and bindings.

use slimbvh::gpu::wgpu;
use std::error::Error;
use wgpu::util::DeviceExt;
use wgpu::{BindGroupEntry, Buffer, CommandEncoder, ComputePipeline, Device, Queue};

pub const EYE: [f32; 3] = [0.0, 1.2, 4.0];
pub const LAMP: [f32; 3] = [3.0, 4.0, 2.0];
const SIZE: [usize; 2] = [78, 30];
const PIXELS: usize = SIZE[0] * SIZE[1];

/// A position and where it is at rest, 16 bytes each.
pub const VERTEX_BYTES: u64 = 32;

pub struct App {
    pub device: Device,
    pub queue: Queue,
    pub vertices: Buffer,
    pub indices: Buffer,
    /// What the eye sees at each pixel.
    hits: Buffer,
    /// Brightness of each pixel; less than 0 where nothing is.
    pub shades: Buffer,
    moving: ComputePipeline,
    looking: ComputePipeline,
    shading: ComputePipeline,
}

impl App {
    /// Opens a device on any adapter.
    pub async fn open(mesh: &slimbvh::Mesh, shaders: String) -> Result<Self, Box<dyn Error>> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = instance.request_adapter(&Default::default()).await?;
        let (device, queue) = adapter.request_device(&Default::default()).await?;

        let vertex = |&[x, y, z]: &[f32; 3]| [x, y, z, 0.0, x, y, z, 0.0];
        let vertices: Vec<[f32; 8]> = mesh.vertices.iter().map(vertex).collect();
        let buffer = |contents: &[u8]| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: None,
                contents,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
            })
        };
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("own shaders"),
            source: wgpu::ShaderSource::Wgsl(shaders.into()),
        });
        let pipeline = |entry_point: &str| {
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(entry_point),
                layout: None,
                module: &module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        };
        Ok(Self {
            vertices: buffer(bytemuck::cast_slice(&vertices)),
            indices: buffer(bytemuck::cast_slice(&mesh.indices)),
            hits: buffer(&[0; 16 * PIXELS]),
            shades: buffer(&[0; 4 * PIXELS]),
            moving: pipeline("move_vertices"),
            looking: pipeline("look"),
            shading: pipeline("shade"),
            device,
            queue,
        })
    }

    pub fn move_vertices(&self, encoder: &mut CommandEncoder) {
        let count = self.vertices.size() / VERTEX_BYTES;
        self.run(encoder, &self.moving, &[], &[(0, &self.vertices)], count);
    }

    /// Finds what the eye sees, through the tree with these bindings.
    pub fn look(&self, encoder: &mut CommandEncoder, tree: &[BindGroupEntry]) {
        let own = [(2, &self.hits)];
        self.run(encoder, &self.looking, tree, &own, PIXELS as u64);
    }

    /// Shades that, with shadow rays through the tree with these bindings.
    pub fn shade(&self, encoder: &mut CommandEncoder, tree: &[BindGroupEntry]) {
        let buffers = [&self.vertices, &self.indices, &self.hits, &self.shades];
        let own: Vec<(u32, &Buffer)> = (0..).zip(buffers).collect();
        self.run(encoder, &self.shading, tree, &own, PIXELS as u64);
    }

    /// Records a thread for each item. A tree's buffers may be others in the next frame, so they are bound anew.
    fn run(
        &self,
        encoder: &mut CommandEncoder,
        pipeline: &ComputePipeline,
        tree: &[BindGroupEntry],
        own: &[(u32, &Buffer)],
        count: u64,
    ) {
        let own = own.iter().map(|&(binding, buffer)| BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        });
        let own: Vec<BindGroupEntry> = own.collect();
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(pipeline);
        for (group, entries) in [(0, tree), (1, &own)] {
            let bound = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(group),
                entries,
            });
            pass.set_bind_group(group, &bound, &[]);
        }
        pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
    }
}

/// Prints a picture: a space for nothing, a mark from dark to light for a surface.
pub fn show(shades: &[f32]) {
    for row in shades.chunks(SIZE[0]) {
        let marks = row.iter().map(|&shade| match shade {
            ..0.0 => ' ',
            _ => ['.', ':', '-', '=', '+', '*', '#', '@'][(shade * 7.99) as usize],
        });
        println!("{}", marks.collect::<String>());
    }
    let lit = shades.iter().filter(|&&shade| shade > 0.0).count();
    let dark = shades.iter().filter(|&&shade| shade == 0.0).count();
    assert!(
        lit > 200 && dark > 100,
        "{lit} pixels are lit and {dark} are in shadow"
    );
}
