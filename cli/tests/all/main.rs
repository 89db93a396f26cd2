//! Tests of the `slimbvh` binary and of whole pictures, from outside.

#[cfg(feature = "gpu")]
mod adapter;
mod animate;
mod bad_input;
mod files;
mod golden;
mod good_output;
#[cfg(feature = "gpu")]
mod gpu;
#[cfg(target_os = "linux")]
mod interrupted;
mod output;
mod pipes;
mod process;
mod reduce;
mod refusal;
mod shading_is_right;
mod storage;
mod wide;

/// The binary under test.
const BINARY: &str = env!("CARGO_BIN_EXE_slimbvh");
