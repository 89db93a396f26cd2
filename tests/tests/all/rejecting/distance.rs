//! Distances in space.

use glam::DVec3;

/// The least distance between two segments (after Ericson 2005, "Real-Time Collision Detection", section 5.1.9).
pub fn between([p, p_end]: [DVec3; 2], [q, q_end]: [DVec3; 2]) -> f64 {
    let (u, v, w) = (p_end - p, q_end - q, p - q);
    let (uu, vv, uv) = (u.dot(u), v.dot(v), u.dot(v));
    let (uw, vw) = (u.dot(w), v.dot(w));
    let share = |over: f64, under: f64| {
        if under > 0.0 {
            (over / under).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    // Along the first as if the second were a line; then along each as far as the other allows.
    let s = share(uv * vw - uw * vv, uu * vv - uv * uv);
    let t = share(uv * s + vw, vv);
    let s = share(uv * t - uw, uu);
    let t = share(uv * s + vw, vv);
    ((p + u * s) - (q + v * t)).length()
}

/// The least distance between a point and a triangle.
pub fn to_triangle(point: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let sides = [[a, b], [b, c], [c, a]];
    let border = sides.map(|side| between([point; 2], side));
    let border = border.into_iter().fold(f64::INFINITY, f64::min);
    let normal = (b - a).cross(c - a);
    let is_above = |[from, to]: &[DVec3; 2]| normal.dot((to - from).cross(point - from)) >= 0.0;
    if normal != DVec3::ZERO && sides.iter().all(is_above) {
        border.min(normal.normalize().dot(point - a).abs())
    } else {
        border
    }
}

#[test]
fn known_distances() {
    let p = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let along_x = [p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)];
    assert_eq!(between(along_x, [p(1.0, -2.0, 3.0), p(1.0, 5.0, 3.0)]), 3.0);
    assert_eq!(between(along_x, [p(7.0, 4.0, 0.0), p(9.0, 4.0, 0.0)]), 5.0);
    assert_eq!(between(along_x, [p(1.0, 2.0, 0.0), p(9.0, 2.0, 0.0)]), 2.0);
    assert_eq!(between([p(1.0, 0.0, 5.0); 2], along_x), 5.0);
    let triangle = [p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0), p(0.0, 3.0, 0.0)];
    assert_eq!(to_triangle(p(1.0, 1.0, 2.0), triangle), 2.0);
    assert_eq!(to_triangle(p(1.0, 1.0, -2.0), triangle), 2.0);
    assert_eq!(to_triangle(p(7.0, 0.0, 4.0), triangle), 5.0);
}
