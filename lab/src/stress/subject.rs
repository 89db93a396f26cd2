//! A scene as its judge sees it: in doubles that lose nothing, and with its surfaces known.

use super::bound::{bound, largest, steepness};
use super::surface::Surface;
use crate::oracle::distance::{Point, length, minus, plus};
use crate::oracle::{Crossing, Unculled};
use slimbvh::internals::{SolidAngle, dot};
use slimbvh_core::Ray;
use slimbvh_core::float::exponent;

/// The triangles that a tracer has, multiplied by a power of two.
#[derive(Clone, Debug)]
pub struct Subject {
    /// What rays meet exactly.
    pub scene: Unculled,
    surface: Surface,
    /// The largest coordinate.
    pub size: f64,
    /// All coordinates are the mesh's times two to this power, so that the tracer's own are numbers of `f32`.
    pub exponent: i32,
}

/// A ray among the triangles.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// In the magnitude of the triangles.
    pub ray: Ray,
    /// Where t is 0.
    pub origin: Point,
    /// Of length 1.
    pub unit: Point,
    /// Length of the direction.
    pub length: f64,
    /// Its t is the caller's times two to this power.
    pub t_exponent: i32,
}

/// Origins farther away than this many times the scene's size see nothing: the third promise on magnitudes.
const FARTHEST: f64 = slimbvh_core::ray::FARTHEST_ORIGIN as f64;

impl Subject {
    /// Triangles whose coordinates were multiplied by two to a power.
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

    /// Carries a ray to the magnitude of the triangles. `None` for one that must hit nothing, as it is no ray.
    #[must_use]
    pub fn line(&self, ray: &Ray) -> Option<Line> {
        let numbers = ray.origin.iter().chain(&ray.direction);
        let is_sane = numbers.chain([&ray.t_min]).all(|x| x.is_finite())
            && ray.direction != [0.0; 3]
            && ray.t_min <= ray.t_max;
        if !is_sane {
            return None;
        }
        // Origin and direction alike, so that t stays as it is, as far as the direction stays finite.
        let longest = ray.direction.iter().fold(0.0, |a: f32, x| a.max(x.abs()));
        let of_direction = self.exponent.min(126 - exponent(longest));
        let t_exponent = self.exponent - of_direction;
        let scaled = |x: f32, exponent: i32| {
            let scaled = (f64::from(x) * 2f64.powi(exponent)) as f32;
            scaled.clamp(f32::MIN, f32::MAX)
        };
        let ray = Ray {
            // Beyond all numbers is beyond what sees anything, too.
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

    /// Whether the triangles are closed surfaces, all of them, that certainly wind around a point in the mesh's unit.
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

    /// The bound on distances from a triangle, and how far along the ray it leads off the triangle's plane.
    #[must_use]
    pub fn slack(&self, line: &Line, primitive: u32, ulps: f64) -> [f64; 2] {
        let corners = self.corners(primitive);
        let bound = bound(ulps, line.origin, &corners, self.size);
        [bound, bound / steepness(line.unit, &corners)]
    }

    /// Whether a ray must be told to meet this, by the bound: it starts near enough, the place lies well within its range, and
    /// the surface goes on around it.
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

    /// The part of the ray's range, longer by this at both ends, in which a triangle may lie.
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
