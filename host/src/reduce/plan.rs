//! What is built for a picture.

use super::decide::{self, Candidate};
use super::group::{group, joined_target};
use super::mesh_survey::MeshSurvey;
use super::target::{self, TargetKind, TreeChoice, ViewTarget};
use super::{Cull, PlanRequest, Reduce, Saving};
use crate::topology::Topology;
use crate::{View, ViewError};

/// The most samples in flight at once with deferred sets, 80 bytes each.
const MOST_IN_FLIGHT: u64 = 1 << 22;

/// What is built for a picture, and why.
#[derive(Clone, Debug)]
pub struct Plan<'a> {
    /// The surfaces; none without a survey, and then nothing is left out.
    pub topology: Option<&'a Topology>,
    /// The camera, then the lights, each once, alone or with others.
    pub targets: Vec<ViewTarget>,
    /// Whether the whole tree is built.
    pub needs_whole: bool,
    /// Whether rays from mirrors and glass are traced, through the whole tree.
    pub has_mirrors: bool,
    /// How many triangles the mesh has.
    pub triangle_count: usize,
    /// What the caller wanted.
    pub reduce: Reduce,
    /// Whether there is one tree, a set, whose triangles are sorted alone.
    pub sorts_alone: bool,
    /// Whether the sets of lights are deferred: each is built when the rays to its lights are traced.
    pub defers_lights: bool,
    /// Whether a deferred set is built even where its lights reach nothing.
    pub(super) builds_unseen: bool,
    /// Whether L− may stand for L+ in the sets of lights, where the eye is outside.
    pub may_turn_away: bool,
    /// Why there was no survey.
    pub(super) no_survey: Option<String>,
}

impl<'a> Plan<'a> {
    /// The plan that needs no survey, where that is the better one or asked for: one whole tree, where all triangles count.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
    pub fn without_survey(request: &PlanRequest) -> Result<Option<Self>, ViewError> {
        let targets = target::targets(request)?;
        let has_mirrors = has_mirrors(request);
        let switches = request.switches;
        let reason = match (switches.cull, switches.reduce) {
            (Some(Cull::Off), _) => Some("all triangles were asked to count".to_owned()),
            (None, Reduce::Off) => Some("nobody asked for it".to_owned()),
            (None, Reduce::Auto) => decide::decline(request, &candidates(&targets), has_mirrors),
            (Some(Cull::On), _) | (None, Reduce::On) => None,
        };
        match reason {
            Some(reason) => Self::plain(request, reason).map(Some),
            None => Ok(None),
        }
    }

    /// One whole tree, where all triangles count, for this reason.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
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

    /// Decides, knowing the surfaces of the scene's mesh. What counts for which rays does not depend on
    /// [`Switches::reduce`](super::Switches::reduce).
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
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
        // Behind mirrors and inside of glass, the origins of shadow rays are not known.
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
                // Outside of all that each of them is outside of.
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
        // Each deferred set is built once: all samples are in flight, no path goes on, and no light comes between two that
        // share a set.
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

    /// Whether lights that share a set follow each other.
    fn is_in_runs(&self) -> bool {
        let mut places = self.target_of_light();
        places.dedup();
        places.len() + 1 == self.targets.len()
    }

    /// Whether everything is traced through one whole tree in which all triangles count.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.topology.is_none()
    }

    /// The component of each triangle; none without a survey.
    pub(super) fn components(&self) -> Option<&'a [u32]> {
        self.topology.map(Topology::components)
    }

    /// The place among the targets of each light.
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

/// Whether any path may go on, at a mirror or through glass.
fn has_mirrors(request: &PlanRequest) -> bool {
    let mut materials = request.scene.materials.iter();
    let settings = request.settings;
    settings.view == View::Color
        && settings.mirror_depth > 0
        && materials.any(|material| material.mirror > 0.0 || material.transmission > 0.0)
}

/// The rays that there are, for the model of costs.
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
