//! View sets: what is decided for the rays of a target, or of several lights together.

use super::target::{TargetKind, ViewTarget};
use crate::backend::TargetSides;
use slimbvh_core::Aabb;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// Which triangles of closed surfaces rays may hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FacingSet {
    /// Those that face the target (C+, L+).
    Front,
    /// Those that face away from it (L−).
    Back,
}

/// The tree that rays of one kind are traced through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TreeChoice {
    /// A tree over the triangles that rays may hit.
    Set,
    /// The whole tree, with the facing filter if there was a survey.
    Whole,
    /// None: there are no such rays.
    Unused,
}

/// What a target is called in reports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Label {
    Camera,
    /// Counted from 1.
    NumberedCamera(usize),
    /// Counted from 1.
    Light(usize),
    Named(String),
}

/// Rays of one kind, and the decisions made for them.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewSet {
    /// The kind of the rays.
    pub kind: TargetKind,
    /// The targets that they come from or lead to, by their places in the caller's list; several if lights share a set.
    pub targets: Vec<usize>,
    pub(super) labels: Vec<Label>,
    /// Where they come from or lead to, in the mesh's unit; for a group, the ball around its lights.
    pub target: Target,
    /// The region that they cross. It bounds the set only. An unbounded region leaves nothing out.
    pub frustum: Frustum,
    /// Rays expected in a frame.
    pub ray_count: f64,
    /// Whether all rays start where the camera's rays hit.
    pub(super) starts_at_hits: bool,
    /// The set of triangles that rays may hit.
    pub half: FacingSet,
    /// For each component, the side that rays may hit, see [`crate::topology::Topology::sides`]; negated for
    /// [`FacingSet::Back`]. Empty without a survey, and if there are no rays.
    pub sides: Vec<i32>,
    /// The tree that they are traced through.
    pub choice: TreeChoice,
    /// The number of triangles in components of which only one side is visible to the target.
    pub reducible_count: usize,
    /// The estimated share of the mesh's triangles that a set keeps.
    pub share: f64,
    /// The estimated time of a ray in the set, divided by that in a set of the same size that faces the target.
    pub effort: f64,
    /// Estimated milliseconds that a set saves in tracing, minus its build time.
    pub saving_ms: f64,
}

impl ViewSet {
    /// The set of one target, with nothing left out yet.
    fn new(place: usize, label: Label, target: &ViewTarget) -> Self {
        Self {
            kind: target.kind,
            targets: vec![place],
            labels: vec![label],
            target: target.target,
            frustum: Frustum::EVERYWHERE,
            ray_count: target.ray_count,
            starts_at_hits: target.starts_at_hits,
            half: FacingSet::Front,
            sides: Vec::new(),
            choice: if target.is_used {
                TreeChoice::Whole
            } else {
                TreeChoice::Unused
            },
            reducible_count: 0,
            share: 1.0,
            effort: 1.0,
            saving_ms: 0.0,
        }
    }

    /// The set that two targets share, around this ball.
    pub(super) fn joined(&self, other: &Self, target: Target) -> Self {
        let mut both: Vec<(usize, &Label)> = [self, other]
            .into_iter()
            .flat_map(|set| set.targets.iter().copied().zip(&set.labels))
            .collect();
        both.sort_unstable_by_key(|(place, _)| *place);
        Self {
            targets: both.iter().map(|(place, _)| *place).collect(),
            labels: both.iter().map(|(_, label)| (*label).clone()).collect(),
            target,
            ray_count: self.ray_count + other.ray_count,
            starts_at_hits: self.starts_at_hits && other.starts_at_hits,
            half: FacingSet::Front,
            sides: Vec::new(),
            reducible_count: 0,
            share: 1.0,
            effort: 1.0,
            ..self.clone()
        }
    }

    /// The inputs of its tree besides the mesh.
    pub(super) fn inputs(&self) -> TargetSides {
        TargetSides {
            target: self.target,
            frustum: self.frustum,
            sides: self.sides.clone(),
        }
    }

    /// Whether a set could leave anything out.
    #[must_use]
    pub fn may_be_set(&self) -> bool {
        self.reducible_count > 0 || self.frustum.is_bounded == 1
    }

