//! The `.slim` format: a scene with a hierarchy over its mesh in one file, so that tracing needs no build.
//!
//! All numbers are little-endian, in words of 4 bytes. Nothing is packed, and there are no pointers: each list has the
//! layout of a GPU buffer, at a multiple of 256 bytes, where every device can bind it. So a file can be mapped into memory
//! and uploaded whole. Bytes between sections are zero, and each content has one encoding: [`write()`] reproduces what
//! [`read`] accepts, byte for byte.
//!
//! ```text
//! header, 64 bytes
//!    0  89 53 4C 49 4D 0D 0A 1A   "SLIM" among bytes that text tools spoil
//!    8  01020304                  byte order
//!   12  version                   2
//!   16  CRC-32 (IEEE, as in PNG)  of all bytes of the file but these four
//!   20  number of sections        13
//!   24  length of the file        8 bytes
//!   32  zeros
//!
//! a record of 32 bytes for each section, right behind
//!    0  kind, 1 to 13 in this order       4  bytes of an item
//!    8  where it begins, 8 bytes         16  its length in bytes, 8 bytes
//!   24  zeros
//!
//! kind             item
//!  1 vertices        12  x, y, z
//!  2 indices         12  three vertices of a triangle
//!  3 normals         12  x, y, z; none, or one a vertex
//!  4 materials used   4  one a triangle, or none
//!  5 parts           16  length of the name in bytes, 0, first triangle, number of triangles
//!  6 names            1  the parts' names in UTF-8, without separators
//!  7 materials       32  base color: r, g, b; mirror share; transmission; index of refraction; 1 if single-sided, else 0; 0
//!  8 cameras         64  eye (3), kind (0 perspective, 1 thin lens, 2 parallel), target (3), degrees or height, up (3), lens
//!                        radius, distance of what is sharp, zeros (3)
//!  9 lights          64  color (3), kind (0 sun, 1 point, 2 disc, 3 rectangle), direction or place (3), range, first half
//!                        edge (3), 0, second half edge (3), 0
//! 10 scene           64  box to be framed: min (3), whether there is one, max (3), 0; number of faces that a lenient loader
//!                        dropped, whether z points up, local origin (three numbers of 8 bytes)
//! 11 hierarchy      128  codec of nodes (0 in full, 1 paper10, 2 the laboratory's lattice; of up to four children: 3 in full, 4 of 64 bytes, 5
//!                        of 48), bits of a plane on the lattice, codec of triangles (0 in full, 1 in 10 bits, 2 lattice), number
//!                        of triangles, that of the mesh, depth bound, scene
//!                        exponent, exponent of the lattice's step, bounds: min (3), whether there are any, max (3), 0, root
//!                        box: min (3), 0, max (3), 0, zeros (8)
//! 12 nodes               in full 64, paper10 24, the laboratory's 12 to 28; of up to four children 128, 64 or 48
//! 13 triangles           in full 40, in 10 bits 16, on the lattice 4: words, of which a triangle has 4, 7 or 10; below nodes of 48
//!                        bytes, of which a leaf of T triangles has T / 2, T, and 1 to 3 a corner
//! ```
//!
//! `slimbvh_core` specifies the items of sections 12 and 13: [`Node`](crate::Node), [`LeafTriangle`](crate::LeafTriangle)
//! and `encode`. A section without items still has a position.
//!
//! A hierarchy alone ([`write_hierarchy`], [`read_hierarchy`]) has the same layout: sections 1 to 9 have no items, and the
//! scene's record is zeros.

mod check;
mod error;
mod hierarchy;
mod layout;
mod read;
mod records;
mod write;

pub use error::{ContentError, FileError, WriteError};
pub use hierarchy::{read_hierarchy, write_hierarchy};
pub use layout::Section;
pub use read::read;
pub use write::write;

use super::load::{Source, read_file};
use super::{LoadError, Scene};
use crate::{Aabb, Bvh};
use std::path::Path;

/// The content of a file.
#[derive(Clone, Debug)]
pub struct Saved {
    /// Geometry, materials, cameras and lights.
    pub scene: Scene,
    /// A hierarchy over its mesh.
    pub bvh: Bvh,
    /// The box that the default camera frames; `None` for the mesh's bounds. It is stored if vertices were snapped to a
    /// lattice, so that the camera stays in place.
    pub framing: Option<Aabb>,
}

/// Loads the scene and the hierarchy from a file of at most this many bytes.
///
/// # Errors
/// If the file cannot be read or is invalid.
pub fn load(path: &Path, max_file_bytes: u64) -> Result<Saved, LoadError> {
    let bytes = read_file(path, max_file_bytes)?;
    read(&bytes).map_err(|error| LoadError::Saved {
        file: path.display().to_string(),
        error,
    })
}

/// The scene in a file, after the whole file was checked.
pub(super) fn read_scene(source: &Source<'_>, bytes: &[u8]) -> Result<Scene, LoadError> {
    match read(bytes) {
        Ok(saved) => Ok(saved.scene),
        Err(error) => Err(LoadError::Saved {
            file: source.file.clone(),
            error,
        }),
    }
}

#[cfg(test)]
mod tests;
