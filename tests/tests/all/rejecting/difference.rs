//! A ray on which the tracer and the exact oracle differ, with its distances to silhouettes, creases and contacts.
//!
//! # How far the tracer may be off
//!
//! Everything is at magnitude 1, in units of rounding `u = 2^-24`, and M is the largest coordinate of the ray's ends and of
//! all triangles. The tracer's answer about a triangle is the exact answer about one whose corners are moved a little, across
//! the ray:
//!
//! - A corner less the origin, at most 2M, is rounded (1 u), multiplied by the direction (1 u), and the difference of two
//!   such products is rounded (1 u): `x·dz − z·dx` is off by at most 3u (|x|·dz + |z|·dx) ≤ 12 u M dz. That moves the
//!   corner by 12 u M on each of the two axes across, 17 u M together.
//! - On which side of an edge from b to c the ray passes is decided by two rounded products, which may be taken for equal
//!   where they differ by up to 2u |b| |c|: then an edge of length L passes the ray, between its ends, at no more than
//!   2u |b| |c| / L ≤ u L / 2, and L is at most 2 √3 M: 2 u M.
//! - The slab test of the triangle's own box is padded by 32 u of its reach, so it decides only about rays that are farther
//!   away than all this.
//! - A shadow ray's end misses its lamp by the rounding of a difference, u M an axis: 2 u M.
//! - A shadow ray starts off its surface by at most `gamma(12)` of its coordinates times √3, and a step: 21 u M + 2 u M.
//!
//! Each is below, and those that add up for one answer (17 + 2 + 2) are below, d = 32 u M. So wherever the exact answer and
//! the tracer's differ, the ray passes within d of an edge beyond which there is nothing that counts (a silhouette), or two
//! surfaces lie within d of each other (a contact: of a hit with another component, of a shadow ray's start or of a lamp
//! with anything), or a shadow ray starts within d of a crease, where it may start inside a solid.

use super::surroundings::{Surroundings, wide};
use super::wave::{Cast, RayKind};
use slimbvh_core::orientation::Target;
use slimbvh_lab::oracle::Crossing;
use std::fmt;

/// d for M = 1.
pub const ERROR_BOUND: f64 = 32.0 / 16_777_216.0;

/// The comparison of both answers to a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal answers.
    Same,
    /// Two primitives at exactly the same t.
    Tie,
    /// Two primitives that share a corner, one of them within d of the ray's hit on the other: at their common edge. On a
    /// triangle seen edge-on t is hardly known.
    Neighbor,
    /// Any other difference.
    Different,
}

/// A ray on which they differ.
#[derive(Clone, Debug)]
pub struct Difference {
    cast: Cast,
    exact: Option<Crossing>,
    /// In units of d: the distance of the ray, up to the farther answer or on its whole length, to a silhouette for its target.
    silhouette: f64,
    /// In units of d: the distance of a shadow ray's start to an edge between two planes.
    crease: f64,
    /// In units of d: the distance of the nearer answer, or of a shadow ray's ends, to another component.
    contact: f64,
    /// In units of d: the distance between both answers.
    other: f64,
}

/// d for a ray in a scene with this largest coordinate.
pub fn error_bound(cast: &Cast, largest: f32) -> f64 {
    let ray = &cast.ray;
    let end = |axis: usize| {
        if ray.t_max == 1.0 {
            ray.origin[axis] + ray.direction[axis]
        } else {
            0.0
        }
    };
    let ends = (0..3).flat_map(|axis| [ray.origin[axis].abs(), end(axis).abs()]);
    ERROR_BOUND * f64::from(ends.fold(largest, f32::max))
}

