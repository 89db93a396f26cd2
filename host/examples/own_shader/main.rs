//! Your own compute shader in Rust, calling slimbvh's core. `shader/` is a rust-gpu crate with a query that slimbvh does
//! not have. This program runs its compiled module; CONTRIBUTING.md says how to compile it.

use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::gpu::{AdapterChoice, Builder, Bvh, Gpu, Mesh, wgpu};
use slimbvh::{BuildConfig, Ray};
use std::error::Error;

const SIZE: [u32; 2] = [78, 36];

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(&AdapterChoice::Any)?;
    let device = gpu.device();
    let mesh = Mesh::upload(&gpu, &torus_knot(&TorusKnot::default()))?;
    let (mut builder, mut bvh) = (Builder::new(BuildConfig::default()), Bvh::new());

    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("thickness"),
        source: wgpu::util::make_spirv(include_bytes!("thickness.spv")),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("thickness"),
        layout: None,
        module: &module,
        entry_point: Some("thickness"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });

    // Parallel rays through the whole knot.
    let rays: Vec<Ray> = (0..SIZE[1])
        .flat_map(|y| (0..SIZE[0]).map(move |x| (x as f32 / 77.0, y as f32 / 35.0)))
        .map(|(x, y)| Ray::new([3.4 * x - 1.7, 10.0, 3.4 * y - 1.7], [0.0, -1.0, 0.0]))
        .collect();
    let storage = wgpu::BufferUsages::STORAGE;
    let buffer = |label, bytes: usize, usage| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes as u64,
            usage: storage | usage,
            mapped_at_creation: false,
        })
    };
    let ray_buffer = buffer("rays", 32 * rays.len(), wgpu::BufferUsages::COPY_DST);
    let found = buffer("found", 8 * rays.len(), wgpu::BufferUsages::COPY_SRC);
    gpu.queue()
        .write_buffer(&ray_buffer, 0, bytemuck::cast_slice(&rays));

    // Build, then trace, in one submission. Bindings 0 to 2 are the tree's.
    let mut frame = gpu.frame();
    builder.build(&mut frame, &mesh, &mut bvh)?;
    let mut entries = bvh.bindings()?.to_vec();
    for (binding, buffer) in [(3, &ray_buffer), (4, &found)] {
        entries.push(wgpu::BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        });
    }
    let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("thickness"),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries,
    });
    let mut pass = frame.encoder().begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &bind_group, &[]);
    pass.dispatch_workgroups((rays.len() as u32).div_ceil(64), 1, 1);
    drop(pass);
    let found = frame.read_later(found.slice(..))?;
    frame.submit()?.wait()?;

    // A ray crosses a closed surface an even number of times; the picture distinguishes 0, 2, 4 and 6.
    let counts: Vec<[u32; 2]> = found.read(&gpu)?;
    for row in counts.chunks(SIZE[0] as usize) {
        let marks = row.iter().map(|[count, _]| match count {
            0 => ' ',
            1..=3 => '.',
            4..=5 => 'o',
            _ => '#',
        });
        println!("{}", marks.collect::<String>());
    }
    let crossed = counts.iter().filter(|[count, _]| *count > 0);
    let even = crossed.clone().filter(|[count, _]| count % 2 == 0).count();
    let crossed = crossed.count();
    println!("{crossed} rays meet the knot, {even} of them an even number of times");
    assert!(crossed > 500 && even * 50 > crossed * 49);
    Ok(())
}
