//! Distances in space, from the oracle's functions.

use glam::DVec3;
use slimbvh_lab::oracle::distance;

/// The least distance between two segments.
pub fn between(a: [DVec3; 2], b: [DVec3; 2]) -> f64 {
    distance::between(a.map(|p| p.to_array()), b.map(|p| p.to_array()))
}

/// The least distance between a point and a triangle.
pub fn to_triangle(point: DVec3, corners: [DVec3; 3]) -> f64 {
    distance::to_triangle(point.to_array(), corners.map(|p| p.to_array()))
}
