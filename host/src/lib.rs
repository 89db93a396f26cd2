#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

pub mod analysis;
pub mod animate;
pub mod backend;
pub mod collect;
mod config;
mod cpu;
mod dvec3;
mod frame;
#[cfg(feature = "scenes")]
pub mod generate;
#[cfg(feature = "gpu")]
pub mod gpu;
#[cfg(feature = "lab")]
#[doc(hidden)]
pub mod internals;
mod mesh;
mod parallel;
mod picture;
pub mod reduce;
pub mod scene;
mod stages;
mod stopwatch;
mod text;
mod tolerance;
pub mod topology;
#[cfg_attr(
    not(feature = "scenes"),
    allow(
        dead_code,
        reason = "only files have tags of codecs, and only they and GPUs have lists of trees"
    )
)]
mod tree;
mod views;

pub use backend::{Backend, Change, Output};
pub use config::{BuildConfig, CodeBits, TreeKind};
pub use cpu::{Builder, Cpu, CpuError, Decisions, Division, Renderer, Subset, Tree, Trees};
pub use frame::{FrameReport, FrameRequest, Frames};
pub use mesh::{Mesh, MeshError, Part};
pub use picture::{Picture, PictureMean, RenderReport, RenderSettings, View};
pub use reduce::ViewTarget;
pub use scene::{AreaShape, Camera, LeftOut, Light, Material, Projection, Scene, Up, ViewError};
pub use slimbvh_core::ray::PreparedRay;
pub use slimbvh_core::tile::Tiles;
pub use slimbvh_core::trace::Collector;
pub use slimbvh_core::{
    Aabb, Hit, LeafTriangle, NO_PRIMITIVE, Node, Ray, RayEnd, RayEnds, SurfacePoint, SurfaceRay,
};
pub use stages::Stages;
pub use stopwatch::Stopwatch;
pub use tolerance::Tolerance;
#[cfg(feature = "lab")]
pub use tree::LatticeBits;
pub use tree::{
    Bvh, CodecError, MeshCodec, NodeCodec, Processor, Reads, RefitError, TreeError, WideStore,
    check_codecs, sah_cost,
};
pub use views::{FrameConfig, FrameSizes, SetSize, ViewSets};

/// The examples of the repository's README.
#[cfg(all(doctest, feature = "gpu", feature = "scenes"))]
#[doc = include_str!("../../README.md")]
struct Readme;
