//! Selection of the backend: the CPU or a GPU.

use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use slimbvh::Processor;

/// Options that select the backend.
#[derive(Debug, Args)]
pub struct BackendArguments {
    /// Backend that builds and traces
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,

    /// GPU whose name contains NAME, software adapters included; `slimbvh info --adapters` lists them
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
}

impl BackendArguments {
    /// Selects the GPU backend, with the adapter whose name contains `adapter` if given.
    #[must_use]
    pub fn gpu(adapter: Option<String>) -> Self {
        Self {
            backend: Backend::Gpu,
            adapter,
        }
    }

    /// Rejects options that exclude each other, and a GPU where this build has no backend for one.
    pub(crate) fn check(&self) -> Result<()> {
        let Self { backend, adapter } = self;
        if cfg!(not(feature = "gpu")) && (*backend == Backend::Gpu || adapter.is_some()) {
            bail!(
                "this build has no GPU backend; use --backend cpu, or build with the feature gpu"
            );
        }
        match adapter {
            Some(name) if *backend == Backend::Cpu => bail!(
                "--adapter {name:?} selects a GPU, but --backend cpu excludes it; leave one out"
            ),
            _ => Ok(()),
        }
    }

    /// The options as written on the command line.
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
    /// A hardware GPU if there is one, else the CPU
    Auto,
    /// The CPU
    Cpu,
    /// A GPU
    Gpu,
}

/// The selected backend.
pub enum Chosen {
    /// The CPU.
    Cpu,
    /// A GPU that the arguments ask for.
    #[cfg(feature = "gpu")]
    Gpu(slimbvh::gpu::Gpu),
    /// A GPU that `auto` found. If the input is too large for it, the CPU takes over.
    #[cfg(feature = "gpu")]
    GpuIfItFits(slimbvh::gpu::Gpu),
}

impl Chosen {
    /// The name in tables.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Cpu => "cpu",
            #[cfg(feature = "gpu")]
            Self::Gpu(_) | Self::GpuIfItFits(_) => "gpu",
        }
    }

    /// Where trees are built and traced.
    #[must_use]
    pub const fn processor(&self) -> Processor {
        match self {
            Self::Cpu => Processor::Cpu,
            #[cfg(feature = "gpu")]
            Self::Gpu(_) | Self::GpuIfItFits(_) => Processor::Gpu,
        }
    }
}

/// Opens the backend that the arguments ask for.
///
/// # Errors
/// If no such GPU exists, or if the arguments contradict each other.
#[cfg(feature = "gpu")]
pub fn choose(arguments: &BackendArguments) -> Result<Chosen> {
    use slimbvh::gpu::{AdapterChoice, Gpu, GpuError};
    arguments.check()?;
    match (arguments.backend, &arguments.adapter) {
        (Backend::Cpu, _) => Ok(Chosen::Cpu),
        (_, Some(name)) => Ok(Chosen::Gpu(Gpu::open(&AdapterChoice::Named(name.clone()))?)),
        (Backend::Gpu, None) => Ok(Chosen::Gpu(Gpu::open(&AdapterChoice::Hardware)?)),
        (Backend::Auto, None) => Ok(match Gpu::open(&AdapterChoice::Hardware) {
            Ok(gpu) => Chosen::GpuIfItFits(gpu),
            Err(GpuError::NoAdapter(_)) => Chosen::Cpu,
            Err(error) => {
                super::output::warn(&format!("{error}; using the CPU instead"));
                Chosen::Cpu
            }
        }),
    }
}

/// Returns the CPU: this build has no GPU backend.
///
/// # Errors
/// If the arguments ask for a GPU.
#[cfg(not(feature = "gpu"))]
pub fn choose(arguments: &BackendArguments) -> Result<Chosen> {
    arguments.check()?;
    Ok(Chosen::Cpu)
}

/// Whether the error says that the input exceeds a limit of the GPU.
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

/// Whether the GPU caused the error, so that the CPU may succeed. False for an invalid mesh, refit or view.
#[cfg(feature = "gpu")]
#[must_use]
pub fn is_the_gpus_fault(error: &anyhow::Error) -> bool {
    use slimbvh::gpu::GpuError;
    match error.downcast_ref() {
        Some(GpuError::Mesh(_) | GpuError::Refit(_) | GpuError::View(_)) | None => false,
        Some(_) => true,
    }
}
