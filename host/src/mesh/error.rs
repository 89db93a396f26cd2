//! Why a mesh is invalid.

use crate::text::only;
use thiserror::Error;

/// A fault that makes a mesh unfit to build from.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MeshError {
    /// More triangles than a `u32` or a node reference can index.
    #[error("{triangle_count} triangles are too many: at most {limit} can be numbered")]
    TooManyTriangles {
        /// How many there are.
        triangle_count: usize,
        /// How many there may be.
        limit: usize,
    },
    /// More vertices than a `u32` can index.
    #[error("{vertex_count} vertices are too many: at most 4294967295 can be numbered")]
    TooManyVertices {
        /// How many there are.
        vertex_count: usize,
    },
    /// A face refers to a vertex that does not exist.
    #[error("{part}face {face} names vertex {vertex}, but {}", only(*vertex_count, "vertices"))]
    IndexOutOfRange {
        /// `mesh "name", `, or empty.
        part: String,
        /// The face, counted from 0 within the part.
        face: usize,
        /// The index in the face.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// A face has a corner that is NaN or infinite.
    #[error("{part}face {face} has vertex {vertex} at ({x}, {y}, {z}), which is not finite")]
    NotFinite {
        /// `mesh "name", `, or empty.
        part: String,
        /// The face, counted from 0 within the part.
        face: usize,
        /// The vertex, counted from 0.
        vertex: u32,
        /// Its coordinates.
        x: f32,
        /// Its coordinates.
        y: f32,
        /// Its coordinates.
        z: f32,
    },
    /// A vertex is off the lattice on which triangles are to be stored.
    #[error(
        "face {face} has vertex {vertex} at ({x}, {y}, {z}), which is not on the lattice of step 2^{step_exponent}; snap the mesh first"
    )]
    OffLattice {
        /// The face, counted from 0.
        face: usize,
        /// The vertex, counted from 0.
        vertex: u32,
        /// Its coordinates.
        x: f32,
        /// Its coordinates.
        y: f32,
        /// Its coordinates.
        z: f32,
        /// The step is 2 to this power.
        step_exponent: i32,
    },
    /// Parts leave a gap, overlap, or are out of order.
    #[error(
        "mesh \"{part}\" begins at triangle {first_triangle}, but the one before it ends at {expected}"
    )]
    PartOutOfPlace {
        /// The part's name.
        part: String,
        /// Where it begins.
        first_triangle: u32,
        /// Where it should begin.
        expected: usize,
    },
    /// A per-vertex or per-triangle list has the wrong length.
    #[error("{count} {what} for {expected} {of}")]
    LengthMismatch {
        /// `normals` or `materials`.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there should be.
        expected: usize,
        /// `vertices` or `triangles`.
        of: &'static str,
    },
}
