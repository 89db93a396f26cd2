//! Judgement of a tracer's answers.

use super::bound::{ULP, largest, steepness};
use super::subject::{Line, Subject};
use crate::oracle::Crossing;
use crate::oracle::distance::{length, minus, plus, segment_to_triangle, to_triangle};
use slimbvh_core::{Hit, Ray};

/// A ray, and what is known about it before it is traced.
#[derive(Clone, Copy, Debug)]
pub struct Shot {
    /// In the mesh's unit.
    pub ray: Ray,
    /// Whether the ray starts inside a closed surface and has no end. Then it must hit something, without tolerance.
    pub is_inside: bool,
}

/// A tracer's answers for a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The closest hit.
    pub closest: Hit,
    /// Whether there is any hit.
    pub any: bool,
}

/// The fault of an answer, if any, and its errors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Verdict {
    /// The gravest fault.
    pub fault: Option<Fault>,
    /// Whether the hit's point is farther off its triangle than the bound. A ray almost in the plane of its triangle passes
    /// it along a stretch, and rounding selects the point.
    pub is_adrift: bool,
    /// The distance along the ray from the exact hit on the same triangle, in ulps of the largest coordinate.
    pub t_error: Option<f64>,
    /// The same distance across the triangle's plane.
    pub plane_error: Option<f64>,
}

/// A fault of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// No hit is reported where one is certain.
    Missed,
    /// The reported hit is not on the ray.
    False,
    /// The reported hit lies behind one that is certain.
    WrongPrimitive,
}

/// Judges answers by a bound.
#[derive(Clone, Copy, Debug)]
pub struct Judge<'a> {
    /// The stored triangles.
    pub subject: &'a Subject,
    /// The bound in ulps of the largest coordinate, see [`super::BOUND_ULPS`].
    pub ulps: f64,
}

impl Judge<'_> {
    /// Judges one answer. `crossings` are the exact hits of the ray, in order.
    #[must_use]
    pub fn judge(&self, shot: &Shot, crossings: &[Crossing], answer: &Answer) -> Verdict {
        let Some(line) = self.subject.line(&shot.ray) else {
            return Verdict::of((answer.closest.is_hit() || answer.any).then_some(Fault::False));
        };
        let hit = &answer.closest;
        if !hit.is_hit() {
            return Verdict::of(self.judge_miss(shot, &line, crossings, answer.any));
        }
        let Some(place) = self.place(shot, &line, hit) else {
            return Verdict::of(Some(Fault::False));
        };
        let passed = crossings
            .iter()
            .take_while(|crossing| crossing.primitive != hit.primitive)
            .find(|crossing| self.is_passed(&line, crossing, &place));
        let is_lost = !answer.any && (shot.is_inside || self.is_any(&line, crossings));
        let mut verdict = Verdict::of(match (passed, is_lost) {
            (Some(_), _) => Some(Fault::WrongPrimitive),
            (None, true) => Some(Fault::Missed),
            (None, false) => None,
        });
        let own = crossings.iter().find(|c| c.primitive == hit.primitive);
        verdict.is_adrift = place.is_adrift;
        if let (Some(own), Some(t)) = (own, place.t) {
            let corners = self.subject.corners(hit.primitive);
            let ulp = ULP * largest(line.origin, &corners);
            let error = (t - own.t).abs() * line.length / ulp;
            verdict.t_error = Some(error);
            verdict.plane_error = Some(error * steepness(line.unit, &corners));
        }
        verdict
    }

    fn is_any(&self, line: &Line, crossings: &[Crossing]) -> bool {
        let must = |crossing: &Crossing| self.subject.must_be_met(line, crossing, self.ulps);
        crossings.iter().any(must)
    }

    /// Judges an answer without a closest hit; `any` says whether the tracer reports any hit.
    fn judge_miss(
        &self,
        shot: &Shot,
        line: &Line,
        crossings: &[Crossing],
        any: bool,
    ) -> Option<Fault> {
        if shot.is_inside || self.is_any(line, crossings) {
            return Some(Fault::Missed);
        }
        let count = self.subject.scene.count() as u32;
        (any && !(0..count).any(|primitive| self.is_near(line, primitive))).then_some(Fault::False)
    }

    /// Whether the ray comes near a triangle within its range. The ends of the range are as uncertain as t.
    fn is_near(&self, line: &Line, primitive: u32) -> bool {
        let corners = self.subject.corners(primitive);
        let [reach, along] = self.subject.slack(line, primitive, self.ulps);
        segment_to_triangle(line.beside(&corners, along), corners) <= reach
    }

    /// The place of a hit; `None` if the hit is false.
    fn place(&self, shot: &Shot, line: &Line, hit: &Hit) -> Option<HitPlace> {
        let count = self.subject.scene.count() as u32;
        let is_sane = [hit.t, hit.u, hit.v].iter().all(|x| x.is_finite());
        if hit.primitive >= count || !is_sane || !self.is_near(line, hit.primitive) {
            return None;
        }
        let corners = self.subject.corners(hit.primitive);
        let [reach, along] = self.subject.slack(line, hit.primitive, self.ulps);
        // A t outside the range of normal numbers carries no information.
        if hit.t.abs() == f32::MAX || hit.t.is_subnormal() {
            return Some(HitPlace {
                t: None,
                along,
                is_adrift: false,
            });
        }
        let Ray { t_min, t_max, .. } = shot.ray;
        if (hit.t < t_min && t_min.is_normal()) || (hit.t > t_max && t_max.is_normal()) {
            return None;
        }
        let t = f64::from(hit.t) * 2f64.powi(line.t_exponent);
        let point = line.at(t);
        let size = length(minus(corners[1], corners[0])) + length(minus(corners[2], corners[0]));
        let way = along.min(size);
        let stretch = [-way, way].map(|way| plus(point, line.unit, way));
        (segment_to_triangle(stretch, corners) <= reach).then(|| HitPlace {
            t: Some(t),
            along,
            is_adrift: to_triangle(point, corners) > reach,
        })
    }

    /// Whether a crossing lies before the reported hit and must be hit.
    fn is_passed(&self, line: &Line, crossing: &Crossing, place: &HitPlace) -> bool {
        let Some(t) = place.t else {
            return false;
        };
        let [_, along] = self.subject.slack(line, crossing.primitive, self.ulps);
        let way = (t - crossing.t) * line.length;
        way > along + place.along && self.subject.must_be_met(line, crossing, self.ulps)
    }
}

/// The place of a hit.
struct HitPlace {
    /// In the magnitude of the triangles; `None` if t carries no information.
    t: Option<f64>,
    /// How far rounding may have moved the hit along the ray.
    along: f64,
    is_adrift: bool,
}

impl Verdict {
    fn of(fault: Option<Fault>) -> Self {
        Self {
            fault,
            ..Self::default()
        }
    }
}
