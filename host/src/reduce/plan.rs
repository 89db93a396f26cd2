//! What is built for a picture.

use super::decide::{self, Candidate};
use super::{Asked, Cull, Reduce};
use crate::scene::{camera_target, light_target};
use crate::topology::{self, Topology};
use crate::{RenderSettings, Scene, View, ViewError};
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::{Sides, is_in_set};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;

/// Triangles that are looked at for the share that a set will keep.
const SAMPLES: usize = 4096;

/// Which rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AimKind {
    /// From the camera.
    Camera,
    /// To the light of this index.
    Light(usize),
}

/// What rays of one kind are traced through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// A tree over the triangles that count.
    Set,
    /// The whole tree, where the rule says what counts if there was a survey.
    Whole,
    /// There are no such rays.
    Unused,
}

/// Rays of one kind, and what was decided for them.
#[derive(Clone, Debug, PartialEq)]
pub struct Aim {
    /// Which rays.
    pub kind: AimKind,
    /// Where they come from or lead to, in the mesh's unit.
    pub target: Target,
    /// The outer side of each component, see [`Topology::sides`]. Empty without a survey, and where there are no rays.
    pub sides: Vec<i32>,
    /// What they are traced through.
    pub choice: Choice,
    /// How many triangles belong to components that this target may see a part of.
    pub reducible_count: usize,
    /// The share of the mesh's triangles that a set keeps, estimated.
    pub share: f64,
    /// Milliseconds that a set saves in tracing, less those that it takes to build; estimated.
    pub saving_ms: f64,
}

/// What is built for a picture, and why.
#[derive(Clone, Debug)]
pub struct Plan<'a> {
    /// The surfaces; none without a survey, and then nothing is left out.
    pub topology: Option<&'a Topology>,
    /// The camera, then each light.
    pub aims: Vec<Aim>,
    /// Whether the whole tree is built.
    pub needs_whole: bool,
    /// Whether rays from mirrors are traced, through the whole tree.
    pub has_mirrors: bool,
    /// How many triangles the mesh has.
    pub triangle_count: usize,
    /// What the caller wanted.
    pub reduce: Reduce,
    /// Why there was no survey.
    pub(super) no_survey: Option<String>,
}

impl<'a> Plan<'a> {
    /// The plan that needs no survey, where that is the better one or asked for: one whole tree, where all triangles count.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
    pub fn without_survey(asked: &Asked) -> Result<Option<Self>, ViewError> {
        let aims = aims(asked)?;
        let has_mirrors = has_mirrors(asked);
        let switches = asked.switches;
        let reason = match (switches.cull, switches.reduce) {
            (Some(Cull::Off), _) => Some("all triangles were asked to count".to_owned()),
            (None, Reduce::Off) => Some("nobody asked for it".to_owned()),
            (None, Reduce::Auto) => decide::decline(asked, &candidates(&aims), has_mirrors),
            (Some(Cull::On), _) | (None, Reduce::On) => None,
        };
        Ok(reason.map(|reason| Self {
            topology: None,
            aims,
            needs_whole: true,
            has_mirrors,
            triangle_count: asked.scene.mesh.indices.len(),
            reduce: switches.reduce,
            no_survey: Some(reason),
        }))
    }

