//! Scenes in which the place of an object, a camera or a light decides about sets.

use super::awkward;
use glam::{Quat, Vec3};
use slimbvh::generate::{append, cuboid, default_scene, ground, icosphere, transformed};
use slimbvh::{AreaShape, Camera, Light, Material, Mesh, Projection, Scene};
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

/// A rectangular light around a place, toward the scene's middle.
fn panel(center: [f32; 3], half_width: f32) -> Light {
    let toward = -Vec3::from(center).normalize();
    let (right, up) = toward.any_orthonormal_pair();
    Light::Area {
        center,
        half_edges: [right * half_width, up * half_width / 2.0].map(|edge| edge.to_array()),
        shape: AreaShape::Rectangle,
        color: [12.0; 3],
        range: f32::INFINITY,
    }
}

/// A camera with a lens that is focused on the scene's middle.
fn lens(radius: f32) -> Camera {
    let projection = Projection::ThinLens {
        vertical_fov: 50.0,
        radius,
        focus_distance: 4.5,
    };
    camera(EYE, [0.0; 3], projection)
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

/// A box, rotated off the axes.
fn turned_box(min: [f32; 3], max: [f32; 3]) -> Mesh {
    let turn = Quat::from_rotation_y(0.3) * Quat::from_rotation_x(0.2);
    transformed(cuboid(min.into(), max.into()), 1.0, turn, Vec3::ZERO)
}

/// The mesh turned inside out.
pub fn inside_out(mut mesh: Mesh) -> Mesh {
    for triangle in &mut mesh.indices {
        triangle.swap(1, 2);
    }
    mesh.normals.clear();
    mesh
}

/// All scenes, by name.
pub fn scenes() -> Vec<(&'static str, Scene)> {
    let mut scenes = plain();
    scenes.extend(awkward::scenes());
    scenes
}

/// A ball and a box of glass, one in the other's shadow, and a lamp inside of a third object: shadow rays start inside.
fn glass(camera: Camera, lights: &[Light]) -> Scene {
    let parts = [
        ball([-0.5, 0.0, 0.0], 0.7),
        turned_box([0.4, -0.6, -0.6], [1.2, 0.4, 0.2]),
        ball([0.5, 0.6, 1.2], 0.3),
        floor(),
    ];
    let mut lights = lights.to_vec();
    lights.push(lamp([0.5, 0.65, 1.2]));
    let mut scene = scene(Vec::new(), camera, &lights);
    for (material, part) in (0..).zip(parts) {
        append(&mut scene.mesh, part, "part", material);
    }
    let material = |transmission, ior| Material {
        transmission,
        ior,
        ..Material::default()
    };
    scene.materials = vec![
        material(0.7, 1.5),
        material(0.5, 1.25),
        material(0.9, 1.5),
        material(0.0, 1.0),
    ];
    scene
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
        ("glass", glass(front(), &both)),
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
        ("many lights near and far", lights()),
        ("seen in part", close()),
        ("room", room(SUN)),
        (
            "disc light",
            scene(
                vec![ball([0.0; 3], 1.0), small_torus_knot(), floor()],
                front(),
                &[
                    SUN,
                    Light::disc([2.5, 2.0, 1.5], [-2.5, -2.0, -1.5], 0.6, [9.0; 3]),
                ],
            ),
        ),
        (
            "rectangle light",
            scene(
                vec![
                    ball([-0.8, 0.0, 0.0], 0.7),
                    turned_box([0.1, -0.5, -0.5], [1.0, 0.5, 0.5]),
                    floor(),
                ],
                front(),
                &[panel([-2.0, 2.5, 1.0], 0.8), panel([2.5, 2.0, 1.5], 0.1)],
            ),
        ),
        (
            // The light's middle is outside of the small ball, but a part of the light is inside.
            "rectangle light partly inside",
            scene(
                vec![ball([0.0; 3], 1.0), ball([2.6, 1.9, 1.3], 0.3), floor()],
                front(),
                &[SUN, panel([2.5, 2.0, 1.9], 0.9)],
            ),
        ),
        (
            "lens",
            scene(
                vec![
                    ball([0.0; 3], 0.8),
                    ball([0.5, 0.9, 2.0], 0.4),
                    ball([-0.9, 0.4, -2.0], 0.9),
                    floor(),
                ],
                lens(0.25),
                &both,
            ),
        ),
        (
            "lens partly inside",
            scene(
                vec![ball([0.0; 3], 1.0), ball([0.75, 0.9, 4.45], 0.25), floor()],
                lens(0.2),
                &both,
            ),
        ),
        (
            "lens and lights",
            scene(
                vec![ball([0.0; 3], 1.0), small_torus_knot(), floor()],
                lens(0.15),
                &[
                    panel([-2.0, 2.5, 1.0], 0.8),
                    Light::disc([2.5, 2.0, 1.5], [-2.5, -2.0, -1.5], 0.6, [9.0; 3]),
                ],
            ),
        ),
    ]
}

/// Lamps close together, lamps on either side, and suns from above and below.
pub fn lights() -> Scene {
    let near = (0..4).map(|i| lamp([0.02 * i as f32, 3.0, 0.5 - 0.03 * i as f32]));
    let apart = [lamp([-3.0, 0.4, 0.2]), lamp([3.0, 0.1, -0.2])];
    let below = Light::Directional {
        direction: [0.1, 1.0, -0.6],
        color: [0.4; 3],
    };
    let lights: Vec<Light> = near.chain(apart).chain([SUN, below]).collect();
    let meshes = vec![small_torus_knot(), ball([1.5, 0.2, 0.0], 0.5), floor()];
    scene(meshes, camera(EYE, [0.0; 3], PERSPECTIVE), &lights)
}

/// A camera close to some of many objects, with more of them behind it.
fn close() -> Scene {
    let mut meshes = vec![floor()];
    for i in 0..12 {
        let turn = i as f32 * 0.55;
        meshes.push(ball([2.0 * turn.cos(), -0.4, 2.0 * turn.sin()], 0.4));
    }
    let eye = camera([0.3, 0.2, 0.4], [1.9, -0.3, 0.8], PERSPECTIVE);
    scene(meshes, eye, &[SUN, lamp([0.5, 2.0, 0.5])])
}

/// A closed room with an object in it, and a light only outside.
pub fn room(light: Light) -> Scene {
    let walls = cuboid(Vec3::new(-3.0, -1.0, -2.0), Vec3::new(2.0, 2.0, 5.0));
    let eye = camera(EYE, [0.0; 3], PERSPECTIVE);
    scene(vec![walls, ball([0.0; 3], 0.6)], eye, &[light])
}
