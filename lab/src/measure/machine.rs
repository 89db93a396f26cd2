//! What measures, by name.

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

/// A GPU's name, and whether it is one.
#[cfg(feature = "gpu")]
pub fn adapter(gpu: &slimbvh::gpu::Gpu) -> String {
    let name = gpu.name();
    match gpu.device().adapter_info().device_type {
        wgpu::DeviceType::Cpu => {
            format!("{name}, a CPU that plays a GPU: the times say nothing about one")
        }
        _ => name.to_owned(),
    }
}
