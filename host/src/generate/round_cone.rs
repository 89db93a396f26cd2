//! Round cones, for limbs.

use super::rings::close_rings;
use crate::Mesh;
use glam::Vec3;
use std::f32::consts::{FRAC_PI_2, TAU};

/// The convex hull of two balls; a capsule if they have one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundCone {
    /// Middles of the balls, further apart than the difference of the radii.
    pub ends: [Vec3; 2],
    /// Radii of the balls.
    pub radii: [f32; 2],
    /// Corners of each ring, at least 3.
    pub sides: u32,
    /// Bands from pole to pole, at least 4, a quarter of them on each ball.
    pub bands: u32,
}

/// A round cone of `2 * sides * (bands - 1)` triangles with smooth normals.
#[must_use]
pub fn round_cone(cone: &RoundCone) -> Mesh {
    let (sides, bands) = (cone.sides.max(3), cone.bands.max(4));
    let [a, b] = cone.ends;
    let [radius_a, radius_b] = cone.radii;
    let axis = (b - a).normalize_or(Vec3::Y);
    let (across, along) = axis.any_orthonormal_pair();
    // The slope of the side; 0 for balls of one size.
    let slope = ((radius_a - radius_b) / a.distance(b))
        .clamp(-1.0, 1.0)
        .asin();

    // A ring's ball, and the latitude of its normals.
    let cap = bands / 4;
    let rings: Vec<(Vec3, f32, f32)> = (1..bands)
        .map(|ring| {
            let (on_a, on_b) = (ring.min(cap), ring.saturating_sub(bands - cap));
            let share = |n: u32, of: u32| n as f32 / of as f32;
            let body = share((ring - on_a).min(bands - 2 * cap), bands - 2 * cap);
            let latitude = if ring < cap {
                -FRAC_PI_2 + share(on_a, cap) * (slope + FRAC_PI_2)
            } else {
                slope + share(on_b, cap) * (FRAC_PI_2 - slope)
            };
            (
                a.lerp(b, body),
                radius_a + body * (radius_b - radius_a),
                latitude,
            )
        })
        .collect();
    let rings: Vec<_> = rings
        .into_iter()
        .map(|(center, radius, latitude)| {
            let (height, width) = latitude.sin_cos();
            let vertex = |side: u32| {
                let (sin, cos) = (TAU * side as f32 / sides as f32).sin_cos();
                let normal = height * axis + width * (cos * across + sin * along);
                (center + radius * normal, normal.normalize_or(axis))
            };
            (0..sides).map(vertex).collect()
        })
        .collect();
    close_rings(
        (a - radius_a * axis, -axis),
        &rings,
        (b + radius_b * axis, axis),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::{assert_solid, assert_unit_normals};
    use std::f64::consts::PI;

    #[test]
    fn solid_with_the_volume_of_a_capsule() {
        let mesh = round_cone(&RoundCone {
            ends: [Vec3::new(1.0, 2.0, 3.0), Vec3::new(3.0, 5.0, 9.0)],
            radii: [0.5, 0.5],
            sides: 96,
            bands: 48,
        });
        assert_unit_normals(&mesh);
        let component = &assert_solid(&mesh)[0];
        assert_eq!(component.triangle_count, 2 * 96 * 47);
        // 7 long.
        let volume = PI * 0.25 * 7.0 + PI * 0.125 * 4.0 / 3.0;
        assert!((component.signed_volume / volume - 1.0).abs() < 0.003);
    }

    #[test]
    fn every_vertex_is_on_the_hull_of_both_balls() {
        let cone = RoundCone {
            ends: [Vec3::ZERO, Vec3::new(0.0, 0.0, 2.0)],
            radii: [1.0, 0.25],
            sides: 12,
            bands: 16,
        };
        let mesh = round_cone(&cone);
        assert_unit_normals(&mesh);
        assert_eq!(assert_solid(&mesh).len(), 1);
        for (vertex, normal) in mesh.vertices.iter().zip(&mesh.normals) {
            let (v, n) = (Vec3::from(*vertex), Vec3::from(*normal));
            // The extent of both balls along the normal.
            let reach = (0..2).map(|i| cone.ends[i].dot(n) + cone.radii[i]);
            assert!((v.dot(n) - reach.fold(f32::MIN, f32::max)).abs() < 1e-5);
        }
    }
}
