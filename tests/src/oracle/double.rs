//! The triangle test in `f64`, with its condition.

use glam::DVec3;
use slimbvh_core::{LeafTriangle, Ray};

/// The intersection of a ray's line with a triangle's plane.
#[derive(Clone, Copy, Debug)]
pub struct PlaneHit {
    /// In units of the direction.
    pub t: f64,
    /// The change of t by a relative error of one unit in each product of the test, in the same units. It grows as the triangle
    /// is seen more edge-on.
    pub sensitivity: f64,
    /// The smallest weight of a corner; negative outside.
    pub inside: f64,
}

/// Intersects the line with the plane; `None` if they are parallel.
#[must_use]
pub fn meet(ray: &Ray, triangle: &LeafTriangle, scene_exponent: i32) -> Option<PlaneHit> {
    let unit = 2f64.powi(-scene_exponent);
    let origin = DVec3::from(ray.origin.map(f64::from));
    let d = DVec3::from(ray.direction.map(f64::from));
    let [a, b, c] = [0, 3, 6].map(|i| {
        let v = &triangle.vertices;
        DVec3::new(v[i].into(), v[i + 1].into(), v[i + 2].into()) * unit - origin
    });

    // Shear along the longest axis, as the test does.
    let axis = d.abs().max_position();
    let across = [(axis + 1) % 3, (axis + 2) % 3];
    let shear = |p: DVec3| across.map(|k| p[k] - p[axis] * (d[k] / d[axis]));
    let spread = |p: DVec3| across.map(|k| p[k].abs() + (p[axis] * (d[k] / d[axis])).abs());
    let pairs = [(c, b), (a, c), (b, a)];
    let mut areas = [0.0; 3];
    let mut error = 0.0;
    for (area, (p, q)) in areas.iter_mut().zip(pairs) {
        let ([px, py], [qx, qy]) = (shear(p), shear(q));
        *area = px * qy - py * qx;
        let ([ax, ay], [bx, by]) = (spread(p), spread(q));
        error += ax * by + ay * bx;
    }
    let area: f64 = areas.iter().sum();
    if area == 0.0 {
        return None;
    }
    let n = (b - a).cross(c - a);
    let t = n.dot(a) / n.dot(d);
    let reach = [a, b, c].map(|p| (p[axis] / d[axis] - t).abs());
    let depth = reach.into_iter().fold(0.0, f64::max);
    Some(PlaneHit {
        t,
        sensitivity: t.abs() + depth * error / area.abs(),
        inside: areas.iter().map(|e| e / area).fold(f64::MAX, f64::min),
    })
}
