//! Your own compute shader in WGSL that traces rays: it views a teapot that a lamp lights, shadows included.

use bytemuck::cast_slice;
use slimbvh::gpu::{AdapterChoice, Builder, Bvh, Gpu, Mesh, wgpu, wgsl_compute};
use slimbvh::{BuildConfig, generate};
use std::error::Error;

const SIZE: [u32; 2] = [78, 30];

/// Group 0 belongs to slimbvh, group 1 to this shader.
const SHADER: &str = "
@group(1) @binding(0) var<storage, read_write> shades: array<f32>;
@group(1) @binding(1) var<storage> vertices: array<f32>;
@group(1) @binding(2) var<storage> indices: array<u32>;

fn corner(primitive: u32, i: u32) -> vec3<f32> {
    let at = 3u * indices[3u * primitive + i];
    return vec3<f32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

@compute @workgroup_size(8, 8)
fn look(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    if id.x >= 78u || id.y >= 30u {
        return;
    }
    // Parallel rays, seen from the front and a little from above.
    let x = (f32(id.x) / 77.0 - 0.5) * 35.0;
    let y = (0.5 - f32(id.y) / 29.0) * 26.0;
    let origin = vec3<f32>(x, y + 25.0, 50.0);
    let direction = vec3<f32>(0.0, -0.5, -1.0);

    let hit = slimbvh_closest_hit_in_group(lane, origin, 0.0, direction, 100.0);
    var shade = -1.0;
    if hit.primitive != 0xffffffffu {
        // The shadow ray begins off the surface, and leaves out the triangle that was hit: no small distance is guessed.
        let i = hit.primitive;
        let surface = slimbvh_surface(corner(i, 0u), corner(i, 1u), corner(i, 2u), hit, direction);
        let to_lamp = vec3<f32>(-30.0, 50.0, 40.0) - surface.leave;
        shade = 0.0;
        if !slimbvh_any_hit_from_in_group(lane, surface.leave, 0.0, to_lamp, 1.0, hit.primitive) {
            shade = max(dot(surface.normal, normalize(to_lamp)), 0.0);
        }
    }
    shades[id.y * 78u + id.x] = shade;
}
";

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(&AdapterChoice::Any)?;
    let device = gpu.device();
    let teapot = generate::teapot();
    let buffer = |label, bytes: u64, usage| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes,
            usage: usage | wgpu::BufferUsages::STORAGE,
            mapped_at_creation: false,
        })
    };
    let [vertices, indices] = [
        ("vertices", cast_slice::<_, u8>(&teapot.vertices)),
        ("indices", cast_slice(&teapot.indices)),
    ]
    .map(|(label, bytes)| {
        let made = buffer(label, bytes.len() as u64, wgpu::BufferUsages::COPY_DST);
        gpu.queue().write_buffer(&made, 0, bytes);
        made
    });
    let mesh = Mesh::from_buffers(&gpu, vertices.slice(..), indices.slice(..))?;
    let (mut builder, mut bvh) = (Builder::new(BuildConfig::default()), Bvh::new());

    // slimbvh's text, then the shader.
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("look"),
        source: wgpu::ShaderSource::Wgsl((wgsl_compute(0) + SHADER).into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("look"),
        layout: None,
        module: &module,
        entry_point: Some("look"),
        compilation_options: wgpu::PipelineCompilationOptions {
            // slimbvh's stacks in workgroup memory need no zeros.
            zero_initialize_workgroup_memory: false,
            ..wgpu::PipelineCompilationOptions::default()
        },
        cache: None,
    });
    let shades = buffer(
        "shades",
        4 * u64::from(SIZE[0] * SIZE[1]),
        wgpu::BufferUsages::COPY_SRC,
    );

    // Build and view in one submission.
    let mut frame = gpu.frame();
    builder.build(&mut frame, &mesh, &mut bvh)?;
    let tree = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("tree"),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &bvh.bindings()?,
    });
    let own = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("own"),
        layout: &pipeline.get_bind_group_layout(1),
        entries: &[(0, &shades), (1, &vertices), (2, &indices)].map(|(binding, buffer)| {
            wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            }
        }),
    });
    let mut pass = frame.encoder().begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &tree, &[]);
    pass.set_bind_group(1, &own, &[]);
    pass.dispatch_workgroups(SIZE[0].div_ceil(8), SIZE[1].div_ceil(8), 1);
    drop(pass);
    let answers = frame.read_later(shades.slice(..))?;
    frame.submit()?.wait()?;

    let answers: Vec<f32> = answers.read(&gpu)?;
    for row in answers.chunks(SIZE[0] as usize) {
        println!("{}", row.iter().copied().map(mark).collect::<String>());
    }
    // Some of the picture is teapot, and some of that in shadow.
    let share = |is_it: fn(&&f32) -> bool| {
        answers.iter().filter(is_it).count() as f64 / answers.len() as f64
    };
    let [teapot, dark] = [share(|&&shade| shade >= 0.0), share(|&&shade| shade == 0.0)];
    assert!((0.3..0.7).contains(&teapot), "{teapot}");
    assert!((0.01..0.5 * teapot).contains(&dark), "{dark}");
    Ok(())
}

/// Dark to bright; a space for a miss.
fn mark(shade: f32) -> char {
    let marks = ['.', ':', '-', '=', '+', '*', '#', '%', '@'];
    if shade < 0.0 {
        return ' ';
    }
    marks[(shade * 8.99) as usize]
}
