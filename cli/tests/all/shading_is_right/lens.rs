//! An edge between two colors, before, at and behind the focus distance, compared with the closed form of its blur.

use super::{ambient, diffuse, quads, render};
use crate::wide::{Wide, wide};
use slimbvh::{Camera, Light, Material, Projection, RenderSettings, Scene};
use std::f64::consts::PI;

const SIZE: [u32; 2] = [41, 1];

/// The width of the picture at distance 1.
const WIDTH: f64 = 0.41;

const RADIUS: f64 = 0.2;
const FOCUS: f64 = 4.0;

const COLORS: [Material; 2] = [
    Material {
        base_color: [0.9, 0.1, 0.3],
        mirror: 0.0,
        transmission: 0.0,
        ior: 1.5,
        double_sided: true,
    },
    Material {
        base_color: [0.1, 0.7, 0.5],
        mirror: 0.0,
        transmission: 0.0,
        ior: 1.5,
        double_sided: true,
    },
];

/// A wall at a distance, with one color on the left of `x` and another on the right.
fn wall(distance: f64, x: f64, projection: Projection) -> Scene {
    let part = |from: f64| {
        (
            wide(from, -9.0, -distance),
            wide(9.0, 0.0, 0.0),
            wide(0.0, 18.0, 0.0),
        )
    };
    Scene {
        mesh: quads(&[part(x - 9.0), part(x)]),
        materials: COLORS.to_vec(),
        cameras: vec![Camera {
            eye: [0.0; 3],
            target: [0.0, 0.0, -1.0],
            up: [0.0, 1.0, 0.0],
            projection,
        }],
        // The light shines away from the wall.
        lights: vec![Light::Directional {
            direction: [0.0, 0.0, 1.0],
            color: [0.0; 3],
        }],
        ..Scene::default()
    }
}

fn fov() -> f32 {
    let half_height = WIDTH / 2.0 / f64::from(SIZE[0]);
    (2.0 * half_height.atan()).to_degrees() as f32
}

fn lens(radius: f64) -> Projection {
    Projection::ThinLens {
        vertical_fov: fov(),
        radius: radius as f32,
        focus_distance: FOCUS as f32,
    }
}

/// The share of the unit disc whose x is below this.
fn below(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 + (x * (1.0 - x * x).sqrt() + x.asin()) / PI
}

/// The share of the left color in a pixel: a mean over the pixel's width.
fn left_share(distance: f64, edge: f64, pixel: u32) -> f64 {
    const STEPS: u32 = 400;
    let share = |step: u32| {
        let x = f64::from(pixel) + (f64::from(step) + 0.5) / f64::from(STEPS);
        let slope = (x / f64::from(SIZE[0]) - 0.5) * WIDTH;
        // A ray leaves the lens at o and meets the wall at d s + o (1 - d / f).
        let spread = RADIUS * (1.0 - distance / FOCUS);
        let room = edge - distance * slope;
        if spread.abs() < 1e-9 {
            f64::from(u8::from(room > 0.0))
        } else {
            below(room / spread.abs())
        }
    };
    (0..STEPS).map(share).sum::<f64>() / f64::from(STEPS)
}

/// The largest difference from the closed form, and the number of pixels that see both colors.
fn error(distance: f64, edge: f64, sample_count: u32) -> (f64, usize) {
    let settings = RenderSettings {
        size: SIZE,
        sample_count,
        ..RenderSettings::default()
    };
    let (picture, _) = render(&wall(distance, edge, lens(RADIUS)), &settings);
    let [left, right] = COLORS.each_ref().map(|color| diffuse(color, ambient()));
    let (mut worst, mut mixed) = (0.0f64, 0);
    for (pixel, &found) in (0..).zip(&picture.pixels) {
        let share = left_share(distance, edge, pixel);
        let expected = left * share + right * (1.0 - share);
        worst = worst.max(expected.farthest(found.into()));
        mixed += usize::from(share > 0.0 && share < 1.0);
    }
    (worst, mixed)
}

#[test]
fn edges_blur_by_their_distance_from_the_focus() {
    // The radius of the blur on the wall is 0.1 at half the focus distance, 0 at it, and 0.2 at twice it.
    for (distance, edge, pixels) in [
        (2.0, 0.013, 9..=11),
        (4.0, 0.013, 1..=1),
        (8.0, 0.02, 4..=7),
    ] {
        let [few, many] = [16, 1024].map(|sample_count| error(distance, edge, sample_count));
        println!("at {distance}: {few:?} {many:?}");
        assert!(many.0 < 6e-3 && (few.0 > 3.0 * many.0 || distance == FOCUS));
        assert!(pixels.contains(&many.1), "{many:?}");
    }
}

/// A lens of radius 0 makes the picture of a pinhole, bit for bit.
#[test]
fn a_closed_lens_is_a_pinhole() {
    let settings = RenderSettings {
        size: SIZE,
        sample_count: 16,
        ..RenderSettings::default()
    };
    let pinhole = Projection::Perspective {
        vertical_fov: fov(),
    };
    let picture = |projection| render(&wall(2.0, 0.013, projection), &settings).0;
    assert!(picture(pinhole) == picture(lens(0.0)));
    assert!(picture(pinhole) != picture(lens(0.1)));
}

/// Depth is measured along the view from any point of the lens, so that a wall has one depth.
#[test]
fn depth_does_not_depend_on_the_lens() {
    let settings = RenderSettings {
        size: SIZE,
        sample_count: 64,
        view: slimbvh::View::Depth,
        ..RenderSettings::default()
    };
    let (picture, _) = render(&wall(2.0, 0.013, lens(RADIUS)), &settings);
    let first = Wide::from(picture.pixels[0]);
    let far = picture
        .pixels
        .iter()
        .map(|&pixel| first.farthest(pixel.into()));
    assert!(far.fold(0.0, f64::max) < 1e-2);
}
