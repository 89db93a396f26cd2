//! An application with its own wgpu device, vertex layout and shaders: its compute shader moves a knot, slimbvh updates what the
//! view needs, and the application's WGSL traces and shades, with shadows. One submission a frame; nothing is read back but the
//! picture.

use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::gpu::{Frame, Gpu, IndexLayout, Mesh, VertexLayout, wgpu, wgsl_compute};
use slimbvh::{Change, FrameConfig, ViewSets, ViewTarget};
use std::error::Error;
use wgpu::util::DeviceExt;

/// Group 0 belongs to slimbvh: each pass binds the tree that its rays are for. Group 1 is the application's.
const SHADER: &str = "
struct Vertex { position: vec3<f32>, rest: vec3<f32> }
@group(1) @binding(0) var<storage, read_write> vertices: array<Vertex>;
@group(1) @binding(1) var<storage, read_write> indices: array<u32>;
@group(1) @binding(2) var<storage, read_write> hits: array<SlimbvhHit>;
@group(1) @binding(3) var<storage, read_write> shades: array<f32>;
const EYE = vec3<f32>(0.0, 1.2, 4.0);
const LAMP = vec3<f32>(3.0, 4.0, 2.0);

@compute @workgroup_size(64)
fn move_vertices(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&vertices) {
        let p = vertices[id.x].position;
        vertices[id.x].position = vec3<f32>(0.96 * p.x - 0.28 * p.z, p.y, 0.28 * p.x + 0.96 * p.z);
    }
}

fn seen(pixel: u32) -> vec3<f32> {
    return vec3<f32>(f32(pixel % 78u) / 39.0 - 1.0, 0.1 - f32(pixel / 78u) / 22.0, -2.0);
}

@compute @workgroup_size(64)
fn look(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    hits[id.x] = slimbvh_closest_hit_in_group(lane, EYE, 0.0, seen(id.x), 1e9);
}

@compute @workgroup_size(64)
fn shade(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let hit = hits[id.x];
    shades[id.x] = -1.0;
    if hit.primitive == 0xffffffffu {
        return;
    }
    let corner = 3u * hit.primitive;
    let v0 = vertices[indices[corner]].position;
    let v1 = vertices[indices[corner + 1u]].position;
    let v2 = vertices[indices[corner + 2u]].position;
    let point = slimbvh_surface(v0, v1, v2, hit, seen(id.x));
    let to_lamp = LAMP - point.leave;
    let is_lit = dot(point.normal, to_lamp) > 0.0 && !slimbvh_any_hit_from_in_group(lane, point.leave, 0.0, to_lamp, 1.0, hit.primitive);
    shades[id.x] = select(0.0, dot(point.normal, normalize(to_lamp)), is_lit);
}
";
const EYE: [f32; 3] = [0.0, 1.2, 4.0];
const LAMP: [f32; 3] = [3.0, 4.0, 2.0];
const SIZE: [u32; 2] = [78, 30];

