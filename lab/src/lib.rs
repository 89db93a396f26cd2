//! The laboratory of slimbvh: measurements, exact answers, and a command line for both.
//!
//! [`oracle`] gives exact answers, and [`stress`] judges tracers by them. `bench` measures every setting on the user's
//! scenes, and `reproduce` measures the papers' tables again. Both measure in rounds ([`measure`]).
#![forbid(unsafe_code)]

#[cfg(feature = "report")]
mod bench;
pub mod measure;
pub mod oracle;
mod own;
mod reproduce;
pub mod scenes;
pub mod stress;

use anyhow::Result;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Measure slimbvh, and check its answers.
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
    /// Measure every setting on your scenes, alone and in promising combinations: times, bytes, errors, Pareto fronts
    #[cfg(feature = "report")]
    Bench(bench::BenchArguments),
    /// Measure the tables of a paper again, and print the results beside the paper's figures
    Reproduce(reproduce::ReproduceArguments),
    /// Trace scenes and rays that are hard for tracers, and judge every answer by an exact one
    Stress(stress::StressArguments),
}

/// Runs the command. Returns 1 if a check failed.
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
