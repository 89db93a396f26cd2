//! The laboratory of slimbvh: what measures and judges it, and the command line of that.
//!
//! [`oracle`] answers exactly, [`stress`] judges tracers by it. `bench` measures every setting on scenes of the user's, `reproduce`
//! measures the papers' tables again; both measure in rounds ([`measure`]).
#![forbid(unsafe_code)]

#[cfg(feature = "report")]
mod bench;
pub mod measure;
pub mod oracle;
mod reproduce;
pub mod stress;

use anyhow::Result;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Measure slimbvh, and judge its answers.
#[derive(Debug, Parser)]
#[command(
    name = "slimbvh-lab",
    version,
    arg_required_else_help = true,
    allow_negative_numbers = true
)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Measure every setting on scenes of yours, one at a time and the best crossed: times, bytes, errors, Pareto fronts
    #[cfg(feature = "report")]
    Bench(bench::BenchArguments),
    /// Measure what a paper's tables show, and print ours beside the printed figures
    Reproduce(reproduce::ReproduceArguments),
    /// Trace scenes and rays that break tracers, and judge every answer by exact ones
    Stress(stress::StressArguments),
}

/// Runs the command. Returns 1 where a check failed.
///
/// # Errors
/// For bad input, and for files that cannot be written.
pub fn run(arguments: &Arguments) -> Result<ExitCode> {
    match &arguments.command {
        #[cfg(feature = "report")]
        Command::Bench(arguments) => bench::run(arguments)?,
        Command::Reproduce(arguments) => reproduce::run(arguments)?,
        Command::Stress(arguments) => return stress::judge_all(arguments),
    }
    Ok(ExitCode::SUCCESS)
}
