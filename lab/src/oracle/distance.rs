//! Distances between points, segments and triangles of `f32` magnitude.

use slimbvh::internals::{cross, dot};

/// A point in space.
pub type Point = [f64; 3];

/// `a + b · factor`.
#[must_use]
pub fn plus(a: Point, b: Point, factor: f64) -> Point {
    [0, 1, 2].map(|axis| a[axis] + b[axis] * factor)
}

/// `a - b`.
#[must_use]
pub fn minus(a: Point, b: Point) -> Point {
    plus(a, b, -1.0)
}

/// The length of a vector.
#[must_use]
pub fn length(v: Point) -> f64 {
    dot(v, v).sqrt()
}

/// The least distance between two segments (after Ericson 2005, "Real-Time Collision Detection", section 5.1.9).
#[must_use]
pub fn between([p, p_end]: [Point; 2], [q, q_end]: [Point; 2]) -> f64 {
    let (u, v, w) = (minus(p_end, p), minus(q_end, q), minus(p, q));
    let (uu, vv, uv) = (dot(u, u), dot(v, v), dot(u, v));
    let (uw, vw) = (dot(u, w), dot(v, w));
    let share = |over: f64, under: f64| {
        if under > 0.0 {
            (over / under).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    // Find the point of the first segment nearest to the line of the second, then clamp along each segment in turn.
    let s = share(uv * vw - uw * vv, uu * vv - uv * uv);
    let t = share(uv * s + vw, vv);
    let s = share(uv * t - uw, uu);
    let t = share(uv * s + vw, vv);
    length(minus(plus(p, u, s), plus(q, v, t)))
}

/// The least distance between a point and a triangle.
#[must_use]
pub fn to_triangle(point: Point, corners: [Point; 3]) -> f64 {
    let border = sides(corners).map(|side| between([point; 2], side));
    let border = border.into_iter().fold(f64::INFINITY, f64::min);
    let normal = normal(corners);
    let is_above =
        |[from, to]: &[Point; 2]| dot(normal, cross(minus(*to, *from), minus(point, *from))) >= 0.0;
    let size = length(normal);
    if size > 0.0 && sides(corners).iter().all(is_above) {
        border.min(dot(normal, minus(point, corners[0])).abs() / size)
    } else {
        border
    }
}

/// The least distance between a segment and a triangle.
#[must_use]
pub fn segment_to_triangle(segment: [Point; 2], corners: [Point; 3]) -> f64 {
    if passes(segment, corners) {
        return 0.0;
    }
    let ends = segment.map(|end| to_triangle(end, corners));
    let border = sides(corners).map(|side| between(segment, side));
    border.into_iter().chain(ends).fold(f64::INFINITY, f64::min)
}

/// Whether a segment passes from one side of a triangle to the other, within it.
fn passes([from, to]: [Point; 2], corners: [Point; 3]) -> bool {
    let normal = normal(corners);
    let heights = [from, to].map(|end| dot(normal, minus(end, corners[0])));
    let along = minus(to, from);
    let turns = sides(corners).map(|[a, b]| dot(along, cross(minus(a, from), minus(b, from))));
    let is_one_sign = turns.iter().all(|&turn| turn > 0.0) || turns.iter().all(|&turn| turn < 0.0);
    heights[0].signum() != heights[1].signum() && is_one_sign
}

/// The three sides of a triangle.
#[must_use]
pub fn sides([a, b, c]: [Point; 3]) -> [[Point; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The normal of a triangle, whose length is twice the area.
#[must_use]
pub fn normal([a, b, c]: [Point; 3]) -> Point {
    cross(minus(b, a), minus(c, a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_distances() {
        let along_x = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
        assert_eq!(between(along_x, [[1.0, -2.0, 3.0], [1.0, 5.0, 3.0]]), 3.0);
        assert_eq!(between(along_x, [[7.0, 4.0, 0.0], [9.0, 4.0, 0.0]]), 5.0);
        assert_eq!(between(along_x, [[1.0, 2.0, 0.0], [9.0, 2.0, 0.0]]), 2.0);
        assert_eq!(between([[1.0, 0.0, 5.0]; 2], along_x), 5.0);
        let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
        assert_eq!(to_triangle([1.0, 1.0, 2.0], triangle), 2.0);
        assert_eq!(to_triangle([1.0, 1.0, -2.0], triangle), 2.0);
        assert_eq!(to_triangle([7.0, 0.0, 4.0], triangle), 5.0);
        let segments = [
            ([[1.0, 1.0, 5.0], [1.0, 1.0, -1.0]], 0.0),
            ([[1.0, 1.0, 5.0], [1.0, 1.0, 2.0]], 2.0),
            ([[6.0, -5.0, 1.5], [6.0, 5.0, 1.5]], 2.5),
        ];
        for (segment, distance) in segments {
            assert_eq!(segment_to_triangle(segment, triangle), distance);
        }
    }
}
