//! Your own compute shader in Rust, calling slimbvh's core. `shader/` is a rust-gpu crate with a query that slimbvh does
//! not have, over nodes in full and over nodes of 48 bytes. This program runs its compiled modules; CONTRIBUTING.md says how to
//! compile them.

use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::gpu::{AdapterChoice, Builder, Bvh, Gpu, Mesh, wgpu};
use slimbvh::{BuildConfig, MeshCodec, NodeCodec, Ray, WideStore};
use std::error::Error;

const SIZE: [u32; 2] = [78, 36];

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(&AdapterChoice::Any)?;
    let mut knot = torus_knot(&TorusKnot::default());
    let step_exponent = -12;
    knot.snap(step_exponent);
    let mesh = Mesh::upload(&gpu, &knot)?;
    // Parallel rays through the whole knot.
    let rays: Vec<Ray> = (0..SIZE[1])
        .flat_map(|y| (0..SIZE[0]).map(move |x| (x as f32 / 77.0, y as f32 / 35.0)))
        .map(|(x, y)| Ray::new([3.4 * x - 1.7, 10.0, 3.4 * y - 1.7], [0.0, -1.0, 0.0]))
        .collect();
    let storage = wgpu::BufferUsages::STORAGE;
    let buffer = |label, bytes: usize, usage| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
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

    let compressed = BuildConfig {
        nodes: NodeCodec::Wide(WideStore::Packed),
        mesh: MeshCodec::Lattice { step_exponent },
        ..BuildConfig::default()
    };
    let plain = include_bytes!("thickness.spv").as_slice();
    let packed = include_bytes!("thickness_w4_48.spv").as_slice();
    let mut all = Vec::new();
    for (module, entry_point, config) in [
        (plain, "thickness", BuildConfig::default()),
        (packed, "thickness_w4_48", compressed),
    ] {
        let pipeline = pipeline(gpu.device(), module, entry_point);
        let (mut builder, mut bvh) = (Builder::new(config), Bvh::new());

        // Build, then trace, in one submission. The tree's bindings come first: three, and a fourth for the compressed one's root. The
        // last two are a rule's, which this shader does not read.
        let mut frame = gpu.frame();
        builder.build(&mut frame, &mesh, &mut bvh)?;
        let mut entries = bvh.bindings()?;
        entries.truncate(entries.len() - 2);
        let first = entries.len() as u32;
        for (binding, buffer) in (first..).zip([&ray_buffer, &found]) {
            entries.push(wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            });
        }
        let bind_group = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(entry_point),
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
        let found: Vec<[u32; 2]> = found.read(&gpu)?;
        all.push((found, bvh.read_bytes(&gpu)?));
    }
    let [(counts, bytes), (same, fewer)] = all.as_slice() else {
        unreachable!("there are two trees");
    };
    assert_eq!(counts, same, "no tree changes an answer");

    // A ray crosses a closed surface an even number of times; the picture distinguishes 0, 2, 4 and 6.
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
    let [bytes, fewer] = [bytes, fewer].map(|bytes| bytes.iter().sum::<u64>());
    println!("in {bytes} bytes of tree and triangles, and in {fewer} of the compressed ones");
    assert!(crossed > 500 && even * 50 > crossed * 49 && fewer * 2 < bytes);
    Ok(())
}

fn pipeline(device: &wgpu::Device, module: &[u8], entry_point: &str) -> wgpu::ComputePipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(entry_point),
        source: wgpu::util::make_spirv(module),
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(entry_point),
        layout: None,
        module: &module,
        entry_point: Some(entry_point),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}
