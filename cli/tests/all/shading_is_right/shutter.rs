//! An object that moves while the shutter is open leaves a streak that holds all of its light.

use super::{render, settings};
use glam::Vec3;
use slimbvh::animate::{Animation, Motion, Shutter};
use slimbvh::generate::{append, icosphere};
use slimbvh::{Camera, Light, Picture, PictureMean, Projection, Scene};

const SIZE: [u32; 2] = [120, 40];

/// Two balls before a uniform sky under ambient light. They move as the camera orbits.
fn scene() -> Scene {
    let mut mesh = icosphere(Vec3::new(1.0, 0.0, 0.0), 0.1, 3);
    append(
        &mut mesh,
        icosphere(Vec3::new(-1.0, 0.0, 0.0), 0.1, 3),
        "ball",
        0,
    );
    Scene {
        mesh,
        cameras: vec![Camera {
            eye: [0.0, 0.0, 5.0],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Orthographic { height: 0.8 },
        }],
        lights: vec![Light::Directional {
            direction: [0.0, -1.0, 0.0],
            color: [0.0; 3],
        }],
        ..Scene::default()
    }
}

/// Frame 3 of 24: an eighth of the orbit.
fn frame(shutter: Shutter) -> Picture {
    let mut scene = scene();
    let motion = Motion {
        frame_count: 24,
        orbit: true,
        ..Motion::default()
    };
    let animation = Animation::new(&scene, motion);
    let mut mean = PictureMean::new();
    for time in shutter.times(3) {
        animation.pose_at(time, &mut scene);
        mean.add(&render(&scene, &settings(SIZE)).0);
    }
    mean.take()
}

/// How a picture differs from its sky in the red channel: the sum, the number of pixels that differ, and the maximum.
fn light_in(picture: &Picture) -> (f64, usize, f64) {
    let sky = f64::from(picture.pixels[0][0]);
    let more: Vec<f64> = picture
        .pixels
        .iter()
        .map(|pixel| sky - f64::from(pixel[0]))
        .collect();
    let lit = more.iter().filter(|more| more.abs() > 1e-6).count();
    (
        more.iter().sum(),
        lit,
        more.iter().copied().fold(0.0, f64::max),
    )
}

#[test]
fn a_streak_has_all_the_light_of_what_made_it() {
    let sharp = light_in(&frame(Shutter::default()));
    let shutter = Shutter {
        share: 1.0,
        time_count: 16,
    };
    let streak = light_in(&frame(shutter));
    println!("{sharp:?} {streak:?}");
    // Each pixel has one sample: the number of pixels that the balls cover varies by a few.
    assert!((streak.0 / sharp.0 - 1.0).abs() < 0.02);
    assert!(streak.1 as f64 > 1.5 * sharp.1 as f64);
    // A ball covers a pixel of the streak for only part of the time.
    assert!(sharp.2 > 0.0 && streak.2 <= sharp.2 * (1.0 + 1e-6));
    let full = |picture: &Picture, most: f64| {
        let sky = f64::from(picture.pixels[0][0]);
        let pixels = picture.pixels.iter();
        pixels
            .filter(|pixel| sky - f64::from(pixel[0]) > 0.99 * most)
            .count()
    };
    assert!(full(&frame(shutter), sharp.2) < sharp.1 / 2);
}

/// A shutter that closes at once makes all times equal, and their mean is the sharp picture, bit for bit.
#[test]
fn equal_times_make_the_picture_of_one() {
    let sharp = frame(Shutter::default());
    for time_count in [2, 3, 7] {
        let shutter = Shutter {
            share: 0.0,
            time_count,
        };
        assert!(frame(shutter) == sharp);
    }
    let open = Shutter {
        share: 0.25,
        time_count: 3,
    };
    assert!(frame(open) != sharp);
    // `pose`, which knows no shutter, makes the same picture.
    let mut scene = scene();
    let motion = Motion {
        frame_count: 24,
        orbit: true,
        ..Motion::default()
    };
    Animation::new(&scene, motion).pose(3, &mut scene);
    assert!(render(&scene, &settings(SIZE)).0 == sharp);
}
