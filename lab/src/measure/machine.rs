//! What measures, by name.

use slimbvh_cli::backend::Chosen;
use slimbvh_cli::output::things;

/// The processor's name, as Linux tells it.
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

/// A backend's name, and what it runs on, in words.
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

/// A GPU's name, and whether it is one.
#[cfg(feature = "gpu")]
fn adapter(gpu: &slimbvh::gpu::Gpu) -> String {
    let name = gpu.name();
    match gpu.device().adapter_info().device_type {
        wgpu::DeviceType::Cpu => {
            format!("{name}, a CPU that plays a GPU: the times say nothing about one")
        }
        _ => name.to_owned(),
    }
}
