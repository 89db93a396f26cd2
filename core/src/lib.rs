//! The algorithms of slimbvh, written once: plain functions of an index, small parameters and read-only slices that
//! return what to store. They run on the CPU and, compiled to SPIR-V, on the GPU.
//!
//! Each stage is a module, here at the root. In the order of a frame:
//! `bounds → (decide → classify → compact → fit) → morton → sort, scan → snap → topology or cluster → refit → encode → camera →
//! trace → shade → view`; those in brackets only where a tree holds a part of the mesh. They live in rooms, each of which
//! uses only rooms before it: [`geometry`], [`build`], [`trace`], [`codec`], [`reduce`] and [`shade`].
//!
//! Conventions: right-handed, counter-clockwise is front, t in units of the ray direction's length, angles in radians.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

pub mod build;
pub mod codec;
pub mod geometry;
pub mod launch;
pub mod reduce;
pub mod shade;
pub mod trace;

pub use build::{
    bounds, cluster, compact, fit, gather, morton, node, refit, scan, snap, sort, sweep, topology,
    wide,
};
pub use codec as encode;
pub use geometry::{
    aabb, ends, float, frustum, lanes, lattice, orientation, planes, ray, slab, triangle,
    watertight,
};
pub use reduce::{classify, decide};
pub use shade::surface_point::SurfacePoint;
pub use shade::{camera, color, light, material, sampling, surface, surface_point, tile, view};

pub use build::node::{Node, NodeRef};
pub use geometry::aabb::Aabb;
pub use geometry::ends::{RayEnd, RayEnds, SurfaceRay};
pub use geometry::ray::{Hit, NO_PRIMITIVE, Ray};
pub use geometry::triangle::{IndexedTriangles, LeafTriangle, Triangle};
pub use glam::Vec3;

/// The example of this crate's README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

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
