//! Renders a file with reduced sets and compressed trees, on a hardware GPU if there is one, else on the CPU:
//! `cargo run --release --example render -- PICTURE.png [FILE]`

use slimbvh::gpu::{AdapterChoice, Gpu};
use slimbvh::scene::{LoadOptions, load};
use slimbvh::{
    Backend, Change, Cpu, FrameConfig, Frames, Output, Picture, Processor, RenderSettings, Scene,
    Tolerance, generate,
};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().unwrap_or("render.png".into());
    let mut scene = match arguments.next() {
        Some(file) => load(Path::new(&file), &LoadOptions::default())?,
        None => generate::default_scene(),
    };
    let picture = match Gpu::open(&AdapterChoice::Hardware) {
        Ok(gpu) => render(&gpu, Processor::Gpu, &mut scene)?,
        Err(reason) => {
            println!("on the CPU: {reason}");
            render(Cpu, Processor::Cpu, &mut scene)?
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

/// Vertices move by at most half a pixel; each tree holds only the triangles that its rays may hit.
fn render<B: Backend>(
    backend: B,
    processor: Processor,
    scene: &mut Scene,
) -> Result<Picture, B::Error> {
    let settings = RenderSettings {
        size: [640, 360],
        sample_count: 4,
        ..RenderSettings::default()
    };
    scene.complete(scene.mesh.bounds(), settings.size);
    let config = FrameConfig {
        build: scene.compress(Tolerance::Pixels(0.5), &settings, processor),
        ..FrameConfig::default().reducing()
    };
    let (mut frames, mut picture) = (Frames::new(backend, config), Picture::default());
    let report = frames.render(scene, &settings, Change::Scene, Output::new(&mut picture))?;
    println!("{}\nbuild: {}", frames.views().explain(), report.build);
    println!(
        "{} rays: {}",
        report.render.ray_count(),
        report.render.stages
    );
    Ok(picture)
}
