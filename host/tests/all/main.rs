//! Tests of the `slimbvh` binary and of whole pictures, from outside.

mod animate;
mod bad_input;
mod files;
mod golden;
mod good_output;
#[cfg(feature = "gpu")]
mod gpu;
#[cfg(target_os = "linux")]
mod interrupted;
mod process;
mod reduce;
mod shading_is_right;
mod storage;
mod wide;
