//! core
#![no_std]

/// Largest number of triangles in one hierarchy: a leaf reference holds its first triangle in 29 bits.
pub const MAX_TRIANGLES: u32 = 1 << 29;
