//! The tracers to judge.

use super::{Backend, StressArguments};
use crate::stress::{Cpu, Tracer};
use anyhow::{Result, bail};

/// One tracer per backend, in the order of the arguments.
pub fn tracers(arguments: &StressArguments) -> Result<Vec<Box<dyn Tracer + Send>>> {
    if arguments.adapter.is_some() && !arguments.backend.contains(&Backend::Gpu) {
        bail!("--adapter names a GPU; it goes with --backend gpu or cpu,gpu");
    }
    let effort = arguments.effort();
    let tracer = |backend: &Backend| -> Result<Box<dyn Tracer + Send>> {
        match backend {
            Backend::Cpu => Ok(Box::new(Cpu { effort })),
            Backend::Gpu => gpu(arguments),
        }
    };
    arguments.backend.iter().map(tracer).collect()
}

/// Fails: this build has no GPU backend.
#[cfg(not(feature = "gpu"))]
fn gpu(_: &StressArguments) -> Result<Box<dyn Tracer + Send>> {
    bail!("this build has no GPU backend; use --backend cpu, or build with the feature gpu")
}

#[cfg(feature = "gpu")]
fn gpu(arguments: &StressArguments) -> Result<Box<dyn Tracer + Send>> {
    use slimbvh::gpu::{AdapterChoice, Gpu};
    let named = arguments.adapter.clone().map(AdapterChoice::Named);
    let gpu = Gpu::open(&named.unwrap_or(AdapterChoice::Hardware))?;
    Ok(Box::new(crate::stress::Gpu {
        gpu,
        effort: arguments.effort(),
    }))
}
