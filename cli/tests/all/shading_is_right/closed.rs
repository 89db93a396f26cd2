//! A closed convex solid under a sun: each face is lit all over or not at all, without acne and light leaks.

use super::{ambient, diffuse, distance, pixel_ray, pixels, render, settings};
use crate::wide::Wide;
use glam::Vec3;
use slimbvh::generate::icosphere;
use slimbvh::{BuildConfig, Builder, Bvh, Camera, Light, Material, Mesh, Projection, Scene};
use slimbvh_core::{Hit, Ray};

const SIZE: [u32; 2] = [256, 192];
const SUN_COLOR: [f32; 3] = [3.0, 2.0, 1.0];

fn scene(center: Vec3, radius: f32, subdivisions: u32, sun: Vec3) -> Scene {
    // Without normals the faces are flat.
    let mesh = Mesh {
        normals: Vec::new(),
        ..icosphere(center, radius, subdivisions)
    };
    Scene {
        mesh,
        materials: vec![Material {
            base_color: [0.9, 0.8, 0.7],
            mirror: 0.0,
            ..Material::default()
        }],
        cameras: vec![Camera {
            eye: (center + radius * Vec3::new(1.0, 1.5, 3.0)).to_array(),
            target: center.to_array(),
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 40.0 },
        }],
        lights: vec![Light::Directional {
            direction: sun.to_array(),
            color: SUN_COLOR,
        }],
        ..Scene::default()
    }
}

/// The colors of the faces around a pixel's center, and whether each is lit; `None` where the sun grazes or misses one.
fn expected(scene: &Scene, bvh: &Bvh, [x, y]: [f64; 2]) -> Option<Vec<(Wide, bool)>> {
    const JITTER: f64 = 0.01;
    let around = [
        [0.0, 0.0],
        [-JITTER, -JITTER],
        [JITTER, -JITTER],
        [-JITTER, JITTER],
        [JITTER, JITTER],
    ];
    around
        .map(|[dx, dy]| {
            let (origin, direction) = pixel_ray(&scene.cameras[0], SIZE, [x + dx, y + dy]);
            let ray = Ray::new(origin.narrow(), direction.narrow());
            let hit: Hit = bvh.closest_hit(ray);
            hit.is_hit()
                .then(|| face_color(scene, hit.primitive))
                .flatten()
        })
        .into_iter()
        .collect()
}

/// A face's color, and whether it is lit; `None` where the sun grazes it.
fn face_color(scene: &Scene, primitive: u32) -> Option<(Wide, bool)> {
    let corners = scene.mesh.indices[primitive as usize];
    let [a, b, c] = corners.map(|vertex| Wide::from(scene.mesh.vertices[vertex as usize]));
    let normal = (b - a).cross(c - a).normalize();
    let Light::Directional { direction, color } = scene.lights[0] else {
        return None;
    };
    let cosine = -normal.dot(Wide::from(direction).normalize());
    let sun = Wide::from(color) * cosine.max(0.0);
    (cosine.abs() > 1e-4).then_some((diffuse(&scene.materials[0], ambient() + sun), cosine > 0.0))
}

#[test]
fn faces_are_lit_all_over_or_not_at_all() {
    let suns = [
        Vec3::new(-1.0, -0.5, 0.2),
        Vec3::new(0.0, -1.0, 0.0),
        Vec3::new(0.3, -0.2, -1.0),
        Vec3::new(1e-3, 1.0, 0.5),
        Vec3::new(-1.0, 0.0, 0.0),
    ];
    let solids = [
        (Vec3::ZERO, 1.0, 5),
        (Vec3::new(3.0, -50.0, 20.0), 1.5, 4),
        (Vec3::ZERO, 1e-12, 2),
        (Vec3::ZERO, 1e15, 6),
    ];
    for (center, radius, subdivisions) in solids {
        for sun in suns {
            let scene = scene(center, radius, subdivisions, sun);
            let mut bvh = Bvh::default();
            Builder::new(BuildConfig::default())
                .build_into(&scene.mesh, &mut bvh)
                .unwrap();
            let (picture, _) = render(&scene, &settings(SIZE));
            let dark = diffuse(&scene.materials[0], ambient());
            let (mut lit, mut unlit) = (0, 0);
            for (pixel, place) in pixels(SIZE) {
                let Some(faces) = expected(&scene, &bvh, place) else {
                    continue;
                };
                let found = picture.pixels[pixel];
                if faces.iter().all(|&(_, is_lit)| is_lit) {
                    lit += 1;
                } else if !faces.iter().any(|&(_, is_lit)| is_lit) {
                    unlit += 1;
                    assert!(
                        distance(found, dark) < 1e-6,
                        "{radius} {sun}: light at {place:?}"
                    );
                }
                let nearest = faces
                    .iter()
                    .map(|&(color, _)| distance(found, color))
                    .fold(1.0, f64::min);
                assert!(
                    nearest < 1e-5,
                    "{radius} {sun} {place:?}: {found:?}, not one of {faces:?}"
                );
            }
            println!(
                "radius {radius}, {subdivisions} subdivisions, sun {sun}: {lit} lit, {unlit} unlit"
            );
            assert!(lit + unlit > 10_000);
        }
    }
}

/// Smooth normals never light faces that turn away from the sun, and no pixel is darker than the ambient light.
#[test]
fn smooth_faces_that_turn_away_are_dark() {
    for subdivisions in [0, 1, 3] {
        let sun = Vec3::new(-1.0, -0.3, 0.1);
        let mut scene = scene(Vec3::ZERO, 1.0, subdivisions, sun);
        scene.mesh = icosphere(Vec3::ZERO, 1.0, subdivisions);
        let mut bvh = Bvh::default();
        Builder::new(BuildConfig::default())
            .build_into(&scene.mesh, &mut bvh)
            .unwrap();
        let (picture, _) = render(&scene, &settings(SIZE));
        let dark = diffuse(&scene.materials[0], ambient());
        let mut unlit = 0;
        for (pixel, place) in pixels(SIZE) {
            if let Some(faces) = expected(&scene, &bvh, place) {
                let found = picture.pixels[pixel];
                assert!(
                    (0..3).all(|channel| found[channel] > dark.narrow()[channel] - 1e-6),
                    "{place:?}: {found:?}"
                );
                if !faces.iter().any(|&(_, is_lit)| is_lit) {
                    unlit += 1;
                    assert!(distance(found, dark) < 1e-6, "{place:?}: {found:?}");
                }
            }
        }
        assert!(unlit > 3000, "{unlit}");
    }
}

/// No sunlight reaches the inside of a closed solid.
#[test]
fn no_light_gets_in() {
    let sun = Vec3::new(-1.0, -0.5, 0.2);
    let mut scene = scene(Vec3::ZERO, 1.0, 4, sun);
    scene.cameras[0].eye = [0.1, 0.2, 0.3];
    scene.cameras[0].projection = Projection::Perspective {
        vertical_fov: 120.0,
    };
    let dark = diffuse(&scene.materials[0], ambient());
    for target in [
        Vec3::X,
        Vec3::NEG_X,
        Vec3::Z,
        Vec3::NEG_Z,
        Vec3::new(0.2, 5.0, 0.1),
    ] {
        scene.cameras[0].target = target.to_array();
        let (picture, report) = render(&scene, &settings(SIZE));
        assert_eq!(report.primary_hit_count, u64::from(SIZE[0] * SIZE[1]));
        assert!(
            picture
                .pixels
                .iter()
                .all(|&found| distance(found, dark) < 1e-6)
        );
    }
}
