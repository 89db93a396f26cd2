//! A scene as the judge sees it: exact in doubles, and with known surfaces.

use super::bound::{bound, largest, steepness};
use super::surface::Surface;
use crate::oracle::distance::{Point, length, minus, plus};
use crate::oracle::{Crossing, Unculled};
use slimbvh::internals::{SolidAngle, dot};
use slimbvh_core::Ray;
use slimbvh_core::float::exponent;

/// The triangles that a tracer stores, scaled by a power of two.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The triangles for exact intersection.
    pub scene: Unculled,
    surface: Surface,
    /// The largest coordinate.
    pub size: f64,
    /// The exponent of the power of two that scales the mesh, so that the tracer's own numbers fit into `f32`.
    pub exponent: i32,
}

/// A ray among the triangles.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// The ray in the magnitude of the triangles.
    pub ray: Ray,
    /// The point where t is 0.
    pub origin: Point,
    /// The direction, of length 1.
    pub unit: Point,
    /// The length of the direction.
    pub length: f64,
    /// t of `ray` is t of the caller's ray times two to this power.
    pub t_exponent: i32,
}

/// Rays from origins farther away than this many times the scene's size hit nothing: the third promise on magnitudes.
const FARTHEST: f64 = slimbvh_core::ray::FARTHEST_ORIGIN as f64;

impl Subject {
    /// Takes triangles whose coordinates are scaled by two to this power.
    #[must_use]
    pub fn new(triangles: Vec<[[f32; 3]; 3]>, exponent: i32) -> Self {
        let coordinates = triangles.as_flattened().as_flattened().iter();
        let size = coordinates.fold(0.0, |largest: f32, x| largest.max(x.abs()));
        Self {
            surface: Surface::new(&triangles),
            scene: Unculled::new(triangles),
            size: size.into(),
            exponent,
        }
    }

    /// Scales a ray to the magnitude of the triangles; `None` for an invalid ray, which must hit nothing.
    #[must_use]
    pub fn line(&self, ray: &Ray) -> Option<Line> {
        let numbers = ray.origin.iter().chain(&ray.direction);
        let is_sane = numbers.chain([&ray.t_min]).all(|x| x.is_finite())
            && ray.direction != [0.0; 3]
            && ray.t_min <= ray.t_max;
        if !is_sane {
            return None;
        }
        // Scale origin and direction alike, so that t stays as it is unless the direction would overflow.
        let longest = ray.direction.iter().fold(0.0, |a: f32, x| a.max(x.abs()));
        let of_direction = self.exponent.min(126 - exponent(longest));
        let t_exponent = self.exponent - of_direction;
        let scaled = |x: f32, exponent: i32| {
            let scaled = (f64::from(x) * 2f64.powi(exponent)) as f32;
            scaled.clamp(f32::MIN, f32::MAX)
        };
        let ray = Ray {
            // An origin that overflows is too far away to hit anything.
            origin: ray.origin.map(|x| scaled(x, self.exponent)),
            direction: ray.direction.map(|x| scaled(x, of_direction)),
            t_min: scaled(ray.t_min, t_exponent),
            t_max: scaled(ray.t_max, t_exponent),
        };
        let direction = ray.direction.map(f64::from);
        let length = length(direction);
        Some(Line {
            ray,
            origin: ray.origin.map(f64::from),
            unit: direction.map(|x| x / length),
            length,
            t_exponent,
        })
    }

    /// Whether all triangles form closed surfaces that certainly wind around a point, given in the mesh's unit.
    #[must_use]
    pub fn is_around(&self, point: [f32; 3]) -> bool {
        let point = point.map(|x| f64::from(x) * 2f64.powi(self.exponent));
        let triangles = self.scene.triangles().iter().copied();
        let turns = SolidAngle::of(triangles, point).winding_number();
        self.surface.is_closed() && turns.is_some_and(|turns| turns != 0)
    }

    /// The corners of a triangle.
    #[must_use]
    pub fn corners(&self, primitive: u32) -> [Point; 3] {
        self.scene.triangle(primitive).map(|p| p.map(f64::from))
    }

    /// The bound on distances from a triangle, and the distance along the ray that it corresponds to.
    #[must_use]
    pub fn slack(&self, line: &Line, primitive: u32, ulps: f64) -> [f64; 2] {
        let corners = self.corners(primitive);
        let bound = bound(ulps, line.origin, &corners, self.size);
        [bound, bound / steepness(line.unit, &corners)]
    }

    /// Whether a ray must hit here, by the bound: its origin is near enough, the hit is well within its range, and the
    /// surface continues around the hit.
    #[must_use]
    pub fn must_be_met(&self, line: &Line, crossing: &Crossing, ulps: f64) -> bool {
        let corners = self.corners(crossing.primitive);
        let [reach, along] = self.slack(line, crossing.primitive, ulps);
        let is_near = line.origin.iter().all(|x| x.abs() <= FARTHEST * self.size);
        let margin = along / line.length;
        let is_within = crossing.t - margin > line.ray.t_min.into()
            && crossing.t + margin < f64::from(line.ray.t_max);
        if !is_near || !is_within {
            return false;
        }
        let middle = line.at(crossing.t);
        let half = 4.0 * largest(line.origin, &corners);
        let part = [-half, half].map(|way| plus(middle, line.unit, way));
        let (surface, ray) = (&self.surface, &line.ray);
        surface.goes_on(&self.scene, (ray, part), crossing.primitive, reach)
    }
}

impl Line {
    /// The point at t.
    #[must_use]
    pub fn at(&self, t: f64) -> Point {
        plus(self.origin, self.unit, t * self.length)
    }

    /// The part of the ray's range in which a triangle may lie, with the range extended by `margin` at both ends.
    #[must_use]
    pub fn beside(&self, corners: &[Point; 3], margin: f64) -> [Point; 2] {
        let ways = corners.map(|corner| dot(minus(corner, self.origin), self.unit));
        let sizes = corners.map(|corner| length(minus(corner, corners[0])));
        let size = sizes.into_iter().fold(0.0, f64::max);
        let low = ways.into_iter().fold(f64::INFINITY, f64::min) - size;
        let high = ways.into_iter().fold(f64::NEG_INFINITY, f64::max) + size;
        let ends = [self.ray.t_min, self.ray.t_max].map(|t| f64::from(t) * self.length);
        let [first, last] = [ends[0] - margin, ends[1] + margin];
        [low, high].map(|way| plus(self.origin, self.unit, way.clamp(first, last)))
    }
}
