//! Stage `scan` on the CPU.

use slimbvh_core::scan::run_scan;

/// Replaces values by the sums of all before each. Returns the sum of all. One thread does it: of a build's values there are
/// few.
pub fn scan(values: &mut [u32]) -> u32 {
    let count = values.len() as u32;
    run_scan(values, 0, count, 0)
}
