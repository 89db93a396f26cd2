//! Your own compute shader in WGSL that traces rays: it views a teapot and stores the steepness of what each ray hits.

use slimbvh::gpu::{AdapterChoice, Builder, Bvh, Gpu, Mesh, wgpu, wgsl_compute};
use slimbvh::{BuildConfig, generate};
use std::error::Error;

const SIZE: [u32; 2] = [78, 30];

/// Group 0 belongs to slimbvh, group 1 to this shader.
const SHADER: &str = "
@group(1) @binding(0) var<storage, read_write> steepness: array<f32>;

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

    // Two more rays beside it tell the slope. One call in a loop, as compilers copy the traversal to each call.
    var first = SlimbvhHit();
    var slope = vec2<f32>();
    for (var i = 0u; i < 3u; i++) {
        let beside = 0.01 * vec3<f32>(f32(i == 1u), f32(i == 2u), 0.0);
        let hit = slimbvh_closest_hit_in_group(lane, origin + beside, 0.0, direction, 100.0);
        if i == 0u {
            first = hit;
        } else {
            slope[i - 1u] = (hit.t - first.t) / 0.01;
        }
    }
    let is_miss = first.primitive == 0xffffffffu;
    steepness[id.y * 78u + id.x] = select(min(length(slope), 4.0) / 4.0, -1.0, is_miss);
}
";

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(&AdapterChoice::Any)?;
    let device = gpu.device();
    let mesh = Mesh::upload(&gpu, &generate::teapot())?;
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
    let steepness = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("steepness"),
        size: 4 * u64::from(SIZE[0] * SIZE[1]),
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });

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
        entries: &[wgpu::BindGroupEntry {
            binding: 0,
            resource: steepness.as_entire_binding(),
        }],
    });
    let mut pass = frame.encoder().begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &tree, &[]);
    pass.set_bind_group(1, &own, &[]);
    pass.dispatch_workgroups(SIZE[0].div_ceil(8), SIZE[1].div_ceil(8), 1);
    drop(pass);
    let answers = frame.read_later(steepness.slice(..))?;
    frame.submit()?.wait()?;

    let answers: Vec<f32> = answers.read(&gpu)?;
    for row in answers.chunks(SIZE[0] as usize) {
        println!("{}", row.iter().copied().map(mark).collect::<String>());
    }
    let seen = answers.iter().filter(|&&answer| answer >= 0.0).count();
    let share = seen as f64 / answers.len() as f64;
    assert!(
        (0.3..0.7).contains(&share),
        "{share} of the picture is teapot"
    );
    Ok(())
}

/// Flat to steep; a space for a miss.
fn mark(steepness: f32) -> char {
    let marks = ['@', '%', '#', '*', '+', '=', '-', ':', '.'];
    if steepness < 0.0 {
        return ' ';
    }
    marks[(steepness * 8.99) as usize]
}
