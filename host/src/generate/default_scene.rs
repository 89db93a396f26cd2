//! The built-in default scene.

use super::{
    TorusKnot, append, cuboid, ground, icosphere, smooth_normals, sphere_flake, subdivide_curved,
    teapot, torus_knot, transformed,
};
use crate::analysis::around;
use crate::{Camera, Light, Material, Mesh, Projection, Scene};
use glam::{Quat, Vec3};

/// The Utah teapot among closed solids on wide ground, under a low warm sun and a cool lamp. Composed for a 16:9 picture.
/// Each object is a part with its own material.
#[must_use]
pub fn default_scene() -> Scene {
    let mut scene = Scene {
        cameras: vec![Camera {
            eye: [0.15, 2.9, 8.4],
            target: [0.15, 0.8, 0.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 35.0 },
        }],
        lights: vec![
            Light::Directional {
                direction: [0.66, -0.66, -0.36],
                color: [3.5, 3.05, 2.4],
            },
            Light::Point {
                position: [4.5, 6.0, 6.0],
                color: [16.0, 22.0, 31.0],
                range: f32::INFINITY,
            },
        ],
        ..Scene::default()
    };
    for object in objects() {
        let material = scene.materials.len() as u32;
        append(&mut scene.mesh, object.mesh, object.name, material);
        scene.materials.push(Material {
            base_color: object.base_color,
            mirror: object.mirror,
            ..Material::default()
        });
    }
    scene
}

/// An object of the scene at its position.
struct Object {
    name: &'static str,
    mesh: Mesh,
    base_color: [f32; 3],
    mirror: f32,
}

/// The ground, and all objects on it.
fn objects() -> Vec<Object> {
    let plinth_height = 0.55;
    let plinth = cuboid(Vec3::ZERO, Vec3::new(1.5, plinth_height, 1.3));
    let brick = cuboid(Vec3::ZERO, Vec3::new(0.7, 0.32, 0.42));
    let turn = |degrees: f32| Quat::from_rotation_y(degrees.to_radians());
    let upright = turn(25.0) * Quat::from_rotation_x(90_f32.to_radians());
    vec![
        Object {
            name: "ground",
            mesh: ground(240.0, 48),
            base_color: [0.46, 0.43, 0.39],
            mirror: 0.0,
        },
        Object {
            name: "teapot",
            mesh: stand(
                smooth_teapot(),
                0.1,
                turn(-28.0),
                Vec3::new(-0.35, 0.0, 0.9),
            ),
            base_color: [0.74, 0.68, 0.56],
            mirror: 0.05,
        },
        Object {
            name: "mirror sphere",
            mesh: icosphere(Vec3::new(1.85, 1.15, -1.7), 1.15, 5),
            base_color: [0.85, 0.86, 0.88],
            mirror: 0.8,
        },
        Object {
            name: "plinth",
            mesh: stand(plinth, 1.0, turn(20.0), Vec3::new(-2.55, 0.0, -1.2)),
            base_color: [0.17, 0.19, 0.24],
            mirror: 0.0,
        },
        Object {
            name: "torus knot",
            mesh: stand(
                torus_knot(&TorusKnot::default()),
                0.55,
                upright,
                Vec3::new(-2.55, plinth_height, -1.2),
            ),
            base_color: [0.08, 0.30, 0.32],
            mirror: 0.08,
        },
        Object {
            name: "sphere flake",
            mesh: stand(
                sphere_flake(2, 4),
                0.5,
                turn(12.0),
                Vec3::new(2.75, 0.0, 0.9),
            ),
            base_color: [0.62, 0.40, 0.13],
            mirror: 0.15,
        },
        Object {
            name: "small sphere",
            mesh: icosphere(Vec3::new(-2.25, 0.38, 1.6), 0.38, 4),
            base_color: [0.50, 0.14, 0.12],
            mirror: 0.05,
        },
        Object {
            name: "brick",
            mesh: stand(brick, 1.0, turn(32.0), Vec3::new(1.3, 0.0, 2.35)),
            base_color: [0.20, 0.28, 0.20],
            mirror: 0.0,
        },
    ]
}

/// The teapot, smoothly subdivided.
fn smooth_teapot() -> Mesh {
    let mut coarse = teapot();
    smooth_normals(&mut coarse);
    let mut fine = subdivide_curved(&coarse, 2);
    smooth_normals(&mut fine);
    fine
}

/// Scales and turns a mesh, and places it on the ground at `place`.
fn stand(mesh: Mesh, scale: f32, rotation: Quat, place: Vec3) -> Mesh {
    let turned = transformed(mesh, scale, rotation, Vec3::ZERO);
    match around(turned.vertices.iter().copied()) {
        Some(bounds) => {
            let foot = (0.5 * (bounds.min + bounds.max)).with_y(bounds.min.y);
            transformed(turned, 1.0, Quat::IDENTITY, place - foot)
        }
        None => turned,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;

    /// The triangles of one part.
    fn part(mesh: &Mesh, number: usize) -> Mesh {
        let part = &mesh.parts[number];
        let first = part.first_triangle as usize;
        Mesh {
            vertices: mesh.vertices.clone(),
            indices: mesh.indices[first..first + part.triangle_count as usize].to_vec(),
            ..Mesh::default()
        }
    }

    #[test]
    fn sound_and_of_moderate_size() {
        let scene = default_scene();
        assert_eq!(scene.mesh.validate(), Ok(()));
        let triangle_count = scene.mesh.indices.len();
        assert!(
            (60_000..150_000).contains(&triangle_count),
            "{triangle_count}"
        );
        assert_eq!(scene.mesh.normals.len(), scene.mesh.vertices.len());
        let last = scene.mesh.materials.iter().max();
        assert_eq!(
            last.map(|&last| last as usize + 1),
            Some(scene.materials.len())
        );
        assert_eq!(scene.mesh.parts.len(), scene.materials.len());
    }

    #[test]
    fn every_object_but_ground_and_teapot_is_solid() {
        let mesh = default_scene().mesh;
        for number in 0..mesh.parts.len() {
            let open = ["ground", "teapot"].contains(&mesh.parts[number].name.as_str());
            let analysis = analyze(&part(&mesh, number));
            assert_eq!(analysis.degenerate_triangle_count, 0);
            assert_eq!(analysis.duplicate_triangle_count, 0);
            for component in &analysis.components {
                assert!(component.consistently_wound);
                assert_eq!(component.outward, (!open).then_some(true));
            }
        }
    }

    #[test]
    fn objects_stand_on_something_and_apart() {
        let mesh = default_scene().mesh;
        let bounds = |number| analyze(&part(&mesh, number)).bounds.expect("not empty");
        let bounds: Vec<crate::Aabb> = (1..mesh.parts.len()).map(bounds).collect();
        let close = |a: f32, b: f32| (a - b).abs() < 1e-6;
        for (number, object) in bounds.iter().enumerate() {
            let below = bounds
                .iter()
                .any(|other| close(other.max[1], object.min[1]));
            assert!(close(object.min[1], 0.0) || below);
            for other in &bounds[..number] {
                let overlap = (0..3).all(|axis| {
                    object.min[axis] < other.max[axis] && other.min[axis] < object.max[axis]
                });
                assert!(
                    !overlap || close(object.min[1], other.max[1]),
                    "{object:?} {other:?}"
                );
            }
        }
    }
}
