//! Mirrors, compared with the reflected scene.

use super::{ambient, diffuse, distance, quads, render, settings};
use crate::wide::{Wide, wide};
use glam::Vec3;
use slimbvh::generate::{append, cuboid, icosphere};
use slimbvh::{Camera, Light, Material, Mesh, Picture, Projection, RenderSettings, Scene};

const SIZE: [u32; 2] = [240, 180];

/// The sun shines from above, so that no light passes through the mirror's plane.
const SUN: Wide = wide(0.4, -0.8, -0.3);
const SUN_COLOR: [f32; 3] = [2.0, 1.8, 1.5];

/// Two objects above the plane y = 0, of which the camera sees only the reflections.
fn things() -> Scene {
    let mut scene = Scene {
        materials: vec![
            Material {
                base_color: [0.7, 0.6, 0.5],
                mirror: 0.7,
                ..Material::default()
            },
            Material {
                base_color: [0.9, 0.3, 0.1],
                mirror: 0.0,
                ..Material::default()
            },
            Material {
                base_color: [0.1, 0.4, 0.9],
                mirror: 0.0,
                ..Material::default()
            },
        ],
        cameras: vec![Camera {
            eye: [0.0, 3.0, 6.0],
            target: [0.0, 0.0, 3.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 40.0 },
        }],
        lights: vec![Light::Directional {
            direction: SUN.narrow(),
            color: SUN_COLOR,
        }],
        ..Scene::default()
    };
    // Each object may shadow the other, and neither shadows the visible part of the plane.
    let brick = cuboid(Vec3::new(-1.5, 1.5, -1.5), Vec3::new(0.0, 2.5, -0.5));
    append(&mut scene.mesh, brick, "brick", 1);
    append(
        &mut scene.mesh,
        icosphere(Vec3::new(0.7, 1.75, -0.75), 0.5, 3),
        "ball",
        2,
    );
    scene
}

/// A mirror in the plane y = 0 that fills the view.
fn plane() -> Mesh {
    quads(&[(
        wide(-20.0, 0.0, -0.6),
        wide(0.0, 0.0, 10.0),
        wide(40.0, 0.0, 0.0),
    )])
}

fn with_plane(mut scene: Scene, mirror: f32) -> Scene {
    append(&mut scene.mesh, plane(), "mirror", 0);
    scene.materials[0].mirror = mirror;
    scene
}

/// The scene reflected at y = 0, the camera's up included, which turns its picture by 180°.
fn behind_the_mirror(mut scene: Scene) -> Scene {
    for y in scene
        .mesh
        .vertices
        .iter_mut()
        .chain(&mut scene.mesh.normals)
    {
        y[1] = -y[1];
    }
    for triangle in &mut scene.mesh.indices {
        triangle.swap(1, 2);
    }
    scene.lights = vec![Light::Directional {
        direction: (SUN * wide(1.0, -1.0, 1.0)).narrow(),
        color: SUN_COLOR,
    }];
    scene.cameras[0].up = [0.0, -1.0, 0.0];
    scene
}

fn turned(picture: &Picture) -> impl Iterator<Item = Wide> {
    picture.pixels.iter().rev().map(|&color| Wide::from(color))
}

fn picture(scene: &Scene, mirror_depth: u32) -> (Picture, u64) {
    let settings = RenderSettings {
        mirror_depth,
        ..settings(SIZE)
    };
    let (picture, report) = render(scene, &settings);
    (picture, report.mirror_ray_count)
}

/// The light that the plane reflects diffusely.
fn own_light(mirror: f32) -> Wide {
    let material = Material {
        mirror,
        ..things().materials[0]
    };
    let sun = Wide::from(SUN_COLOR) * -SUN.normalize().y;
    diffuse(&material, ambient() + sun)
}

#[test]
fn a_mirror_shows_the_mirrored_things() {
    let (beyond, _) = picture(&behind_the_mirror(things()), 0);
    for mirror in [1.0, 0.7, 0.25] {
        let scene = with_plane(things(), mirror);
        let own_light = own_light(mirror);
        for depth in [1, 2, 9] {
            let (found, rays) = picture(&scene, depth);
            // The plane fills the picture, and no mirror is visible in it.
            assert_eq!(rays, u64::from(SIZE[0] * SIZE[1]));
            for (pixel, (&found, beyond)) in found.pixels.iter().zip(turned(&beyond)).enumerate() {
                let expected = beyond * f64::from(mirror) + own_light;
                assert!(
                    distance(found, expected) < 1e-4,
                    "{pixel}: {found:?}, not {expected:?}"
                );
            }
        }
    }
    // The picture has many colors.
    let colors: std::collections::BTreeSet<_> =
        beyond.to_srgb().chunks(3).map(<[u8]>::to_vec).collect();
    assert!(colors.len() > 100, "{}", colors.len());
}

#[test]
fn without_depth_no_reflection() {
    for mirror in [1.0, 0.7] {
        let (found, rays) = picture(&with_plane(things(), mirror), 0);
        assert_eq!(rays, 0);
        let own_light = own_light(mirror);
        for found in found.pixels {
            assert!(distance(found, own_light) < 1e-5, "{found:?}");
        }
    }
}

/// Between two facing mirrors, every step of depth adds one reflection, which is weaker by the mirror's share.
#[test]
fn mirrors_in_mirrors() {
    let mut scene = with_plane(
        Scene {
            mesh: Mesh::default(),
            ..things()
        },
        0.5,
    );
    let lid = quads(&[(
        wide(-20.0, 5.0, -20.0),
        wide(40.0, 0.0, 0.0),
        wide(0.0, 0.0, 40.0),
    )]);
    append(&mut scene.mesh, lid, "lid", 0);
    scene.lights = vec![Light::Directional {
        direction: [0.0, -1.0, 0.0],
        color: [0.0; 3],
    }];
    // The camera looks straight down, so that reflections go back and forth.
    scene.cameras[0] = Camera {
        eye: [0.0, 4.0, 5.0],
        target: [0.0, 0.0, 5.0],
        up: [0.0, 0.0, -1.0],
        projection: Projection::Orthographic { height: 1.0 },
    };
    let once = diffuse(&scene.materials[0], ambient());
    for depth in 0..8 {
        let (found, rays) = picture(&scene, depth);
        assert_eq!(rays, u64::from(SIZE[0] * SIZE[1] * depth));
        let sum = 2.0 - 0.5_f64.powi(depth as i32);
        for found in found.pixels {
            assert!(distance(found, once * sum) < 1e-6, "{depth}: {found:?}");
        }
    }
}
