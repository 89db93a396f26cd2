//! What is built for a picture.

use super::decide::{self, Candidate};
use super::group::{group, joined_target};
use super::sample::Samples;
use super::target::{self, FacingSet, TargetKind, TreeChoice, ViewTarget};
use super::{Costs, Cull, PlanRequest, Reduce, Saving};
use crate::topology::{Facts, Topology};
use crate::{View, ViewError};
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;

/// Samples that may be in flight at once for sets in turn, 80 bytes each.
const MOST_IN_TURN: u64 = 1 << 22;

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
    /// Whether the sets of lights are built in turn, each when the rays to its lights are traced.
    pub in_turn: bool,
    /// Whether a set is built in its turn even where its lights reach nothing.
    pub(super) builds_unseen: bool,
    /// Whether sets for lights may hold what faces away from them, where the eye is outside.
    pub may_turn_away: bool,
    /// Why there was no survey.
    pub(super) no_survey: Option<String>,
}

impl<'a> Plan<'a> {
    /// The plan that needs no survey, where that is the better one or asked for: one whole tree, where all triangles count.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
    pub fn without_survey(asked: &PlanRequest) -> Result<Option<Self>, ViewError> {
        let aims = target::aims(asked)?;
        let has_mirrors = has_mirrors(asked);
        let switches = asked.switches;
        let reason = match (switches.cull, switches.reduce) {
            (Some(Cull::Off), _) => Some("all triangles were asked to count".to_owned()),
            (None, Reduce::Off) => Some("nobody asked for it".to_owned()),
            (None, Reduce::Auto) => decide::decline(asked, &candidates(&aims), has_mirrors),
            (Some(Cull::On), _) | (None, Reduce::On) => None,
        };
        match reason {
            Some(reason) => Self::plain(asked, reason).map(Some),
            None => Ok(None),
        }
    }

