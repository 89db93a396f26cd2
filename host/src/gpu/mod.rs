//! The GPU backend: core's kernels, compiled to SPIR-V, driven by wgpu.
//!
//! All data of a frame stays on the GPU. A [`Frame`] is one submission: no stage waits for the host, and sizes that the GPU
//! finds drive indirect dispatches. Builds and pictures reuse their buffers, bindings and kernels from frame to frame.
//!
//! ```no_run
//! use slimbvh::gpu::{AdapterChoice, Builder, Bvh, Gpu, Mesh, Query};
//! # fn run(mesh: &slimbvh::Mesh, rays: &wgpu::Buffer, hits: &wgpu::Buffer) -> Result<(), slimbvh::gpu::GpuError> {
//! let gpu = Gpu::open(&AdapterChoice::Hardware)?;
//! let mesh = Mesh::upload(&gpu, mesh)?;
//! let mut builder = Builder::new(slimbvh::BuildConfig::default());
//! let mut bvh = Bvh::new();
//!
//! let mut frame = gpu.frame();
//! builder.build(&mut frame, &mesh, &mut bvh)?;
//! bvh.trace(&mut frame, Query::Closest, rays.slice(..), hits.slice(..))?;
//! let stages = frame.submit()?.wait()?;
//! println!("{stages}");
//! # Ok(())
//! # }
//! ```
//!
//! Devices must follow IEEE 754 where Vulkan leaves a choice: subtraction, multiplication and comparison round to nearest,
//! and numbers below 2^-126 are kept if the whole scene is that small. Objects made with one [`Gpu`] can only be used with
//! it.

mod adapter;
mod backend;
mod bounds;
mod buffer;
mod build;
mod bvh;
mod camera;
mod classify;
mod coding;
mod compact;
mod decide;
mod decisions;
mod decisions_report;
mod device;
mod encode;
mod error;
mod fit;
mod frame;
mod gather;
mod kernel;
mod mesh;
mod misfit;
mod morton;
mod program;
mod refit;
mod render;
mod scan;
mod scene;
mod scopes;
mod shade;
mod sides;
mod signal;
mod snap;
mod sort;
mod timer;
mod topology;
mod trace;
mod trees;
mod view;
mod warm_up;
mod wgsl;
mod wide;
mod work;

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
pub use adapter::adapters;
pub use adapter::{AdapterChoice, AdapterSummary, adapters_async};
pub use backend::{Geometry, Held, LightSets};
pub use buffer::Download;
pub use build::Builder;
pub use bvh::Bvh;
pub use compact::Compact;
pub use decide::{Answer, Decided, SidesDownload};
pub use decisions::{Decisions, Measured, MeasuresDownload};
pub use decisions_report::{DecisionsDownload, DecisionsReport};
pub use device::Gpu;
pub use error::{AdapterError, GpuError};
pub use fit::SetFit;
pub use frame::{Frame, Recorded, Submission};
pub use gather::{IndexLayout, VertexLayout};
pub use kernel::Kernel;
pub use mesh::Mesh;
pub use misfit::Misfit;
pub use render::{Counters, PictureDownload, Renderer};
pub use scan::Scan;
pub use scene::Scene;
pub use sides::{Components, Subset, TargetSides};
pub use sort::{Keys, Sort};
pub use trace::{Query, Rays};
pub use trees::{Tree, Trees};
pub use warm_up::WarmUp;
/// The version of wgpu in this crate's interface.
pub use wgpu;
pub use wgsl::{wgsl, wgsl_compute, wgsl_compute_for, wgsl_for};
pub use work::{Traffic, Work};