fn main() -> Result<(), Box<dyn Error>> {
    // The application's own device and data.
    let (device, queue) = pollster::block_on(open())?;
    let knot = torus_knot(&TorusKnot::default());
    let vertices: Vec<[f32; 8]> = knot
        .vertices
        .iter()
        .map(|&[x, y, z]| [x, y, z, 0.0, x, y, z, 0.0])
        .collect();
    let buffer = |bytes: &[u8]| {
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: None,
            contents: bytes,
            usage,
        })
    };
    let pixels = (SIZE[0] * SIZE[1]) as usize;
    let own = [
        buffer(bytemuck::cast_slice(&vertices)),
        buffer(bytemuck::cast_slice(&knot.indices)),
        buffer(&vec![0; 16 * pixels]),
        buffer(&vec![0; 4 * pixels]),
    ];

    let gpu = Gpu::from_device(device.clone(), queue)?;
    let positions = VertexLayout {
        slice: own[0].slice(..),
        stride: 32,
        offset: 0,
    };
    let indices = IndexLayout {
        slice: own[1].slice(..),
        format: wgpu::IndexFormat::Uint32,
    };
    let mesh = Mesh::from_layout(&gpu, positions, indices)?;
    let targets = [
        ViewTarget::rays_from(EYE, 0.0)?,
        ViewTarget::rays_to(LAMP, 0.0)?,
    ];
    // The knot never comes to cut itself.
    let config = FrameConfig::for_frames(1000).promising_solids().reducing();
    let mut views = ViewSets::new(&gpu, config);

    let app = App::new(&gpu, own);
    let [moving, looking, shading] = [
        app.pass("move_vertices", &[0]),
        app.pass("look", &[2]),
        app.pass("shade", &[0, 1, 2, 3]),
    ];
    for change in [Change::Scene, Change::Vertices, Change::Vertices] {
        let mut frame = gpu.frame();
        app.run(&mut frame, &moving, &[], vertices.len());
        views.update(&mut frame, &mesh, &targets, change)?;
        let trees = views.trees();
        app.run(&mut frame, &looking, &trees[0].bindings()?, pixels);
        app.run(&mut frame, &shading, &trees[1].bindings()?, pixels);
        let shades = frame.read_later(app.buffers[3].slice(..))?;
        frame.submit()?;
        show(&shades.read(&gpu)?);
    }
    println!("{}", views.explain());
    Ok(())
}

/// The application's shaders and buffers.
struct App {
    device: wgpu::Device,
    module: wgpu::ShaderModule,
    buffers: [wgpu::Buffer; 4],
}

/// A pipeline, with its bindings of some buffers.
struct Pass {
    pipeline: wgpu::ComputePipeline,
    own: wgpu::BindGroup,
}

impl App {
    fn new(gpu: &Gpu, buffers: [wgpu::Buffer; 4]) -> Self {
        let device = gpu.device().clone();
        // slimbvh's text, then the application's.
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("own shaders"),
            source: wgpu::ShaderSource::Wgsl((wgsl_compute(0) + SHADER).into()),
        });
        Self {
            device,
            module,
            buffers,
        }
    }

    fn pass(&self, entry_point: &str, buffers: &[u32]) -> Pass {
        let pipeline = self
            .device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(entry_point),
                layout: None,
                module: &self.module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            });
        let entry = |&binding: &u32| wgpu::BindGroupEntry {
            binding,
            resource: self.buffers[binding as usize].as_entire_binding(),
        };
        let entries: Vec<wgpu::BindGroupEntry> = buffers.iter().map(entry).collect();
        let own = self.bind(&pipeline, 1, &entries);
        Pass { pipeline, own }
    }

    fn bind(
        &self,
        pipeline: &wgpu::ComputePipeline,
        group: u32,
        entries: &[wgpu::BindGroupEntry],
    ) -> wgpu::BindGroup {
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(group),
            entries,
        })
    }

    /// Records a thread for each item, with a tree's bindings.
    fn run(&self, frame: &mut Frame, pass: &Pass, tree: &[wgpu::BindGroupEntry], count: usize) {
        // A tree's buffers may be others in the next frame.
        let tree = self.bind(&pass.pipeline, 0, tree);
        let mut recorded = frame.encoder().begin_compute_pass(&Default::default());
        recorded.set_pipeline(&pass.pipeline);
        recorded.set_bind_group(0, &tree, &[]);
        recorded.set_bind_group(1, &pass.own, &[]);
        recorded.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
    }
}

/// The application's own device, on any adapter.
async fn open() -> Result<(wgpu::Device, wgpu::Queue), Box<dyn Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = instance
        .request_adapter(&wgpu::RequestAdapterOptions::default())
        .await?;
    Ok(adapter
        .request_device(&wgpu::DeviceDescriptor::default())
        .await?)
}

/// Prints a picture: a space for nothing, a mark from dark to light for a surface.
fn show(shades: &[f32]) {
    for row in shades.chunks(SIZE[0] as usize) {
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