    /// The names of its targets; cameras and lights without a name are numbered from 1.
    #[must_use]
    pub fn name(&self) -> String {
        let mut runs: Vec<[usize; 2]> = Vec::new();
        let mut names: Vec<String> = Vec::new();
        for label in &self.labels {
            match label {
                Label::Camera => names.push("camera".to_owned()),
                Label::NumberedCamera(number) => names.push(format!("camera {number}")),
                Label::Named(name) => names.push(name.clone()),
                Label::Light(number) => match runs.last_mut() {
                    Some(run) if run[1] + 1 == *number => run[1] = *number,
                    _ => runs.push([*number; 2]),
                },
            }
        }
        if !runs.is_empty() {
            let is_one = matches!(runs.as_slice(), [[first, last]] if first == last);
            let runs = runs.iter().map(|&[first, last]| match last - first {
                0 => format!("{first}"),
                1 => format!("{first}, {last}"),
                _ => format!("{first} to {last}"),
            });
            let numbers = runs.collect::<Vec<_>>().join(", ");
            let word = if is_one { "light" } else { "lights" };
            names.insert(0, format!("{word} {numbers}"));
        }
        names.join(", ")
    }
}

/// A set for each target that rays come from, then one for each that they lead to, with nothing left out yet. Other rays have
/// none.
pub fn sets(targets: &[ViewTarget]) -> Vec<ViewSet> {
    let of_kind = |kind: TargetKind| {
        let places = targets.iter().enumerate();
        places.filter(move |(_, target)| target.kind == kind)
    };
    let unnamed = of_kind(TargetKind::From).filter(|(_, target)| target.name.is_none());
    let has_one_camera = unnamed.count() == 1;
    let mut sets = Vec::new();
    for kind in [TargetKind::From, TargetKind::To] {
        let mut number = 0;
        for (place, target) in of_kind(kind) {
            let label = match (&target.name, kind) {
                (Some(name), _) => Label::Named(name.clone()),
                (None, TargetKind::From) if has_one_camera => Label::Camera,
                (None, _) => {
                    number += 1;
                    match kind {
                        TargetKind::From => Label::NumberedCamera(number),
                        TargetKind::To | TargetKind::Other => Label::Light(number),
                    }
                }
            };
            sets.push(ViewSet::new(place, label, target));
        }
    }
    sets
}

/// The part of a box that rays within a frustum can reach; unbounded if that is all of it.
pub fn frustum_within(frustum: &Frustum, bounds: &Aabb) -> Frustum {
    let eye = frustum.eye.map(f64::from);
    let corners = (0..8).map(|corner| -> [f64; 3] {
        std::array::from_fn(|i| {
            let corner = [bounds.min[i], bounds.max[i]][corner >> i & 1];
            f64::from(corner) - eye[i]
        })
    });
    let is_inside = |corner: [f64; 3]| {
        let planes = frustum.planes.iter();
        let mut distances = planes.map(|plane| {
            let [x, y, z, offset] = plane.map(f64::from);
            x * corner[0] + y * corner[1] + z * corner[2] + offset
        });
        distances.all(|distance| distance >= 0.0)
    };
    if frustum.is_bounded == 0 || bounds.is_empty() || corners.into_iter().all(is_inside) {
        Frustum::EVERYWHERE
    } else {
        *frustum
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// The set of a lamp.
    pub fn lamp(number: usize, target: Target) -> ViewSet {
        let ball = ViewTarget::rays_to(target.point, target.radius).expect("a ball");
        let mut set = ViewSet::new(number, Label::Light(number), &ball);
        set.target = target;
        set
    }

    #[test]
    fn sets_are_named_by_their_targets() {
        let place = Target::position([0.0; 3]);
        let name = |lights: &[usize]| {
            let mut lamps = lights.iter().map(|&light| lamp(light, place));
            let first = lamps.next().expect("one light");
            lamps.fold(first, |a, b| a.joined(&b, place)).name()
        };
        assert_eq!(name(&[5]), "light 5");
        assert_eq!(name(&[1, 2]), "lights 1, 2");
        assert_eq!(name(&[1, 2, 3, 4, 7, 9, 10]), "lights 1 to 4, 7, 9, 10");

        let eye = || ViewTarget::rays_from([0.0; 3], 1.0).expect("a ball");
        let lamp = || ViewTarget::rays_to([0.0; 3], 1.0).expect("a ball");
        let names = |targets: &[ViewTarget]| -> Vec<String> {
            sets(targets).iter().map(ViewSet::name).collect()
        };
        assert_eq!(
            names(&[lamp(), eye(), lamp().named("a door")]),
            ["camera", "light 1", "a door"]
        );
        assert_eq!(
            names(&[eye(), ViewTarget::other_rays(), eye().named("left"), eye()]),
            ["camera 1", "left", "camera 2"]
        );
    }
}
