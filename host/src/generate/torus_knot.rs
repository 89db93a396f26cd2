//! Tubes around knots.

use crate::Mesh;
use glam::Vec3;
use std::f64::consts::TAU;

/// The measures of [`torus_knot`]. The knot winds on a torus that lies around the y axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorusKnot {
    /// Turns around the y axis; shares no divisor with `q`.
    pub p: u32,
    /// Turns around the torus' tube.
    pub q: u32,
    /// Rings along the knot, at least 3.
    pub segments: u32,
    /// Corners of each ring, at least 3.
    pub sides: u32,
    /// From the middle to the middle of the torus' tube.
    pub major_radius: f32,
    /// Of the torus' tube, below `major_radius`.
    pub minor_radius: f32,
    /// Of the tube around the knot.
    pub tube_radius: f32,
}

impl Default for TorusKnot {
    /// A trefoil of 32 768 triangles.
    fn default() -> Self {
        Self {
            p: 2,
            q: 3,
            segments: 512,
            sides: 32,
            major_radius: 1.0,
            minor_radius: 0.45,
            tube_radius: 0.22,
        }
    }
}

/// A tube around a (p, q) torus knot, of `2 * segments * sides` triangles with smooth normals.
#[must_use]
pub fn torus_knot(knot: &TorusKnot) -> Mesh {
    let (segments, sides) = (knot.segments.max(3), knot.sides.max(3));
    let mut mesh = Mesh::default();
    for segment in 0..segments {
        let frame = CurveAxes::at(knot, f64::from(segment) / f64::from(segments));
        for side in 0..sides {
            let (sin, cos) = turn(f64::from(side) / f64::from(sides));
            let normal = (cos * frame.normal + sin * frame.binormal).normalize();
            let position = frame.point + knot.tube_radius * normal;
            mesh.vertices.push(position.to_array());
            mesh.normals.push(normal.to_array());
        }
    }

    // Join each ring to the next one, and the last to the first.
    let vertex = |segment: u32, side: u32| segment % segments * sides + side % sides;
    for segment in 0..segments {
        for side in 0..sides {
            let (a, b) = (vertex(segment, side), vertex(segment, side + 1));
            let (c, d) = (vertex(segment + 1, side), vertex(segment + 1, side + 1));
            mesh.indices.extend([[a, b, c], [c, b, d]]);
        }
    }
    mesh
}

/// A point of the knot, with two axes across it. `normal` is the torus' own, which comes around without a twist left.
struct CurveAxes {
    point: Vec3,
    normal: Vec3,
    binormal: Vec3,
}

impl CurveAxes {
    /// At a place from 0 to 1 along the knot.
    fn at(knot: &TorusKnot, place: f64) -> Self {
        let (sin_p, cos_p) = turn(f64::from(knot.p) * place);
        let (sin_q, cos_q) = turn(f64::from(knot.q) * place);

        // Directions at this place: out from the y axis, around it, out of the torus, around its tube.
        let out = Vec3::new(cos_p, 0.0, -sin_p);
        let around = Vec3::new(-sin_p, 0.0, -cos_p);
        let normal = cos_q * out + sin_q * Vec3::Y;
        let tube = -sin_q * out + cos_q * Vec3::Y;

        let radius = knot.major_radius + knot.minor_radius * cos_q;
        let (speed_around, speed_tube) =
            (knot.p as f32 * radius, knot.q as f32 * knot.minor_radius);
        let tangent = (speed_around * around + speed_tube * tube).normalize();
        Self {
            point: knot.major_radius * out + knot.minor_radius * normal,
            normal,
            binormal: tangent.cross(normal),
        }
    }
}

/// Sine and cosine of an angle in full turns.
fn turn(turns: f64) -> (f32, f32) {
    let (sin, cos) = (TAU * turns).sin_cos();
    (sin as f32, cos as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::{assert_solid, assert_unit_normals};

    #[test]
    fn a_plain_torus_has_the_volume_of_pappus() {
        let mesh = torus_knot(&TorusKnot {
            p: 1,
            q: 0,
            segments: 200,
            sides: 100,
            major_radius: 3.0,
            minor_radius: 0.0,
            tube_radius: 0.5,
        });
        let component = &assert_solid(&mesh)[0];
        let volume = TAU * 3.0 * 0.5 * TAU * 0.25;
        assert!((component.signed_volume / volume - 1.0).abs() < 0.002);
    }

    #[test]
    fn knots_are_solid() {
        for (p, q, segments, sides) in [(2, 3, 90, 7), (3, 2, 64, 5), (5, 7, 300, 8)] {
            let mesh = torus_knot(&TorusKnot {
                p,
                q,
                segments,
                sides,
                ..TorusKnot::default()
            });
            assert_unit_normals(&mesh);
            assert_eq!(assert_solid(&mesh).len(), 1);
            assert_eq!(mesh.indices.len() as u32, 2 * segments * sides);
            assert_eq!(mesh.vertices.len() as u32, segments * sides);
        }
    }

    #[test]
    fn normals_agree_with_the_winding() {
        let mesh = torus_knot(&TorusKnot::default());
        for triangle in &mesh.indices {
            let [a, b, c] = triangle.map(|v| Vec3::from(mesh.vertices[v as usize]));
            let normal = Vec3::from(mesh.normals[triangle[0] as usize]);
            assert!((b - a).cross(c - a).dot(normal) > 0.0);
        }
    }
}
