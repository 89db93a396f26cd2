//! The CPU backend: core's kernels under rayon. The number of threads never changes a bit.

mod build;
mod render;
mod sort;

pub use build::{BuildConfig, Builder, CodeBits};
pub use render::Renderer;
