//! A SPIR-V module as wgpu gives it to a Vulkan driver.

use anyhow::{Context, Result, ensure};
use naga::back::spv;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use std::path::Path;

/// A module of one compute kernel, read and validated by naga.
pub struct Kernel {
    /// The module.
    pub module: naga::Module,
    /// What validation found.
    pub info: ModuleInfo,
}

impl Kernel {
    /// Reads a module's file.
    pub fn read(file: &Path) -> Result<Self> {
        let bytes = std::fs::read(file).with_context(|| format!("cannot read {file:?}"))?;
        Self::parse(&bytes).with_context(|| format!("{file:?}"))
    }

    /// Parses SPIR-V in little-endian order.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        let module = naga::front::spv::parse_u8_slice(bytes, &naga::front::spv::Options::default());
        Self::new(module.context("it is not SPIR-V that naga reads")?)
    }

    fn new(module: naga::Module) -> Result<Self> {
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::all());
        let info = validator.validate(&module).context("it is invalid")?;
        ensure!(
            module.entry_points.len() == 1,
            "a module has one kernel, not {}",
            module.entry_points.len()
        );
        Ok(Self { module, info })
    }

    /// The kernel's name.
    pub fn name(&self) -> &str {
        &self.module.entry_points[0].name
    }

    /// The SPIR-V that wgpu 30 makes of the module on a device of Vulkan 1.3 with `robustBufferAccess2`, with the options of
    /// slimbvh's pipelines (see `naga_options` in wgpu-hal's `vulkan/adapter.rs`).
    pub fn for_vulkan(&self) -> Result<Vec<u32>> {
        let options = spv::Options {
            lang_version: (1, 6),
            flags: spv::WriterFlags::LABEL_VARYINGS | spv::WriterFlags::FORCE_POINT_SIZE,
            bounds_check_policies: checks(),
            // Each kernel writes its workgroup memory before it reads it: slimbvh switches this off.
            zero_initialize_workgroup_memory: spv::ZeroInitializeWorkgroupMemoryMode::None,
            force_loop_bounding: true,
            emit_int_div_checks: true,
            ..spv::Options::default()
        };
        spv::write_vec(&self.module, &self.info, &options, None).context("naga cannot write it")
    }
}

/// wgpu's checks of indices with `robustBufferAccess2`: in arrays of shaders, not in buffers, which the driver checks.
pub fn checks() -> BoundsCheckPolicies {
    BoundsCheckPolicies {
        index: BoundsCheckPolicy::Restrict,
        buffer: BoundsCheckPolicy::Unchecked,
        image_load: BoundsCheckPolicy::Unchecked,
        binding_array: BoundsCheckPolicy::Unchecked,
    }
}
