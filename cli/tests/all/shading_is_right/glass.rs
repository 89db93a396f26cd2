//! Refraction through glass, compared with Snell's law.

use super::{
    ambient, diffuse, distance, is_inside, meet, pixel_ray, pixels, quads, render, settings, sky,
};
use crate::wide::{Wide, wide};
use glam::Vec3;
use slimbvh::generate::{append, cuboid};
use slimbvh::{Camera, Light, Material, Mesh, Projection, RenderSettings, Scene};

const IOR: f32 = 1.5;

/// The tint and the share of the light that a surface transmits.
const TINT: [f32; 3] = [0.9, 0.75, 0.6];
const SHARE: f32 = 0.875;

fn glass(ior: f32) -> Material {
    Material {
        base_color: TINT,
        transmission: SHARE,
        ior,
        ..Material::default()
    }
}

/// The light that passes through this many surfaces.
fn passed(light: Wide, surfaces: i32) -> Wide {
    let tint = Wide::from(TINT) * f64::from(SHARE);
    (0..surfaces).fold(light, |light, _| light * tint)
}

/// The light that a path gathers at the surfaces themselves.
fn own_light(surfaces: i32) -> Wide {
    let own = Wide::from(TINT) * ambient() * (f64::from(1.0 - SHARE) / std::f64::consts::PI);
    (0..surfaces).fold(wide(0.0, 0.0, 0.0), |sum, n| sum + passed(own, n))
}

fn no_light() -> Vec<Light> {
    vec![Light::Directional {
        direction: [0.0, -1.0, 0.0],
        color: [0.0; 3],
    }]
}

/// The squares of a floor in y = 0, by column and row, and their materials.
fn checker() -> (Vec<(Wide, Wide, Wide)>, Vec<Material>) {
    const COLORS: [[f32; 3]; 2] = [[0.9, 0.2, 0.1], [0.1, 0.5, 0.8]];
    let places = (-4..4).flat_map(|x| (-6..4).map(move |z| (x, z)));
    let square = |(x, z): (i32, i32)| {
        let corner = wide(f64::from(x), 0.0, f64::from(z));
        let square = (corner, wide(0.0, 0.0, 1.0), wide(1.0, 0.0, 0.0));
        let base_color = COLORS[(x + z).rem_euclid(2) as usize];
        (
            square,
            Material {
                base_color,
                ..Material::default()
            },
        )
    };
    places.map(square).unzip()
}

/// A slab shifts the floor below it by its height times the difference of the tangents of both angles.
#[test]
fn a_slab_moves_what_is_below_it() {
    const HEIGHT: f64 = 1.25;
    let size = [200, 150];
    let (squares, mut materials) = checker();
    let mut scene = Scene {
        mesh: quads(&squares),
        cameras: vec![Camera {
            eye: [0.5, 4.0, 4.5],
            target: [0.0, 0.0, -0.5],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 30.0 },
        }],
        lights: no_light(),
        ..Scene::default()
    };
    let slab = cuboid(Vec3::new(-20.0, 0.5, -20.0), Vec3::new(20.0, 1.75, 20.0));
    let number = materials.len() as u32;
    append(&mut scene.mesh, slab, "slab", number);
    for ior in [IOR, 1.0, 2.4] {
        materials.truncate(number as usize);
        materials.push(glass(ior));
        scene.materials.clone_from(&materials);
        let (picture, report) = render(&scene, &settings(size));
        assert_eq!(report.mirror_ray_count, u64::from(2 * size[0] * size[1]));
        let (mut checked, mut moved) = (0, 0);
        for (pixel, center) in pixels(size) {
            let (origin, direction) = pixel_ray(&scene.cameras[0], size, center);
            // Per unit of height, a ray advances along the floor by the tangent of its angle, outside and inside the slab.
            let down = direction * (-1.0 / direction.y);
            let tangent = (down.x * down.x + down.z * down.z).sqrt();
            let sine = tangent / (1.0 + tangent * tangent).sqrt() / f64::from(ior);
            let inside = sine / (1.0 - sine * sine).sqrt() / tangent;
            let shift = wide(down.x, 0.0, down.z) * (HEIGHT * (inside - 1.0));
            let through = |from: Wide| {
                let meets = squares.iter().map(|&square| meet(square, from, direction));
                let mut places = meets.map(|place| place.map(is_inside));
                places.position(|place| place == Some(Some(true)))
            };
            let Some(square) = through(origin + shift) else {
                continue;
            };
            let floor = diffuse(&materials[square], ambient());
            let expected = passed(floor, 2) + own_light(2);
            let found = picture.pixels[pixel];
            assert!(
                distance(found, expected) < 1e-5,
                "{ior}, {pixel}: {found:?}, not {expected:?}"
            );
            checked += 1;
            moved += u32::from(through(origin) != Some(square));
        }
        assert!(checked > 25_000, "{checked}");
        assert!(
            (ior == 1.0) == (moved < 10) && (ior == 1.0 || moved > 5000),
            "{moved}"
        );
    }
}

/// An equilateral prism along x, 1 wide. One edge is at the origin and the opposite side is above it. The ends are open,
/// since no ray meets them.
fn prism() -> Mesh {
    let half = 3f64.sqrt() / 2.0;
    let edge = wide(-9.0, 0.0, 0.0);
    let (right, left) = (wide(-9.0, half, 0.5), wide(-9.0, half, -0.5));
    let along = wide(18.0, 0.0, 0.0);
    let mut mesh = quads(&[
        (edge, along, right - edge),
        (left, along, edge - left),
        (right, along, left - right),
    ]);
    mesh.materials.fill(0);
    mesh
}

