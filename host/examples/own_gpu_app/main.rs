//! An application with its own wgpu device, vertex layout and shaders: its compute shader moves a knot, slimbvh updates what the
//! view needs, and the application's WGSL traces and shades, with shadows. One submission a frame; nothing is read back but the
//! picture.
//!
//! This file is all that has to do with slimbvh. `app.rs` is what such an application has anyway.

mod app;

use app::{App, EYE, LAMP, VERTEX_BYTES, show};
use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::gpu::{Gpu, IndexLayout, Mesh, VertexLayout, wgpu, wgsl_compute};
use slimbvh::{Change, FrameConfig, ViewSets, ViewTarget};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // The functions that trace, then the application's shaders.
    let shaders = wgsl_compute(0) + include_str!("shaders.wgsl");
    let app = pollster::block_on(App::open(&torus_knot(&TorusKnot::default()), shaders))?;

    let gpu = Gpu::from_device(app.device.clone(), app.queue.clone())?;
    let positions = VertexLayout {
        slice: app.vertices.slice(..),
        stride: VERTEX_BYTES,
        offset: 0,
    };
    let indices = IndexLayout {
        slice: app.indices.slice(..),
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

    for change in [Change::Scene, Change::Vertices, Change::Vertices] {
        let mut frame = gpu.frame();
        app.move_vertices(frame.encoder());
        views.update(&mut frame, &mesh, &targets, change)?;
        let [eye, lamp] = views.trees()[..] else {
            unreachable!("two targets have two trees")
        };
        app.look(frame.encoder(), &eye.bindings()?);
        app.shade(frame.encoder(), &lamp.bindings()?);
        let shades = frame.read_later(app.shades.slice(..))?;
        frame.submit()?;
        show(&shades.read(&gpu)?);
    }
    println!("{}", views.explain());
    Ok(())
}
