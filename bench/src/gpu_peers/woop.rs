//! Triangles as rows of the transformation that makes them the unit triangle: Woop, Schmittler and Slusallek 2005, "RPU: A
//! Programmable Ray Processing Unit for Realtime Ray Tracing", section 4.2.

use glam::{DVec3, Vec4};
use obvhs::triangle::Triangle;

/// Three rows, 48 bytes. A point p has the coordinates `row.xyz · p + row.w`: its height w over the triangle's plane in units of
/// the normal v0v1 × v0v2, then its weights u of v1 and v of v2. A triangle without an area gets rows that no ray meets.
#[must_use]
pub fn rows(triangle: &Triangle) -> [Vec4; 3] {
    let [v0, v1, v2] = [triangle.v0, triangle.v1, triangle.v2].map(|v| v.to_array().map(f64::from));
    let [v0, v1, v2] = [v0, v1, v2].map(DVec3::from_array);
    let (e1, e2) = (v1 - v0, v2 - v0);
    let n = e1.cross(e2);
    let area = n.length_squared();
    let row = |axis: DVec3| {
        let axis = axis / area;
        axis.extend(-axis.dot(v0)).as_vec4()
    };
    let rows = [n, e2.cross(n), n.cross(e1)].map(row);
    if rows.iter().all(|row| row.is_finite()) {
        rows
    } else {
        // t is −1/0 or not a number.
        [Vec4::new(0.0, 0.0, 0.0, 1.0), Vec4::ZERO, Vec4::ZERO]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3A;

    const TRIANGLE: Triangle = Triangle {
        v0: Vec3A::new(1.0, 2.0, 3.0),
        v1: Vec3A::new(3.0, 2.5, 3.0),
        v2: Vec3A::new(1.0, 5.0, 4.0),
    };

    fn coordinates(rows: [Vec4; 3], point: Vec3A) -> [f32; 3] {
        rows.map(|row| row.dot(point.extend(1.0)))
    }

    #[test]
    fn corners_are_those_of_the_unit_triangle() {
        let rows = rows(&TRIANGLE);
        let close = |point, expected: [f32; 3]| {
            let found = coordinates(rows, point);
            let pairs = found.iter().zip(expected);
            assert!(
                pairs.clone().all(|(a, b)| (a - b).abs() < 1e-6),
                "{found:?}, not {expected:?}"
            );
        };
        close(TRIANGLE.v0, [0.0, 0.0, 0.0]);
        close(TRIANGLE.v1, [0.0, 1.0, 0.0]);
        close(TRIANGLE.v2, [0.0, 0.0, 1.0]);
        let normal = (TRIANGLE.v1 - TRIANGLE.v0).cross(TRIANGLE.v2 - TRIANGLE.v0);
        close(TRIANGLE.v0 + 2.0 * normal, [2.0, 0.0, 0.0]);
    }

    #[test]
    fn a_triangle_without_an_area_has_finite_rows() {
        let flat = Triangle {
            v2: TRIANGLE.v0,
            ..TRIANGLE
        };
        assert!(rows(&flat).iter().all(|row| row.is_finite()));
    }
}