    /// Decides, knowing the surfaces of the scene's mesh.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
    pub fn new(topology: &'a Topology, asked: &Asked) -> Result<Self, ViewError> {
        let mesh = &asked.scene.mesh;
        let bounds = mesh.bounds().unwrap_or(slimbvh_core::Aabb::EMPTY);
        let scale = PowerOfTwo::new(scene_exponent(&bounds));
        let has_mirrors = has_mirrors(asked);
        let facts = topology.facts();
        let mut aims = aims(asked)?;
        for aim in aims.iter_mut().filter(|aim| aim.choice != Choice::Unused) {
            aim.sides = topology.sides(&outside(&aim.target));
            let reducible = aim.sides.iter().zip(&facts).filter(|(side, _)| **side != 0);
            aim.reducible_count = reducible
                .map(|(_, facts)| facts.triangle_count - facts.seam_count)
                .sum();
            aim.share = if aim.reducible_count > 0 {
                let sides = Sides {
                    components: topology.components(),
                    sides: &aim.sides,
                };
                share(asked.scene, &scale, &sides, &aim.target)
            } else {
                1.0
            };
        }
        let mut candidates = candidates(&aims);
        decide::estimate(&mut candidates, asked);
        let chosen = decide::choose(&candidates, asked, has_mirrors);
        let mut needs_whole = has_mirrors;
        for ((aim, candidate), is_set) in aims.iter_mut().zip(&candidates).zip(chosen) {
            aim.saving_ms = candidate.saving_ms;
            if aim.choice == Choice::Whole && is_set {
                aim.choice = Choice::Set;
            }
            needs_whole |= aim.choice == Choice::Whole;
        }
        Ok(Self {
            topology: Some(topology),
            aims,
            needs_whole,
            has_mirrors,
            triangle_count: mesh.indices.len(),
            reduce: asked.switches.reduce,
            no_survey: None,
        })
    }

    /// Whether everything is traced through one whole tree in which all triangles count.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.topology.is_none()
    }

    /// The component of each triangle; none without a survey.
    pub(super) fn components(&self) -> &'a [u32] {
        self.topology.map_or(&[], Topology::components)
    }
}

/// The camera and the lights, whole as long as nothing is known.
fn aims(asked: &Asked) -> Result<Vec<Aim>, ViewError> {
    let RenderSettings {
        size, sample_count, ..
    } = *asked.settings;
    let Scene {
        cameras, lights, ..
    } = asked.scene;
    let camera = cameras.first().ok_or(ViewError::NoCamera)?;
    let core = camera.to_core(size, sample_count)?;
    let eye = camera_target(&core);
    let aim = |kind, target, is_used| Aim {
        kind,
        target,
        sides: Vec::new(),
        choice: if is_used {
            Choice::Whole
        } else {
            Choice::Unused
        },
        reducible_count: 0,
        share: 1.0,
        saving_ms: 0.0,
    };
    let mut aims = vec![aim(AimKind::Camera, eye, true)];
    for (index, light) in lights.iter().enumerate() {
        let light = light.to_core(index)?;
        let target = light_target(&light);
        let is_used = asked.settings.view == View::Color && light.color != [0.0; 3];
        aims.push(aim(AimKind::Light(index), target, is_used));
    }
    Ok(aims)
}

/// Whether any path may go on at a mirror.
fn has_mirrors(asked: &Asked) -> bool {
    let mut materials = asked.scene.materials.iter();
    let settings = asked.settings;
    settings.view == View::Color
        && settings.mirror_depth > 0
        && materials.any(|material| material.mirror > 0.0)
}

/// The rays that there are, for the model of costs.
fn candidates(aims: &[Aim]) -> Vec<Candidate> {
    let candidate = |aim: &Aim| Candidate {
        kind: aim.kind,
        is_used: aim.choice != Choice::Unused,
        may_be_set: aim.reducible_count > 0,
        share: aim.share,
        saving_ms: 0.0,
    };
    aims.iter().map(candidate).collect()
}

/// The target as the topology knows it.
fn outside(target: &Target) -> topology::Target {
    let center = target.point;
    match (target.is_position, target.radius) {
        (0, _) => topology::Target::Direction(center),
        (_, 0.0) => topology::Target::Point(center),
        (_, radius) => topology::Target::Ball { center, radius },
    }
}

/// The share of the triangles in a set, from evenly spaced samples.
fn share(scene: &Scene, scale: &PowerOfTwo, sides: &Sides, target: &Target) -> f64 {
    let mesh = scene.mesh.triangles();
    let count = mesh.indices.len();
    let target = target.scaled(scale);
    let samples = (0..count).step_by(count.div_ceil(SAMPLES).max(1));
    let sample_count = samples.len();
    let kept = samples.filter(|&i| is_in_set(i as u32, &mesh, scale, sides, &target));
    kept.count() as f64 / sample_count.max(1) as f64
}