/// Compares the tracer's answer with the exact crossings, which are in order of t.
pub fn judge(cast: &Cast, crossings: &[Crossing], d: f64, near: &Surroundings) -> Verdict {
    let found = cast.hit;
    let Some(exact) = crossings.first() else {
        return if found.is_hit() {
            Verdict::Different
        } else {
            Verdict::Same
        };
    };
    if !found.is_hit() {
        return Verdict::Different;
    }
    if found.primitive == exact.primitive || cast.kind != RayKind::Camera {
        return Verdict::Same;
    }
    let is_tie =
        |other: &Crossing| other.primitive == found.primitive && other.compare_t(exact).is_eq();
    if crossings.iter().any(is_tie) {
        return Verdict::Tie;
    }
    let at = |t: f64| wide(cast.ray.origin) + wide(cast.ray.direction) * t;
    let is_near = |t: f64, primitive: u32| near.to_primitive(at(t), primitive) <= d;
    if near.are_neighbors(found.primitive, exact.primitive)
        && (is_near(f64::from(found.t), exact.primitive) || is_near(exact.t, found.primitive))
    {
        Verdict::Neighbor
    } else {
        Verdict::Different
    }
}

impl Difference {
    /// Measures the distances.
    pub fn new(
        cast: &Cast,
        exact: Option<Crossing>,
        d: f64,
        near: &Surroundings,
        target: &Target,
    ) -> Self {
        let at = |t: f64| wide(cast.ray.origin) + wide(cast.ray.direction) * t;
        let found = cast
            .hit
            .is_hit()
            .then_some((f64::from(cast.hit.t), cast.hit.primitive));
        let both = [found, exact.map(|exact| (exact.t, exact.primitive))];
        let answers = || both.iter().flatten().copied();
        let first = answers().fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
        // If one answer is a miss, the silhouette may lie beyond the hit.
        let length = wide(cast.ray.direction).length();
        let end = f64::from(cast.ray.t_max).min(8.0 * d / (ERROR_BOUND * length));
        let last = match both {
            [Some(a), Some(b)] => a.0.max(b.0),
            _ => end,
        };
        let mut contact = near.to_other(at(first.0), Some(first.1));
        let mut crease = f64::INFINITY;
        if cast.kind != RayKind::Camera {
            contact = contact.min(near.to_other(at(0.0), Some(cast.skip)));
            crease = near.to_crease(at(0.0), d);
            if target.is_position == 1 {
                contact = contact.min(near.to_other(wide(target.point), None));
            }
        }
        let other = match both {
            [Some(a), Some(b)] => at(a.0).distance(at(b.0)),
            _ => f64::INFINITY,
        };
        Self {
            cast: *cast,
            exact,
            silhouette: near.to_silhouette([at(0.0), at(last)], target, d) / d,
            crease: crease / d,
            contact: contact / d,
            other: other / d,
        }
    }

    /// The source of the ray: the camera or a light.
    pub fn kind(&self) -> RayKind {
        self.cast.kind
    }

    /// Whether the tracer misses a hit.
    pub fn is_lit_wrongly(&self) -> bool {
        !self.cast.hit.is_hit() && self.exact.is_some()
    }

    /// The least of the distances.
    pub fn nearest(&self) -> f64 {
        self.silhouette.min(self.crease).min(self.contact)
    }

    /// Whether rounding explains it.
    pub fn is_explained(&self) -> bool {
        self.nearest() <= 1.0
    }
}

/// The difference on one line.
impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Cast {
            kind,
            sample,
            ray,
            skip,
            hit,
        } = self.cast;
        let who = match kind {
            RayKind::Camera => "camera".to_owned(),
            RayKind::Light(index) => format!("light {}", index + 1),
        };
        write!(
            f,
            "{who}, sample {sample}, from {:?} along {:?}",
            ray.origin, ray.direction
        )?;
        if kind != RayKind::Camera {
            write!(f, " off {skip}")?;
        }
        if hit.is_hit() {
            write!(f, ": tracer {} at {}", hit.primitive, hit.t)?;
        } else {
            write!(f, ": tracer nothing")?;
        }
        match &self.exact {
            Some(exact) => write!(f, ", exact {} at {}", exact.primitive, exact.t)?,
            None => write!(f, ", exact nothing")?,
        }
        let Self {
            silhouette,
            crease,
            contact,
            other,
            ..
        } = self;
        write!(
            f,
            "; silhouette {silhouette:.3} d, crease {crease:.3} d, contact {contact:.3} d, other surface {other:.3} d"
        )
    }
}
