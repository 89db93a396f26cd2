//! Seams: triangles that a ray from outside may hit from behind.

use super::budget::{Budget, Meter, PAIR_STEPS, STEPS_A_TRIANGLE};
use super::contact::{Face, collide, meet_in_corner_alone};
use super::crossing::Probe;
use super::within::for_each_within;
use super::{Topology, welded_triangles};
use crate::analysis::{Buckets, Edges, UnionFind, are_collinear};
use crate::parallel::prelude::*;
use crate::{Bvh, Mesh, NodeCodec};
use glam::Vec3;
use slimbvh_core::float::{next_down, next_up};
use slimbvh_core::{Aabb, LeafTriangle};
use std::ops::ControlFlow::{Break, Continue};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

impl Topology {
    /// Finds the seams, triangles that stay in every set although their component may be reduced, and removes them from
    /// their components. A triangle is a seam if
    /// - it meets another triangle of its component beyond the corners and the side that they share,
    /// - its component's winding number just outside of it is negative (an inverted lobe, as of a figure-eight tube) or
    ///   uncertain, or
    /// - it has no area.
    ///
    /// `mesh` is the one seen last, `bvh` a hierarchy over all of it. Components that cannot be reduced now get no seams,
    /// and will not be reduced before the next search. Neither do components that the search gives up
    /// ([`Facts::search_given_up`](super::Facts)), because their triangles have too many others near them, as in fans of
    /// thousands of slivers around one corner, many copies at one place, or noise.
    ///
    /// Takes O(n log n): for surfaces whose triangles are near few others, the time that they need; for others at most a
    /// fixed number of steps for each triangle of the mesh. The result does not depend on the number of threads.
    ///
    /// # Panics
    /// If the hierarchy or the mesh has a different number of triangles, or the hierarchy's triangle codec [moves
    /// vertices](crate::MeshCodec::moves_vertices).
    pub fn find_seams(&mut self, mesh: &Mesh, bvh: &Bvh) {
        self.find_seams_within(mesh, bvh, STEPS_A_TRIANGLE);
    }

    /// The search with a budget of so many steps for each triangle.
    pub(super) fn find_seams_within(&mut self, mesh: &Mesh, bvh: &Bvh, steps_a_triangle: u64) {
        let counts = [bvh.triangle_count(), mesh.indices.len()];
        assert_eq!(
            counts,
            [self.components.len(); 2],
            "triangles of another mesh"
        );
        let decoded;
        let (nodes, triangles) = bvh.codecs();
        assert!(
            !triangles.moves_vertices(),
            "a hierarchy whose triangles were moved"
        );
        let bvh = if nodes == NodeCodec::default() {
            bvh
        } else {
            decoded = bvh.decoded();
            &decoded
        };
        for (triangle, component) in self.seams.drain(..) {
            self.components[triangle as usize] = component;
        }

        let search = Search::new(self, mesh, bvh, steps_a_triangle);
        search.mark_collisions();
        search.mark_inverted();
        let seams = (0_u32..).zip(&search.is_seam);
        let seams: Vec<u32> = seams
            .filter(|(triangle, is_seam)| is_seam.load(Relaxed) && !search.is_given_up(*triangle))
            .map(|(triangle, _)| triangle)
            .collect();

        let (kept, budget) = (self.component_count(), search.budget);
        for (component, shape) in (0..).zip(&mut self.shapes) {
            shape.spending = budget.spending(component);
            shape.barred = shape.outward.is_none() || shape.spending.is_exceeded();
            shape.seam_count = 0;
        }
        for triangle in seams {
            let component = std::mem::replace(&mut self.components[triangle as usize], kept);
            self.shapes[component as usize].seam_count += 1;
            self.seams.push((triangle, component));
        }
    }
}

/// The state of a search.
struct Search<'a> {
    mesh: &'a Mesh,
    bvh: &'a Bvh,
    components: &'a [u32],
    /// For each component, the side that faces outward, or 0 if its seams are not needed; and a final 0.
    sides: Vec<i32>,
    /// The triangles over welded vertices.
    welded: Vec<[u32; 3]>,
    /// Of each triangle; `false` in components whose seams are not needed.
    has_area: Vec<bool>,
    /// The result; arbitrary in components that the search gives up.
    is_seam: Vec<AtomicBool>,
    budget: Budget,
}

/// Triangles searched by one thread without a break.
const BLOCK: usize = 256;

