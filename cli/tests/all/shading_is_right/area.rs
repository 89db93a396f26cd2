//! A floor lit by an area light, in the open and half under a board, compared with integrals over the light.

use super::{ambient, diffuse, quads, render};
use crate::wide::{Wide, wide};
use slimbvh::{AreaShape, Camera, Light, Material, Projection, RenderSettings, Scene};
use std::f64::consts::TAU;

/// A row of small pixels across the edge of the shadow.
const SIZE: [u32; 2] = [25, 1];

/// The width of a pixel on the floor.
const PIXEL: f64 = 0.12;

const WHITE: Material = Material {
    base_color: [0.8, 0.6, 0.4],
    mirror: 0.0,
    transmission: 0.0,
    ior: 1.5,
    double_sided: true,
};

/// The height of the board, which covers x < 0.
const BOARD_HEIGHT: f64 = 1.0;

/// A tilted light above the board, a rectangle of about 2 × 1.4 or the ellipse inscribed in it.
fn light(shape: AreaShape) -> Light {
    Light::Area {
        center: [0.2, 2.5, 0.3],
        half_edges: [[1.0, 0.1, 0.0], [-0.1, 0.2, 0.65]],
        shape,
        color: [9.0, 6.0, 3.0],
        range: f32::INFINITY,
    }
}

/// The floor, and a board over half of it if asked for. The camera is below the board.
fn scene(light: Light, has_board: bool) -> Scene {
    let floor = (
        wide(-10.0, 0.0, -8.0),
        wide(0.0, 0.0, 18.0),
        wide(20.0, 0.0, 0.0),
    );
    let board = (
        wide(-9.0, BOARD_HEIGHT, -9.0),
        wide(0.0, 0.0, 18.0),
        wide(9.0, 0.0, 0.0),
    );
    let parts = if has_board {
        vec![floor, board]
    } else {
        vec![floor]
    };
    Scene {
        mesh: quads(&parts),
        materials: vec![WHITE; 2],
        cameras: vec![Camera {
            eye: [0.0, 0.75, 0.0],
            target: [0.0, 0.0, 0.0],
            up: [0.0, 0.0, 1.0],
            projection: Projection::Orthographic {
                height: PIXEL as f32,
            },
        }],
        lights: vec![light],
        ..Scene::default()
    }
}

/// Evenly spaced points on a light, and its normal.
fn points(light: &Light) -> (Vec<Wide>, Wide) {
    const COUNT: usize = 160;
    let Light::Area {
        center,
        half_edges: [a, b],
        shape,
        ..
    } = *light
    else {
        panic!("it is an area");
    };
    let (center, a, b) = (Wide::from(center), Wide::from(a), Wide::from(b));
    let middle = |i: usize| (i as f64 + 0.5) / COUNT as f64;
    let point = |i: usize| {
        let (u, v) = (middle(i % COUNT), middle(i / COUNT));
        let [s, t] = match shape {
            AreaShape::Rectangle => [2.0 * u - 1.0, 2.0 * v - 1.0],
            // Rings of equal area.
            AreaShape::Disc => [v.sqrt() * (TAU * u).cos(), v.sqrt() * (TAU * u).sin()],
        };
        center + a * s + b * t
    };
    let points = (0..COUNT * COUNT).map(point).collect();
    (points, a.cross(b).normalize())
}

/// The irradiance of the floor in a pixel, and the share of the light that it sees.
fn irradiance(light: &Light, pixel: u32, has_board: bool) -> (Wide, f64) {
    const PLACES: usize = 6;
    let (points, normal) = points(light);
    let (mut sum, mut seen) = (0.0, 0.0);
    for place in 0..PLACES * PLACES {
        let inside = |i: usize| (i as f64 + 0.5) / PLACES as f64;
        // Seen from above with z up, the picture's right is -x.
        let x = f64::from(SIZE[0]) / 2.0 - f64::from(pixel) - inside(place % PLACES);
        let z = 0.5 - inside(place / PLACES);
        let p = wide(x * PIXEL, 0.0, z * PIXEL);
        for &q in &points {
            let way = q - p;
            let crossing = p + way * (BOARD_HEIGHT / way.y);
            if has_board && crossing.x < 0.0 {
                continue;
            }
            let squared = way.dot(way);
            sum += way.y * (-normal.dot(way)).max(0.0) / (squared * squared);
            seen += 1.0;
        }
    }
    let count = (points.len() * PLACES * PLACES) as f64;
    let Light::Area { color, .. } = light else {
        panic!("it is an area");
    };
    (Wide::from(*color) * (sum / count), seen / count)
}

