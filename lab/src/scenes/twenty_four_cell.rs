//! The 24-cell.

use glam::{Vec3, Vec4};
use slimbvh::generate::concatenate;
use slimbvh::generate::icosphere;
use slimbvh::internals::{Vertex, close_rings};
use slimbvh::{Camera, Light, Material, Mesh, Scene};
use std::f32::consts::TAU;

/// How finely [`twenty_four_cell`] is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TwentyFourCell {
    /// Rings along each edge, at least 2.
    pub rings: u32,
    /// Corners of each ring, at least 3.
    pub sides: u32,
    /// Of the ball at each corner, an [`icosphere`].
    pub subdivisions: u32,
}

impl Default for TwentyFourCell {
    /// 122 880 triangles; the model of Wong, Cheng and Lii ("Reduced BVHs for GPU Ray Tracing", 2012) has 122 882.
    fn default() -> Self {
        Self {
            rings: 30,
            sides: 16,
            subdivisions: 3,
        }
    }
}

/// On the unit sphere of four dimensions: of an edge, of a corner's ball, and how far edges stay away from corners, inside
/// the balls there.
const EDGE_RADIUS: f32 = 0.05;
const CORNER_RADIUS: f32 = 0.125;
const GAP: f32 = 0.06;

/// The regular solid of four dimensions with 24 corners and 96 edges, as a scene with a camera and a light: on the unit
/// sphere, seen from the middle of one of its cells by stereographic projection. So edges are arcs of circles, and thicker
/// and longer farther out; the whole is 5.9 wide, high and deep. Each edge and each corner is a solid of its own,
/// `96 * 2 * rings * sides + 24 * 20 * 4^subdivisions` triangles together. About half of them face any eye outside.
#[must_use]
pub fn twenty_four_cell(measures: &TwentyFourCell) -> Scene {
    let corners = corners();
    let mut mesh = Mesh::default();
    for (i, &a) in corners.iter().enumerate() {
        for &b in &corners[i + 1..] {
            // Neighbours are a sixth of a circle apart, others a quarter or more.
            if a.dot(b) > 0.4 {
                concatenate(&mut mesh, &edge(a, b, measures));
            }
        }
    }
    mesh.materials = vec![0; mesh.indices.len()];
    for corner in corners {
        let (center, scale) = project(corner);
        let ball = icosphere(center, CORNER_RADIUS * scale, measures.subdivisions);
        mesh.materials
            .resize(mesh.indices.len() + ball.indices.len(), 1);
        concatenate(&mut mesh, &ball);
    }
    let mut scene = Scene {
        mesh,
        materials: vec![
            Material {
                base_color: [0.10, 0.32, 0.40],
                mirror: 0.1,
                ..Material::default()
            },
            Material {
                base_color: [0.72, 0.45, 0.14],
                mirror: 0.15,
                ..Material::default()
            },
        ],
        cameras: vec![Camera {
            eye: [3.4, 3.2, 9.6],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            projection: slimbvh::Projection::Perspective { vertical_fov: 38.0 },
        }],
        ..Scene::default()
    };
    scene.lights.push(Light::beside(&scene.cameras[0]));
    scene
}

/// All points with two coordinates of equal size and two zeros.
fn corners() -> Vec<Vec4> {
    let mut corners = Vec::with_capacity(24);
    let size = 0.5_f32.sqrt();
    for first in 0..4 {
        for second in first + 1..4 {
            for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
                let mut corner = Vec4::ZERO;
                corner[first] = size * signs[0];
                corner[second] = size * signs[1];
                corners.push(corner);
            }
        }
    }
    corners
}

/// The projection from (0, 0, 0, 1), and how much it enlarges there.
fn project(point: Vec4) -> (Vec3, f32) {
    let scale = 1.0 / (1.0 - point.w);
    (scale * point.truncate(), scale)
}

/// A closed tube from one corner to another, without its ends.
fn edge(a: Vec4, b: Vec4, measures: &TwentyFourCell) -> Mesh {
    let (rings, sides) = (measures.rings.max(2), measures.sides.max(3));
    let angle = a.dot(b).clamp(-1.0, 1.0).acos();
    // The circle on the sphere: at an angle from a, and which way it goes there.
    let toward = (b - a * a.dot(b)).normalize();
    let at = |angle: f32| {
        let (sin, cos) = angle.sin_cos();
        (cos * a + sin * toward, cos * toward - sin * a)
    };
    let [start, middle, end] = [0.0, 0.5, 1.0].map(|share| project(at(share * angle).0).0);
    // The projected arc lies in a plane.
    let plane = (end - start).cross(middle - start).normalize();
    let ring = |ring: u32| -> (Vec3, Vec3, Vec<Vertex>) {
        let share = ring as f32 / (rings - 1) as f32;
        let (point, motion) = at(GAP + share * (angle - 2.0 * GAP));
        let (center, scale) = project(point);
        let velocity = scale * motion.truncate() + scale * motion.w * center;
        let speed = velocity.length();
        let tangent = velocity / speed;
        let radius = EDGE_RADIUS * scale;
        // The tube widens by this much along the way.
        let slope = EDGE_RADIUS * scale * scale * motion.w / speed;
        let inward = plane.cross(tangent).normalize();
        let vertex = |side: u32| {
            let (sin, cos) = (TAU * side as f32 / sides as f32).sin_cos();
            let out = cos * plane - sin * inward;
            (center + radius * out, (out - slope * tangent).normalize())
        };
        (center, tangent, (0..sides).map(vertex).collect())
    };
    let rings: Vec<_> = (0..rings).map(ring).collect();
    let (first, last) = (&rings[0], &rings[rings.len() - 1]);
    let ends = [(first.0, -first.1), (last.0, last.1)];
    let rings: Vec<_> = rings.into_iter().map(|(.., ring)| ring).collect();
    close_rings(ends[0], &rings, ends[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::internals::{assert_solid, assert_unit_normals};

    #[test]
    fn every_edge_and_corner_is_solid() {
        let measures = TwentyFourCell {
            rings: 5,
            sides: 6,
            subdivisions: 1,
        };
        let mesh = twenty_four_cell(&measures).mesh;
        assert_unit_normals(&mesh);
        let components = assert_solid(&mesh);
        assert_eq!(components.len(), 96 + 24);
        assert_eq!(mesh.indices.len(), 96 * 2 * 5 * 6 + 24 * 80);
        let bounds = mesh.bounds().unwrap();
        assert!((5.8..6.0).contains(&(bounds.max.x - bounds.min.x)));
    }

    #[test]
    fn eight_edges_meet_at_each_corner() {
        let corners = corners();
        assert_eq!(corners.len(), 24);
        for a in &corners {
            let near = corners.iter().filter(|b| (a.dot(**b) - 0.5).abs() < 1e-6);
            assert_eq!(near.count(), 8);
        }
    }

    #[test]
    fn normals_agree_with_the_winding() {
        let mesh = twenty_four_cell(&TwentyFourCell::default()).mesh;
        assert_eq!(mesh.indices.len(), 122_880);
        assert_eq!(mesh.validate(), Ok(()));
        for triangle in &mesh.indices {
            let [a, b, c] = triangle.map(|v| Vec3::from(mesh.vertices[v as usize]));
            let normal: Vec3 = triangle
                .map(|v| Vec3::from(mesh.normals[v as usize]))
                .iter()
                .sum();
            assert!((b - a).cross(c - a).dot(normal) > 0.0);
        }
    }
}