    /// One whole tree, where all triangles count, for this reason.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
    pub fn plain(asked: &PlanRequest, reason: String) -> Result<Self, ViewError> {
        Ok(Self {
            topology: None,
            targets: target::aims(asked)?,
            needs_whole: true,
            has_mirrors: has_mirrors(asked),
            triangle_count: asked.scene.mesh.indices.len(),
            reduce: asked.switches.reduce,
            sorts_alone: false,
            in_turn: false,
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
    pub fn new(topology: &'a Topology, asked: &PlanRequest) -> Result<Self, ViewError> {
        let mesh = &asked.scene.mesh;
        let savings = asked.switches.savings;
        let bounds = mesh.bounds().unwrap_or(slimbvh_core::Aabb::EMPTY);
        let scale = PowerOfTwo::new(scene_exponent(&bounds));
        let has_mirrors = has_mirrors(asked);
        let look = MeshSurvey {
            topology,
            facts: topology.facts(),
            samples: Samples::new(asked.scene, topology.components(), scale),
        };

        let mut aims = target::aims(asked)?;
        let mut lights = aims.split_off(1);
        for camera in &mut aims {
            if savings.has(Saving::Frustum) {
                camera.frustum = target::frustum_within(asked, &bounds)?;
            }
            look.measure(camera);
        }
        // Where paths leave mirrors, or are inside of glass, nobody knows from where shadow rays start.
        let eye_sides = aims.iter().map(|camera| camera.sides.clone()).next();
        let eye_sides = eye_sides.filter(|_| savings.has(Saving::Away) && !has_mirrors);
        let cost_ms = |aim: &ViewTarget| decide::set_cost_ms(&candidate(aim), asked);
        let measure = |aim: &mut ViewTarget| {
            look.measure(aim);
            if let Some(eye_sides) = &eye_sides {
                look.take_cheaper_half(aim, eye_sides, cost_ms);
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
                    |aim: &ViewTarget| aim.sides.iter().filter(|side| **side != 0).count();
                let is_outside = outside(&joined) == outside(a) && outside(a) == outside(b);
                is_outside.then_some(joined)
            };
            lights = group(lights, join, cost_ms);
        }
        aims.append(&mut lights);

        let mut candidates = candidates(&aims);
        decide::estimate(&mut candidates, asked);
        let chosen = decide::choose(&candidates, asked, has_mirrors);
        let mut needs_whole = has_mirrors;
        for ((aim, candidate), is_set) in aims.iter_mut().zip(&candidates).zip(chosen) {
            aim.saving_ms = candidate.saving_ms;
            if aim.choice == TreeChoice::Whole && is_set {
                aim.choice = TreeChoice::Set;
            }
            needs_whole |= aim.choice == TreeChoice::Whole;
        }
        let set_count = aims
            .iter()
            .filter(|aim| aim.choice == TreeChoice::Set)
            .count();
        let light_sets = aims
            .iter()
            .skip(1)
            .filter(|aim| aim.choice == TreeChoice::Set);
        let light_set_count = light_sets.count();
        let plan = Self {
            topology: Some(topology),
            targets: aims,
            needs_whole,
            has_mirrors,
            triangle_count: mesh.indices.len(),
            reduce: asked.switches.reduce,
            sorts_alone: savings.has(Saving::Alone) && !needs_whole && set_count == 1,
            in_turn: false,
            builds_unseen: !savings.has(Saving::Unseen),
            may_turn_away: eye_sides.is_some(),
            no_survey: None,
        };
        // Each set has its turn once: all samples are in flight, no path goes on, and no light comes between two that share
        // a set.
        let [width, height] = asked.settings.size.map(u64::from);
        let samples = width * height * u64::from(asked.settings.sample_count);
        let in_turn = savings.has(Saving::Turns)
            && light_set_count > 1
            && samples <= MOST_IN_TURN
            && !has_mirrors
            && plan.is_in_runs();
        Ok(Self { in_turn, ..plan })
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

    /// The place among the aims of each light.
    #[must_use]
    pub fn target_of_light(&self) -> Vec<usize> {
        let places = self.targets.iter().enumerate();
        let mut pairs: Vec<(usize, usize)> = places
            .flat_map(|(place, aim)| aim.lights.iter().map(move |&light| (light, place)))
            .collect();
        pairs.sort_unstable();
        pairs.into_iter().map(|(_, place)| place).collect()
    }
}

/// What is known of the mesh.
struct MeshSurvey<'a> {
    topology: &'a Topology,
    facts: Vec<Facts>,
    samples: Samples<'a>,
}

impl MeshSurvey<'_> {
    /// Which sides of which components an aim sees, and what share of all triangles.
    fn measure(&self, aim: &mut ViewTarget) {
        aim.sides = self.topology.sides(&(&aim.target).into());
        let reducible = aim.sides.iter().zip(&self.facts);
        aim.reducible_count = reducible
            .filter(|(side, _)| **side != 0)
            .map(|(_, facts)| facts.triangle_count - facts.seam_count)
            .sum();
        if aim.may_be_set() {
            aim.share = self.samples.share(&aim.sides, &aim.target, &aim.frustum);
        }
    }

    /// Turns an aim at lights to the half that faces away, where that costs less and the eye, too, is outside of all that
    /// these lights are outside of: then every shadow ray starts outside, and meets as many triangles of either half.
    fn take_cheaper_half(
        &self,
        aim: &mut ViewTarget,
        eye_sides: &[i32],
        cost_ms: impl Fn(&ViewTarget) -> f64,
    ) {
        let mut pairs = aim.sides.iter().zip(eye_sides);
        if aim.reducible_count == 0 || pairs.any(|(light, eye)| *light != 0 && *eye == 0) {
            return;
        }
        let sides: Vec<i32> = aim.sides.iter().map(|side| -side).collect();
        let share = self.samples.share(&sides, &aim.target, &aim.frustum);
        let away = ViewTarget {
            effort: Costs::MEASURED.away_effort(aim.share + share - 1.0),
            share,
            half: FacingSet::Back,
            sides,
            ..aim.clone()
        };
        if cost_ms(&away) < cost_ms(aim) {
            *aim = away;
        }
    }
}

/// Whether any path may go on, at a mirror or through glass.
fn has_mirrors(asked: &PlanRequest) -> bool {
    let mut materials = asked.scene.materials.iter();
    let settings = asked.settings;
    settings.view == View::Color
        && settings.mirror_depth > 0
        && materials.any(|material| material.mirror > 0.0 || material.transmission > 0.0)
}

/// The rays that there are, for the model of costs.
fn candidates(aims: &[ViewTarget]) -> Vec<Candidate> {
    aims.iter().map(candidate).collect()
}

fn candidate(aim: &ViewTarget) -> Candidate {
    Candidate {
        kind: aim.kind,
        effort: aim.effort,
        light_count: aim.lights.len(),
        is_used: aim.choice != TreeChoice::Unused,
        may_be_set: aim.may_be_set(),
        share: aim.share,
        saving_ms: 0.0,
    }
}
