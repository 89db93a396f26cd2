//! Stage `decide` on the CPU.

use crate::parallel::prelude::*;
use crate::topology::{Runs, Topology};
use crate::{Aabb, Mesh};
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::Sides;
use slimbvh_core::decide::{
    Choice, Measure, SetCounts, Unit, count_step, join_step, lane_counts, lane_joined,
    lane_measure, lane_total,
};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::launch::{BLOCK, LANES};
use slimbvh_core::orientation::Target;

/// Measures of a mesh's components at the present vertices, by the same kernels as on a GPU: equal to
/// [`crate::gpu::Decisions`] to the bit. [`Topology`] also uses solid angles, and so decides more targets that touch a
/// component's box.
#[derive(Clone, Debug)]
pub struct Decisions {
    runs: Runs,
    /// The component of each triangle.
    components: Vec<u32>,
    component_count: u32,
    vertex_count: usize,
    measures: Vec<Measure>,
    exponent: i32,
}

impl Decisions {
    /// Copies what does not depend on positions from a topology. If seams matter, the topology must have searched for them.
    #[must_use]
    pub fn new(topology: &Topology) -> Self {
        Self {
            runs: topology.runs(),
            components: topology.components().to_vec(),
            component_count: topology.component_count(),
            vertex_count: topology.vertex_count(),
            measures: Vec::new(),
            exponent: 0,
        }
    }

    /// Measures all components at the mesh's present vertices.
    ///
    /// # Panics
    /// If the counts of vertices or triangles show that it is another mesh.
    pub fn measure(&mut self, mesh: &Mesh) {
        let counts = (mesh.vertices.len(), mesh.indices.len());
        let expected = (self.vertex_count, self.components.len());
        assert_eq!(counts, expected, "vertices and triangles of another mesh");
        self.exponent = scene_exponent(&mesh.bounds().unwrap_or(Aabb::EMPTY));
        let unit = Unit {
            scale: PowerOfTwo::new(self.exponent),
            opaque_zero: 0,
        };
        let surfaces = self.runs.surfaces(&mesh.vertices);
        let spans = self.runs.spans.par_iter().map(|span| {
            let own = |lane| lane_measure(lane, span, &surfaces, &unit);
            reduce(Measure::EMPTY, own, join_step::<LANES>)
        });
        let spans: Vec<Measure> = spans.collect();
        let components = self.runs.components.par_iter().map(|component| {
            let own = |lane| lane_joined(lane, component, &spans);
            reduce(Measure::EMPTY, own, join_step::<LANES>)
        });
        components.collect_into_vec(&mut self.measures);
    }

    /// The measures of each component that may be reduced, with its number.
    pub fn measures(&self) -> impl Iterator<Item = (u32, &Measure)> {
        let components = self.runs.components.iter().zip(&self.measures);
        components.map(|(component, measure)| (component.number, measure))
    }

    /// For each component, the side that faces outward: 1 for the front, −1 for the back. 0 if it must stay whole, or if
    /// the target (in the mesh's unit) touches its box. The entry at the number of components is 0.
    #[must_use]
    pub fn sides(&self, target: &Target) -> Vec<i32> {
        let mut sides = vec![0; self.component_count as usize + 1];
        for (number, measure) in self.measures() {
            sides[number as usize] = measure.side(target);
        }
        sides
    }

    /// Counts the triangles that face a light (L+) and those that face away (L−). If L− is smaller and the eye is outside
    /// of every component that the light is outside of, negates the light's sides. Requires that every shadow ray starts
    /// outside wherever the eye is, so nothing may be transparent.
    ///
    /// # Panics
    /// If the lists of sides have the wrong length.
    pub fn take_smaller(
        &self,
        mesh: &Mesh,
        light: &Target,
        eye_sides: &[i32],
        sides: &mut [i32],
    ) -> SetCounts {
        let expected = self.component_count as usize + 1;
        assert_eq!([eye_sides.len(), sides.len()], [expected; 2], "sides");
        let scale = PowerOfTwo::new(self.exponent);
        let choice = Choice {
            mesh: mesh.triangles(),
            scale,
            sides: Sides {
                components: &self.components,
                sides,
            },
            eye_sides,
            target: light.scaled(&scale),
        };
        let blocks = (0..(mesh.indices.len() as u32).div_ceil(BLOCK)).into_par_iter();
        let none = SetCounts::default();
        let blocks = blocks.map(|block| {
            let own = |lane| lane_counts(block, lane, &choice);
            reduce(none, own, count_step::<LANES>)
        });
        let blocks: Vec<SetCounts> = blocks.collect();
        let own = |lane| lane_total(lane, &blocks);
        let counts = reduce(none, own, count_step::<LANES>).decided();
        if counts.is_minus == 1 {
            for side in sides {
                *side = -*side;
            }
        }
        counts
    }
}

/// The reduction of a workgroup's lanes, in the order of its steps.
fn reduce<T: Copy>(
    identity: T,
    own: impl Fn(u32) -> T,
    step: impl Fn(u32, u32, &[T; LANES]) -> T,
) -> T {
    let mut all = [identity; LANES];
    for (lane, value) in (0..).zip(&mut all) {
        *value = own(lane);
    }
    let mut distance = LANES as u32 / 2;
    while distance > 0 {
        // A lane reads only values that no other lane of the step stores.
        for lane in 0..distance {
            all[lane as usize] = step(lane, distance, &all);
        }
        distance /= 2;
    }
    all[0]
}
