//! Scenes in which savings matter: one model with different cameras and lights.

use super::Saved;
use crate::reproduce::lights::{Rig, extent};
use crate::reproduce::printed;
use crate::reproduce::scenes::Subject;
use glam::Vec3;
use slimbvh::reduce::Saving;
use slimbvh::{Light, Scene};

/// A scene with a short description.
pub struct Stage {
    pub words: &'static str,
    pub scene: Scene,
}

/// The distance of a close camera, as a share of that of one that sees the whole model.
const CLOSE: f32 = 0.4;

/// The number of lights around the model.
const AROUND: u32 = 64;

/// Distance from the model's middle to each of these lights, in diagonals of its box. The model reaches at most half a diagonal.
const DISTANCE: f32 = 0.75;

/// The part of the circle with lights: the last is not next to the first.
const ARC: f32 = 0.75;

impl Stage {
    /// The scene in which this saving matters.
    pub fn new(saved: Saved, subject: &Subject) -> Self {
        let whole = &subject.scene;
        let with = |words: &'static str, lights: Vec<Light>| Self {
            words,
            scene: Scene {
                lights,
                ..whole.clone()
            },
        };
        let first = || whole.lights.iter().take(1).copied();
        match saved {
            Saved::Plan(Saving::Frustum) => {
                let mut stage = with("seen from close by, no light", Vec::new());
                for camera in &mut stage.scene.cameras {
                    let (eye, target) = (Vec3::from(camera.eye), Vec3::from(camera.target));
                    camera.eye = (target + CLOSE * (eye - target)).to_array();
                }
                stage
            }
            Saved::Plan(Saving::Away) => with("one light", first().collect()),
            Saved::Plan(Saving::Groups) => {
                let rig = Rig::new(whole, &subject.topology, 3, printed::group_share(9));
                with("9 lights near each other", rig.lights)
            }
            Saved::Plan(Saving::Turns) => with("64 lights around it", around(whole)),
            Saved::Plan(Saving::Unseen) => {
                let lights = first().chain([out_of_reach(whole)]);
                with("two lights, one out of reach", lights.collect())
            }
            Saved::Plan(Saving::Alone) => with("no light", Vec::new()),
            Saved::DarkRays => with("one light behind it", vec![behind(whole)]),
        }
    }
}

/// Lights on a part of a circle around the model, level with its middle.
fn around(scene: &Scene) -> Vec<Light> {
    let (middle, diagonal) = extent(scene);
    let radius = DISTANCE * diagonal;
    let brightness = 3.0 * radius * radius / AROUND as f32;
    let light = |i: u32| {
        let turn = ARC * (i as f32 / (AROUND - 1) as f32 - 0.5);
        let (sine, cosine) = (std::f32::consts::TAU * turn).sin_cos();
        Light::Point {
            position: (middle + radius * Vec3::new(sine, 0.0, cosine)).to_array(),
            color: [brightness; 3],
            range: f32::INFINITY,
        }
    };
    (0..AROUND).map(light).collect()
}

/// A light on the far side of the model, seen from the first camera.
fn behind(scene: &Scene) -> Light {
    let (middle, diagonal) = extent(scene);
    let eye = scene
        .cameras
        .first()
        .map_or(middle, |camera| camera.eye.into());
    let away = (middle - eye).normalize_or(Vec3::NEG_Z);
    Light::Point {
        position: (middle + 1.5 * diagonal * away).to_array(),
        color: [3.0 * diagonal * diagonal; 3],
        range: f32::INFINITY,
    }
}

/// A light below the model, whose range ends before it.
fn out_of_reach(scene: &Scene) -> Light {
    let (middle, diagonal) = extent(scene);
    Light::Point {
        position: (middle - Vec3::new(0.0, 1.5 * diagonal, 0.0)).to_array(),
        color: [diagonal * diagonal; 3],
        range: 0.5 * diagonal,
    }
}
