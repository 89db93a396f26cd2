//! The `slimbvh-lab` binary. Exit codes: 0 done, 1 a check failed, 2 usage or input.

use clap::Parser;
use slimbvh_cli::exit_code;
use slimbvh_lab::{Arguments, run};
use std::process::ExitCode;

fn main() -> ExitCode {
    exit_code(run(&Arguments::parse()))
}
