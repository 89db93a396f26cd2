//! How far from the exact answer a tracer's may be.

use crate::oracle::distance::{Point, length, normal};
use crate::wide::dot;

/// What slimbvh promises: where a ray passes farther than this from every silhouette and border, it meets what the exact ray
/// meets, and what it reports is no farther away than this. In ulps of the largest coordinate of the ray's origin and the
/// triangle's corners (2^-23 of that coordinate).
///
/// With u = 2^-24 and M that coordinate, core's arithmetic (`slimbvh_core::watertight`) moves, seen along the ray,
/// - a corner by at most `√2 · γ(3) · 4M` < 17 uM: a difference of up to 2M, a product and a difference on each of two
///   axes, where the ray's own slope on an axis is at most 1 (tiny components of the direction, left out below 2^-60, add
///   nothing that counts);
/// - an edge by at most 8 u of its length < 28 uM: two products are compared, each rounded by u;
/// - the point of the hit by the rounding of t and of the box's planes, < 6 uM.
///
/// That is 51 uM, or 26 ulps.
pub const BOUND_ULPS: f64 = 26.0;

/// What is smaller than this share of the scene may vanish: the second promise on magnitudes.
pub const LEAST_SHARE: f64 = 1.0 / (1_u64 << 40) as f64;

/// An ulp of a coordinate, as [`BOUND_ULPS`] counts them.
pub const ULP: f64 = 1.0 / (1_u64 << 23) as f64;

/// The bound for a ray from here and a triangle, in a scene whose largest coordinate is `scene`.
#[must_use]
pub fn bound(ulps: f64, origin: Point, corners: &[Point; 3], scene: f64) -> f64 {
    (ulps * ULP * largest(origin, corners)).max(LEAST_SHARE * scene)
}

/// The largest coordinate of an origin and a triangle.
#[must_use]
pub fn largest(origin: Point, corners: &[Point; 3]) -> f64 {
    let coordinates = corners.as_flattened().iter().chain(&origin);
    coordinates.fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

/// The cosine between a unit direction and a triangle's normal; 0 for a triangle without one.
#[must_use]
pub fn steepness(unit: Point, corners: &[Point; 3]) -> f64 {
    let normal = normal(*corners);
    let size = length(normal);
    if size > 0.0 {
        dot(normal, unit).abs() / size
    } else {
        0.0
    }
}
