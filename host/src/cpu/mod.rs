//! The CPU backend: core's kernels under rayon. The number of threads never changes a bit.

mod build;
mod order;
mod paint;
mod refit;
mod render;
mod sort;
mod topology;

pub use build::{BuildConfig, Builder, CodeBits, RefitError};
pub(crate) use order::scene_bounds;
pub use render::Renderer;

/// Items that a task takes at once.
const BLOCK: usize = 4096;
