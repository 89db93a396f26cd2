//! An application with its own wgpu device, geometry and command encoder: two moving hills, with interleaved vertices and 16-bit
//! indices. slimbvh builds once, then refits, and traces straight down in the application's submission. Only the hits are read back.

use bytemuck::cast_slice;
use slimbvh::gpu::{Builder, Bvh, Gpu, IndexLayout, Mesh, Query, VertexLayout, WarmUp, wgpu};
use slimbvh::{BuildConfig, Hit, Ray};
use std::error::Error;
use wgpu::BufferUsages;

/// Squares along a side of the ground.
const SIDE: u32 = 64;

fn main() -> Result<(), Box<dyn Error>> {
    let (device, queue) = pollster::block_on(open())?;
    let buffer = |label, bytes: u64, usage| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes,
            usage: usage | BufferUsages::STORAGE | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    };

    // The application's data: vertices, indices, rays, and room for hits.
    let indices = squares();
    let rays: Vec<Ray> = (0..SIDE)
        .map(|i| Ray::new([i as f32 + 0.3, 100.0, 31.6], [0.0, -1.0, 0.0]))
        .collect();
    let vertex_buffer = buffer(
        "vertices",
        24 * u64::from((SIDE + 1) * (SIDE + 1)),
        BufferUsages::VERTEX,
    );
    let index_buffer = buffer("indices", 6 * indices.len() as u64, BufferUsages::INDEX);
    let ray_buffer = buffer("rays", 32 * u64::from(SIDE), BufferUsages::empty());
    let hit_buffer = buffer("hits", 16 * u64::from(SIDE), BufferUsages::COPY_SRC);
    queue.write_buffer(&index_buffer, 0, cast_slice(&indices));
    queue.write_buffer(&ray_buffer, 0, cast_slice(&rays));

    // slimbvh works on the same device.
    let gpu = Gpu::from_device(device.clone(), queue.clone())?;
    let vertices = VertexLayout {
        slice: vertex_buffer.slice(..),
        stride: 24,
        offset: 0,
    };
    let indices = IndexLayout {
        slice: index_buffer.slice(..),
        format: wgpu::IndexFormat::Uint16,
    };
    let mesh = Mesh::from_layout(&gpu, vertices, indices)?;
    let config = BuildConfig::default();
    let mut builder = Builder::new(config);
    let mut bvh = Bvh::new();

    // Otherwise the first frame compiles the kernels.
    let uses = WarmUp::new(config)
        .with_layouts()
        .with_refits()
        .with_queries(&[Query::Closest]);
    println!("{}", gpu.warm_up(&uses)?);

    for step in 0..3 {
        let phase = step as f32;
        queue.write_buffer(&vertex_buffer, 0, cast_slice(&hills(phase)));

        // The application's encoder: its own passes may stand before and behind.
        let encoder = device.create_command_encoder(&Default::default());
        let mut frame = gpu.frame_in(encoder);
        if step == 0 {
            builder.build(&mut frame, &mesh, &mut bvh)?;
        } else {
            builder.refit(&mut frame, &mesh, &mut bvh)?;
        }
        bvh.trace(
            &mut frame,
            Query::Closest,
            ray_buffer.slice(..),
            hit_buffer.slice(..),
        )?;
        let hits = frame.read_later(hit_buffer.slice(..))?;
        let (encoder, recorded) = frame.end()?;
        let index = queue.submit([encoder.finish()]);
        let stages = recorded.submitted(&gpu, index).wait()?;

        let hits: Vec<Hit> = hits.read(&gpu)?;
        let heights = hits.iter().map(|hit| 100.0 - hit.t);
        println!("{}", heights.clone().map(mark).collect::<String>());
        println!("  {stages}");
        for (i, found) in heights.enumerate() {
            let expected = height(i as f32 + 0.3, 31.6, phase);
            assert!((found - expected).abs() < 0.1, "{i}: {found} {expected}");
        }
    }
    Ok(())
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

fn height(x: f32, z: f32, phase: f32) -> f32 {
    4.0 * (0.2 * x + phase).sin() + 2.0 * (0.15 * z).cos()
}

/// Positions and normals.
fn hills(phase: f32) -> Vec<[f32; 6]> {
    let points = (0..=SIDE).flat_map(|z| (0..=SIDE).map(move |x| (x as f32, z as f32)));
    let slope = |x: f32, z: f32| {
        let along_x = 0.8 * (0.2 * x + phase).cos();
        let along_z = -0.3 * (0.15 * z).sin();
        (along_x, along_z)
    };
    points
        .map(|(x, z)| {
            let (along_x, along_z) = slope(x, z);
            [x, height(x, z, phase), z, -along_x, 1.0, -along_z]
        })
        .collect()
}

fn squares() -> Vec<[u16; 3]> {
    let corners = (0..SIDE).flat_map(|z| (0..SIDE).map(move |x| z * (SIDE + 1) + x));
    corners
        .flat_map(|a| {
            let [a, b, c, d] = [a, a + 1, a + SIDE + 1, a + SIDE + 2].map(|corner| corner as u16);
            [[a, c, b], [b, c, d]]
        })
        .collect()
}

/// A height as a character, low to high.
fn mark(height: f32) -> char {
    let marks = ['_', '.', '-', '=', '+', '*', '#', '%'];
    marks[((height + 6.0) / 12.0 * 8.0).clamp(0.0, 7.0) as usize]
}
