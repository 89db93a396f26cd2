//! A floor and a board above it: light, shadow and falloff.

use super::{
    ambient, diffuse, distance, is_inside, meet, pixel_ray, pixels, quads, render, settings, sky,
};
use crate::wide::{Wide, wide};
use slimbvh::{Camera, Light, Material, Projection, Scene};

type Quad = (Wide, Wide, Wide);

const SIZE: [u32; 2] = [320, 240];

/// The floor, which faces up.
const FLOOR: Quad = (
    wide(-10.0, 0.0, -8.0),
    wide(0.0, 0.0, 18.0),
    wide(20.0, 0.0, 0.0),
);

/// The board, which is tilted and faces up.
const BOARD: Quad = (
    wide(-1.5, 1.5, -1.0),
    wide(0.25, 0.5, 2.0),
    wide(2.5, 0.25, 0.0),
);

const MATERIALS: [Material; 2] = [
    Material {
        base_color: [0.8, 0.5, 0.25],
        mirror: 0.0,
        transmission: 0.0,
        ior: 1.5,
        double_sided: true,
    },
    Material {
        base_color: [0.2, 0.6, 1.0],
        mirror: 0.0,
        transmission: 0.0,
        ior: 1.5,
        double_sided: true,
    },
];

fn scene(light: Light) -> Scene {
    Scene {
        mesh: quads(&[FLOOR, BOARD]),
        materials: MATERIALS.to_vec(),
        cameras: vec![Camera {
            eye: [1.0, 7.0, 11.0],
            target: [0.25, 0.5, 0.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 50.0 },
        }],
        lights: vec![light],
        ..Scene::default()
    }
}

/// A light's irradiance at a point without occlusion, and the vector to the light; `None` where rounding decides whether the
/// point is in range.
fn unshadowed(light: &Light, point: Wide, normal: Wide) -> Option<(Wide, Wide)> {
    match *light {
        Light::Directional { direction, color } => {
            let way = -Wide::from(direction).normalize();
            Some((Wide::from(color) * normal.dot(way).max(0.0), way))
        }
        Light::Point {
            position,
            color,
            range,
        } => {
            let way = Wide::from(position) - point;
            let (distance, range) = (way.length(), f64::from(range));
            if (distance - range).abs() < 1e-4 {
                return None;
            }
            let reach = f64::from(u8::from(distance < range));
            let cosine = (normal.dot(way) / distance).max(0.0);
            Some((
                Wide::from(color) * (reach * cosine / (distance * distance)),
                way,
            ))
        }
        Light::Area { .. } => panic!("`area.rs` has those"),
    }
}

/// Counts of a picture's pixels by kind.
#[derive(Debug, Default)]
struct Seen {
    sky: usize,
    lit: usize,
    shadow: usize,
    dark: usize,
    skipped: usize,
}

/// Compares every pixel with its closed form, except those on borders.
fn check(scene: &Scene, tolerance: f64) -> Seen {
    let (picture, _) = render(scene, &settings(SIZE));
    let mut seen = Seen::default();
    for (pixel, place) in pixels(SIZE) {
        let (origin, direction) = pixel_ray(&scene.cameras[0], SIZE, place);
        match expected(scene, origin, direction, &mut seen) {
            Some(expected) => {
                let found = picture.pixels[pixel];
                let distance = distance(found, expected);
                // Channels above 1 have a relative error.
                let brightest = expected.farthest(Wide::ZERO).max(1.0);
                assert!(
                    distance < tolerance * brightest,
                    "{place:?}: {found:?}, not {expected:?}"
                );
            }
            None => seen.skipped += 1,
        }
    }
    assert!(seen.skipped < 200, "{seen:?}");
    seen
}

