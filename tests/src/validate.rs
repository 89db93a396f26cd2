//! Checks all invariants of a tree, using only boxes, codes and grids of core.

mod fault;
mod order;
mod shape;

pub use fault::Fault;
pub use order::validate_order;
pub use shape::{Shape, validate_shape};

use slimbvh::{Bvh, CodeBits, Mesh};

/// Checks all invariants of a tree built from a mesh.
///
/// # Errors
/// The first fault found.
pub fn validate(bvh: &Bvh, mesh: &Mesh, code_bits: CodeBits) -> Result<Shape, Fault> {
    let shape = validate_shape(bvh.nodes(), bvh.leaf_triangles(), bvh.depth_bound())?;
    validate_order(bvh.nodes(), bvh.leaf_triangles(), mesh, code_bits)?;
    Ok(shape)
}
