//! The `slimbvh` binary. Exit codes: 0 done, 2 usage or input.

use slimbvh_cli::{Arguments, exit_code, run};
use std::process::ExitCode;

fn main() -> ExitCode {
    exit_code(run(Arguments::read()))
}
