//! Plans from frame to frame, with one survey for all.

use super::mesh_survey::Known;
use super::{Plan, PlanRequest, Reduce, Saving, Seams, Survey, Switches, Views, survey};
use crate::{BuildConfig, Mesh, MeshError};
use std::sync::Arc;

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
    /// Whether vertices have moved since the survey.
    has_moved: bool,
    /// What the latest plan found, while no vertex moves.
    known: Known,
}

impl Planner {
    /// A planner without a survey: all plans are plain until there is one.
    #[must_use]
    pub fn new(build: BuildConfig, config: PlanConfig) -> Self {
        Self {
            config,
            build,
            survey: None,
            has_moved: false,
            known: Known::default(),
        }
    }

    /// Whether a survey of a mesh with this many triangles is likely to pay for these targets, or the settings ask for it.
    #[must_use]
    pub fn wants_survey(&self, triangle_count: usize, views: &Views) -> bool {
        let request = self.request(triangle_count, views);
        !self.must_stay_plain() && Plan::without_survey(&request).is_none()
    }

    /// Surveys the mesh, if that is likely to pay for these targets or the settings ask for it. Replaces the previous survey.
    /// Returns the survey.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn survey(&mut self, mesh: &Mesh, views: &Views) -> Result<Option<&Survey>, MeshError> {
        self.forget();
        if self.wants_survey(mesh.indices.len(), views) {
            let seams = self.config.switches.seams;
            self.survey = Some(survey(mesh, self.build, seams)?);
        }
        Ok(self.survey.as_ref())
    }

    /// Drops the survey: the mesh is another one.
    pub fn forget(&mut self) {
        self.survey = None;
        self.has_moved = false;
        self.known = Known::default();
    }

    /// The latest survey.
    #[must_use]
    pub fn surveyed(&self) -> Option<&Survey> {
        self.survey.as_ref()
    }

    /// Notes that vertices have moved. Unless the caller promises that no closed part comes to intersect itself
    /// ([`Seams::None`]), nothing is left out from now on until the next survey.
    pub fn moved(&mut self) {
        self.has_moved = true;
        self.known.forget_bounds();
    }

    /// Updates the survey for vertices that have moved ([`Self::moved`]).
    pub fn follow(&mut self, mesh: &Mesh) {
        self.moved();
        let is_used = !self.must_stay_plain();
        self.known = Known::default();
        if let Some(survey) = self.survey.as_mut().filter(|_| is_used) {
            Arc::make_mut(&mut survey.topology).update(mesh);
        }
    }

    /// The plan for the mesh in its present state; a plain one without a survey.
    #[must_use]
    pub fn plan(&mut self, mesh: &Mesh, views: &Views) -> Plan {
        let request = self.request(mesh.indices.len(), views);
        let is_plain = self.must_stay_plain();
        match &self.survey {
            Some(survey) if !is_plain => {
                Plan::knowing(&survey.topology, mesh, &request, &mut self.known)
            }
            _ => self.plain(mesh.indices.len(), views),
        }
    }

    /// The plan without a survey.
    #[must_use]
    pub fn plain(&self, triangle_count: usize, views: &Views) -> Plan {
        let request = self.request(triangle_count, views);
        if self.must_stay_plain() {
            let reason = "a deforming mesh may come to intersect itself, and nothing promises that it does not (Seams::None, --solid)";
            return Plan::plain(&request, reason.to_owned());
        }
        Plan::without_survey(&request)
            .unwrap_or_else(|| Plan::plain(&request, "the surfaces were not surveyed".to_owned()))
    }

    fn must_stay_plain(&self) -> bool {
        let has_moved = self.has_moved && self.config.switches.seams == Seams::Find;
        has_moved || self.config.must_stay_plain()
    }

    fn request(&self, triangle_count: usize, views: &Views) -> PlanRequest {
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
            triangle_count,
            views: views.clone(),
            switches,
            frame_count,
        }
    }
}
