//! Spheres on spheres.

use super::compose::concatenate;
use super::icosphere;
use crate::Mesh;
use glam::{Quat, Vec3};
use std::f32::consts::TAU;

/// A sphere of radius 1 around the origin with nine spheres of a third of its size on it, repeated `depth` times (Haines,
/// "A Proposal for Standard Graphics Environments", 1987): `(9^(depth + 1) - 1) / 8` separate solids. Each is an icosphere,
/// with `subdivisions` for the largest and one fewer for each smaller size. The lower half stays free, so the flake stands
/// on the ground at y = -1.
#[must_use]
pub fn sphere_flake(depth: u32, subdivisions: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let root = Sphere {
        center: Vec3::ZERO,
        radius: 1.0,
        axis: Vec3::Y,
    };
    grow(&mut mesh, root, depth, subdivisions);
    mesh
}

/// A sphere and the direction in which it grows.
struct Sphere {
    center: Vec3,
    radius: f32,
    axis: Vec3,
}

/// Adds a sphere and all spheres on it.
fn grow(mesh: &mut Mesh, sphere: Sphere, depth: u32, subdivisions: u32) {
    concatenate(mesh, &icosphere(sphere.center, sphere.radius, subdivisions));
    if depth == 0 {
        return;
    }
    let rotation = Quat::from_rotation_arc(Vec3::Y, sphere.axis);
    for direction in directions() {
        let axis = rotation * direction;
        let child = Sphere {
            center: sphere.center + sphere.radius * (4.0 / 3.0) * axis,
            radius: sphere.radius / 3.0,
            axis,
        };
        grow(mesh, child, depth - 1, subdivisions.saturating_sub(1));
    }
}

/// Six directions around the equator and three above, as in a close packing of spheres.
fn directions() -> [Vec3; 9] {
    std::array::from_fn(|child| {
        let (turn, height) = if child < 6 {
            (child as f32 / 6.0, 0.0)
        } else {
            ((child as f32 - 5.75) / 3.0, (2.0_f32 / 3.0).sqrt())
        };
        let (sin, cos) = (TAU * turn).sin_cos();
        let radius = (1.0 - height * height).sqrt();
        Vec3::new(radius * cos, height, radius * sin)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::{assert_solid, assert_unit_normals};

    #[test]
    fn every_sphere_is_solid() {
        let mesh = sphere_flake(2, 1);
        assert_unit_normals(&mesh);
        let components = assert_solid(&mesh);
        assert_eq!(components.len(), 1 + 9 + 81);
        assert_eq!(mesh.indices.len(), 80 + (9 + 81) * 20);
        assert_eq!(components[0].bounds.min[1], -1.0);
    }

    #[test]
    fn it_stands_on_its_largest_sphere_and_stays_within_twice_its_size() {
        let mesh = sphere_flake(3, 2);
        for &vertex in &mesh.vertices {
            assert!(vertex[1] >= -1.0 && Vec3::from(vertex).length() < 2.0);
        }
    }
}
