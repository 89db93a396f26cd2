//! Stage `scan` on the CPU.

use slimbvh_core::scan::run_scan;

/// Replaces values by their exclusive prefix sums. Returns the total. Runs on one thread, because a build scans few values.
pub fn scan(values: &mut [u32]) -> u32 {
    let count = values.len() as u32;
    run_scan(values, 0, count, 0)
}
