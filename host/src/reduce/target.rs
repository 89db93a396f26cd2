//! Targets of rays: the camera, and lights or groups of lights.

use super::PlanRequest;
use crate::backend::TargetSides;
use crate::scene::{camera_target, frustum, light_target};
use crate::{RenderSettings, Scene, View, ViewError};
use slimbvh_core::Aabb;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// The kind of the rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetKind {
    /// From the camera.
    Camera,
    /// To one light, or to a group.
    Lights,
}

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

/// Rays of one kind, and the decisions made for them.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewTarget {
    /// The kind of the rays.
    pub kind: TargetKind,
    /// The lights that they lead to, numbered from 0.
    pub lights: Vec<usize>,
    /// Where they come from or lead to, in the mesh's unit; for a group, the ball around its lights.
    pub target: Target,
    /// The region that they cross. It bounds the set only. An unbounded region leaves nothing out.
    pub frustum: Frustum,
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

impl ViewTarget {
    pub(super) fn new(kind: TargetKind, lights: Vec<usize>, target: Target) -> Self {
        Self {
            kind,
            lights,
            target,
            frustum: Frustum::EVERYWHERE,
            half: FacingSet::Front,
            sides: Vec::new(),
            choice: TreeChoice::Whole,
            reducible_count: 0,
            share: 1.0,
            effort: 1.0,
            saving_ms: 0.0,
        }
    }

    /// The inputs of its set besides the mesh.
    pub(super) fn sides(&self) -> TargetSides {
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

    /// `camera`, or the lights, numbered from 1.
    #[must_use]
    pub fn name(&self) -> String {
        let Some((first, rest)) = self.lights.split_first() else {
            return "camera".to_owned();
        };
        if rest.is_empty() {
            return format!("light {}", first + 1);
        }
        let mut runs: Vec<[usize; 2]> = Vec::new();
        for &light in &self.lights {
            match runs.last_mut() {
                Some(run) if run[1] + 1 == light => run[1] = light,
                _ => runs.push([light, light]),
            }
        }
        let runs = runs.iter().map(|&[first, last]| match last - first {
            0 => format!("{}", first + 1),
            1 => format!("{}, {}", first + 1, last + 1),
            _ => format!("{} to {}", first + 1, last + 1),
        });
        format!("lights {}", runs.collect::<Vec<_>>().join(", "))
    }
}

/// The camera and each light, with nothing left out yet.
pub fn targets(request: &PlanRequest) -> Result<Vec<ViewTarget>, ViewError> {
    let RenderSettings {
        size,
        sample_count,
        view: shown,
        dark_rays,
        ..
    } = *request.settings;
    let Scene {
        cameras, lights, ..
    } = request.scene;
    let camera = cameras.first().ok_or(ViewError::NoCamera)?;
    let core = camera.to_core(size, sample_count)?;
    let mut targets = vec![ViewTarget::new(
        TargetKind::Camera,
        Vec::new(),
        camera_target(&core),
    )];
    for (index, light) in lights.iter().enumerate() {
        let light = light.to_core(index)?;
        let mut view = ViewTarget::new(TargetKind::Lights, vec![index], light_target(&light));
        let is_used = shown == View::Color && (dark_rays || light.color != [0.0; 3]);
        if !is_used {
            view.choice = TreeChoice::Unused;
        }
        targets.push(view);
    }
    Ok(targets)
}

/// The part of a box that the camera's rays can reach; unbounded if that is all of it.
pub fn frustum_within(request: &PlanRequest, bounds: &Aabb) -> Result<Frustum, ViewError> {
    let settings = request.settings;
    let camera = request.scene.cameras.first().ok_or(ViewError::NoCamera)?;
    let frustum = frustum(&camera.to_core(settings.size, settings.sample_count)?);
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
    if bounds.is_empty() || corners.into_iter().all(is_inside) {
        Ok(Frustum::EVERYWHERE)
    } else {
        Ok(frustum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lights_are_named_in_runs() {
        let name = |lights: &[usize]| {
            let target = Target::position([0.0; 3]);
            ViewTarget::new(TargetKind::Lights, lights.to_vec(), target).name()
        };
        assert_eq!(name(&[]), "camera");
        assert_eq!(name(&[4]), "light 5");
        assert_eq!(name(&[0, 1]), "lights 1, 2");
        assert_eq!(name(&[0, 1, 2, 3, 6, 8, 9]), "lights 1 to 4, 7, 9, 10");
    }
}
