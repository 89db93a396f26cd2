//! The outward side of each component, for a target outside of it.

use super::Topology;
use super::distance::is_clear;
use super::shape::{Shape, Span};
use super::solid_angle::SolidAngle;
use crate::parallel::prelude::*;

/// Where rays come from or lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// An eye or a light.
    Point([f32; 3]),
    /// The direction to a light at infinity: outside of everything.
    Direction([f32; 3]),
    /// A lens, or a group of lights. Outside only if the whole ball is.
    Ball {
        /// The middle.
        center: [f32; 3],
        /// At least 0.
        radius: f32,
    },
}

impl From<&slimbvh_core::orientation::Target> for Target {
    fn from(target: &slimbvh_core::orientation::Target) -> Self {
        let center = target.point;
        match (target.is_position, target.radius) {
            (0, _) => Self::Direction(center),
            (_, 0.0) => Self::Point(center),
            (_, radius) => Self::Ball { center, radius },
        }
    }
}

impl Topology {
    /// For each component, the side that faces outward: 1 for the front (counter-clockwise), −1 for the back. 0 if the
    /// component must stay whole: it is open, the sign of its volume is uncertain, its seams are unknown, or the target is
    /// not certainly outside. The entry at [`Self::component_count`] is 0.
    ///
    /// Takes O(1) for a component whose box the target does not touch, else O(n).
    #[must_use]
    pub fn sides(&self, target: &Target) -> Vec<i32> {
        let side = |shape: &Shape| match shape.side() {
            Some(side) if !shape.barred && self.is_outside(shape, target) => side,
            _ => 0,
        };
        let mut sides: Vec<i32> = self.shapes.par_iter().map(side).collect();
        sides.push(0);
        sides
    }

    /// Whether the target is certainly outside of every closed component, reducible or not.
    #[must_use]
    pub fn is_outside_all(&self, target: &Target) -> bool {
        let is_clear = |shape: &Shape| !shape.closed || self.is_outside(shape, target);
        self.shapes.par_iter().all(is_clear)
    }

    /// Whether the target is certainly outside of a closed component.
    fn is_outside(&self, shape: &Shape, target: &Target) -> bool {
        let (center, radius) = match *target {
            Target::Direction(direction) => return direction.iter().all(|x| x.is_finite()),
            Target::Point(point) => (point, 0.0),
            Target::Ball { center, radius } => (center, radius),
        };
        if !center.iter().all(|x| x.is_finite()) || !radius.is_finite() || radius < 0.0 {
            return false;
        }
        let (center, radius) = (center.map(f64::from), f64::from(radius));
        if is_clear_of_box(shape, center, radius) {
            return true;
        }

        // A ball that meets no triangle is outside if its middle is. A point on a triangle has no winding number.
        let spans = &self.spans[shape.spans.start as usize..shape.spans.end as usize];
        if radius > 0.0 {
            let clear = |span: &Span| {
                self.corners(span)
                    .all(|face| is_clear(center, radius, face))
            };
            if !spans.par_iter().all(clear) {
                return false;
            }
        }
        let angles: Vec<SolidAngle> = spans
            .par_iter()
            .map(|span| SolidAngle::of(self.corners(span), center))
            .collect();
        let sum = angles
            .into_iter()
            .fold(SolidAngle::default(), SolidAngle::plus);
        sum.winding_number() == Some(0)
    }

    /// The corners of a span's triangles.
    fn corners(&self, span: &Span) -> impl Iterator<Item = [[f32; 3]; 3]> {
        let faces = span.faces(&self.faces).iter();
        faces.map(|face| face.map(|vertex| self.vertices[vertex as usize]))
    }
}

/// Whether a ball is certainly clear of a component's box.
fn is_clear_of_box(shape: &Shape, center: [f64; 3], radius: f64) -> bool {
    let gap = |axis: usize| {
        let low = f64::from(shape.bounds.min[axis]) - center[axis];
        let high = center[axis] - f64::from(shape.bounds.max[axis]);
        low.max(high).max(0.0)
    };
    let squared: f64 = (0..3).map(|axis| gap(axis) * gap(axis)).sum();
    squared > radius * radius * (1.0 + 1e-12)
}
