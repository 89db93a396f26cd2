//! The trees that a picture is traced through.

use super::facing_target::FacingTarget;
use super::steps::Steps;
use super::times::{Build, Picture};
use crate::measure::rounds::Rounds;
use anyhow::Result;
use serde::Serialize;
use slimbvh::{Backend, RenderSettings};

/// How triangles are sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Sorting {
    /// All triangles once, for all trees.
    Once,
    /// The triangles of each set by themselves.
    Each,
}

/// The trees for the rays of a picture. `None` is the whole tree, in which all triangles count.
#[derive(Clone, Debug)]
pub struct Layout {
    pub camera: Option<FacingTarget>,
    /// Trees for shadow rays.
    pub shadows: Vec<Option<FacingTarget>>,
    /// For each light, the index of its tree in `shadows`.
    pub lights: Vec<usize>,
    pub sorting: Sorting,
}

/// The places of the whole tree, of the camera's tree, and of the first tree for shadow rays.
const WHOLE: usize = 0;
const CAMERA: usize = 1;
const SHADOWS: usize = 2;

impl Layout {
    /// One whole tree for everything.
    pub fn whole(light_count: usize) -> Self {
        Self {
            camera: None,
            shadows: vec![None],
            lights: vec![0; light_count],
            sorting: Sorting::Once,
        }
    }

    /// A set for the camera, and one for each light.
    pub fn sets(camera: &FacingTarget, lights: &[FacingTarget], sorting: Sorting) -> Self {
        Self {
            camera: Some(camera.clone()),
            shadows: lights.iter().cloned().map(Some).collect(),
            lights: (0..lights.len()).collect(),
            sorting,
        }
    }

    /// Builds the trees and renders a picture.
    fn picture<B: Backend>(
        &self,
        steps: &mut Steps<B>,
        settings: &RenderSettings,
    ) -> Result<Picture> {
        let mut picture = Picture::default();
        let is_any_whole = self.camera.is_none() || self.shadows.iter().any(Option::is_none);
        if self.sorting == Sorting::Once || is_any_whole {
            picture.camera_build = Build::of(&steps.sort()?);
        }
        let mut build = |place: usize, set: Option<&FacingTarget>| -> Result<Build> {
            Ok(Build::of(&match (self.sorting, set) {
                (Sorting::Each, Some(set)) => steps.build_alone(place, set)?,
                (_, set) => steps.build(place, set)?,
            }))
        };
        // The whole tree comes first, while the order is that of all triangles.
        if is_any_whole {
            let whole = build(WHOLE, None)?;
            let to = if self.camera.is_none() {
                &mut picture.camera_build
            } else {
                &mut picture.shadow_build
            };
            *to = to.plus(whole);
        }
        if let Some(camera) = &self.camera {
            let set = build(CAMERA, Some(camera))?;
            picture.camera_build = picture.camera_build.plus(set);
        }
        for (i, shadow) in self.shadows.iter().enumerate() {
            if let Some(shadow) = shadow {
                let set = build(SHADOWS + i, Some(shadow))?;
                picture.shadow_build = picture.shadow_build.plus(set);
            }
        }
        let place = |i: usize| self.shadows[i].as_ref().map_or(WHOLE, |_| SHADOWS + i);
        let camera = self.camera.as_ref().map_or(WHOLE, |_| CAMERA);
        let lights: Vec<usize> = self.lights.iter().map(|&i| place(i)).collect();
        picture.add_render(&steps.render(camera, &lights, settings)?);
        Ok(picture)
    }
}

/// Alternates pictures with each layout, round by round. The first `warm_ups` rounds are not counted.
pub fn take_turns<B: Backend>(
    steps: &mut Steps<B>,
    layouts: &[&Layout],
    settings: &RenderSettings,
    (warm_ups, rounds): (u32, u32),
) -> Result<Vec<Rounds<Picture>>> {
    let mut all = vec![Rounds(Vec::new()); layouts.len()];
    for round in 0..warm_ups + rounds {
        for (layout, rounds) in layouts.iter().zip(&mut all) {
            let picture = layout.picture(steps, settings)?;
            if round >= warm_ups {
                rounds.0.push(picture);
            }
        }
    }
    Ok(all)
}
