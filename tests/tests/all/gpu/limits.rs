//! Sizes beyond a device's limits are errors before anything is allocated, and later calls that fit still work.

use super::builds::same_tree;
use super::trace::{Answers, rays_at};
use slimbvh::generate::{default_scene, soup};
use slimbvh::gpu::{self, AdapterChoice, AdapterError, Gpu, GpuError, adapters, wgpu};
use slimbvh::{BuildConfig, CodeBits, RenderSettings};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_tests::gpu::{done, gpu, gpu_with_limits, own_gpu};
use slimbvh_tests::{CODE_BITS, build};

const MIB: u64 = 1 << 20;

/// A device that binds at most a mebibyte of a buffer.
pub fn short_sighted() -> Option<Gpu> {
    gpu_with_limits(|limits| limits.max_storage_buffer_binding_size = MIB)
}

/// The fields of an error: the object, its size, and the limit by name.
fn too_large<T>(result: Result<T, GpuError>) -> (&'static str, u64, &'static str, u64) {
    match result {
        Err(GpuError::TooLarge {
            what,
            bytes,
            limit,
            limit_bytes,
            ..
        }) => (what, bytes, limit, limit_bytes),
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("it was not refused"),
    }
}

const BINDING: &str = "max_storage_buffer_binding_size";

#[test]
fn meshes_too_large_for_the_device_are_refused_and_smaller_ones_are_built() {
    let Some(gpu) = short_sighted() else { return };
    let refused = too_large(gpu::Mesh::upload(&gpu, &soup(30_000, 1)));
    assert_eq!(refused, ("the vertices", 30_000 * 36, BINDING, MIB));
    // The largest possible number of nodes: one for each triangle beyond a leaf's.
    let most_nodes = (MIB / 64) as u32;
    let most_triangles = most_nodes + LEAF_SIZE;
    for code_bits in CODE_BITS {
        let mut builder = gpu::Builder::new(BuildConfig::from(code_bits));
        let mut bvh = gpu::Bvh::new();
        let large = done(gpu::Mesh::upload(&gpu, &soup(most_triangles + 1, 1)));
        let mut frame = gpu.frame();
        let refused = too_large(builder.build(&mut frame, &large, &mut bvh));
        assert_eq!(refused, ("the nodes", MIB + 64, BINDING, MIB));
        assert_eq!((builder.scratch_bytes(), bvh.bytes()), (0, 0));

        // The largest mesh that fits.
        let small = soup(most_triangles, 1);
        let uploaded = done(gpu::Mesh::upload(&gpu, &small));
        done(builder.build(&mut frame, &uploaded, &mut bvh));
        let again = too_large(builder.build(&mut frame, &large, &mut bvh));
        assert_eq!(again.0, "the nodes");
        done(frame.submit());
        let built = done(bvh.download(&gpu));
        done(same_tree(&built, &build(&small, code_bits)));
    }
}

#[test]
fn buffers_too_large_for_the_device_are_refused() {
    let gpu = gpu_with_limits(|limits| {
        limits.max_storage_buffer_binding_size = MIB;
        limits.max_buffer_size = MIB;
    });
    let Some(gpu) = gpu else { return };
    let refused = too_large(gpu::Mesh::upload(&gpu, &soup(30_000, 1)));
    assert_eq!(
        refused,
        ("the vertices", 30_000 * 36, "max_buffer_size", MIB)
    );
}

#[test]
fn pictures_too_large_for_the_device_are_refused_and_smaller_ones_are_made() {
    let gpu = gpu_with_limits(|limits| {
        limits.max_storage_buffer_binding_size = MIB;
        limits.max_buffer_size = 2 * MIB;
    });
    let Some(gpu) = gpu else { return };
    let mut scene = default_scene();
    scene.mesh = soup(100, 1);
    let uploaded = done(gpu::Scene::upload(&gpu, &scene));
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    let mut builder = gpu::Builder::new(BuildConfig::default());
    done(builder.build(&mut frame, &uploaded.mesh, &mut bvh));
    let mut renderer = gpu::Renderer::new();
    let mut render = |size, sample_count, view| {
        let settings = RenderSettings {
            size,
            sample_count,
            view,
            ..RenderSettings::default()
        };
        let (camera, lights) = (&scene.cameras[0], &scene.lights);
        let result = renderer.render(&mut frame, &uploaded, &bvh, camera, lights, &settings);
        (result, renderer.scratch_bytes())
    };
    use slimbvh::View::{Color, Depth};
    let (result, bytes) = render([512, 512], 1, Color);
    let picture = ("the picture", 4 * MIB, "max_buffer_size", 2 * MIB);
    assert_eq!((too_large(result), bytes), (picture, 0));
    let (result, bytes) = render([1, 1], 1 << 15, Color);
    let paths = ("the paths of a wave", 2 * MIB, BINDING, MIB);
    assert_eq!((too_large(result), bytes), (paths, 0));
    let (result, bytes) = render([64, 64], 64, Depth);
    let values = ("the values of all samples", 2 * MIB, BINDING, MIB);
    assert_eq!((too_large(result), bytes), (values, 0));
    done(render([64, 64], 4, Color).0);
    done(render([64, 64], 1, Depth).0);
    done(frame.submit());
}

