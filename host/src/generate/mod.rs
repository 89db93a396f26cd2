//! Generated meshes, scenes made of them, and the default scene.
//!
//! +y is up. Solids are exactly closed, with shared vertices, and their front sides face outward. Equal arguments give
//! equal meshes. Sizes are in the caller's unit.

mod compose;
mod cuboid;
mod default_scene;
mod grid_of_objects;
mod ground;
mod huge_and_tiny;
mod icosphere;
mod midpoints;
pub(crate) mod random;
pub(crate) mod rings;
mod round_cone;
mod rounded_box;
mod slivers;
mod smooth_normals;
mod soup;
mod sphere_flake;
mod split_longest;
mod subdivide;
mod teapot;
mod terrain;
mod torus_knot;

pub use compose::{append, concatenate, transformed};
pub use cuboid::cuboid;
pub use default_scene::default_scene;
pub use grid_of_objects::grid_of_objects;
pub use ground::ground;
pub use huge_and_tiny::huge_and_tiny;
pub use icosphere::icosphere;
pub use round_cone::{RoundCone, round_cone};
pub use rounded_box::{RoundedBox, Sides, rounded_box};
pub use slivers::slivers;
pub use smooth_normals::smooth_normals;
pub use soup::soup;
pub use sphere_flake::sphere_flake;
pub use split_longest::split_longest;
pub use subdivide::{subdivide, subdivide_curved};
pub use teapot::teapot;
pub use terrain::terrain;
pub use torus_knot::{TorusKnot, torus_knot};

/// Checks common to the tests of all solids.
#[cfg(any(test, feature = "lab"))]
pub(crate) mod checks {
    use crate::Mesh;
    use crate::analysis::{Component, analyze};

    /// Asserts that a mesh is sound and without faults, and that each of its components is closed and faces outward.
    /// Returns the components, largest first.
    ///
    /// # Panics
    /// If one of these does not hold.
    #[must_use]
    pub fn assert_solid(mesh: &Mesh) -> Vec<Component> {
        assert_eq!(mesh.validate(), Ok(()));
        let analysis = analyze(mesh);
        assert_eq!(analysis.degenerate_triangle_count, 0);
        assert_eq!(analysis.duplicate_triangle_count, 0);
        assert_eq!(analysis.welded_vertex_count, mesh.vertices.len());
        for component in &analysis.components {
            assert!(component.closed && component.consistently_wound);
            assert_eq!(component.outward, Some(true));
        }
        analysis.components
    }

    /// Asserts that there is one unit normal a vertex.
    ///
    /// # Panics
    /// If one is missing or not a unit vector.
    pub fn assert_unit_normals(mesh: &Mesh) {
        assert_eq!(mesh.normals.len(), mesh.vertices.len());
        for &normal in &mesh.normals {
            assert!((glam::Vec3::from(normal).length() - 1.0).abs() < 1e-6);
        }
    }
}
