//! Scenes where something stands where it makes a difference.

use super::awkward;
use glam::{Quat, Vec3};
use slimbvh::generate::{append, cuboid, default_scene, ground, icosphere, transformed};
use slimbvh::{Camera, Light, Mesh, Projection, Scene};
use slimbvh_tests::closed::small_torus_knot;

pub const EYE: [f32; 3] = [0.4, 0.9, 4.5];
pub const PERSPECTIVE: Projection = Projection::Perspective { vertical_fov: 50.0 };
pub const SUN: Light = Light::Directional {
    direction: [-0.35, -1.0, -0.45],
    color: [2.0; 3],
};

pub fn lamp(position: [f32; 3]) -> Light {
    Light::Point {
        position,
        color: [9.0; 3],
        range: f32::INFINITY,
    }
}

pub fn camera(eye: [f32; 3], target: [f32; 3], projection: Projection) -> Camera {
    Camera {
        eye,
        target,
        up: [0.0, 1.0, 0.0],
        projection,
    }
}

pub fn scene(meshes: Vec<Mesh>, camera: Camera, lights: &[Light]) -> Scene {
    let mut mesh = Mesh::default();
    for part in meshes {
        append(&mut mesh, part, "part", 0);
    }
    Scene {
        mesh,
        cameras: vec![camera],
        lights: lights.to_vec(),
        ..Scene::default()
    }
}

pub fn ball(center: [f32; 3], radius: f32) -> Mesh {
    icosphere(center.into(), radius, 4)
}

pub fn floor() -> Mesh {
    transformed(
        ground(8.0, 6),
        1.0,
        Quat::IDENTITY,
        Vec3::new(0.0, -1.0, 0.0),
    )
}

/// A box, turned off the axes.
fn turned_box(min: [f32; 3], max: [f32; 3]) -> Mesh {
    let turn = Quat::from_rotation_y(0.3) * Quat::from_rotation_x(0.2);
    transformed(cuboid(min.into(), max.into()), 1.0, turn, Vec3::ZERO)
}

/// With its back sides out.
pub fn inside_out(mut mesh: Mesh) -> Mesh {
    for triangle in &mut mesh.indices {
        triangle.swap(1, 2);
    }
    mesh.normals.clear();
    mesh
}

/// All of them, by name.
pub fn scenes() -> Vec<(&'static str, Scene)> {
    let mut scenes = plain();
    scenes.extend(awkward::scenes());
    scenes
}

fn plain() -> Vec<(&'static str, Scene)> {
    let front = || camera(EYE, [0.0; 3], PERSPECTIVE);
    let both = [SUN, lamp([2.5, 2.0, 1.5])];
    let hollow = || {
        vec![
            ball([0.0; 3], 1.2),
            inside_out(ball([0.1, 0.0, 0.0], 0.8)),
            floor(),
        ]
    };
    vec![
        ("default scene", default_scene()),
        (
            "eye inside",
            scene(
                vec![ball([0.4, 0.9, 4.5], 0.5), ball([0.0; 3], 1.0), floor()],
                front(),
                &both,
            ),
        ),
        (
            "light inside",
            scene(
                vec![ball([0.0; 3], 1.0), ball([1.6, 0.0, 0.0], 0.4), floor()],
                front(),
                &[SUN, lamp([1.6, 0.1, 0.0])],
            ),
        ),
        (
            "open meshes mixed in",
            scene(
                vec![
                    ball([-0.8, 0.0, 0.0], 0.7),
                    transformed(
                        ground(1.5, 3),
                        1.0,
                        Quat::from_rotation_x(1.1),
                        Vec3::new(0.8, 0.2, 0.3),
                    ),
                    small_torus_knot(),
                    floor(),
                ],
                front(),
                &both,
            ),
        ),
        (
            "spheres that cut each other",
            scene(
                vec![
                    ball([-0.4, 0.0, 0.0], 0.8),
                    ball([0.4, 0.1, 0.1], 0.8),
                    floor(),
                ],
                front(),
                &both,
            ),
        ),
        (
            "boxes that share a side",
            scene(
                vec![
                    turned_box([-1.0, -0.5, -0.5], [0.0, 0.5, 0.5]),
                    turned_box([0.0, -0.5, -0.5], [1.0, 0.5, 0.5]),
                ],
                front(),
                &both,
            ),
        ),
        (
            "boxes that touch",
            scene(
                vec![
                    turned_box([-1.0, -0.5, -0.5], [0.0, 0.5, 0.5]),
                    turned_box([0.0, -0.25, -0.75], [0.75, 0.75, 0.25]),
                ],
                front(),
                &both,
            ),
        ),
        ("cavity", scene(hollow(), front(), &both)),
        (
            "inside a cavity",
            scene(
                hollow(),
                camera([0.1, 0.0, 0.6], [0.0; 3], PERSPECTIVE),
                &[SUN, lamp([0.2, 0.3, 0.1])],
            ),
        ),
        (
            "in the hole of a knot",
            scene(
                vec![small_torus_knot(), floor()],
                camera([0.03, 0.02, 0.05], [1.0, 0.2, 0.4], PERSPECTIVE),
                &both,
            ),
        ),
        (
            "parallel camera",
            scene(
                vec![ball([0.0; 3], 1.0), small_torus_knot(), floor()],
                camera(EYE, [0.0; 3], Projection::Orthographic { height: 3.5 }),
                &both,
            ),
        ),
        ("room", room(SUN)),
    ]
}

/// A closed room with something in it, and no light but that from outside.
pub fn room(light: Light) -> Scene {
    let walls = cuboid(Vec3::new(-3.0, -1.0, -2.0), Vec3::new(2.0, 2.0, 5.0));
    let eye = camera(EYE, [0.0; 3], PERSPECTIVE);
    scene(vec![walls, ball([0.0; 3], 0.6)], eye, &[light])
}
