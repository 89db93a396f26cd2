//! Renders a scene, on a hardware GPU if there is one, else on the CPU: `cargo run --example render -- FILE.png`

use slimbvh::gpu::{AdapterChoice, Gpu};
use slimbvh::{
    Backend, Change, Cpu, FrameConfig, Frames, Output, Picture, RenderSettings, Scene, generate,
};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or("render.png".into());
    let scene = generate::default_scene();
    let picture = match Gpu::open(&AdapterChoice::Hardware) {
        Ok(gpu) => {
            println!("on {}", gpu.name());
            render(&gpu, &scene)?
        }
        Err(reason) => {
            println!("on the CPU: {reason}");
            render(Cpu, &scene)?
        }
    };

    let mut encoder =
        png::Encoder::new(std::fs::File::create(&path)?, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder
        .write_header()?
        .write_image_data(&picture.to_srgb())?;
    println!("wrote {path}");
    Ok(())
}

/// Plans which triangles may be left out, builds the trees, and renders.
fn render<B: Backend>(backend: B, scene: &Scene) -> Result<Picture, B::Error> {
    let settings = RenderSettings {
        size: [640, 360],
        sample_count: 4,
        ..RenderSettings::default()
    };
    let mut frames = Frames::new(backend, FrameConfig::default());
    let mut picture = Picture::default();
    let output = Output::new(&mut picture);
    let report = frames.render(scene, &settings, Change::Scene, output)?;
    println!("build: {}", report.build);
    println!(
        "{} rays: {}",
        report.render.ray_count(),
        report.render.stages
    );
    Ok(picture)
}
