//! Internals that the laboratory reads. Not part of the public interface; no stability.

pub use crate::analysis::edges::{Edges, Side, excess};
pub use crate::analysis::weld::weld;
pub use crate::dvec3::{cross, dot};
#[cfg(feature = "scenes")]
pub use crate::generate::{
    checks::{assert_solid, assert_unit_normals},
    random::Random,
    rings::{Vertex, close_rings},
};
pub use crate::topology::solid_angle::SolidAngle;
