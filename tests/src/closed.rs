//! Closed solids, and points inside them.

use crate::random::Random;
use glam::Vec3;
use slimbvh::Mesh;
use slimbvh::generate::{TorusKnot, icosphere, torus_knot};

/// A sphere around the origin whose vertices lie at random distances from `1 - depth` to 1, as in pbrt's tests. The whole
/// surface is visible from the origin.
#[must_use]
pub fn dented_sphere(subdivisions: u32, depth: f32, seed: u64) -> Mesh {
    let mut random = Random::new(seed);
    let mut mesh = icosphere(Vec3::ZERO, 1.0, subdivisions);
    for vertex in &mut mesh.vertices {
        let radius = 1.0 - depth * random.unit();
        *vertex = vertex.map(|x| x * radius);
    }
    mesh.normals.clear();
    mesh
}

/// A trefoil of 192 triangles.
#[must_use]
pub fn small_torus_knot() -> Mesh {
    torus_knot(&TorusKnot {
        p: 2,
        q: 3,
        segments: 24,
        sides: 4,
        major_radius: 1.0,
        minor_radius: 0.4,
        tube_radius: 0.15,
    })
}

/// A closed tube along x of this length and radius; each side is a single strip of long triangles.
#[must_use]
pub fn long_prism(length: f32, radius: f32, sides: u32) -> Mesh {
    let mut vertices = Vec::new();
    for side in 0..sides {
        let (sin, cos) = (std::f32::consts::TAU * side as f32 / sides as f32).sin_cos();
        for x in [0.0, length] {
            vertices.push([x, radius * cos, radius * sin]);
        }
    }
    let mut indices = Vec::new();
    for side in 0..sides {
        let (a, b) = (2 * side, 2 * ((side + 1) % sides));
        indices.extend([[a, b, a + 1], [b, b + 1, a + 1]]);
        if side > 0 && side + 1 < sides {
            indices.extend([[0, b, a], [1, a + 1, b + 1]]);
        }
    }
    Mesh {
        vertices,
        indices,
        ..Mesh::default()
    }
}

/// Scales, then moves a mesh; shared vertices stay shared.
#[must_use]
pub fn placed(mut mesh: Mesh, scale: f32, translation: Vec3) -> Mesh {
    for vertex in &mut mesh.vertices {
        *vertex = (Vec3::from(*vertex) * scale + translation).to_array();
    }
    mesh
}

/// The winding number of a mesh's closed surfaces around a point, by solid angles (van Oosterom and Strackee 1983); 0 is
/// outside.
#[must_use]
pub fn winding_number(mesh: &Mesh, point: [f32; 3]) -> f64 {
    let point = point.map(f64::from);
    let mut solid_angle = 0.0;
    for triangle in &mesh.indices {
        let [a, b, c] = triangle.map(|v| {
            let p = mesh.vertices[v as usize].map(f64::from);
            glam::DVec3::new(p[0] - point[0], p[1] - point[1], p[2] - point[2])
        });
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let numerator = a.dot(b.cross(c));
        let denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        solid_angle += 2.0 * numerator.atan2(denominator);
    }
    solid_angle / (4.0 * std::f64::consts::PI)
}

/// Points inside: a little below the middles of random faces, if the winding number there is not 0.
#[must_use]
pub fn points_inside(mesh: &Mesh, depth: f32, count: usize, seed: u64) -> Vec<Vec3> {
    let mut random = Random::new(seed);
    let mut points = Vec::new();
    for _ in 0..20 * count {
        let face = mesh.indices[random.below(mesh.indices.len())];
        let [a, b, c] = face.map(|v| Vec3::from(mesh.vertices[v as usize]));
        let inward = -(b - a).cross(c - a).normalize_or_zero();
        let point = (a + b + c) / 3.0 + depth * inward;
        if winding_number(mesh, point.to_array()).abs() > 0.9 {
            points.push(point);
        }
        if points.len() == count {
            break;
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::analysis::analyze;

    #[test]
    fn solids_are_closed_and_face_out() {
        for mesh in [
            dented_sphere(3, 0.4, 1),
            small_torus_knot(),
            long_prism(10.0, 1.0, 7),
        ] {
            let analysis = analyze(&mesh);
            assert_eq!(analysis.components.len(), 1);
            assert!(analysis.components[0].closed);
            assert_eq!(analysis.components[0].outward, Some(true));
        }
    }

    #[test]
    fn winding_tells_inside_from_outside() {
        let sphere = dented_sphere(2, 0.4, 2);
        assert!((winding_number(&sphere, [0.1, 0.0, 0.2]) - 1.0).abs() < 1e-9);
        assert!(winding_number(&sphere, [1.1, 0.0, 0.2]).abs() < 1e-9);
        assert_eq!(points_inside(&sphere, 0.05, 10, 3).len(), 10);
    }
}
