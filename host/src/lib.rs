//! slimbvh.

pub mod analysis;
#[cfg(feature = "scenes")]
pub mod generate;
mod bvh;
mod cpu;
mod mesh;
mod stages;
pub mod scene;

pub use bvh::Bvh;
pub use cpu::{BuildConfig, Builder, CodeBits};
pub use stages::Stages;
pub use mesh::{Mesh, MeshError, Part};
pub use scene::{Camera, Light, Material, Projection, Scene};