fn expected(scene: &Scene, origin: Wide, direction: Wide, seen: &mut Seen) -> Option<Wide> {
    // Find the nearer of floor and board.
    let mut nearest = f64::INFINITY;
    let mut found = None;
    for (quad, material) in [FLOOR, BOARD].into_iter().zip(&scene.materials) {
        if let Some(place) = meet(quad, origin, direction)
            && is_inside(place)?
            && place[0] < nearest
        {
            nearest = place[0];
            found = Some((quad, material));
        }
    }
    let Some(((_, a, b), material)) = found else {
        seen.sky += 1;
        return Some(sky(scene.cameras[0].up, direction));
    };

    // The camera sees both from above.
    let normal = a.cross(b).normalize();
    let point = origin + direction * nearest;
    let (light, way) = unshadowed(&scene.lights[0], point, normal)?;
    let is_position = matches!(scene.lights[0], Light::Point { .. });
    let in_shadow = match meet(BOARD, point + normal * 1e-6, way) {
        Some(place) => is_inside(place)? && (!is_position || place[0] < 1.0),
        None => false,
    };
    *match (light == Wide::ZERO, in_shadow) {
        (true, _) => &mut seen.dark,
        (false, true) => &mut seen.shadow,
        (false, false) => &mut seen.lit,
    } += 1;
    let direct = if in_shadow { Wide::ZERO } else { light };
    Some(diffuse(material, ambient() + direct))
}

#[test]
fn a_sun() {
    for direction in [
        [0.0, -1.0, 0.0],
        [0.5, -1.0, 0.25],
        [-30.0, -20.0, -10.0],
        [3e-20, -2e-20, 0.0],
    ] {
        let scene = scene(Light::Directional {
            direction,
            color: [3.0, 2.0, 0.5],
        });
        let seen = check(&scene, 1e-5);
        println!("{direction:?}: {seen:?}");
        assert!(
            seen.sky > 1000 && seen.lit > 20_000 && seen.shadow > 500,
            "{seen:?}"
        );
    }
}

#[test]
fn a_sun_that_does_not_reach_the_upper_side() {
    for direction in [[0.0, 1.0, 0.0], [0.4, 0.7, 0.1], [1.0, 0.3, 0.0]] {
        let scene = scene(Light::Directional {
            direction,
            color: [3.0, 2.0, 0.5],
        });
        let seen = check(&scene, 1e-5);
        assert!(seen.lit == 0 && seen.dark > 20_000, "{seen:?}");
    }
}

#[test]
fn a_lamp() {
    for (position, range, tolerance) in [
        ([0.5, 4.0, 0.5], f32::INFINITY, 1e-5),
        ([0.5, 4.0, 0.5], 5.0, 1e-5),
        ([-3.0, 6.0, 2.0], 8.0, 1e-5),
        // Below the board, which shadows nothing of the floor. A point on a floor of 20 units is accurate to some 1e-5,
        // and at distance 1 that counts twice.
        ([0.0, 1.0, 0.5], 3.0, 3e-5),
    ] {
        let scene = scene(Light::Point {
            position,
            color: [30.0, 20.0, 10.0],
            range,
        });
        let seen = check(&scene, tolerance);
        println!("{position:?} {range}: {seen:?}");
        assert!(seen.lit > 1000, "{seen:?}");
        assert_eq!(seen.shadow > 0, position[1] > 2.0, "{seen:?}");
        assert_eq!(seen.dark > 1000, range.is_finite(), "{seen:?}");
    }
}

/// Lights add up, in any number, and no light counts twice.
#[test]
fn many_lights() {
    let lights = [
        Light::Directional {
            direction: [0.5, -1.0, 0.25],
            color: [1.0, 2.0, 0.5],
        },
        Light::Point {
            position: [0.5, 4.0, 0.5],
            color: [30.0, 20.0, 10.0],
            range: 6.0,
        },
        Light::Directional {
            direction: [-0.5, -1.0, -0.25],
            color: [0.0; 3],
        },
    ];
    let picture = |lights: &[Light]| {
        let mut scene = scene(lights[0]);
        scene.lights = lights.to_vec();
        render(&scene, &settings(SIZE)).0.pixels
    };
    let dark = picture(&lights[2..]);
    let alone = [0, 1].map(|i| picture(&lights[i..=i]));
    for (pixel, together) in picture(&lights).into_iter().enumerate() {
        let sum =
            Wide::from(alone[0][pixel]) + Wide::from(alone[1][pixel]) - Wide::from(dark[pixel]);
        assert!(distance(together, sum) < 1e-5);
    }
}
