//! Long thin walls seen from a corner of the room: rays graze edges that are much longer than the distance to them. A slab
//! test padded only relative to t loses such hits.

use super::{Aims, aims, escapes};
use crate::meshes::Solid;
use glam::{Quat, Vec3};
use slimbvh::CodeBits;
use slimbvh::generate::{cuboid, subdivide, transformed};
use slimbvh_core::Ray;
use slimbvh_tests::build;
use slimbvh_tests::random::Random;

/// Rooms of one shape: along each axis, plain and divided, axis-aligned and turned.
fn rooms(length: f32) -> Vec<Solid> {
    let mut random = Random::new(3);
    let mut rooms = Vec::new();
    for axis in 0..3 {
        let mut size = Vec3::new(1.0, 1.3, 0.7);
        size[axis] = length;
        let plain = cuboid(Vec3::ZERO, size);

        // Near every corner, as near as a millionth of the room's width.
        let mut inside = vec![0.5 * size];
        for corner in 0..8u32 {
            let near = 10f32.powf(random.between(-6.0, -1.0));
            let weight = |axis: u32| {
                if corner >> axis & 1 == 0 {
                    near
                } else {
                    1.0 - near
                }
            };
            let from = Vec3::new(weight(0), weight(1), weight(2));
            let mut eye = from * size;
            if length > 1.0 {
                let near = near.max(1e-6 * length);
                let is_low = corner >> axis & 1 == 0;
                eye[axis] = if is_low { near } else { length - near };
            }
            inside.push(eye);
        }
        for (kind, mesh) in [("plain", plain.clone()), ("divided", subdivide(&plain, 3))] {
            let name = format!("{kind} room, {length} along axis {axis}");
            rooms.push(Solid::new(&name, mesh.clone(), &inside));
            let rotation = Quat::from_axis_angle(random.direction(), 0.7);
            let turned = transformed(mesh, 1.0, rotation, Vec3::ZERO);
            let eyes: Vec<Vec3> = inside
                .iter()
                .map(|&eye| rotation * eye)
                .filter(|eye| slimbvh_tests::closed::winding_number(&turned, eye.to_array()) > 0.9)
                .filter(|&eye| far_from_walls(&turned, eye))
                .collect();
            rooms.push(Solid::new(&format!("turned {name}"), turned, &eyes));
        }
    }
    rooms
}

/// Whether the eye is so far from all walls that rounding cannot have moved it into one.
fn far_from_walls(mesh: &slimbvh::Mesh, eye: Vec3) -> bool {
    mesh.indices.iter().all(|face| {
        let [a, b, c] = face.map(|v| Vec3::from(mesh.vertices[v as usize]).as_dvec3());
        let normal = (b - a).cross(c - a).normalize();
        let size = a.abs().max_element().max(b.abs().max_element());
        (eye.as_dvec3() - a).dot(normal).abs() > 1e-6 * size
    })
}

fn check(length: f32) {
    for room in rooms(length) {
        let bvh = build(&room.mesh, CodeBits::Bits30);
        let edges = aims::edges(&room.mesh).len();
        let rays = aims::rays(
            &room,
            Aims {
                random_count: 2000,
                per_edge: (8000 / edges).max(20),
            },
        );
        let escaped = escapes(&bvh, &rays);
        assert!(
            escaped.is_empty(),
            "{}: {} of {} rays escape, the first {:?}",
            room.name,
            escaped.len(),
            rays.len(),
            escaped[0]
        );
    }
}

#[test]
fn watertight_long_rooms() {
    check(1000.0);
    check(1e5);
}

#[test]
fn watertight_flat_rooms() {
    check(1e-3);
    check(1e-5);
}

/// The smallest case of a former bug: t as the weighted sum of the corners' t is off by the weights' rounding times the
/// wall's length, here by -12, so a hit at 2.18 fell behind the eye.
#[test]
fn a_hit_on_a_long_wall_does_not_fall_behind_the_eye() {
    let wall = slimbvh::Mesh {
        vertices: vec![
            [0.0, 0.0, 0.7],
            [1e5, 0.0, 0.7],
            [1e5, 1.3, 0.7],
            [0.0, 1.3, 0.7],
        ],
        indices: vec![[0, 1, 2], [0, 2, 3]],
        ..slimbvh::Mesh::default()
    };
    let direction = Vec3::new(-0.958_579_6, -0.235_256_52, 0.160_559_83);
    for turn in [0.0, 0.7] {
        let rotation = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), turn);
        let bvh = build(
            &transformed(wall.clone(), 1.0, rotation, Vec3::ZERO),
            CodeBits::Bits30,
        );
        let eye = rotation * Vec3::new(50_000.0, 0.65, 0.35);
        let hit = bvh.closest_hit(Ray::new(eye.to_array(), (rotation * direction).to_array()));
        assert!(hit.is_hit(), "turned by {turn}");

        // Rotation rounds the eye and the corners to 2^-9.
        let tolerance = if turn == 0.0 { 1e-5 } else { 0.1 };
        assert!((hit.t - 2.179_873).abs() < tolerance, "{hit:?}");
    }
}
