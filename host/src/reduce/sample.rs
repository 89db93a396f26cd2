//! Estimates of the size of sets, from evenly spaced samples.

use crate::Mesh;
use slimbvh_core::IndexedTriangles;
use slimbvh_core::classify::{Sides, VisibleSet, is_in_set};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// The number of triangles sampled.
const SAMPLES: usize = 4096;

/// Some of a mesh's triangles.
pub struct Samples<'a> {
    mesh: IndexedTriangles<'a>,
    components: &'a [u32],
    scale: PowerOfTwo,
}

impl<'a> Samples<'a> {
    pub fn new(mesh: &'a Mesh, components: &'a [u32], scale: PowerOfTwo) -> Self {
        Self {
            mesh: mesh.triangles(),
            components,
            scale,
        }
    }

    /// The share of the triangles that rays may hit. All arguments in the mesh's unit.
    pub fn share(&self, sides: &[i32], target: &Target, frustum: &Frustum) -> f64 {
        let components = self.components;
        let reach = VisibleSet {
            sides: Sides { components, sides },
            target: *target,
            frustum: *frustum,
        };
        let reach = reach.scaled(&self.scale);
        let count = self.mesh.indices.len();
        let places = (0..count).step_by(count.div_ceil(SAMPLES).max(1));
        let place_count = places.len();
        let kept = places.filter(|&i| is_in_set(i as u32, &self.mesh, &self.scale, &reach));
        kept.count() as f64 / place_count.max(1) as f64
    }
}
