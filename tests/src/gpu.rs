//! The GPU of the tests, single dispatches of kernels, and devices with other limits.

mod dispatch;

pub use dispatch::{Dispatch, answers, contents, storage};

use pollster::block_on;
use slimbvh::gpu::{AdapterChoice, AdapterError, Gpu, GpuError, wgpu};
use slimbvh::reduce::{PlanConfig, Reduce, Switches};
use slimbvh::{BuildConfig, FrameConfig, Frames};
use std::fmt::Display;
use std::io::Write;
use std::sync::OnceLock;

/// The adapter that `SLIMBVH_ADAPTER` names, else a hardware GPU, else a software adapter. If there is none, prints that to
/// stderr and returns `None`.
///
/// # Panics
/// If the adapter cannot be opened, and with `REQUIRE_GPU=1` if there is none.
#[must_use]
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
    GPU.get_or_init(open).as_ref()
}

fn open() -> Option<Gpu> {
    let choice = std::env::var("SLIMBVH_ADAPTER").map_or(AdapterChoice::Any, AdapterChoice::Named);
    match Gpu::open(&choice) {
        Ok(gpu) => Some(gpu),
        Err(GpuError::NoAdapter(AdapterError::None)) => {
            let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
            assert!(!is_required, "there is no GPU, and REQUIRE_GPU is set");
            // The test harness would capture `eprintln`. An error means that stderr is closed, so it is ignored.
            let _ = writeln!(
                std::io::stderr(),
                "SKIPPED: there is no GPU, not even in software: nothing of the GPU backend was tested"
            );
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Opens the same adapter once more, for tests that break it.
///
/// # Panics
/// As [`gpu`].
#[must_use]
pub fn own_gpu() -> Option<Gpu> {
    gpu().map(|gpu| done(Gpu::open(&AdapterChoice::Named(gpu.name().to_owned()))))
}

/// The same adapter with changed limits, on a device that the test opens as a caller would.
///
/// # Panics
/// As [`gpu`], and if the driver refuses the limits.
#[must_use]
pub fn gpu_with_limits(change: impl FnOnce(&mut wgpu::Limits)) -> Option<Gpu> {
    let name = gpu()?.name();
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapters = block_on(instance.enumerate_adapters(wgpu::Backends::PRIMARY));
    let adapter = adapters
        .into_iter()
        .find(|adapter| adapter.get_info().name == name);
    let Some(adapter) = adapter else {
        panic!("{name} is there no more");
    };
    let mut limits = adapter.limits();
    change(&mut limits);
    let (device, queue) = done(block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("slimbvh tests"),
        required_limits: limits,
        ..wgpu::DeviceDescriptor::default()
    })));
    Some(done(Gpu::from_device(device, queue)))
}

/// Whether this is a software adapter, which has the CPU backend's arithmetic.
#[must_use]
pub fn is_software(gpu: &Gpu) -> bool {
    gpu.device().adapter_info().device_type == wgpu::DeviceType::Cpu
}

/// Unwraps the result of an operation that must not fail.
///
/// # Panics
/// If the operation failed.
#[track_caller]
pub fn done<T, E: Display>(result: Result<T, E>) -> T {
    match result {
        Ok(value) => value,
        Err(error) => panic!("{error}"),
    }
}

/// Frames on a GPU, with one tree over all triangles.
pub fn whole_tree(gpu: &Gpu, build: BuildConfig) -> Frames<&Gpu> {
    let switches = Switches {
        reduce: Reduce::Off,
        ..Switches::default()
    };
    let plan = PlanConfig {
        switches,
        ..PlanConfig::default()
    };
    Frames::new(
        gpu,
        FrameConfig {
            build,
            plan,
            ..FrameConfig::default()
        },
    )
}
