//! Groups of lights near each other, and the sets that they share.

use super::facing_target::FacingTarget;
use super::layout::{Layout, Sorting};
use anyhow::Result;
use glam::Vec3;
use slimbvh::reduce::{self, Cull, FacingSet, Plan, PlanRequest, Switches, TreeChoice};
use slimbvh::topology::Topology;
use slimbvh::{Light, RenderSettings, Scene};
use std::sync::Arc;

/// Lights in a square above a scene.
pub struct Rig {
    pub lights: Vec<Light>,
    pub center: [f32; 3],
    /// Distance from the middle to the farthest light.
    pub radius: f32,
    /// Distance from one light to the next.
    pub spacing: f32,
    /// The share of the triangles that the set shared by all lights keeps.
    pub share: f64,
}

/// Height of the lights above the model's middle, in diagonals of its box.
const HEIGHT: f32 = 2.5;

/// Steps of the bisection for the spacing.
const HALVINGS: u32 = 24;

impl Rig {
    /// Places `side * side` lights so far apart that one set for all keeps at least this share of the triangles, as nearly as
    /// the geometry allows.
    pub fn new(scene: &Scene, topology: &Topology, side: u32, share: f64) -> Self {
        let (middle, diagonal) = extent(scene);
        let center = middle + Vec3::new(0.0, HEIGHT * diagonal, 0.0);
        // The set grows with the spacing, and the ball around the lights must not touch the model. The last factor covers
        // rounding, so that each light lies in the ball.
        let reach = |spacing: f32| 0.5 * (side - 1) as f32 * spacing * 2.0f32.sqrt() * 1.000_001;
        let count = scene.mesh.indices.len().max(1) as f64;
        let share_of = |spacing: f32| {
            let target = FacingTarget::ball(center.to_array(), reach(spacing), topology);
            target.count(scene, topology) as f64 / count
        };
        let mut low = 0.0;
        let mut high = (HEIGHT - 0.6) * diagonal / reach(1.0).max(f32::MIN_POSITIVE);
        for _ in 0..HALVINGS {
            let spacing = 0.5 * (low + high);
            if share_of(spacing) < share {
                low = spacing;
            } else {
                high = spacing;
            }
        }
        let spacing = high;
        let place = |i: u32| spacing * (i as f32 - 0.5 * (side - 1) as f32);
        let brightness = 3.0 * (HEIGHT * diagonal).powi(2) / (side * side) as f32;
        let lights = (0..side * side).map(|i| Light::Point {
            position: (center + Vec3::new(place(i % side), 0.0, place(i / side))).to_array(),
            color: [brightness; 3],
            range: f32::INFINITY,
        });
        Self {
            lights: lights.collect(),
            center: center.to_array(),
            radius: reach(spacing),
            spacing,
            share: share_of(spacing),
        }
    }

    /// The set that all lights share.
    pub fn group(&self, topology: &Topology) -> FacingTarget {
        FacingTarget::ball(self.center, self.radius, topology)
    }
}

/// The middle of the model's box, and its diagonal.
pub fn extent(scene: &Scene) -> (Vec3, f32) {
    let bounds = scene.mesh.bounds().unwrap_or(slimbvh::Aabb::EMPTY);
    let middle = 0.5 * bounds.min + 0.5 * bounds.max;
    (middle, (bounds.max - bounds.min).length())
}

/// The plan for one frame of a surveyed scene, in words and as a layout of trees.
pub fn plan(
    scene: &Scene,
    topology: &Arc<Topology>,
    settings: &RenderSettings,
) -> Result<(String, Layout)> {
    let switches = Switches {
        cull: Some(Cull::On),
        ..Switches::default()
    };
    let asked = PlanRequest::of_picture(scene, settings, switches)?;
    let plan = Plan::new(topology, &scene.mesh, &asked);
    let set = |view: &reduce::ViewSet| {
        let is_set = view.choice == TreeChoice::Set;
        is_set.then(|| FacingTarget {
            target: view.target,
            sides: view.sides.clone(),
        })
    };
    // If any light needs the whole tree, it is the last.
    let (camera, lights) = plan.sets.split_at(1);
    let mut shadows: Vec<Option<FacingTarget>> =
        lights.iter().map(set).filter(Option::is_some).collect();
    let sets = shadows.len();
    let mut next = 0..sets;
    let trees: Vec<usize> = lights
        .iter()
        .map(|view| match view.choice {
            TreeChoice::Set => next.next().unwrap_or(sets),
            TreeChoice::Whole | TreeChoice::Unused => sets,
        })
        .collect();
    if trees.contains(&sets) {
        shadows.push(None);
    }
    let camera = camera.first().and_then(set);
    let camera_tree = match &camera {
        Some(_) => "a set",
        None => "the whole tree",
    };
    let name = |view: &reduce::ViewSet| match (view.choice, view.half) {
        (TreeChoice::Set, FacingSet::Front) => format!("a set L+ for {}", view.name()),
        (TreeChoice::Set, FacingSet::Back) => format!("a set L- for {}", view.name()),
        _ => format!("the whole tree for {}", view.name()),
    };
    let names: Vec<String> = lights.iter().map(name).collect();
    let places = plan.set_of_target().into_iter().skip(1).flatten();
    let layout = Layout {
        camera,
        shadows,
        lights: places.map(|place| trees[place - 1]).collect(),
        sorting: Sorting::Once,
    };
    let name = format!("{camera_tree} for the camera, {}", names.join(", "));
    Ok((name, layout))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::generate::icosphere;

    /// The set of a ball of radius 2 under lights is a cap, whose share is known.
    #[test]
    fn the_set_of_all_lights_keeps_the_share_that_is_asked_for() {
        let scene = Scene {
            mesh: icosphere(Vec3::new(1.0, 2.0, 3.0), 2.0, 5),
            ..Scene::default()
        };
        let topology = Topology::new(&scene.mesh);
        for (side, share) in [(2, 0.55), (3, 0.69)] {
            let rig = Rig::new(&scene, &topology, side, share);
            assert!((rig.share - share).abs() < 0.002, "{}", rig.share);
            assert_eq!(rig.lights.len() as u32, side * side);
            let distance = f64::from(rig.center[1] - 2.0);
            // The lengths of normals are upper bounds, up to 13 % too large.
            let cap = |radius: f32| 0.5 * (1.0 - (2.0 - f64::from(radius)) / distance);
            let (least, most) = (cap(rig.radius), cap(1.13 * rig.radius));
            assert!(
                (least - 0.005..most + 0.005).contains(&share),
                "{least} {most}"
            );
            for light in &rig.lights {
                let Light::Point { position, .. } = light else {
                    unreachable!("they are points");
                };
                let away = Vec3::from(*position).distance(Vec3::from(rig.center));
                assert!(away <= rig.radius * 1.000_001);
            }
            // Lights farther apart would keep more.
            let wider = FacingTarget::ball(rig.center, rig.radius * 1.1, &topology);
            let count = wider.count(&scene, &topology);
            assert!(count as f64 / scene.mesh.indices.len() as f64 > share + 0.01);
        }
    }
}
