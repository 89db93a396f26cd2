//! Meshes in the caller's buffers.

use super::builds::same_tree;
use super::pictures::{hall_of_mirrors, of_gpu, settings};
use bytemuck::cast_slice;
use slimbvh::generate::{icosphere, soup};
use slimbvh::gpu::{self, GpuError, wgpu};
use slimbvh::{BuildConfig, CodeBits, Picture, View};
use slimbvh_tests::build;
use slimbvh_tests::gpu::{contents, done, gpu, storage};
use slimbvh_tests::parity::same_bits;

/// A buffer with garbage in front of these bytes.
fn behind(offset: usize, bytes: &[u8]) -> Vec<u8> {
    let mut all = vec![0xa5; offset];
    all.extend(bytes);
    all.extend([0xa5; 100]);
    all
}

#[test]
fn parts_of_larger_buffers_are_meshes() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(1234, 5);
    let vertices: &[u8] = cast_slice(&mesh.vertices);
    let indices: &[u8] = cast_slice(&mesh.indices);
    for (first, second) in [(0, 256), (256, 0), (1024, 512)] {
        let buffers = [
            storage(gpu, &behind(first, vertices)),
            storage(gpu, &behind(second, indices)),
        ];
        let part = |offset: usize, bytes: &[u8]| offset as u64..(offset + bytes.len()) as u64;
        let placed = done(gpu::Mesh::from_buffers(
            gpu,
            buffers[0].slice(part(first, vertices)),
            buffers[1].slice(part(second, indices)),
        ));
        assert_eq!(placed.triangle_count(), 1234);
        assert_eq!(placed.bytes() as usize, vertices.len() + indices.len());
        assert!(placed.vertex_buffer() == &buffers[0]);
        let before: [Vec<u8>; 2] = [0, 1].map(|i| contents(gpu, &buffers[i]));
        let mut bvh = gpu::Bvh::new();
        let mut frame = gpu.frame();
        let mut builder = gpu::Builder::new(BuildConfig::default());
        done(builder.build(&mut frame, &placed, &mut bvh));
        done(frame.submit());
        let expected = build(&mesh, CodeBits::Bits30);
        done(same_tree(&done(bvh.download(gpu)), &expected));
        let after: [Vec<u8>; 2] = [0, 1].map(|i| contents(gpu, &buffers[i]));
        assert!(before == after);
    }
}

#[test]
fn vertices_that_move_in_their_buffer_are_refitted_in_place() {
    let Some(gpu) = gpu() else { return };
    let mut mesh = icosphere(glam::Vec3::new(0.1, 0.2, 0.3), 1.0, 3);
    let buffers = [
        storage(gpu, &mesh.vertices),
        storage(gpu, cast_slice::<_, u32>(&mesh.indices)),
    ];
    let placed = gpu::Mesh::from_buffers(gpu, buffers[0].slice(..), buffers[1].slice(..));
    let placed = done(placed);
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &placed, &mut bvh));
    done(frame.submit());
    let mut expected = build(&mesh, CodeBits::Bits30);
    let mut cpu_builder = slimbvh::Builder::new(BuildConfig::default());
    for step in 1..4 {
        for vertex in &mut mesh.vertices {
            vertex[step % 3] *= 1.5;
        }
        let moved = cast_slice(&mesh.vertices);
        gpu.queue().write_buffer(placed.vertex_buffer(), 0, moved);
        let mut frame = gpu.frame();
        done(builder.refit(&mut frame, &placed, &mut bvh));
        done(frame.submit());
        let refitted = done(bvh.download(gpu));
        assert!(same_tree(&refitted, &expected).is_err(), "nothing moved");
        done(cpu_builder.refit(&mesh, &mut expected));
        done(same_tree(&refitted, &expected));
    }
}

