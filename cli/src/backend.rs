//! What computes: the CPU or a GPU.

use anyhow::{Result, bail};
use clap::{Args, ValueEnum};

/// The options that say what computes.
#[derive(Debug, Args)]
pub struct BackendArguments {
    /// What computes
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,

    /// The GPU with this in its name, also one that computes in software; `slimbvh info --adapters` lists them
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
}

impl BackendArguments {
    /// A GPU, the one with this in its name if there is one.
    #[must_use]
    pub fn gpu(adapter: Option<String>) -> Self {
        Self {
            backend: Backend::Gpu,
            adapter,
        }
    }

    /// As they are written on the command line.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let backend = self.backend.to_possible_value();
        let backend = backend.filter(|_| self.backend != Backend::Auto);
        let backend = backend.map(|backend| format!("--backend {}", backend.get_name()));
        let adapter = self
            .adapter
            .as_ref()
            .map(|name| format!("--adapter {name:?}"));
        backend.into_iter().chain(adapter).collect()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Backend {
    /// A GPU where there is a real one, else the CPU
    Auto,
    /// This machine's cores
    Cpu,
    /// A GPU
    Gpu,
}

/// What was chosen.
pub enum Chosen {
    /// This machine's cores.
    Cpu,
    /// A GPU that was asked for.
    #[cfg(feature = "gpu")]
    Gpu(slimbvh::gpu::Gpu),
    /// A GPU that `auto` found: where it is too small, the CPU takes over.
    #[cfg(feature = "gpu")]
    GpuIfItFits(slimbvh::gpu::Gpu),
}

impl Chosen {
    /// Its name in tables.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Cpu => "cpu",
            #[cfg(feature = "gpu")]
            Self::Gpu(_) | Self::GpuIfItFits(_) => "gpu",
        }
    }
}

/// Opens what the arguments ask for.
///
/// # Errors
/// If there is no such GPU, or the arguments contradict each other.
#[cfg(feature = "gpu")]
pub fn choose(arguments: &BackendArguments) -> Result<Chosen> {
    use slimbvh::gpu::{AdapterChoice, Gpu, GpuError};
    match (arguments.backend, &arguments.adapter) {
        (Backend::Cpu, Some(name)) => {
            bail!("--adapter {name:?} asks for a GPU, but --backend cpu for none; leave one out")
        }
        (Backend::Cpu, None) => Ok(Chosen::Cpu),
        (_, Some(name)) => Ok(Chosen::Gpu(Gpu::open(&AdapterChoice::Named(name.clone()))?)),
        (Backend::Gpu, None) => Ok(Chosen::Gpu(Gpu::open(&AdapterChoice::Hardware)?)),
        (Backend::Auto, None) => Ok(match Gpu::open(&AdapterChoice::Hardware) {
            Ok(gpu) => Chosen::GpuIfItFits(gpu),
            Err(GpuError::NoAdapter(_)) => Chosen::Cpu,
            Err(error) => {
                super::output::warn(&format!("{error}; the CPU does it"));
                Chosen::Cpu
            }
        }),
    }
}

/// The CPU, as there is nothing else.
///
/// # Errors
/// If a GPU is asked for.
#[cfg(not(feature = "gpu"))]
pub fn choose(arguments: &BackendArguments) -> Result<Chosen> {
    if arguments.backend == Backend::Gpu || arguments.adapter.is_some() {
        bail!("this build has no GPU backend; use --backend cpu, or build with the feature gpu");
    }
    Ok(Chosen::Cpu)
}

/// Whether something is too large for the GPU.
#[must_use]
pub fn is_too_large(error: &anyhow::Error) -> bool {
    #[cfg(feature = "gpu")]
    return matches!(
        error.downcast_ref(),
        Some(slimbvh::gpu::GpuError::TooLarge { .. })
    );
    #[cfg(not(feature = "gpu"))]
    {
        let _ = error;
        false
    }
}

/// Whether the CPU may do what the GPU could not.
#[cfg(feature = "gpu")]
#[must_use]
pub fn is_the_gpus_fault(error: &anyhow::Error) -> bool {
    use slimbvh::gpu::GpuError;
    match error.downcast_ref() {
        Some(GpuError::Mesh(_) | GpuError::Refit(_) | GpuError::View(_)) | None => false,
        Some(_) => true,
    }
}
