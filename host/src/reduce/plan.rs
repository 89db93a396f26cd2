//! The plan of a frame: which trees are built.

use super::decide::{self, Candidate};
use super::group::{group, joined_target};
use super::mesh_survey::{Known, MeshSurvey};
use super::set::{TreeChoice, ViewSet, frustum_within, sets};
use super::target::TargetKind;
use super::{Cull, PlanRequest, Reduce, Saving};
use crate::Mesh;
use crate::topology::Topology;
use slimbvh_core::frustum::Frustum;
use std::fmt;
use std::sync::Arc;

/// The most samples in flight together with deferred sets, at 80 bytes each.
const MOST_IN_FLIGHT: u64 = 1 << 22;

/// The trees of a frame, and the reasons for them.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The surfaces. `None` without a survey; then nothing is left out.
    pub topology: Option<Arc<Topology>>,
    /// Cameras first, then each light once, alone or in a group.
    pub sets: Vec<ViewSet>,
    /// The number of targets.
    pub target_count: usize,
    /// Whether the whole tree is built.
    pub needs_whole: bool,
    /// The names of the targets whose rays go through the whole tree, all triangles counting.
    pub others: Vec<String>,
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

impl Plan {
    /// The plan without a survey, one whole tree in which all triangles count, if the settings ask for it or it is the
    /// better one.
    #[must_use]
    pub fn without_survey(request: &PlanRequest) -> Option<Self> {
        let switches = request.switches;
        let reason = match (switches.cull, switches.reduce) {
            (Some(Cull::Off), _) => "culling is off, so all triangles count".to_owned(),
            (None, Reduce::Off) => "reduction is off".to_owned(),
            (None, Reduce::Auto) => {
                decide::decline(request, &candidates(&sets(&request.views.targets)))?
            }
            (Some(Cull::On), _) | (None, Reduce::On) => return None,
        };
        Some(Self::plain(request, reason))
    }

    /// One whole tree in which all triangles count, for this reason.
    #[must_use]
    pub fn plain(request: &PlanRequest, reason: String) -> Self {
        Self {
            topology: None,
            sets: sets(&request.views.targets),
            target_count: request.views.targets.len(),
            needs_whole: true,
            others: others(request),
            triangle_count: request.triangle_count,
            reduce: request.switches.reduce,
            sorts_alone: false,
            defers_lights: false,
            builds_unseen: false,
            may_turn_away: false,
            no_survey: Some(reason),
        }
    }

    /// Decides from the surfaces of a mesh. Which triangles count for which rays does not depend on
    /// [`Switches::reduce`](super::Switches::reduce).
    #[must_use]
    pub fn new(topology: &Arc<Topology>, mesh: &Mesh, request: &PlanRequest) -> Self {
        Self::knowing(topology, mesh, request, &mut Known::default())
    }