#[test]
fn indices_out_of_range_are_vertices_at_the_origin() {
    let Some(gpu) = gpu() else { return };
    let vertices = [[1.0f32, 2.0, 3.0], [-1.0, 0.5, 0.25], [0.5, -2.0, 1.0]];
    let wild = [
        [0u32, 1, 2],
        [0, u32::MAX, 2],
        [3, 1, 1 << 31],
        [2, 1, 0],
        [7, 8, 9],
    ];
    let buffers = [storage(gpu, &vertices), storage(gpu, &wild)];
    let placed = gpu::Mesh::from_buffers(gpu, buffers[0].slice(..), buffers[1].slice(..));
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    let mut builder = gpu::Builder::new(BuildConfig::default());
    done(builder.build(&mut frame, &done(placed), &mut bvh));
    done(frame.submit());
    let mesh = slimbvh::Mesh {
        vertices: [vertices.as_slice(), &[[0.0; 3]]].concat(),
        indices: wild.map(|face| face.map(|corner| corner.min(3))).to_vec(),
        ..slimbvh::Mesh::default()
    };
    let expected = build(&mesh, CodeBits::Bits30);
    done(same_tree(&done(bvh.download(gpu)), &expected));
}

#[test]
fn scenes_in_buffers_make_the_picture_of_uploaded_ones() {
    let Some(gpu) = gpu() else { return };
    let scene = hall_of_mirrors();
    let mesh = &scene.mesh;
    let buffers = [
        storage(gpu, &mesh.vertices),
        storage(gpu, cast_slice::<_, u32>(&mesh.indices)),
        storage(gpu, &mesh.normals),
        storage(gpu, &mesh.materials),
    ];
    let [vertices, indices, normals, materials] = [0, 1, 2, 3].map(|i| buffers[i].slice(..));
    let pictures = [true, false].map(|is_smooth| {
        let mesh = done(gpu::Mesh::from_buffers(gpu, vertices, indices));
        let normals = is_smooth.then_some(normals);
        let (indices, list) = (Some(materials), &scene.materials);
        let placed = done(gpu::Scene::from_buffers(gpu, mesh, normals, indices, list));
        let (mut bvh, mut renderer) = (gpu::Bvh::new(), gpu::Renderer::new());
        let mut frame = gpu.frame();
        let mut builder = gpu::Builder::new(BuildConfig::default());
        done(builder.build(&mut frame, &placed.mesh, &mut bvh));
        let (camera, lights) = (&scene.cameras[0], &scene.lights);
        let settings = settings(View::Color);
        done(renderer.render(&mut frame, &placed, &bvh, camera, lights, &settings));
        let download = done(renderer.read_later(&mut frame));
        done(frame.submit());
        let mut picture = Picture::default();
        done(download.read(gpu, &mut picture));
        picture.pixels
    });
    let flat = slimbvh::Scene {
        mesh: slimbvh::Mesh {
            normals: Vec::new(),
            ..mesh.clone()
        },
        ..scene.clone()
    };
    for (pixels, scene) in pictures.iter().zip([&scene, &flat]) {
        let uploaded = of_gpu(gpu, scene, &settings(View::Color)).0;
        done(same_bits(pixels, &uploaded.pixels));
    }
    assert!(same_bits(&pictures[0], &pictures[1]).is_err());
}

#[test]
fn unfit_buffers_are_refused_by_name() {
    let Some(gpu) = gpu() else { return };
    let good = storage(gpu, &[0u32; 900]);
    let plain = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 3600,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let refusal = |vertices, indices| match gpu::Mesh::from_buffers(gpu, vertices, indices) {
        Err(error @ GpuError::Unfit { .. }) => error.to_string(),
        other => panic!("{other:?}"),
    };
    let usage = "was made without the usage STORAGE";
    let vertices = refusal(plain.slice(..), good.slice(..));
    assert_eq!(vertices, format!("the buffer of vertices {usage}"));
    let indices = refusal(good.slice(..), plain.slice(..));
    assert_eq!(indices, format!("the buffer of indices {usage}"));
    assert!(refusal(good.slice(..40), good.slice(..)).contains("40 bytes"));
    assert!(refusal(good.slice(..), good.slice(..16)).contains("16 bytes"));
    if gpu.limits().min_storage_buffer_offset_alignment > 4 {
        assert!(refusal(good.slice(12..), good.slice(..)).contains("begins at byte 12"));
    }
}
