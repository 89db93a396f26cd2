//! The names of the processor and of the GPU that measure.

use slimbvh_cli::backend::Chosen;
use slimbvh_cli::output::things;

/// The processor's name, from Linux' `/proc/cpuinfo`.
#[must_use]
pub fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("model name"));
    let name = line.and_then(|line| line.split_once(':'));
    name.map_or_else(
        || "this machine's cores".into(),
        |(_, name)| name.trim().to_owned(),
    )
}

/// A backend's name, and the machine that it runs on.
pub(crate) fn describe(chosen: &Chosen) -> (&'static str, String) {
    match chosen {
        Chosen::Cpu => {
            let threads = things(rayon::current_num_threads(), "thread");
            ("cpu", format!("{}, {threads}", processor()))
        }
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => ("gpu", adapter(gpu)),
    }
}

/// An adapter's name, with a note if it is a software adapter.
#[cfg(feature = "gpu")]
fn adapter(gpu: &slimbvh::gpu::Gpu) -> String {
    let name = gpu.name();
    match gpu.device().adapter_info().device_type {
        wgpu::DeviceType::Cpu => {
            format!("{name}, a software adapter: the times say nothing about a GPU")
        }
        _ => name.to_owned(),
    }
}
