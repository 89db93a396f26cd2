//! Which triangles of a mesh rays may hit, for each target, and the choice between L+ and L−.

use super::Costs;
use super::sample::Samples;
use super::set::{FacingSet, ViewSet};
use crate::Mesh;
use crate::topology::{Facts, Topology};
use slimbvh_core::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;

/// The surfaces, and samples of the triangles.
pub struct MeshSurvey<'a> {
    topology: &'a Topology,
    facts: Vec<Facts>,
    samples: Samples<'a>,
}

impl<'a> MeshSurvey<'a> {
    /// A survey of the mesh, whose bounds these are.
    pub fn new(topology: &'a Topology, mesh: &'a Mesh, bounds: &Aabb) -> Self {
        let scale = PowerOfTwo::new(scene_exponent(bounds));
        Self {
            topology,
            facts: topology.facts(),
            samples: Samples::new(mesh, topology.components(), scale),
        }
    }

    /// Measures a target: the sides of the components that it sees, and the share of all triangles that its set keeps.
    pub fn measure(&self, view: &mut ViewSet) {
        view.sides = self.topology.sides(&(&view.target).into());
        let reducible = view.sides.iter().zip(&self.facts);
        view.reducible_count = reducible
            .filter(|(side, _)| **side != 0)
            .map(|(_, facts)| facts.triangle_count - facts.seam_count)
            .sum();
        if view.may_be_set() {
            view.share = self.samples.share(&view.sides, &view.target, &view.frustum);
        }
    }

    /// Replaces L+ by L− for lights, if L− costs less and the eye is outside of every component that the lights are outside
    /// of. Then every shadow ray starts outside and meets the same number of triangles of either set.
    pub fn take_cheaper_set(
        &self,
        view: &mut ViewSet,
        eye_sides: &[i32],
        cost_ms: impl Fn(&ViewSet) -> f64,
    ) {
        let mut pairs = view.sides.iter().zip(eye_sides);
        if view.reducible_count == 0 || pairs.any(|(light, eye)| *light != 0 && *eye == 0) {
            return;
        }
        let sides: Vec<i32> = view.sides.iter().map(|side| -side).collect();
        let share = self.samples.share(&sides, &view.target, &view.frustum);
        let back = ViewSet {
            effort: Costs::MEASURED.away_effort(view.share + share - 1.0),
            share,
            half: FacingSet::Back,
            sides,
            ..view.clone()
        };
        if cost_ms(&back) < cost_ms(view) {
            *view = back;
        }
    }
}
