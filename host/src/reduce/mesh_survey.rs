//! Which triangles of a mesh rays may hit, for each target, and the choice between L+ and L−.

use super::Costs;
use super::sample::Samples;
use super::set::{FacingSet, ViewSet};
use crate::Mesh;
use crate::topology::{Facts, Topology};
use slimbvh_core::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use std::cell::RefCell;

/// What was found before over the same surfaces and positions, as it takes all triangles: the mesh's bounds, and the sides of
/// components for targets.
#[derive(Clone, Debug, Default)]
pub struct Known {
    bounds: Option<Aabb>,
    /// Of the plan before this one.
    old: Vec<(Target, Vec<i32>)>,
    /// Of this plan.
    new: Vec<(Target, Vec<i32>)>,
}

impl Known {
    /// The mesh's bounds.
    pub fn bounds(&mut self, mesh: &Mesh) -> Aabb {
        *(self.bounds).get_or_insert_with(|| mesh.bounds().unwrap_or(Aabb::EMPTY))
    }

    /// Forgets the bounds: vertices have moved.
    pub fn forget_bounds(&mut self) {
        self.bounds = None;
    }

    /// Forgets what the latest plan did not need.
    pub fn begin(&mut self) {
        self.old = std::mem::take(&mut self.new);
    }

    fn sides(&mut self, topology: &Topology, target: &Target) -> Vec<i32> {
        let of = |known: &[(Target, Vec<i32>)]| {
            let found = known.iter().find(|(other, _)| other == target);
            found.map(|(_, sides)| sides.clone())
        };
        if let Some(sides) = of(&self.new) {
            return sides;
        }
        let sides = of(&self.old).unwrap_or_else(|| topology.sides(&target.into()));
        self.new.push((*target, sides.clone()));
        sides
    }
}

/// The surfaces, and samples of the triangles.
pub struct MeshSurvey<'a> {
    topology: &'a Topology,
    known: RefCell<&'a mut Known>,
    facts: Vec<Facts>,
    samples: Samples<'a>,
}

impl<'a> MeshSurvey<'a> {
    /// A survey of the mesh, whose bounds these are, with what is known of these surfaces.
    pub fn new(
        topology: &'a Topology,
        mesh: &'a Mesh,
        bounds: &Aabb,
        known: &'a mut Known,
    ) -> Self {
        known.begin();
        let scale = PowerOfTwo::new(scene_exponent(bounds));
        Self {
            topology,
            known: RefCell::new(known),
            facts: topology.facts(),
            samples: Samples::new(mesh, topology.components(), scale),
        }
    }

    /// Measures a target: the sides of the components that it sees, and the share of all triangles that its set keeps.
    pub fn measure(&self, view: &mut ViewSet) {
        view.sides = (self.known.borrow_mut()).sides(self.topology, &view.target);
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
