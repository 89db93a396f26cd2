//! Mesa's Vulkan driver for AMD GPUs, RADV, on its null device: it compiles for a GPU that is not there.
//!
//! wgpu cannot open this device, as it has no semaphores, and tells nothing of what a driver compiles; so this calls Vulkan
//! itself, through `VK_KHR_pipeline_executable_properties`. Nothing is ever submitted.
#![allow(unsafe_code)] // Vulkan is a C interface.

use super::translate::Kernel;
use anyhow::{Context, Result, ensure};
use ash::{khr, vk};
use std::ffi::{CStr, CString};

/// An open null device. It is never closed: its process ends soon.
pub struct Radv {
    /// The driver's name and version and the GPU it compiles for.
    pub compiler: String,
    device: ash::Device,
    executables: khr::pipeline_executable_properties::Device,
    _instance: ash::Instance,
    _entry: ash::Entry,
}

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Statistics.
    Counts,
    /// Statistics and the disassembly.
    Assembly,
}

/// What RADV made of a kernel.
pub struct Compiled {
    /// Statistics by their names in RADV.
    pub statistics: Vec<(String, u64)>,
    /// Lanes of a wave.
    pub lanes: u64,
    /// The disassembly, if it was asked for.
    pub assembly: Option<String>,
}

impl Compiled {
    /// A statistic by its name.
    pub fn statistic(&self, name: &str) -> Result<u64> {
        let mut statistics = self.statistics.iter();
        let found = statistics.find(|(other, _)| other == name);
        Ok(found
            .with_context(|| format!("the driver has no statistic {name:?}"))?
            .1)
    }
}

