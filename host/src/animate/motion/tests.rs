//! Motions are periodic.

use super::*;
use crate::Mesh;
use crate::generate::{cuboid, icosphere, smooth_normals, subdivide};
use glam::Vec3;

const COUNT: u32 = 24;

/// A camera, lights of all kinds, and a mesh with normals.
fn scene() -> Scene {
    let mut mesh = subdivide(
        &cuboid(Vec3::new(1.0, 0.0, -1.0), Vec3::new(2.0, 3.0, 4.0)),
        3,
    );
    smooth_normals(&mut mesh);
    let mut scene = Scene {
        mesh,
        lights: vec![
            Light::Directional {
                direction: [0.5, -1.0, 0.25],
                color: [1.0; 3],
            },
            Light::Point {
                position: [4.0, 5.0, 6.0],
                color: [2.0; 3],
                range: 9.0,
            },
            Light::disc([4.0, 5.0, 6.0], [0.6, -0.8, 0.0], 0.5, [2.0; 3]),
        ],
        ..Scene::default()
    };
    scene.complete(scene.mesh.bounds(), [160, 90]);
    scene
}

fn motion(deform: Deform) -> Motion {
    Motion {
        frame_count: COUNT,
        orbit: true,
        orbit_light: true,
        deform: Some(deform),
    }
}

/// All numbers of a frame.
fn numbers(animation: &Animation, scene: &mut Scene, frame: u32) -> Vec<f32> {
    animation.pose(frame, scene);
    let mut numbers = Vec::new();
    let camera = &scene.cameras[0];
    numbers.extend(camera.eye.iter().chain(&camera.target).chain(&camera.up));
    for light in &scene.lights {
        match light {
            Light::Directional { direction: v, .. } | Light::Point { position: v, .. } => {
                numbers.extend(v);
            }
            Light::Area {
                center, half_edges, ..
            } => numbers.extend(center.iter().chain(half_edges.as_flattened())),
        }
    }
    numbers.extend(scene.mesh.vertices.as_flattened());
    numbers.extend(scene.mesh.normals.as_flattened());
    numbers
}

fn largest_step(a: &[f32], b: &[f32]) -> f32 {
    let steps = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    steps.fold(0.0, f32::max)
}

#[test]
fn the_last_frame_leads_on_to_the_first_as_any_to_the_next() {
    for deform in [Deform::Wave, Deform::Twist] {
        let mut scene = scene();
        let animation = Animation::new(&scene, motion(deform));
        let frames: Vec<_> = (0..=COUNT)
            .map(|frame| numbers(&animation, &mut scene, frame))
            .collect();
        assert_eq!(frames[0], frames[COUNT as usize]);
        let steps: Vec<f32> = frames
            .windows(2)
            .map(|pair| largest_step(&pair[0], &pair[1]))
            .collect();
        let last = steps[COUNT as usize - 1];
        let (least, most) = steps[..COUNT as usize - 1]
            .iter()
            .fold((f32::MAX, 0.0), |(a, b): (f32, f32), &x| {
                (a.min(x), b.max(x))
            });
        assert!(
            least > 0.0 && last >= 0.9 * least && last <= 1.1 * most,
            "{steps:?}"
        );
        // No motion repeats after half a period.
        let halfway = COUNT as usize / 2;
        assert!(largest_step(&frames[0], &frames[halfway]) > last);
    }
}

/// A moment is the same by frame and by time, and a time between two frames gives a pose between theirs.
#[test]
fn frames_have_moments_between_them() {
    let mut scene = scene();
    let animation = Animation::new(&scene, motion(Deform::Twist));
    let mut at = |time: f64| {
        animation.pose_at(time, &mut scene);
        let mut numbers = scene.cameras[0].eye.to_vec();
        numbers.extend(scene.mesh.vertices.as_flattened());
        numbers
    };
    let (two, half, three) = (at(2.0), at(2.5), at(3.0));
    let step = largest_step(&two, &three);
    for near in [&two, &three] {
        let part = largest_step(near, &half);
        assert!((0.4 * step..0.6 * step).contains(&part), "{part} of {step}");
    }
    // Motions repeat after each period, also for times before the first frame.
    let round = f64::from(COUNT);
    assert_eq!((at(2.5 + round), at(2.5 - round)), (half.clone(), half));
    animation.pose(2, &mut scene);
    assert_eq!(scene.mesh.vertices.as_flattened(), &two[3..]);
}

#[test]
fn frame_0_is_the_scene_as_it_was() {
    let mut scene = scene();
    let before = scene.clone();
    let animation = Animation::new(&scene, motion(Deform::Twist));
    assert!(animation.pose(0, &mut scene));
    assert_eq!(
        (&scene.cameras, &scene.lights),
        (&before.cameras, &before.lights)
    );
    assert_eq!(scene.mesh.vertices, before.mesh.vertices);
    assert!(
        largest_step(
            scene.mesh.normals.as_flattened(),
            before.mesh.normals.as_flattened()
        ) < 1e-6
    );
}

#[test]
fn the_camera_stays_at_its_distance_and_height() {
    let mut scene = scene();
    let bounds = scene.mesh.bounds().unwrap();
    let center = 0.5 * (bounds.min + bounds.max);
    let eye = |scene: &Scene| Vec3::from(scene.cameras[0].eye) - center;
    let first = eye(&scene);
    let motion = Motion {
        frame_count: 4,
        orbit: true,
        ..Motion::default()
    };
    let animation = Animation::new(&scene, motion);
    let lights = scene.lights.clone();
    for frame in 0..4 {
        assert!(!animation.pose(frame, &mut scene));
        let eye = eye(&scene);
        assert!((eye.length() - first.length()).abs() < 1e-4);
        assert!((eye.y - first.y).abs() < 1e-5);
    }
    // Three quarters of a turn counter-clockwise: the front is now on the left.
    let eye = eye(&scene);
    assert!((eye.x + first.z).abs() < 1e-4 && (eye.z - first.x).abs() < 1e-4);
    assert_eq!(scene.lights, lights);
}

#[test]
fn solids_stay_solid() {
    for deform in [Deform::Wave, Deform::Twist] {
        let mut scene = scene();
        let sphere = icosphere(Vec3::new(-1.0, 2.0, 3.0), 1.5, 4);
        crate::generate::append(&mut scene.mesh, sphere, "sphere", 0);
        let volume = |mesh: &Mesh| {
            let components = crate::generate::checks::assert_solid(mesh);
            components.iter().map(|c| c.signed_volume).sum::<f64>()
        };
        let before = volume(&scene.mesh);
        let animation = Animation::new(&scene, motion(deform));
        for frame in [0, 3, 7, 12, 20] {
            animation.pose(frame, &mut scene);
            crate::generate::checks::assert_unit_normals(&scene.mesh);
            let after = volume(&scene.mesh);
            assert!((0.87 * before..1.13 * before).contains(&after), "{after}");
        }
    }
}

#[test]
fn an_empty_scene_is_posed_but_not_seen() {
    let mut scene = Scene::default();
    let animation = Animation::new(&scene, motion(Deform::Wave));
    assert!(animation.pose(5, &mut scene));
    let checked = animation.check(&RenderSettings::default());
    assert_eq!(checked, Err(ViewError::NoCamera));
}
