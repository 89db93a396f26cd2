//! How long all benches measure.

use criterion::Criterion;
use std::time::Duration;

/// Settings by the command line over the usual ones.
pub fn criterion() -> Criterion {
    Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2))
        .configure_from_args()
}
