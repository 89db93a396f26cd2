//! The CPU backend: core's kernels, over all cores with feature `parallel`. Results do not depend on the number of threads.

mod backend;
mod bounds;
mod build;
mod camera;
mod classify;
mod cluster;
mod compact;
mod decide;
mod encode;
mod morton;
mod order;
mod refit;
mod render;
mod scan;
mod shade;
mod snap;
mod sort;
mod sweep;
mod topology;
mod trace;
mod trees;
mod view;
mod wide;

pub use backend::{Cpu, CpuError};
pub use build::{Builder, Subset};
pub use classify::Division;
pub use decide::Decisions;
pub use render::Renderer;
pub use trees::{Tree, Trees};

/// Items in a parallel task.
const BLOCK: usize = 4096;
