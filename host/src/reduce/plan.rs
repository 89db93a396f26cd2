//! The plan of a picture: which trees are built.

use super::decide::{self, Candidate};
use super::group::{group, joined_target};
use super::mesh_survey::MeshSurvey;
use super::target::{self, TargetKind, TreeChoice, ViewTarget};
use super::{Cull, PlanRequest, Reduce, Saving};
use crate::topology::Topology;
use crate::{View, ViewError};

/// The most samples in flight together with deferred sets, at 80 bytes each.
const MOST_IN_FLIGHT: u64 = 1 << 22;

/// The trees of a picture, and the reasons for them.
#[derive(Clone, Debug)]
pub struct Plan<'a> {
    /// The surfaces. `None` without a survey; then nothing is left out.
    pub topology: Option<&'a Topology>,
    /// The camera first, then each light once, alone or in a group.
    pub targets: Vec<ViewTarget>,
    /// Whether the whole tree is built.
    pub needs_whole: bool,
    /// Whether rays from mirrors and glass are traced, through the whole tree.
    pub has_mirrors: bool,
    /// The number of triangles in the mesh.
    pub triangle_count: usize,
    /// The caller's setting.
    pub reduce: Reduce,
    /// Whether the only tree is a set, whose triangles are sorted alone.
    pub sorts_alone: bool,
    /// Whether the sets of lights are deferred: each is built just before the rays to its lights are traced.
    pub defers_lights: bool,
    /// Whether a deferred set is built even if its lights reach no point of the picture.
    pub(super) builds_unseen: bool,
    /// Whether L− may replace L+ in the sets of lights.
    pub may_turn_away: bool,
    /// The reason why there was no survey.
    pub(super) no_survey: Option<String>,
}