#[test]
fn more_rays_than_a_kernel_sees_are_answered_in_parts() {
    let (Some(gpu), Some(short_sighted)) = (gpu(), short_sighted()) else {
        return;
    };
    let mesh = soup(1000, 4);
    let rays = rays_at(&mesh, 40_000, 5);
    let whole = Answers::of_gpu(gpu, &mesh, CodeBits::Bits30, &rays);
    let parts = Answers::of_gpu(&short_sighted, &mesh, CodeBits::Bits30, &rays);
    done(parts.compare(&whole, true));
    let cpu = Answers::of_cpu(&build(&mesh, CodeBits::Bits30), &rays);
    done(parts.compare(&cpu, slimbvh_tests::gpu::is_software(gpu)));
}

#[test]
fn devices_too_small_for_the_kernels_are_refused() {
    let Some(gpu) = gpu() else { return };
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let backends = wgpu::Backends::PRIMARY;
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let mut of_name = adapters.into_iter();
    let adapter = of_name.find(|adapter| adapter.get_info().name == gpu.name());
    let mut required_limits = gpu.limits().clone();
    required_limits.max_storage_buffers_per_shader_stage = 7;
    let opened = adapter.unwrap().request_device(&wgpu::DeviceDescriptor {
        required_limits,
        ..Default::default()
    });
    let (device, queue) = pollster::block_on(opened).unwrap();
    let refused = Gpu::from_device(device, queue).map(|_| ());
    let expected = GpuError::TooSmall {
        adapter: gpu.name().to_owned(),
        limit: "max_storage_buffers_per_shader_stage",
        has: 7,
        needs: 8,
    };
    assert_eq!(refused, Err(expected));
}

#[test]
fn an_adapter_that_is_not_there_is_answered_with_those_that_are() {
    if gpu().is_none() {
        return;
    }
    let choice = AdapterChoice::Named("no such gpu".to_owned());
    let error = match Gpu::open(&choice) {
        Err(error @ GpuError::NoAdapter(AdapterError::NoSuchName { .. })) => error.to_string(),
        other => panic!("{other:?}"),
    };
    assert!(error.contains("\"no such gpu\""), "{error}");
    for adapter in adapters() {
        assert!(error.contains(&adapter.name), "{error}");
    }
    if adapters().iter().all(|adapter| adapter.is_software) {
        let refused = Gpu::open(&AdapterChoice::Hardware).map(|_| ());
        let only = matches!(
            refused,
            Err(GpuError::NoAdapter(AdapterError::OnlySoftware { .. }))
        );
        assert!(only, "{refused:?}");
    }
}

/// Reads that cannot be made are errors, and the frame works on.
#[test]
fn reads_that_cannot_be_are_refused_before_the_frame_is_spoilt() {
    let Some(gpu) = gpu() else { return };
    let buffer = |usage| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("a buffer"),
            size: 64,
            usage,
            mapped_at_creation: false,
        })
    };
    let unreadable = buffer(wgpu::BufferUsages::STORAGE);
    let readable = buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
    let mut frame = gpu.frame();
    let refused = frame.read_later(unreadable.slice(..)).map(|_| ());
    let said = refused.map_or_else(|error| error.to_string(), |()| String::new());
    assert_eq!(
        said,
        "the buffer to read was made without the usage COPY_SRC"
    );
    let refused = frame.read_later(readable.slice(..6)).map(|_| ());
    let said = refused.map_or_else(|error| error.to_string(), |()| String::new());
    assert!(said.contains("6 bytes"), "{said}");
    let read = done(frame.read_later(readable.slice(..)));
    done(frame.submit());
    assert_eq!(done(read.read::<u32>(gpu)), [0; 16]);
}

/// An error of the caller's own is reported by the next call, once; later calls work.
#[test]
fn an_error_of_the_caller_is_told_once_and_is_no_loss() {
    let Some(gpu) = own_gpu() else { return };
    // An error outside of the library's calls: a shader that does not compile.
    let _ = gpu
        .device()
        .create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("wrong"),
            source: wgpu::ShaderSource::Wgsl("fn wrong( {".into()),
        });
    let mesh = slimbvh::generate::icosphere(glam::Vec3::ZERO, 1.0, 2);
    let first = gpu::Mesh::upload(&gpu, &mesh);
    assert!(matches!(first, Err(GpuError::Invalid { .. })), "{first:?}");
    assert!(gpu::Mesh::upload(&gpu, &mesh).is_ok());
}
