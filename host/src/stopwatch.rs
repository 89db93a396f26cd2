//! Times by the platform's clock, where it has one.

use std::time::{Duration, Instant};

/// The time since a start, by the platform's monotonic clock. `wasm32-unknown-unknown` has none: there every time is zero.
///
/// ```
/// let stopwatch = slimbvh::Stopwatch::start();
/// assert!(stopwatch.elapsed() <= stopwatch.elapsed());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Stopwatch {
    start: Option<Instant>,
}

impl Stopwatch {
    /// Whether this platform has a clock.
    pub const HAS_CLOCK: bool = cfg!(not(all(target_family = "wasm", target_os = "unknown")));

    /// Starts at zero.
    #[must_use]
    pub fn start() -> Self {
        Self {
            start: Self::HAS_CLOCK.then(Instant::now),
        }
    }

    /// The time since the start; zero without a clock.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        self.start.map_or(Duration::ZERO, |start| start.elapsed())
    }
}
