//! A scene made ready for a setup.

use super::setup::{Lights, Setup, Update};
use crate::stress::{Moves, snapped};
use slimbvh::animate::{Animation, Deform, Motion};
use slimbvh::reduce::{PlanConfig, Saving, Savings, Switches};
use slimbvh::{BuildConfig, RenderSettings, Scene};
use std::borrow::Cow;

/// All that a picture with a setup is made from.
pub struct Prepared<'a> {
    pub setup: Setup,
    /// Its vertices moved onto the lattice, where there is one.
    pub scene: Cow<'a, Scene>,
    /// The same with its mesh twisted, where the tree is refitted from there.
    pub twisted: Option<Scene>,
    pub config: BuildConfig,
    pub settings: RenderSettings,
    /// How far the lattice moved vertices.
    pub moves: Moves,
}

/// The mesh that trees are refitted from is twisted by a small share of a turn.
const TWIST: Motion = Motion {
    frame_count: 64,
    orbit: false,
    orbit_light: false,
    deform: Some(Deform::Twist),
};

impl<'a> Prepared<'a> {
    pub fn new(setup: Setup, scene: &'a Scene, settings: RenderSettings) -> Self {
        let config = setup.config(scene);
        let mut own = Cow::Borrowed(scene);
        let mut moves = Moves::default();
        let snap = |scene: &mut Scene| {
            if let Some(step_exponent) = config.mesh.step_exponent() {
                scene.mesh.snap(step_exponent);
            }
        };
        if let Some(step_exponent) = config.mesh.step_exponent() {
            snap(own.to_mut());
            let (before, after) = (&scene.mesh.vertices, &own.mesh.vertices);
            moves = snapped(before, after, step_exponent);
        }
        let twisted = (setup.update == Update::Refit).then(|| {
            let mut twisted = scene.clone();
            Animation::new(scene, TWIST).pose(1, &mut twisted);
            snap(&mut twisted);
            twisted
        });
        Self {
            setup,
            scene: own,
            twisted,
            config,
            settings,
            moves,
        }
    }

    /// How its frames are planned.
    pub fn plan_config(&self, savings: Savings) -> PlanConfig {
        PlanConfig {
            switches: Switches {
                reduce: self.setup.reduce,
                savings: match self.setup.lights {
                    Lights::Grouped => savings,
                    Lights::Apart => savings.without(Saving::Groups),
                },
                ..Switches::default()
            },
            ..PlanConfig::default()
        }
    }
}
