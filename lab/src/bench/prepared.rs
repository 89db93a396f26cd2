//! A scene prepared for a setup.

use super::setup::{Lights, Setup, Update};
use crate::stress::{Moves, snapped};
use anyhow::Result;
use slimbvh::animate::{Animation, Deform, Motion};
use slimbvh::reduce::{Plan, PlanConfig, Planner, Saving, Savings, Switches, Views};
use slimbvh::{BuildConfig, RenderSettings, Scene};
use std::borrow::Cow;

/// The inputs of a picture with a setup.
pub struct Prepared<'a> {
    pub setup: Setup,
    /// The scene, with vertices on the lattice if the setup has one.
    pub scene: Cow<'a, Scene>,
    /// The scene with a twisted mesh, if the setup refits: its tree is built here first.
    pub twisted: Option<Scene>,
    pub config: BuildConfig,
    pub settings: RenderSettings,
    /// Distances by which the lattice moved vertices.
    pub moves: Moves,
}

/// A refit starts from a mesh that is twisted by a small share of a turn.
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

    /// The plan of the picture with these savings, after a survey if that is likely to pay.
    pub fn plan(&self, savings: Savings) -> Result<Plan> {
        let mesh = &self.scene.mesh;
        let mut planner = Planner::new(self.config, self.plan_config(savings));
        let views = Views::of_picture(&self.scene, &self.settings)?;
        planner.survey(mesh, &views)?;
        Ok(planner.plan(mesh, &views))
    }

    /// The settings of the plan, with these savings.
    fn plan_config(&self, savings: Savings) -> PlanConfig {
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