    /// As [`Self::new`], with what is known from the plan before.
    pub(super) fn knowing(
        topology: &Arc<Topology>,
        mesh: &Mesh,
        request: &PlanRequest,
        known: &mut Known,
    ) -> Self {
        let savings = request.switches.savings;
        let bounds = known.bounds(mesh);
        let survey = MeshSurvey::new(topology, mesh, &bounds, known);
        let targets = &request.views.targets;

        let mut sets = sets(targets);
        let is_camera = |set: &ViewSet| set.kind == TargetKind::From;
        let mut lights = sets.split_off(sets.partition_point(is_camera));
        for camera in &mut sets {
            if savings.has(Saving::Frustum) {
                let frustum = camera.targets.first().map(|&place| &targets[place].frustum);
                camera.frustum = frustum_within(frustum.unwrap_or(&Frustum::EVERYWHERE), &bounds);
            }
            survey.measure(camera);
        }
        // L− needs rays that start outside, so the one eye that they start from the hits of must be known.
        let eye_sides = match sets.as_slice() {
            [eye] if savings.has(Saving::Away) => Some(eye.sides.clone()),
            _ => None,
        };
        let cost_ms = |set: &ViewSet| decide::set_cost_ms(&candidate(set), request);
        let measure = |set: &mut ViewSet| {
            survey.measure(set);
            if let Some(eye_sides) = eye_sides.as_ref().filter(|_| set.starts_at_hits) {
                survey.take_cheaper_set(set, eye_sides, cost_ms);
            }
        };
        for light in &mut lights {
            if light.choice != TreeChoice::Unused {
                measure(light);
            }
        }
        // On a GPU all sets of lights are decided alike.
        let may_turn_away = eye_sides.is_some() && lights.iter().all(|light| light.starts_at_hits);
        if savings.has(Saving::Groups) {
            let join = |a: &ViewSet, b: &ViewSet| {
                let mut joined = a.joined(b, joined_target(&a.target, &b.target));
                measure(&mut joined);
                // The group must be outside of every component that its members are outside of.
                let outside = |set: &ViewSet| set.sides.iter().filter(|side| **side != 0).count();
                let is_outside = outside(&joined) == outside(a) && outside(a) == outside(b);
                is_outside.then_some(joined)
            };
            lights = group(lights, join, cost_ms);
        }
        sets.append(&mut lights);

        let mut candidates = candidates(&sets);
        decide::estimate(&mut candidates, request);
        let chosen = decide::choose(&candidates, request);
        let has_others = request.views.has_others();
        let mut needs_whole = has_others;
        for ((set, candidate), is_set) in sets.iter_mut().zip(&candidates).zip(chosen) {
            set.saving_ms = candidate.saving_ms;
            if set.choice == TreeChoice::Whole && is_set {
                set.choice = TreeChoice::Set;
            }
            needs_whole |= set.choice == TreeChoice::Whole;
        }
        let is_built = |set: &&ViewSet| set.choice == TreeChoice::Set;
        let set_count = sets.iter().filter(is_built).count();
        let light_set_count = sets
            .iter()
            .filter(|set| !is_camera(set))
            .filter(is_built)
            .count();
        let plan = Self {
            topology: Some(Arc::clone(topology)),
            sets,
            target_count: targets.len(),
            needs_whole,
            others: others(request),
            triangle_count: request.triangle_count,
            reduce: request.switches.reduce,
            sorts_alone: savings.has(Saving::Alone) && !needs_whole && set_count == 1,
            defers_lights: false,
            builds_unseen: !savings.has(Saving::Unseen),
            may_turn_away,
            no_survey: None,
        };
        // Each deferred set is built only once: all samples are in flight, no path continues, and the lights of a set are
        // adjacent.
        let samples = request.views.samples;
        let defers_lights = savings.has(Saving::Turns)
            && light_set_count > 1
            && samples.is_some_and(|samples| samples <= MOST_IN_FLIGHT)
            && !has_others
            && plan.is_in_runs();
        Self {
            defers_lights,
            ..plan
        }
    }

    /// Whether lights that share a set are adjacent.
    fn is_in_runs(&self) -> bool {
        let mut places = self.set_of_target();
        places.dedup();
        places.len() == self.sets.len()
    }

    /// Whether all rays go through one whole tree in which all triangles count.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.topology.is_none()
    }

    /// The component of each triangle; `None` without a survey.
    pub(super) fn components(&self) -> Option<&[u32]> {
        self.topology.as_deref().map(Topology::components)
    }

    /// The number of lights of a picture, whose targets are a camera, the lights, and other rays.
    pub(crate) fn light_count(&self) -> usize {
        self.target_count.saturating_sub(1 + self.others.len())
    }

    /// For each target the index of its set among the sets; `None` for other rays, which go through the whole tree.
    #[must_use]
    pub fn set_of_target(&self) -> Vec<Option<usize>> {
        let mut all = vec![None; self.target_count];
        for (place, set) in self.sets.iter().enumerate() {
            for &target in &set.targets {
                all[target] = Some(place);
            }
        }
        all
    }
}

/// The decisions, one a line.
impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, (about, text)) in self.explain().iter().enumerate() {
            let end = if i == 0 { "" } else { "\n" };
            write!(f, "{end}{about}: {text}")?;
        }
        Ok(())
    }
}

/// The names of the targets that need the whole tree.
fn others(request: &PlanRequest) -> Vec<String> {
    let targets = request.views.targets.iter();
    let others = targets.filter(|target| target.kind == TargetKind::Other && target.is_used);
    let name = |name: &Option<String>| name.clone().unwrap_or_else(|| "other rays".to_owned());
    others.map(|target| name(&target.name)).collect()
}

/// The rays of each set, as input of the cost model.
fn candidates(sets: &[ViewSet]) -> Vec<Candidate> {
    sets.iter().map(candidate).collect()
}

fn candidate(set: &ViewSet) -> Candidate {
    Candidate {
        kind: set.kind,
        effort: set.effort,
        ray_count: set.ray_count,
        is_used: set.choice != TreeChoice::Unused,
        may_be_set: set.may_be_set(),
        share: set.share,
        saving_ms: 0.0,
    }
}