/// A prism deviates a ray with angle of incidence `i` and of emergence `e` upward by `i + e − 60°`. Beyond the critical
/// angle the far side reflects the ray as a mirror would, and it leaves through the third side.
#[test]
fn a_prism_turns_rays_by_the_known_angles() {
    let size = [40, 30];
    let mut scene = Scene {
        mesh: prism(),
        materials: vec![glass(IOR)],
        lights: no_light(),
        ..Scene::default()
    };
    // The outward normal of the near side points to z and down.
    let outward = wide(0.0, -0.5, 3f64.sqrt() / 2.0);
    let far = wide(0.0, -0.5, -(3f64.sqrt()) / 2.0);
    // Near the edge, so that rays meet the far side first.
    let middle = wide(0.0, 3f64.sqrt() / 2.0, 0.5) * 0.3;
    for incidence in [
        80.0_f64,
        65.0,
        48.590_377_890_729,
        40.0,
        30.0,
        26.0,
        10.0,
        0.0,
    ] {
        let i = incidence.to_radians();
        // At incidence 0 the ray rises by 30°. A larger incidence turns it downward.
        let angle = i - 30f64.to_radians();
        let direction = wide(0.0, -angle.sin(), -angle.cos());
        assert!((-direction.dot(outward) - i.cos()).abs() < 1e-12);
        scene.cameras = vec![Camera {
            eye: (middle - direction * 5.0).narrow(),
            target: middle.narrow(),
            up: [0.0, 1.0, 0.0],
            projection: Projection::Orthographic { height: 0.02 },
        }];
        let first = (i.sin() / f64::from(IOR)).asin();
        let second = f64::from(IOR) * (60f64.to_radians() - first).sin();
        let (surfaces, expected) = if second < 1.0 {
            let turn = i + second.asin() - 60f64.to_radians();
            let angle = angle - turn;
            (2, wide(0.0, -angle.sin(), -angle.cos()))
        } else {
            (3, direction - far * (2.0 * direction.dot(far)))
        };
        if incidence < 50.0 && incidence > 48.0 {
            // Tables list this minimum deviation for 60° and an index of 1.5.
            let turn = (direction.dot(expected)).acos().to_degrees();
            assert!((turn - 37.180_755_8).abs() < 1e-6, "{turn}");
        }
        let seen = passed(sky([0.0, 1.0, 0.0], expected), surfaces) + own_light(surfaces);
        let (picture, report) = render(&scene, &settings(size));
        let rays = surfaces as u64 * u64::from(size[0] * size[1]);
        assert_eq!(report.mirror_ray_count, rays, "{incidence}");
        for found in &picture.pixels {
            assert!(
                distance(*found, seen) < 2e-6,
                "{incidence}: {found:?}, not {seen:?}"
            );
        }
    }
}

/// Each glass surface takes one step of the mirror depth, and the path ends with the depth.
#[test]
fn glass_takes_depth() {
    let (squares, mut materials) = checker();
    let mut mesh = quads(&squares);
    let slab = cuboid(Vec3::new(-20.0, 0.5, -20.0), Vec3::new(20.0, 1.75, 20.0));
    append(&mut mesh, slab, "slab", materials.len() as u32);
    materials.push(glass(IOR));
    let scene = Scene {
        mesh,
        materials,
        cameras: vec![Camera {
            eye: [0.5, 4.0, 0.25],
            target: [0.5, 0.0, 0.25],
            up: [0.0, 0.0, -1.0],
            projection: Projection::Orthographic { height: 0.1 },
        }],
        lights: no_light(),
        ..Scene::default()
    };
    let square = scene.mesh.materials[0] as usize;
    assert_eq!(square, 0);
    for depth in 0..4 {
        let settings = RenderSettings {
            mirror_depth: depth,
            ..settings([16, 12])
        };
        let (picture, report) = render(&scene, &settings);
        let rays = u64::from(depth.min(2) * 16 * 12);
        assert_eq!(report.mirror_ray_count, rays);
        let floor = passed(
            diffuse(
                &Material {
                    base_color: [0.9, 0.2, 0.1],
                    ..Material::default()
                },
                ambient(),
            ),
            2,
        );
        let met = own_light(depth.min(1) as i32 + 1);
        let expected = if depth < 2 { met } else { met + floor };
        for found in &picture.pixels {
            assert!(distance(*found, expected) < 1e-6, "{depth}: {found:?}");
        }
    }
}

/// Glass casts a full shadow.
#[test]
fn glass_stops_light() {
    let mut scene = Scene {
        mesh: quads(&[(
            wide(-9.0, 0.0, -9.0),
            wide(0.0, 0.0, 18.0),
            wide(18.0, 0.0, 0.0),
        )]),
        materials: vec![Material::default(), glass(IOR)],
        cameras: vec![Camera {
            eye: [0.0, 1.0, 0.0],
            target: [0.0, 0.0, 0.0],
            up: [0.0, 0.0, -1.0],
            projection: Projection::Orthographic { height: 2.0 },
        }],
        lights: vec![Light::Directional {
            direction: [0.0, -1.0, 0.0],
            color: [2.0; 3],
        }],
        ..Scene::default()
    };
    let roof = cuboid(Vec3::new(0.0, 2.0, -9.0), Vec3::new(9.0, 3.0, 9.0));
    append(&mut scene.mesh, roof, "roof", 1);
    let (picture, _) = render(&scene, &settings([16, 12]));
    let lit = diffuse(&scene.materials[0], ambient() + Wide::from([2.0; 3]));
    let dark = diffuse(&scene.materials[0], ambient());
    for (pixel, [x, _]) in pixels([16, 12]) {
        let expected = if x < 8.0 { lit } else { dark };
        let found = picture.pixels[pixel];
        assert!(distance(found, expected) < 1e-6, "{pixel}: {found:?}");
    }
}
