//! Times by the platform's clock, where it has one.

use std::time::Duration;
#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
use std::time::Instant;

/// The time since a start, by the platform's monotonic clock. `wasm32-unknown-unknown` has none: there every time is zero.
///
/// ```
/// let stopwatch = slimbvh::Stopwatch::start();
/// assert!(stopwatch.elapsed() <= stopwatch.elapsed());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Stopwatch {
    #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
    start: Instant,
}

impl Stopwatch {
    /// Whether this platform has a clock.
    pub const HAS_CLOCK: bool = cfg!(not(all(target_family = "wasm", target_os = "unknown")));

    /// Starts at zero.
    #[must_use]
    pub fn start() -> Self {
        Self {
            #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
            start: Instant::now(),
        }
    }

    /// The time since the start; zero without a clock.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
        return self.start.elapsed();
        #[cfg(all(target_family = "wasm", target_os = "unknown"))]
        Duration::ZERO
    }
}
