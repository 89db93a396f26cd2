//! Pictures in textures equal the pictures in memory.

use super::pictures::settings;
use slimbvh::generate::{default_scene, icosphere};
use slimbvh::gpu::{self, Gpu, GpuError, wgpu};
use slimbvh::{BuildConfig, Picture, RenderSettings, Scene, View};
use slimbvh_tests::gpu::{done, gpu};
use slimbvh_tests::parity::same_bits;
use wgpu::{TextureFormat, TextureUsages};

fn texture(gpu: &Gpu, format: TextureFormat, [width, height]: [u32; 2]) -> wgpu::Texture {
    gpu.device().create_texture(&wgpu::TextureDescriptor {
        label: Some("slimbvh tests"),
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: TextureUsages::COPY_DST | TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The texels at the upper left, row by row.
fn texels(gpu: &Gpu, texture: &wgpu::Texture, [width, height]: [u32; 2]) -> Vec<u8> {
    let texel_bytes = texture.format().block_copy_size(None).unwrap_or(0);
    let row_bytes = (width * texel_bytes).next_multiple_of(256);
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("slimbvh tests"),
        size: u64::from(row_bytes * height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let mut frame = gpu.frame();
    frame.encoder().copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row_bytes),
                rows_per_image: Some(height),
            },
        },
        wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
    );
    done(frame.submit());
    let bytes = slimbvh_tests::gpu::contents::<u8>(gpu, &buffer);
    let row = |row: &[u8]| row[..(width * texel_bytes) as usize].to_vec();
    bytes.chunks(row_bytes as usize).flat_map(row).collect()
}

/// A renderer after a picture, and the picture.
fn rendered(gpu: &Gpu, settings: &RenderSettings) -> (gpu::Renderer, Picture) {
    let scene = Scene {
        mesh: icosphere(glam::Vec3::new(0.0, 1.0, 0.0), 1.5, 3),
        ..default_scene()
    };
    let uploaded = done(gpu::Scene::upload(gpu, &scene));
    let (mut bvh, mut renderer) = (gpu::Bvh::new(), gpu::Renderer::new());
    let mut frame = gpu.frame();
    let mut builder = gpu::Builder::new(BuildConfig::default());
    done(builder.build(&mut frame, &uploaded.mesh, &mut bvh));
    let (camera, lights) = (&scene.cameras[0], &scene.lights);
    done(renderer.render(&mut frame, &uploaded, &bvh, camera, lights, settings));
    let download = done(renderer.read_later(&mut frame));
    done(frame.submit());
    let mut picture = Picture::default();
    done(download.read(gpu, &mut picture));
    (renderer, picture)
}

#[test]
fn textures_hold_the_picture() {
    let Some(gpu) = gpu() else { return };
    // Rows with and without padding in memory, and a texture larger than the picture.
    for (size, room) in [([160, 90], [160, 90]), ([64, 5], [70, 9]), ([1, 1], [1, 1])] {
        let settings = RenderSettings {
            size,
            ..settings(View::Color)
        };
        let (mut renderer, picture) = rendered(gpu, &settings);
        let mut copied = |format| {
            let texture = texture(gpu, format, room);
            let mut frame = gpu.frame();
            done(renderer.copy_to_texture(&mut frame, &texture));
            done(frame.submit());
            texels(gpu, &texture, size)
        };
        let numbers: Vec<f32> = slimbvh_tests::gpu::answers(&copied(TextureFormat::Rgba32Float));
        let opaque = |&[r, g, b]: &[f32; 3]| [r, g, b, 1.0];
        let expected: Vec<f32> = picture.pixels.iter().flat_map(opaque).collect();
        done(same_bits(&numbers, &expected));
        let mut spoilt = numbers;
        spoilt[2] = f32::from_bits(spoilt[2].to_bits() ^ 1);
        assert!(same_bits(&spoilt, &expected).is_err());

        // A GPU's power function may round to the neighbouring byte.
        let bytes = picture.to_srgb();
        let formats = [
            (TextureFormat::Rgba8UnormSrgb, [0, 1, 2]),
            (TextureFormat::Rgba8Unorm, [0, 1, 2]),
            (TextureFormat::Bgra8Unorm, [2, 1, 0]),
            (TextureFormat::Bgra8UnormSrgb, [2, 1, 0]),
        ];
        for (format, order) in formats {
            let texels = copied(format);
            assert_eq!(texels.len() / 4, bytes.len() / 3);
            let off = |swapped: [usize; 3]| {
                let pairs = texels.chunks(4).zip(bytes.chunks(3));
                let steps = pairs.map(|(a, b)| {
                    let steps = [0, 1, 2].map(|i| a[i].abs_diff(b[swapped[i]]));
                    steps.into_iter().max().unwrap_or(0)
                });
                steps.max().unwrap_or(u8::MAX)
            };
            assert!(off(order) <= 1, "{format:?}");
            assert!(
                off([order[2], order[1], order[0]]) > 1,
                "{format:?} swapped"
            );
            assert!(texels.chunks(4).all(|texel| texel[3] == 255));
        }
    }
}

#[test]
fn unfit_textures_are_refused() {
    let Some(gpu) = gpu() else { return };
    let (mut renderer, _) = rendered(gpu, &settings(View::Color));
    let mut frame = gpu.frame();
    let mut refusal = |renderer: &mut gpu::Renderer, texture: &wgpu::Texture| match renderer
        .copy_to_texture(&mut frame, texture)
    {
        Err(error @ GpuError::Unfit { .. }) => error.to_string(),
        other => panic!("{other:?}"),
    };
    let small = texture(gpu, TextureFormat::Rgba32Float, [160, 89]);
    assert!(refusal(&mut renderer, &small).contains("160x89"));
    let odd = texture(gpu, TextureFormat::Rgba16Float, [160, 90]);
    assert!(refusal(&mut renderer, &odd).contains("Rgba16Float"));
    let fixed = gpu.device().create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: odd.size(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: TextureFormat::Rgba8Unorm,
        usage: TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    assert!(refusal(&mut renderer, &fixed).contains("COPY_DST"));
    let good = texture(gpu, TextureFormat::Rgba8Unorm, [160, 90]);
    assert!(refusal(&mut gpu::Renderer::new(), &good).contains("render first"));
    done(renderer.copy_to_texture(&mut frame, &good));
    done(frame.submit());
}