impl<'a> Search<'a> {
    /// Marks triangles without area.
    fn new(topology: &'a Topology, mesh: &'a Mesh, bvh: &'a Bvh, steps_a_triangle: u64) -> Self {
        let shapes = topology.shapes.iter();
        let mut sides: Vec<i32> = shapes.map(|shape| shape.side().unwrap_or(0)).collect();
        sides.push(0);
        let components = topology.components.as_slice();
        let of_interest = |triangle: usize| sides[components[triangle] as usize] != 0;
        let has_area: Vec<bool> = (0..components.len())
            .into_par_iter()
            .map(|triangle| of_interest(triangle) && !are_collinear(corners(mesh, triangle as u32)))
            .collect();
        let is_seam = (0..components.len())
            .map(|triangle| AtomicBool::new(of_interest(triangle) && !has_area[triangle]))
            .collect();
        let mut triangle_counts = vec![0; sides.len()];
        for (shape, (count, side)) in topology
            .shapes
            .iter()
            .zip(triangle_counts.iter_mut().zip(&sides))
        {
            *count = if *side == 0 {
                0
            } else {
                shape.triangle_count as usize
            };
        }
        Self {
            mesh,
            bvh,
            components,
            sides,
            welded: welded_triangles(mesh),
            has_area,
            is_seam,
            budget: Budget::new(&triangle_counts, steps_a_triangle),
        }
    }

    /// Marks triangles that meet others of their component beyond shared corners and sides. Triangles without area are
    /// ignored, because no ray hits them.
    fn mark_collisions(&self) {
        let blocks = self.bvh.leaf_triangles().par_chunks(BLOCK);
        blocks.for_each(|block| {
            let mut meter = self.budget.meter();
            for own in block {
                let first = own.primitive;
                if self.has_area[first as usize] && meter.enter(self.component(first)) {
                    self.mark_collisions_of(own, &mut meter);
                }
            }
        });
    }

    /// The collisions of one triangle with those of higher numbers.
    fn mark_collisions_of(&self, own: &LeafTriangle, meter: &mut Meter) {
        let first = own.primitive;
        let face = self.face(first);
        let (mut steps, mut pair_count) = (0, 0);
        // The visitor never stops early.
        let _ = for_each_within(self.bvh, &own.triangle().bounds(), &mut steps, |other| {
            let second = other.primitive;
            let is_pair = first < second
                && self.component(first) == self.component(second)
                && self.has_area[second as usize];
            if !is_pair {
                return Continue(());
            }
            let second_face = self.face(second);
            if meet_in_corner_alone(&face, &second_face) {
                return Continue(());
            }
            // The count must not depend on what other threads have marked.
            pair_count += 1;
            let is_known = self.is_seam(first) && self.is_seam(second);
            if !is_known && collide(&face, &second_face) {
                self.mark(first);
                self.mark(second);
            }
            Continue(())
        });
        meter.add(steps + PAIR_STEPS * pair_count);
    }

    /// Marks triangles with a negative winding number of their component at their outer side. If exactly two triangles
    /// share an edge and no third intersects there, the number is the same beside both, so one line of sight decides for a
    /// whole patch of such triangles.
    fn mark_inverted(&self) {
        let mut patches = UnionFind::new(self.welded.len());
        let is_sound = |triangle: u32| {
            self.has_area[triangle as usize]
                && !self.is_seam(triangle)
                && !self.is_given_up(triangle)
        };
        Edges::new(&self.welded, self.mesh.vertices.len()).for_each(|sides| {
            if let [a, b] = sides
                && a.is_forward() != b.is_forward()
                && is_sound(a.triangle())
                && is_sound(b.triangle())
            {
                patches.join(a.triangle(), b.triangle());
            }
        });
        let sound: Vec<(u32, u64)> = (0..self.welded.len() as u32)
            .filter(|&triangle| is_sound(triangle))
            .map(|triangle| (patches.find(triangle), u64::from(triangle)))
            .collect();
        let patches = Buckets::new(self.welded.len(), sound.iter().copied());
        let patches: Vec<&[u64]> = patches
            .iter()
            .filter(|(_, patch)| !patch.is_empty())
            .map(|(_, patch)| patch)
            .collect();
        patches.par_iter().for_each(|patch| {
            let mut meter = self.budget.meter();
            if !meter.enter(self.component(patch[0] as u32)) {
                return;
            }
            let number = self.outer_winding(patch, &mut meter);
            if number.is_none_or(|number| number < 0) {
                for &triangle in *patch {
                    self.mark(triangle as u32);
                }
            }
        });
    }