impl Radv {
    /// Opens the null device. The environment selects driver and GPU: see [`super::child`].
    pub fn open() -> Result<Self> {
        // SAFETY: the library that is loaded is the system's Vulkan loader; its functions are called as Vulkan asks, with
        // structures that outlive the calls.
        unsafe {
            let entry = ash::Entry::load().context("there is no Vulkan loader (libvulkan.so.1)")?;
            let application = vk::ApplicationInfo::default().api_version(vk::API_VERSION_1_3);
            let info = vk::InstanceCreateInfo::default().application_info(&application);
            let instance = entry.create_instance(&info, None)?;
            let devices = instance.enumerate_physical_devices()?;
            let &physical = devices.first().context("RADV opens no null device")?;

            let mut driver = vk::PhysicalDeviceDriverProperties::default();
            let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut driver);
            instance.get_physical_device_properties2(physical, &mut properties);
            let device_name = text(&properties.properties.device_name);
            ensure!(
                driver.driver_id == vk::DriverId::MESA_RADV,
                "the driver is {}, not RADV",
                text(&driver.driver_name)
            );
            let compiler = format!(
                "{}, {}, {device_name}",
                text(&driver.driver_name),
                text(&driver.driver_info)
            );

            // Without the Vulkan memory model and 64-bit integers the driver refuses modules.
            let mut executable =
                vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default()
                    .pipeline_executable_info(true);
            let mut robust =
                vk::PhysicalDeviceRobustness2FeaturesEXT::default().robust_buffer_access2(true);
            let mut model = vk::PhysicalDeviceVulkan12Features::default()
                .vulkan_memory_model(true)
                .vulkan_memory_model_device_scope(true);
            let features = vk::PhysicalDeviceFeatures::default()
                .robust_buffer_access(true)
                .shader_int64(true);
            let extensions = [
                khr::pipeline_executable_properties::NAME.as_ptr(),
                ash::ext::robustness2::NAME.as_ptr(),
            ];
            let queues = [vk::DeviceQueueCreateInfo::default().queue_priorities(&[1.0])];
            let info = vk::DeviceCreateInfo::default()
                .queue_create_infos(&queues)
                .enabled_extension_names(&extensions)
                .enabled_features(&features)
                .push_next(&mut executable)
                .push_next(&mut robust)
                .push_next(&mut model);
            let device = instance.create_device(physical, &info, None)?;
            let executables = khr::pipeline_executable_properties::Device::new(&instance, &device);
            Ok(Self {
                compiler,
                device,
                executables,
                _instance: instance,
                _entry: entry,
            })
        }
    }

    /// Compiles a kernel. Its disassembly takes longer than all else.
    pub fn compile(&self, kernel: &Kernel, detail: Detail) -> Result<Compiled> {
        let words = kernel.for_vulkan()?;
        let name = CString::new(kernel.name())?;
        let bindings = bindings(&kernel.module)?;
        // SAFETY: the words are SPIR-V from naga's writer, the layout has all bindings of the module, and all structures
        // outlive the calls.
        unsafe {
            let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            let sets = [self.device.create_descriptor_set_layout(&info, None)?];
            let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&sets);
            let layout = self.device.create_pipeline_layout(&info, None)?;
            let info = vk::ShaderModuleCreateInfo::default().code(&words);
            let module = self.device.create_shader_module(&info, None)?;
            let stage = vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::COMPUTE)
                .module(module)
                .name(&name);
            let mut flags = vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR;
            if detail == Detail::Assembly {
                flags |= vk::PipelineCreateFlags::CAPTURE_INTERNAL_REPRESENTATIONS_KHR;
            }
            let info = vk::ComputePipelineCreateInfo::default()
                .flags(flags)
                .stage(stage)
                .layout(layout);
            let cache = vk::PipelineCache::null();
            let made = self.device.create_compute_pipelines(cache, &[info], None);
            let pipeline = made.map_err(|(_, error)| error)?[0];
            self.describe(pipeline, detail)
        }
    }

    /// Reads what the driver tells about a pipeline's only executable.
    fn describe(&self, pipeline: vk::Pipeline, detail: Detail) -> Result<Compiled> {
        // SAFETY: the pipeline is of this device, made with the flags that these calls need. A representation's buffer has
        // the size that the driver asked for, and a value is read in the format that the driver names.
        unsafe {
            let info = vk::PipelineInfoKHR::default().pipeline(pipeline);
            let executables = self.executables.get_pipeline_executable_properties(&info)?;
            ensure!(executables.len() == 1, "a kernel is one executable");
            let info = vk::PipelineExecutableInfoKHR::default().pipeline(pipeline);
            let mut statistics = Vec::new();
            for statistic in self.executables.get_pipeline_executable_statistics(&info)? {
                let value = match statistic.format {
                    vk::PipelineExecutableStatisticFormatKHR::UINT64 => statistic.value.u64,
                    vk::PipelineExecutableStatisticFormatKHR::INT64 => {
                        statistic.value.i64.try_into()?
                    }
                    _ => continue,
                };
                statistics.push((text(&statistic.name), value));
            }
            Ok(Compiled {
                statistics,
                lanes: executables[0].subgroup_size.into(),
                assembly: match detail {
                    Detail::Counts => None,
                    Detail::Assembly => Some(self.assembly(&info)?),
                },
            })
        }
    }

    fn assembly(&self, info: &vk::PipelineExecutableInfoKHR<'_>) -> Result<String> {
        // SAFETY: as in `describe`; the second call fills buffers of the sizes that the first returned.
        unsafe {
            let get = self
                .executables
                .fp()
                .get_pipeline_executable_internal_representations_khr;
            let mut count = 0;
            let device = self.device.handle();
            get(device, info, &raw mut count, std::ptr::null_mut()).result()?;
            let mut found =
                vec![vk::PipelineExecutableInternalRepresentationKHR::default(); count as usize];
            get(device, info, &raw mut count, found.as_mut_ptr()).result()?;
            let mut texts: Vec<Vec<u8>> = found.iter().map(|one| vec![0; one.data_size]).collect();
            for (one, text) in found.iter_mut().zip(&mut texts) {
                one.p_data = text.as_mut_ptr().cast();
            }
            get(device, info, &raw mut count, found.as_mut_ptr()).result()?;
            let place = found.iter().position(|one| text(&one.name) == "Assembly");
            let place = place.context("the driver shows no assembly")?;
            let bytes = &texts[place];
            let end = bytes.iter().position(|&byte| byte == 0);
            Ok(String::from_utf8_lossy(&bytes[..end.unwrap_or(bytes.len())]).into_owned())
        }
    }
}

/// The bindings of a module.
fn bindings(module: &naga::Module) -> Result<Vec<vk::DescriptorSetLayoutBinding<'static>>> {
    let mut bindings = Vec::new();
    for (_, variable) in module.global_variables.iter() {
        let Some(binding) = variable.binding else {
            continue;
        };
        ensure!(binding.group == 0, "there is one bind group");
        let kind = match variable.space {
            naga::AddressSpace::Uniform => vk::DescriptorType::UNIFORM_BUFFER,
            naga::AddressSpace::Storage { .. } => vk::DescriptorType::STORAGE_BUFFER,
            other => anyhow::bail!("kernels bind buffers only, not {other:?}"),
        };
        bindings.push(
            vk::DescriptorSetLayoutBinding::default()
                .binding(binding.binding)
                .descriptor_type(kind)
                .descriptor_count(1)
                .stage_flags(vk::ShaderStageFlags::COMPUTE),
        );
    }
    Ok(bindings)
}

/// A name that the driver wrote.
fn text(bytes: &[std::ffi::c_char]) -> String {
    let bytes: Vec<u8> = bytes.iter().map(|&byte| byte as u8).collect();
    let name = CStr::from_bytes_until_nul(&bytes).unwrap_or_default();
    name.to_string_lossy().into_owned()
}