impl<'a> Plan<'a> {
    /// The plan without a survey, one whole tree in which all triangles count, if the settings ask for it or it is the
    /// better one.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn without_survey(request: &PlanRequest) -> Result<Option<Self>, ViewError> {
        let targets = target::targets(request)?;
        let has_mirrors = has_mirrors(request);
        let switches = request.switches;
        let reason = match (switches.cull, switches.reduce) {
            (Some(Cull::Off), _) => Some("culling is off, so all triangles count".to_owned()),
            (None, Reduce::Off) => Some("reduction is off".to_owned()),
            (None, Reduce::Auto) => decide::decline(request, &candidates(&targets), has_mirrors),
            (Some(Cull::On), _) | (None, Reduce::On) => None,
        };
        match reason {
            Some(reason) => Self::plain(request, reason).map(Some),
            None => Ok(None),
        }
    }

    /// One whole tree in which all triangles count, for this reason.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn plain(request: &PlanRequest, reason: String) -> Result<Self, ViewError> {
        Ok(Self {
            topology: None,
            targets: target::targets(request)?,
            needs_whole: true,
            has_mirrors: has_mirrors(request),
            triangle_count: request.scene.mesh.indices.len(),
            reduce: request.switches.reduce,
            sorts_alone: false,
            defers_lights: false,
            builds_unseen: false,
            may_turn_away: false,
            no_survey: Some(reason),
        })
    }

    /// Decides from the surfaces of the scene's mesh. Which triangles count for which rays does not depend on
    /// [`Switches::reduce`](super::Switches::reduce).
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn new(topology: &'a Topology, request: &PlanRequest) -> Result<Self, ViewError> {
        let mesh = &request.scene.mesh;
        let savings = request.switches.savings;
        let bounds = mesh.bounds().unwrap_or(slimbvh_core::Aabb::EMPTY);
        let has_mirrors = has_mirrors(request);
        let survey = MeshSurvey::new(topology, request.scene, &bounds);

        let mut targets = target::targets(request)?;
        let mut lights = targets.split_off(1);
        for camera in &mut targets {
            if savings.has(Saving::Frustum) {
                camera.frustum = target::frustum_within(request, &bounds)?;
            }
            survey.measure(camera);
        }
        // Shadow rays that start behind mirrors or inside glass have unknown origins, which rules out L−.
        let eye_sides = targets.iter().map(|camera| camera.sides.clone()).next();
        let eye_sides = eye_sides.filter(|_| savings.has(Saving::Away) && !has_mirrors);
        let cost_ms = |view: &ViewTarget| decide::set_cost_ms(&candidate(view), request);
        let measure = |view: &mut ViewTarget| {
            survey.measure(view);
            if let Some(eye_sides) = &eye_sides {
                survey.take_cheaper_set(view, eye_sides, cost_ms);
            }
        };
        for light in &mut lights {
            if light.choice != TreeChoice::Unused {
                measure(light);
            }
        }
        if savings.has(Saving::Groups) {
            let join = |a: &ViewTarget, b: &ViewTarget| {
                let mut lights: Vec<usize> = a.lights.iter().chain(&b.lights).copied().collect();
                lights.sort_unstable();
                let target = joined_target(&a.target, &b.target);
                let mut joined = ViewTarget::new(TargetKind::Lights, lights, target);
                measure(&mut joined);
                // The group must be outside of every component that its members are outside of.
                let outside =
                    |view: &ViewTarget| view.sides.iter().filter(|side| **side != 0).count();
                let is_outside = outside(&joined) == outside(a) && outside(a) == outside(b);
                is_outside.then_some(joined)
            };
            lights = group(lights, join, cost_ms);
        }
        targets.append(&mut lights);

        let mut candidates = candidates(&targets);
        decide::estimate(&mut candidates, request);
        let chosen = decide::choose(&candidates, request, has_mirrors);
        let mut needs_whole = has_mirrors;
        for ((view, candidate), is_set) in targets.iter_mut().zip(&candidates).zip(chosen) {
            view.saving_ms = candidate.saving_ms;
            if view.choice == TreeChoice::Whole && is_set {
                view.choice = TreeChoice::Set;
            }
            needs_whole |= view.choice == TreeChoice::Whole;
        }
        let set_count = targets
            .iter()
            .filter(|view| view.choice == TreeChoice::Set)
            .count();
        let light_sets = targets
            .iter()
            .skip(1)
            .filter(|view| view.choice == TreeChoice::Set);
        let light_set_count = light_sets.count();
        let plan = Self {
            topology: Some(topology),
            targets,
            needs_whole,
            has_mirrors,
            triangle_count: mesh.indices.len(),
            reduce: request.switches.reduce,
            sorts_alone: savings.has(Saving::Alone) && !needs_whole && set_count == 1,
            defers_lights: false,
            builds_unseen: !savings.has(Saving::Unseen),
            may_turn_away: eye_sides.is_some(),
            no_survey: None,
        };
        // Each deferred set is built only once: all samples are in flight, no path continues, and the lights of a set are
        // adjacent.
        let [width, height] = request.settings.size.map(u64::from);
        let samples = width * height * u64::from(request.settings.sample_count);
        let defers_lights = savings.has(Saving::Turns)
            && light_set_count > 1
            && samples <= MOST_IN_FLIGHT
            && !has_mirrors
            && plan.is_in_runs();
        Ok(Self {
            defers_lights,
            ..plan
        })
    }

    /// Whether lights that share a set are adjacent.
    fn is_in_runs(&self) -> bool {
        let mut places = self.target_of_light();
        places.dedup();
        places.len() + 1 == self.targets.len()
    }

    /// Whether all rays go through one whole tree in which all triangles count.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.topology.is_none()
    }

    /// The component of each triangle; `None` without a survey.
    pub(super) fn components(&self) -> Option<&'a [u32]> {
        self.topology.map(Topology::components)
    }

    /// The index among the targets of each light.
    #[must_use]
    pub fn target_of_light(&self) -> Vec<usize> {
        let places = self.targets.iter().enumerate();
        let mut pairs: Vec<(usize, usize)> = places
            .flat_map(|(place, view)| view.lights.iter().map(move |&light| (light, place)))
            .collect();
        pairs.sort_unstable();
        pairs.into_iter().map(|(_, place)| place).collect()
    }
}

/// Whether any path may continue at a mirror or through glass.
fn has_mirrors(request: &PlanRequest) -> bool {
    let mut materials = request.scene.materials.iter();
    let settings = request.settings;
    settings.view == View::Color
        && settings.mirror_depth > 0
        && materials.any(|material| material.mirror > 0.0 || material.transmission > 0.0)
}

/// The rays of each target, as input of the cost model.
fn candidates(targets: &[ViewTarget]) -> Vec<Candidate> {
    targets.iter().map(candidate).collect()
}

fn candidate(view: &ViewTarget) -> Candidate {
    Candidate {
        kind: view.kind,
        effort: view.effort,
        light_count: view.lights.len(),
        is_used: view.choice != TreeChoice::Unused,
        may_be_set: view.may_be_set(),
        share: view.share,
        saving_ms: 0.0,
    }
}
