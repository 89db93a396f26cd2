//! slimbvh.

#[cfg(feature = "scenes")]
pub mod generate;
mod mesh;
pub mod scene;

pub use mesh::{Mesh, MeshError, Part};
pub use scene::{Camera, Light, Material, Projection, Scene};
