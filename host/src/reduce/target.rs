//! Rays of one kind, and where they go.

use super::PlanRequest;
use crate::backend::TargetSides;
use crate::scene::{camera_target, frustum, light_target};
use crate::{RenderSettings, Scene, View, ViewError};
use slimbvh_core::Aabb;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// Which rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetKind {
    /// From the camera.
    Camera,
    /// To one light, or to some.
    Lights,
}

/// Which triangles of closed surfaces may block rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FacingSet {
    /// Those that face the target (C+, L+).
    Front,
    /// Those that face away from it (L−).
    Back,
}

/// What rays of one kind are traced through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TreeChoice {
    /// A tree over the triangles that count.
    Set,
    /// The whole tree, where the rule says what counts if there was a survey.
    Whole,
    /// There are no such rays.
    Unused,
}

/// Rays of one kind, and what was decided for them.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewTarget {
    /// Which rays.
    pub kind: TargetKind,
    /// The lights that they go to, by number from 0.
    pub lights: Vec<usize>,
    /// Where they come from or lead to, in the mesh's unit: all of the lights, for some.
    pub target: Target,
    /// Where they go. It bounds a set only; where it bounds nothing, nothing is left out for it.
    pub frustum: Frustum,
    /// Which half counts.
    pub half: FacingSet,
    /// The side of each component that counts, see [`crate::topology::Topology::sides`]: negated for [`FacingSet::Back`]. Empty
    /// without a survey, and where there are no rays.
    pub sides: Vec<i32>,
    /// What they are traced through.
    pub choice: TreeChoice,
    /// How many triangles belong to components that this target may see a part of.
    pub reducible_count: usize,
    /// The share of the mesh's triangles that a set keeps, estimated.
    pub share: f64,
    /// How long a ray takes in the set, against one in a set of the same size of what faces the target; estimated.
    pub effort: f64,
    /// Milliseconds that a set saves in tracing, less those that it takes to build; estimated.
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

    /// What a set for it depends on, besides the mesh.
    pub(super) fn sides(&self) -> TargetSides {
        TargetSides {
            target: self.target,
            frustum: self.frustum,
            sides: self.sides.clone(),
        }
    }

    /// Whether a set may leave out anything.
    #[must_use]
    pub fn may_be_set(&self) -> bool {
        self.reducible_count > 0 || self.frustum.is_bounded == 1
    }

    /// `camera`, or the lights with their numbers from 1.
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

/// The camera and each light, whole as long as nothing is known.
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

/// What the camera's rays can reach of a box, which bounds nothing where that is all of it.
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
