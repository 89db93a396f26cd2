//! A picture of a scene, on the GPU where there is a real one, else on the CPU: `cargo run --example render -- FILE.png`

use slimbvh::gpu::{AdapterChoice, Gpu, ImageRenderer};
use slimbvh::{BuildConfig, Builder, Bvh, Picture, RenderSettings, Renderer, generate};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or("render.png".into());
    let scene = generate::default_scene();
    let settings = RenderSettings {
        size: [640, 360],
        sample_count: 4,
        ..RenderSettings::default()
    };
    let (config, mut picture) = (BuildConfig::default(), Picture::default());

    let report = match Gpu::open(&AdapterChoice::Hardware) {
        Ok(gpu) => {
            println!("on {}", gpu.name());
            let mut renderer = ImageRenderer::new(config);
            let (_, report) = renderer.render(&gpu, &scene, &settings, &mut picture, |_| {})?;
            report
        }
        Err(reason) => {
            println!("on the CPU: {reason}");
            let mut bvh = Bvh::default();
            Builder::new(config).build_into(&scene.mesh, &mut bvh)?;
            Renderer::new().render(&scene, &bvh, &settings, &mut picture, |_| {})?
        }
    };
    println!("{} rays: {}", report.ray_count(), report.stages);

    let mut encoder =
        png::Encoder::new(std::fs::File::create(&path)?, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder
        .write_header()?
        .write_image_data(&picture.to_srgb())?;
    println!("wrote {path}");
    Ok(())
}
