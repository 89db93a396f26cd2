//! Tests of the `slimbvh-lab` binary, from outside.

#[cfg(feature = "gpu")]
#[path = "../../../cli/tests/all/adapter.rs"]
mod adapter;
mod bad_input;
#[allow(dead_code, reason = "shared with the tests of `slimbvh`")]
#[path = "../../../cli/tests/all/files.rs"]
mod files;
mod good_output;
#[cfg(feature = "gpu")]
mod gpu;
#[allow(dead_code, reason = "shared with the tests of `slimbvh`")]
#[path = "../../../cli/tests/all/output.rs"]
mod output;
#[allow(dead_code, reason = "shared with the tests of `slimbvh`")]
#[path = "../../../cli/tests/all/process.rs"]
mod process;
#[allow(dead_code, reason = "shared with the tests of `slimbvh`")]
#[path = "../../../cli/tests/all/refusal.rs"]
mod refusal;

/// The binary under test.
const BINARY: &str = env!("CARGO_BIN_EXE_slimbvh-lab");
