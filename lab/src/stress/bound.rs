//! The bound on the errors of a tracer's answers.

use crate::oracle::distance::{Point, length, normal};
use slimbvh::internals::dot;

/// The promise of slimbvh: a ray that passes farther than this from every silhouette and border hits what the exact ray
/// hits, and the reported hit is off by no more than this. In ulps of the largest coordinate of the ray's origin and the
/// triangle's corners (2^-23 of that coordinate).
///
/// With u = 2^-24 and M that coordinate, the errors of core's arithmetic (`slimbvh_core::watertight`) are at most:
/// - across the ray, a corner by at most `√2 · γ(3) · 4M` < 17 uM, as a difference of up to 2M, a product and another
///   difference are rounded on each of two axes, on which the ray's slope is at most 1; and an edge by at most 8 u of its
///   length, < 28 uM, as two rounded products are compared. 45 uM in all.
/// - across the triangle's plane, the point on the longest side beside the ray by 9 uM (three roundings an axis), and the hit
///   from there by 32 uM where the corner's t is taken, whose test adds 33 uM by its own rounding; else by less. 74 uM in all.
///
/// Both are below 80 uM, or 40 ulps. Along the ray the error is larger by the slant of the ray to the plane
/// ([`super::steepness`]), but stays within the triangle's box.
pub const BOUND_ULPS: f64 = 40.0;

/// Features smaller than this share of the scene may vanish: the second promise on magnitudes.
pub const LEAST_SHARE: f64 = 1.0 / (1_u64 << 40) as f64;

/// An ulp of a coordinate, as [`BOUND_ULPS`] counts them.
pub const ULP: f64 = 1.0 / (1_u64 << 23) as f64;

/// The bound for a ray from `origin` and a triangle, in a scene whose largest coordinate is `scene`.
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
