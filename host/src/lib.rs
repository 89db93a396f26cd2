#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

pub mod analysis;
pub mod animate;
mod bvh;
mod codec;
mod coded;
mod cpu;
#[cfg(feature = "scenes")]
pub mod file;
#[cfg(feature = "scenes")]
pub mod generate;
#[cfg(feature = "gpu")]
pub mod gpu;
#[cfg(feature = "lab")]
#[doc(hidden)]
pub mod internals;
mod mesh;
mod picture;
pub mod reduce;
pub mod scene;
mod stages;
mod text;
mod tolerance;
pub mod topology;
mod wide;

pub use bvh::{Bvh, TreeError};
pub use codec::{CodecError, LatticeBits, MeshCodec, NodeCodec, check_codecs};
pub use cpu::{
    BuildConfig, Builder, CodeBits, Decisions, Division, RefitError, Renderer, Subset, Tree,
    TreeKind, Trees, Turns,
};
pub use mesh::{Mesh, MeshError, Part};
pub use picture::{Picture, PictureMean, RenderReport, RenderSettings, View};
pub use scene::{AreaShape, Camera, Light, Material, Projection, Scene, ViewError};
pub use slimbvh_core::{Aabb, Hit, LeafTriangle, Node, Ray};
pub use stages::Stages;
pub use tolerance::Tolerance;

/// The examples of the repository's README.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