    /// The component's winding number at points just outside of a patch, positive for a solid. `None` if no line of sight
    /// is certain.
    fn outer_winding(&self, patch: &[u64], meter: &mut Meter) -> Option<i32> {
        const LOOK_COUNT: usize = 24;
        (0..LOOK_COUNT).find_map(|look| {
            let triangle = patch[look % patch.len()] as u32;
            let side = self.sides[self.component(triangle) as usize];
            let corners = corners(self.mesh, triangle);
            let axis = (widest_axis(corners) + look / 8) % 3;
            let probe = Probe::new(corners, WEIGHTS[look % WEIGHTS.len()], axis, side)?;
            Some(side * self.winding(triangle, &probe, meter)?)
        })
    }

    /// The winding number along a probe of a triangle; `None` if uncertain.
    fn winding(&self, triangle: u32, probe: &Probe, meter: &mut Meter) -> Option<i32> {
        let (mut number, mut steps) = (0, 0);
        let region = self.line_of_sight(probe);
        let flow = for_each_within(self.bvh, &region, &mut steps, |other| {
            let other = other.primitive;
            if other == triangle || self.component(other) != self.component(triangle) {
                return Continue(());
            }
            match probe.fall(corners(self.mesh, other)) {
                Some(fall) => {
                    number += fall;
                    Continue(())
                }
                None => Break(()),
            }
        });
        meter.add(steps);
        flow.is_continue().then_some(number)
    }

    /// The box around a probe's line of sight, in the tree's space.
    fn line_of_sight(&self, probe: &Probe) -> Aabb {
        let scale = 2_f64.powi(self.bvh.scene_exponent());
        let point = Vec3::from(probe.point.map(|x| (x * scale) as f32));
        // Rounded once here and once in the tree, so a step to both sides contains the point.
        let step = |p: Vec3, by: fn(f32) -> f32| Vec3::new(by(p.x), by(p.y), by(p.z));
        let mut region = Aabb {
            min: step(point, next_down),
            max: step(point, next_up),
        };
        if probe.is_upward {
            region.max[probe.axis] = f32::MAX;
        } else {
            region.min[probe.axis] = -f32::MAX;
        }
        region
    }

    fn component(&self, triangle: u32) -> u32 {
        self.components[triangle as usize]
    }

    fn face(&self, triangle: u32) -> Face {
        Face {
            corners: corners(self.mesh, triangle),
            ids: self.welded[triangle as usize],
        }
    }

    /// Whether the search in the triangle's component is given up.
    fn is_given_up(&self, triangle: u32) -> bool {
        let component = self.component(triangle);
        self.budget.spending(component).is_exceeded()
    }

    fn is_seam(&self, triangle: u32) -> bool {
        self.is_seam[triangle as usize].load(Relaxed)
    }

    fn mark(&self, triangle: u32) {
        self.is_seam[triangle as usize].store(true, Relaxed);
    }
}

/// Barycentric coordinates of the probes' points, in no simple ratio, so that lines of sight seldom hit edges of regular
/// meshes.
const WEIGHTS: [[f64; 3]; 8] = [
    [0.381_966, 0.311_310, 0.306_724],
    [0.234_131, 0.414_214, 0.351_655],
    [0.577_350, 0.207_107, 0.215_543],
    [0.171_573, 0.267_949, 0.560_478],
    [0.145_898, 0.720_759, 0.133_343],
    [0.854_102, 0.070_711, 0.075_187],
    [0.057_191, 0.486_833, 0.455_976],
    [0.436_790, 0.090_169, 0.473_041],
];

/// The axis along which a triangle's projection is largest.
fn widest_axis(corners: [[f32; 3]; 3]) -> usize {
    let [a, b, c] = corners.map(|p| p.map(f64::from));
    let area = |axis: &usize| {
        let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
        ((b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x])).abs()
    };
    let larger = |best: usize, axis: usize| {
        if area(&axis) > area(&best) {
            axis
        } else {
            best
        }
    };
    (0..3).fold(0, larger)
}

fn corners(mesh: &Mesh, triangle: u32) -> [[f32; 3]; 3] {
    mesh.indices[triangle as usize].map(|vertex| mesh.vertices[vertex as usize])
}
