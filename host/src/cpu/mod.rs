//! The CPU backend: core's kernels under rayon. The number of threads never changes a bit.

mod backend;
mod build;
mod cluster;
mod decide;
mod divide;
mod encode;
mod order;
mod paint;
mod refit;
mod render;
mod select;
mod sort;
mod topology;
mod trees;

pub use backend::{Cpu, CpuError};
pub use build::{BuildConfig, Builder, CodeBits, RefitError, Subset, TreeKind};
pub use decide::Decisions;
pub use divide::Division;
pub(crate) use order::scene_bounds;
pub use render::Renderer;
pub use trees::{Tree, Trees};

/// Items that a task takes at once.
const BLOCK: usize = 4096;