/// The root mean square error as a share of the brightest pixel, and the share of the light that each pixel sees.
fn error(light: Light, has_board: bool, sample_count: u32) -> (f64, Vec<f64>) {
    let settings = RenderSettings {
        size: SIZE,
        sample_count,
        ..RenderSettings::default()
    };
    let (picture, _) = render(&scene(light, has_board), &settings);
    let (mut squares, mut brightest, mut seen) = (0.0, 0.0f64, Vec::new());
    for (pixel, found) in (0..).zip(&picture.pixels) {
        let (irradiance, share) = irradiance(&light, pixel, has_board);
        let expected = diffuse(&WHITE, ambient() + irradiance);
        squares += expected.farthest((*found).into()).powi(2);
        brightest = brightest.max(expected.x);
        seen.push(share);
    }
    let mean = squares / picture.pixels.len() as f64;
    (mean.sqrt() / brightest, seen)
}

#[test]
fn an_open_floor_is_lit_as_by_the_integral() {
    for shape in [AreaShape::Disc, AreaShape::Rectangle] {
        let [few, some, many] =
            [4, 64, 1024].map(|sample_count| error(light(shape), false, sample_count).0);
        println!("{shape:?}: {few} {some} {many}");
        // Independent samples would reduce the error to a quarter and a sixteenth. Well distributed ones reduce it far more.
        assert!(some < few / 16.0 && many < few / 128.0 && many < 2e-4);
    }
}

#[test]
fn half_a_floor_is_in_the_shadow_of_the_integral() {
    for shape in [AreaShape::Disc, AreaShape::Rectangle] {
        let (few, seen) = error(light(shape), true, 4);
        let [some, many] = [64, 1024].map(|sample_count| error(light(shape), true, sample_count).0);
        println!("{shape:?}: {few} {some} {many}; {seen:?}");
        assert!(some < few / 5.0 && many < some / 5.0 && many < 2e-3);
        // The row has fully lit pixels, fully dark ones, and a penumbra that darkens monotonically.
        let count = |is: &dyn Fn(f64) -> bool| seen.iter().filter(|&&share| is(share)).count();
        assert!(count(&|share| share == 0.0) > 2 && count(&|share| share == 1.0) > 2);
        assert!(count(&|share| share > 0.0 && share < 1.0) > 8);
        assert!(seen.is_sorted_by(|a, b| a >= b));
    }
}

/// Negative control: a light of half the size casts another shadow.
#[test]
fn the_shadow_is_that_of_the_lights_size() {
    let whole = light(AreaShape::Rectangle);
    let Light::Area {
        center,
        half_edges,
        shape,
        color,
        range,
    } = whole
    else {
        panic!("it is an area");
    };
    let half = Light::Area {
        center,
        half_edges: half_edges.map(|edge| edge.map(|x| x / 2.0)),
        shape,
        color,
        range,
    };
    let settings = RenderSettings {
        size: SIZE,
        sample_count: 256,
        ..RenderSettings::default()
    };
    let farthest = |a: Light, b: Light, has_board| {
        let [a, b] = [a, b].map(|light| render(&scene(light, has_board), &settings).0.pixels);
        let apart = a
            .iter()
            .zip(&b)
            .map(|(&a, &b)| Wide::from(a).farthest(b.into()));
        apart.fold(0.0, f64::max)
    };
    assert!(farthest(whole, half, true) > 0.05);
    // The color does not scale with the area, so that the open floor differs little.
    assert!(farthest(whole, half, false) < 0.05);
    // Swapped edges make the light shine upward.
    let turned = Light::Area {
        center,
        half_edges: [half_edges[1], half_edges[0]],
        shape,
        color,
        range,
    };
    let dark = Light::Area {
        center,
        half_edges,
        shape,
        color: [0.0; 3],
        range,
    };
    assert_eq!(farthest(turned, dark, false), 0.0);
}

/// A small distant disc equals a point light, except for its cosine.
#[test]
fn a_small_light_is_a_point() {
    let disc = Light::disc([0.0, 8.0, 0.0], [0.0, -1.0, 0.0], 1e-4, [50.0, 40.0, 30.0]);
    let point = Light::Point {
        position: [0.0, 8.0, 0.0],
        color: [50.0, 40.0, 30.0],
        range: f32::INFINITY,
    };
    let settings = RenderSettings {
        size: [1, 1],
        ..RenderSettings::default()
    };
    let [a, b] =
        [disc, point].map(|light| Wide::from(render(&scene(light, false), &settings).0.pixels[0]));
    assert!(a.farthest(b) < 1e-5, "{a:?} {b:?}");
}
