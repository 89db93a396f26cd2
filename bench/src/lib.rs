//! slimbvh side by side with its peers: the same triangles, the same rays, one run.
//!
//! A [`Tracer`] is anything that builds over a mesh and answers rays. Times are of whole jobs as a user would run them:
//! a build goes from the caller's triangles to the last thing that tracing needs, a trace from a list of [`Ray`]s to a
//! list of answers in the caller's triangle numbers. `README.md` says what is measured and how.
//!
//! [`Ray`]: slimbvh_core::Ray

pub mod agreement;
pub mod exit;
pub mod gpu_peers;
pub mod machine;
pub mod meshes;
pub mod rays;
pub mod reference;
pub mod tracers;

pub use agreement::Agreement;
pub use meshes::Subject;
pub use rays::{RayLists, RayOrder};
pub use reference::Reference;
pub use tracers::{Answer, Input, Tracer};

use anyhow::{Context, Result};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The numbers of threads to measure: 1, and the number of processors if it is larger and obvhs was built to use them.
#[must_use]
pub fn thread_counts() -> Vec<usize> {
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    if all == 1 || cfg!(not(feature = "parallel")) {
        vec![1]
    } else {
        vec![1, all]
    }
}

/// A pool for all tracers: slimbvh, obvhs and bvh run in the pool that calls them; others start as many threads, or build on
/// one thread.
///
/// # Errors
/// If the threads cannot be started.
pub fn pool(threads: usize) -> Result<ThreadPool> {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .with_context(|| format!("cannot start {threads} threads"))
}
