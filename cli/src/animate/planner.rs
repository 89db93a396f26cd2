//! What each frame's trees may leave out.

use crate::reduce::ReduceArguments;
use anyhow::Result;
use slimbvh::reduce::{Asked, Plan, Reduce, Saving, Seams, Survey, survey};
use slimbvh::{BuildConfig, MeshCodec, RenderSettings, Scene};
use std::time::Duration;

/// What stays as it is from frame to frame.
#[derive(Clone, Copy, Debug)]
pub struct Still {
    pub vertices: bool,
    pub lights: bool,
}

/// Plans frame by frame, with one survey for all.
pub struct Planner<'a> {
    reduce: &'a ReduceArguments,
    settings: RenderSettings,
    still: Still,
    picture_count: u32,
    survey: Option<Survey>,
    /// Whether triangles are not those that a set would be decided for.
    moves_triangles: bool,
}

impl<'a> Planner<'a> {
    /// Surveys the scene where so many pictures make that worth it.
    pub fn new(
        reduce: &'a ReduceArguments,
        scene: &Scene,
        (settings, config): (RenderSettings, BuildConfig),
        picture_count: u32,
        still: Still,
    ) -> Result<Self> {
        let mut planner = Self {
            reduce,
            settings,
            still,
            picture_count,
            survey: None,
            moves_triangles: config.mesh == MeshCodec::Leaf10,
        };
        let asked = planner.asked(scene);
        if planner.plain(scene)?.is_none() {
            let seams = asked.switches.seams;
            planner.survey = Some(survey(&scene.mesh, config, seams)?);
        }
        Ok(planner)
    }

    /// What the survey took.
    pub fn survey_time(&self) -> Duration {
        let stages = self.survey.as_ref().map(|survey| survey.stages.total());
        stages.unwrap_or_default()
    }

    /// Follows vertices that have moved.
    pub fn follow(&mut self, scene: &Scene) {
        if let Some(survey) = &mut self.survey {
            survey.topology.update(&scene.mesh);
        }
    }

    /// The plan for the scene as it is.
    pub fn plan(&self, scene: &Scene) -> Result<Plan<'_>> {
        match (&self.survey, self.plain(scene)?) {
            (Some(survey), _) => Ok(Plan::new(&survey.topology, &self.asked(scene))?),
            (None, Some(plain)) => Ok(plain),
            (None, None) => unreachable!("without a survey the plan is plain"),
        }
    }

    /// The plan that needs no survey, if that is the one.
    fn plain(&self, scene: &Scene) -> Result<Option<Plan<'static>>> {
        let asked = self.asked(scene);
        if !self.still.vertices && asked.switches.seams == Seams::Find {
            let reason = "what bends may come to cut itself; --solid promises that it does not";
            return Ok(Some(Plan::plain(&asked, reason.to_owned())?));
        }
        Ok(Plan::without_survey(&asked)?)
    }

    fn asked<'b>(&'b self, scene: &'b Scene) -> Asked<'b> {
        let mut asked = self.reduce.asked(scene, &self.settings);
        asked.frame_count = self.picture_count;
        if self.moves_triangles {
            asked.switches.reduce = Reduce::Off;
        }
        // What is to be kept for the next frame needs a place of its own, and an order of all triangles.
        let savings = &mut asked.switches.savings;
        if self.still.vertices {
            *savings = savings.without(Saving::Alone);
            if self.still.lights {
                *savings = savings.without(Saving::Turns);
            }
        }
        asked
    }

    /// Whether the arguments ask for sets that bending vertices rule out.
    pub fn is_refused(&self, scene: &Scene) -> bool {
        let asked = self.asked(scene);
        let switches = asked.switches;
        !self.still.vertices && switches.seams == Seams::Find && switches.reduce == Reduce::On
    }
}
