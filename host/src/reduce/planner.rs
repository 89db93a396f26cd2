//! Plans from frame to frame, with one survey for all.

use super::{Plan, PlanRequest, Reduce, Saving, Seams, Survey, Switches, survey};
use crate::{BuildConfig, Mesh, MeshError, RenderSettings, Scene, ViewError};

/// What does not change from frame to frame, so that trees can be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Still {
    /// No vertex moves.
    pub vertices: bool,
    /// No light moves.
    pub lights: bool,
}

/// How frames are planned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanConfig {
    /// The caller's settings.
    pub switches: Switches,
    /// The number of frames that share a survey.
    pub frame_count: u32,
    /// What does not change from frame to frame; `None` if each frame is built anew.
    pub still: Option<Still>,
}

impl Default for PlanConfig {
    /// A single frame of a scene.
    fn default() -> Self {
        Self {
            switches: Switches::default(),
            frame_count: 1,
            still: None,
        }
    }
}

impl PlanConfig {
    /// Whether it asks for sets although vertices deform: a deforming mesh may come to intersect itself.
    #[must_use]
    pub fn is_refused(&self) -> bool {
        self.must_stay_plain() && self.switches.reduce == Reduce::On
    }

    fn must_stay_plain(&self) -> bool {
        let bends = self.still.is_some_and(|still| !still.vertices);
        bends && self.switches.seams == Seams::Find
    }
}

/// Plans from frame to frame, with one survey for all.
#[derive(Debug, Default)]
pub struct Planner {
    config: PlanConfig,
    build: BuildConfig,
    survey: Option<Survey>,
}

impl Planner {
    /// A planner without a survey: all plans are plain until there is one.
    #[must_use]
    pub fn new(build: BuildConfig, config: PlanConfig) -> Self {
        Self {
            config,
            build,
            survey: None,
        }
    }

    /// Surveys the scene's mesh, if that is likely to pay or the settings ask for it. Replaces the previous survey. Returns
    /// the survey.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`], and for cameras and lights that cannot be rendered.
    pub fn survey<E: From<MeshError> + From<ViewError>>(
        &mut self,
        scene: &Scene,
        settings: &RenderSettings,
    ) -> Result<Option<&Survey>, E> {
        self.survey = None;
        if self.plain(scene, settings)?.is_none() {
            let seams = self.config.switches.seams;
            self.survey = Some(survey(&scene.mesh, self.build, seams)?);
        }
        Ok(self.survey.as_ref())
    }

    /// The latest survey.
    #[must_use]
    pub fn surveyed(&self) -> Option<&Survey> {
        self.survey.as_ref()
    }

    /// Updates the survey for vertices that have moved.
    pub fn follow(&mut self, mesh: &Mesh) {
        if let Some(survey) = &mut self.survey {
            survey.topology.update(mesh);
        }
    }

    /// The plan for the scene in its present state; a plain one without a survey.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn plan(&self, scene: &Scene, settings: &RenderSettings) -> Result<Plan<'_>, ViewError> {
        if let Some(survey) = &self.survey {
            return Plan::new(&survey.topology, &self.request(scene, settings));
        }
        match self.plain(scene, settings)? {
            Some(plain) => Ok(plain),
            None => Plan::plain(
                &self.request(scene, settings),
                "the surfaces were not surveyed".to_owned(),
            ),
        }
    }

    /// The plan without a survey, if that is the better one.
    fn plain(
        &self,
        scene: &Scene,
        settings: &RenderSettings,
    ) -> Result<Option<Plan<'static>>, ViewError> {
        let request = self.request(scene, settings);
        if self.config.must_stay_plain() {
            let reason =
                "a deforming mesh may come to intersect itself; --solid promises that it does not";
            return Plan::plain(&request, reason.to_owned()).map(Some);
        }
        Plan::without_survey(&request)
    }

    fn request<'a>(&self, scene: &'a Scene, settings: &'a RenderSettings) -> PlanRequest<'a> {
        let PlanConfig {
            mut switches,
            frame_count,
            still,
        } = self.config;
        // The codec moves triangles, so a set decided for the mesh's triangles would be wrong.
        if self.build.mesh.moves_vertices() {
            switches.reduce = Reduce::Off;
        }
        // Trees kept for the next frame need separate memory and an order of all triangles.
        let savings = &mut switches.savings;
        if let Some(still) = still.filter(|still| still.vertices) {
            *savings = savings.without(Saving::Alone);
            if still.lights {
                *savings = savings.without(Saving::Turns);
            }
        }
        PlanRequest {
            scene,
            settings,
            switches,
            frame_count,
        }
    }
}
