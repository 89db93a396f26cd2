//! The compiled entry points of `gpu-shaders`.

use super::GpuError;
use super::coding::Coding;
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A module of `host/shaders`.
macro_rules! module {
    ($name:ident) => {
        include_bytes!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/shaders/",
            stringify!($name),
            ".spv"
        ))
    };
}

macro_rules! kernels {
    (shipped { $($name:ident,)* } lab { $($lab:ident,)* }) => {
        /// An entry point of `gpu-shaders`, under its name there. Its documentation there says what it reads and stores: all
        /// bindings are in group 0, in the order of the arguments, and the length of a bound range is the number of its
        /// elements.
        ///
        /// Kernels that only the laboratory asks for are compiled in with the feature `lab`: those of the paper10 codec,
        /// and the nearest hits and visits of rays in codecs.
        #[allow(non_camel_case_types, missing_docs, reason = "named as in gpu-shaders")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Kernel { $($name,)* $($lab,)* }

        impl Kernel {
            /// All kernels that are compiled in.
            pub const ALL: &'static [Self] = &[
                $(Self::$name,)*
                $(#[cfg(feature = "lab")] Self::$lab,)*
            ];

            /// The entry point's name.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$name => stringify!($name),)*
                    $(Self::$lab => stringify!($lab),)*
                }
            }

            /// The SPIR-V module, which holds this entry point alone; empty where the kernel is not compiled in.
            #[must_use]
            pub const fn spirv(self) -> &'static [u8] {
                match self {
                    $(Self::$name => module!($name),)*
                    $(
                        #[cfg(feature = "lab")]
                        Self::$lab => module!($lab),
                        #[cfg(not(feature = "lab"))]
                        Self::$lab => &[],
                    )*
                }
            }
        }
    };
}

/// The kernels that trace one kind of tree.
#[derive(Clone, Copy, Debug)]
pub struct Traces {
    pub closest: Kernel,
    pub any: Kernel,
    /// The two above, of triangles that a filter accepts.
    pub filtered_closest: Kernel,
    pub filtered_any: Kernel,
    pub nearest: Kernel,
    /// The second pass of all above.
    pub rays_overflow: Kernel,
    pub counted: Kernel,
    pub paths: Kernel,
    pub paths_overflow: Kernel,
    pub paths_counted: Kernel,
    pub shadows: Kernel,
    pub shadows_overflow: Kernel,
}

macro_rules! traces {
    (
        $(
            $coding:pat => $closest:ident, $any:ident, $filtered_closest:ident, $filtered_any:ident, $nearest:ident, $rays_overflow:ident, $counted:ident, $paths:ident,
            $paths_overflow:ident, $paths_counted:ident, $shadows:ident, $shadows_overflow:ident;
        )*
    ) => {
        /// The kernels for a codec, or for trees in full.
        pub const fn traces(coding: Option<Coding>) -> Traces {
            match coding {
                $($coding => Traces {
                    closest: Kernel::$closest,
                    any: Kernel::$any,
                    filtered_closest: Kernel::$filtered_closest,
                    filtered_any: Kernel::$filtered_any,
                    nearest: Kernel::$nearest,
                    rays_overflow: Kernel::$rays_overflow,
                    counted: Kernel::$counted,
                    paths: Kernel::$paths,
                    paths_overflow: Kernel::$paths_overflow,
                    paths_counted: Kernel::$paths_counted,
                    shadows: Kernel::$shadows,
                    shadows_overflow: Kernel::$shadows_overflow,
                },)*
            }
        }
    };
}

include!("../../shaders/kernels.rs");

/// Pipelines, each compiled at its first use.
#[derive(Debug, Default)]
pub struct Pipelines(Mutex<HashMap<Kernel, wgpu::ComputePipeline>>);

impl Pipelines {
    /// The pipeline, if it has been compiled.
    pub fn compiled(&self, kernel: Kernel) -> Option<wgpu::ComputePipeline> {
        self.all().get(&kernel).cloned()
    }

    /// Keeps a pipeline for the next time.
    pub fn keep(&self, kernel: Kernel, pipeline: &wgpu::ComputePipeline) {
        self.all().insert(kernel, pipeline.clone());
    }

    /// Drops all pipelines, which are then compiled again.
    pub fn clear(&self) {
        self.all().clear();
    }

    fn all(&self) -> MutexGuard<'_, HashMap<Kernel, wgpu::ComputePipeline>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Compiles a kernel for a device.
///
/// # Errors
/// If the kernel is not compiled in.
pub fn compile(device: &wgpu::Device, kernel: Kernel) -> Result<wgpu::ComputePipeline, GpuError> {
    if kernel.spirv().is_empty() {
        return Err(GpuError::LabKernel {
            what: kernel.name(),
        });
    }
    let label = Some(kernel.name());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label,
        source: wgpu::util::make_spirv(kernel.spirv()),
    });
    Ok(
        device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label,
            layout: None,
            module: &module,
            // The only one. For a browser wgpu writes WGSL, and changes names that end in a digit.
            entry_point: None,
            compilation_options: wgpu::PipelineCompilationOptions {
                // Every kernel writes its workgroup memory before it reads it.
                zero_initialize_workgroup_memory: false,
                ..wgpu::PipelineCompilationOptions::default()
            },
            cache: None,
        }),
    )
}
