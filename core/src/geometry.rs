//! Numbers, boxes, rays and triangles, and the exact tests between them. No tree is known here.

pub mod aabb;
pub mod ends;
pub mod float;
pub mod frustum;
pub mod lanes;
pub mod lattice;
pub mod orientation;
pub mod planes;
pub mod ray;
pub mod slab;
pub mod triangle;
pub mod watertight;
