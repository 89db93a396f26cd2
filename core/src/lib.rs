//! The algorithms of slimbvh, written once: plain functions of an index, small parameters and read-only slices that
//! return what to store. They run on the CPU and, compiled to SPIR-V, on the GPU.
//!
//! Stages, in the order of a frame, a file each: `bounds → morton → sort → snap → topology or cluster → refit → trace → shade`.
//!
//! Conventions: right-handed, counter-clockwise is front, t in units of the ray direction's length, angles in radians.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

pub mod aabb;
pub mod bounds;
pub mod camera;
pub mod classify;
pub mod cluster;
pub mod color;
pub mod compact;
pub mod decide;
pub mod encode;
pub mod float;
pub mod frustum;
pub mod lanes;
pub mod lattice;
pub mod launch;
pub mod light;
pub mod material;
pub mod morton;
pub mod node;
pub mod orientation;
pub mod ray;
pub mod refit;
pub mod sampling;
pub mod scan;
pub mod shade;
pub mod slab;
pub mod snap;
pub mod sort;
pub mod surface;
pub mod topology;
pub mod trace;
pub mod triangle;
pub mod view;
pub mod watertight;

pub use aabb::Aabb;
pub use glam::Vec3;
pub use node::{Node, NodeRef};
pub use ray::{Hit, NO_PRIMITIVE, Ray};
pub use triangle::{IndexedTriangles, LeafTriangle, Triangle};

/// Largest number of triangles in one hierarchy: a leaf reference holds its first triangle in 28 bits.
pub const MAX_TRIANGLES: u32 = 1 << 28;

/// An element of a slice, or `otherwise` where there is none: no index can panic.
#[inline(always)]
pub(crate) fn load<T: Copy>(slice: &[T], index: u32, otherwise: T) -> T {
    if (index as usize) < slice.len() {
        slice[index as usize]
    } else {
        otherwise
    }
}
