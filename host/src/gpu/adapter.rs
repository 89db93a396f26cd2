//! The GPUs of this machine, and the choice of one.

use super::AdapterError;

/// Which GPU to use.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum AdapterChoice {
    /// The strongest hardware GPU, discrete before integrated. Never a software adapter.
    #[default]
    Hardware,
    /// The strongest adapter; a software adapter if there is no hardware GPU.
    Any,
    /// The first adapter, hardware or software, whose name contains this text, in any case.
    Named(String),
}

/// A printable description of an adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterSummary {
    /// Its name; a browser hides it, and has "WebGPU".
    pub name: String,
    /// Discrete, integrated, virtual, software, or other.
    pub kind: &'static str,
    /// Vulkan, Metal, Direct3D 12, or WebGPU.
    pub api: &'static str,
    /// The driver and its version.
    pub driver: String,
    /// Whether it is a software adapter, which runs on the CPU.
    pub is_software: bool,
    /// Whether it has timestamps, to time stages.
    pub has_timestamps: bool,
    /// The largest buffer in bytes.
    pub max_buffer_bytes: u64,
    /// The largest storage binding in bytes.
    pub max_binding_bytes: u64,
    /// The most storage buffers in a kernel.
    pub max_storage_buffers: u32,
    /// The most bytes of workgroup memory.
    pub max_workgroup_bytes: u32,
    /// The smallest and the largest subgroup size.
    pub subgroup_size: [u32; 2],
}

/// All adapters, in order of preference. Not in browsers: [`adapters_async`].
#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
#[must_use]
pub fn adapters() -> Vec<AdapterSummary> {
    pollster::block_on(adapters_async())
}

/// All adapters, in order of preference; in a browser, the one that it offers.
///
/// ```no_run
/// # async fn run() {
/// for adapter in slimbvh::gpu::adapters_async().await {
///     println!("{} ({})", adapter.name, adapter.api);
/// }
/// # }
/// ```
pub async fn adapters_async() -> Vec<AdapterSummary> {
    enumerate().await.iter().map(summarize).collect()
}

pub(super) async fn choose(choice: &AdapterChoice) -> Result<wgpu::Adapter, AdapterError> {
    let adapters = enumerate().await;
    let names = adapters
        .iter()
        .map(|adapter| format!("{:?}", name_of(adapter.get_info())))
        .collect::<Vec<_>>()
        .join(", ");
    if adapters.is_empty() {
        return Err(AdapterError::None);
    }
    match choice {
        AdapterChoice::Any => adapters.into_iter().next().ok_or(AdapterError::None),
        AdapterChoice::Hardware => adapters
            .into_iter()
            .find(|adapter| !is_software(&adapter.get_info()))
            .ok_or(AdapterError::OnlySoftware { names }),
        AdapterChoice::Named(wanted) => {
            let lower = wanted.to_lowercase();
            adapters
                .into_iter()
                .find(|adapter| name_of(adapter.get_info()).to_lowercase().contains(&lower))
                .ok_or(AdapterError::NoSuchName {
                    wanted: wanted.clone(),
                    names,
                })
        }
    }
}

/// All adapters that run compute shaders, in order of preference.
async fn enumerate() -> Vec<wgpu::Adapter> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::PRIMARY;
    // The crate handles errors itself; a driver's validation layer is for the driver's developers.
    descriptor.flags = wgpu::InstanceFlags::empty().with_env();
    let instance = wgpu::Instance::new(descriptor);
    let mut adapters = instance.enumerate_adapters(wgpu::Backends::PRIMARY).await;
    let compute = wgpu::DownlevelFlags::COMPUTE_SHADERS;
    adapters.retain(|adapter| adapter.get_downlevel_capabilities().flags.contains(compute));
    adapters.sort_by_key(|adapter| match adapter.get_info().device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    });
    adapters
}

/// An adapter's name, or that of its interface where a browser hides it.
pub(super) fn name_of(info: wgpu::AdapterInfo) -> String {
    if info.name.is_empty() {
        return api_of(&info).into();
    }
    info.name
}

fn is_software(info: &wgpu::AdapterInfo) -> bool {
    info.device_type == wgpu::DeviceType::Cpu
}

fn api_of(info: &wgpu::AdapterInfo) -> &'static str {
    match info.backend {
        wgpu::Backend::Vulkan => "Vulkan",
        wgpu::Backend::Metal => "Metal",
        wgpu::Backend::Dx12 => "Direct3D 12",
        wgpu::Backend::BrowserWebGpu => "WebGPU",
        _ => "other",
    }
}

fn summarize(adapter: &wgpu::Adapter) -> AdapterSummary {
    let (info, limits) = (adapter.get_info(), adapter.limits());
    let driver = format!("{} {}", info.driver, info.driver_info);
    AdapterSummary {
        kind: match info.device_type {
            wgpu::DeviceType::DiscreteGpu => "discrete",
            wgpu::DeviceType::IntegratedGpu => "integrated",
            wgpu::DeviceType::VirtualGpu => "virtual",
            wgpu::DeviceType::Cpu => "software",
            wgpu::DeviceType::Other => "other",
        },
        api: api_of(&info),
        driver: driver.trim().into(),
        is_software: is_software(&info),
        has_timestamps: adapter.features().contains(wgpu::Features::TIMESTAMP_QUERY),
        max_buffer_bytes: limits.max_buffer_size,
        max_binding_bytes: limits.max_storage_buffer_binding_size,
        max_storage_buffers: limits.max_storage_buffers_per_shader_stage,
        max_workgroup_bytes: limits.max_compute_workgroup_storage_size,
        subgroup_size: [info.subgroup_min_size, info.subgroup_max_size],
        name: name_of(info),
    }
}
