//! Whether a tracer's answer may stand.

use super::bound::{ULP, largest, steepness};
use super::subject::{Line, Subject};
use crate::oracle::Crossing;
use crate::oracle::distance::{length, minus, plus, segment_to_triangle, to_triangle};
use slimbvh_core::{Hit, Ray};

/// A ray, and what is known of it before it is traced.
#[derive(Clone, Copy, Debug)]
pub struct Shot {
    /// In the mesh's unit.
    pub ray: Ray,
    /// Whether it starts inside of a closed surface and has no end: then it meets something, without any tolerance.
    pub is_inside: bool,
}

/// What a tracer says about a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The closest hit.
    pub closest: Hit,
    /// Whether there is any.
    pub any: bool,
}

/// What is wrong with an answer, if anything, and how exact it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Verdict {
    /// The gravest fault.
    pub fault: Option<Fault>,
    /// Whether the hit's point lies off its triangle by more than the bound. A ray that runs almost in the plane of its
    /// triangle passes it in a stretch, and rounding says where.
    pub is_adrift: bool,
    /// How far along the ray the hit is off the exact one on the same triangle, in ulps of the largest coordinate.
    pub t_error: Option<f64>,
    /// The same, across the triangle's plane.
    pub plane_error: Option<f64>,
}

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Something must be met, and nothing is reported.
    Missed,
    /// What is reported is not where the ray is.
    False,
    /// Something else behind it is reported.
    WrongPrimitive,
}

/// Judges by a bound.
#[derive(Clone, Copy, Debug)]
pub struct Judge<'a> {
    /// What there is to meet.
    pub subject: &'a Subject,
    /// The bound in ulps of the largest coordinate, see [`super::BOUND_ULPS`].
    pub ulps: f64,
}

impl Judge<'_> {
    /// Judges one answer. `crossings` are what the ray meets exactly, in order.
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

    /// Nothing is reported, or only that there is something.
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

    /// Whether the ray comes near a triangle within its range, whose ends are as uncertain as t.
    fn is_near(&self, line: &Line, primitive: u32) -> bool {
        let corners = self.subject.corners(primitive);
        let [reach, along] = self.subject.slack(line, primitive, self.ulps);
        segment_to_triangle(line.beside(&corners, along), corners) <= reach
    }

    /// Where a hit is, if it is one.
    fn place(&self, shot: &Shot, line: &Line, hit: &Hit) -> Option<Place> {
        let count = self.subject.scene.count() as u32;
        let is_sane = [hit.t, hit.u, hit.v].iter().all(|x| x.is_finite());
        if hit.primitive >= count || !is_sane || !self.is_near(line, hit.primitive) {
            return None;
        }
        let corners = self.subject.corners(hit.primitive);
        let [reach, along] = self.subject.slack(line, hit.primitive, self.ulps);
        // A t that has left the range of normal numbers says nothing.
        if hit.t.abs() == f32::MAX || hit.t.is_subnormal() {
            return Some(Place {
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
        (segment_to_triangle(stretch, corners) <= reach).then(|| Place {
            t: Some(t),
            along,
            is_adrift: to_triangle(point, corners) > reach,
        })
    }

    /// Whether a crossing lies before what is reported, and must be met.
    fn is_passed(&self, line: &Line, crossing: &Crossing, place: &Place) -> bool {
        let Some(t) = place.t else {
            return false;
        };
        let [_, along] = self.subject.slack(line, crossing.primitive, self.ulps);
        let way = (t - crossing.t) * line.length;
        way > along + place.along && self.subject.must_be_met(line, crossing, self.ulps)
    }
}

/// Where a hit is.
struct Place {
    /// In the magnitude of the triangles; `None` where the number does not tell.
    t: Option<f64>,
    /// How far along the ray rounding may have carried it.
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
