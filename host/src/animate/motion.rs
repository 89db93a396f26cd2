//! The motion of a scene, and the pose in each frame.

use super::anchor::Anchor;
use super::deform::{Deform, Rest, bend};
use super::turn::Turn;
use crate::{Camera, Light, RenderSettings, Scene, ViewError};
use slimbvh_core::bounds::scene_exponent;

/// What moves; nothing by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Motion {
    /// Frames of one period; 0 counts as 1.
    pub frame_count: u32,
    /// The camera circles the scene's middle, counter-clockwise from above: a turntable.
    pub orbit: bool,
    /// The lights circle it.
    pub orbit_light: bool,
    /// The mesh deforms.
    pub deform: Option<Deform>,
}

impl Default for Motion {
    fn default() -> Self {
        Self {
            frame_count: 1,
            orbit: false,
            orbit_light: false,
            deform: None,
        }
    }
}

/// A scene's motion.
#[derive(Clone, Debug)]
pub struct Animation {
    motion: Motion,
    anchor: Anchor,
    camera: Option<Camera>,
    lights: Vec<Light>,
    rest: Rest,
    scene_exponent: i32,
}

impl Animation {
    /// The motion of a scene from its present pose. Its mesh must be [valid](crate::Mesh::validate). Only the first camera
    /// moves. The vertical is the coordinate axis nearest to the camera's up direction.
    #[must_use]
    pub fn new(scene: &Scene, motion: Motion) -> Self {
        let camera = scene.cameras.first().copied();
        let mesh = &scene.mesh;
        let bounds = mesh.bounds().unwrap_or(crate::Aabb::EMPTY);
        let mut rest = Rest::default();
        if motion.deform.is_some() {
            rest.vertices.clone_from(&mesh.vertices);
            rest.normals.clone_from(&mesh.normals);
        }
        Self {
            motion,
            anchor: Anchor::new(mesh, camera.as_ref()),
            camera,
            lights: scene.lights.clone(),
            rest,
            scene_exponent: scene_exponent(&bounds),
        }
    }

    /// Moves the scene, which must be the one passed to [`Self::new`], to its pose in a frame. Returns whether vertices
    /// moved; `false` if only the camera and the lights did.
    ///
    /// In frame 0, camera and lights are in their first pose.
    pub fn pose(&self, frame: u32, scene: &mut Scene) -> bool {
        self.pose_at(f64::from(frame), scene)
    }

    /// [`Self::pose`] at any finite time, in frames: 2.5 is halfway from frame 2 to frame 3.
    pub fn pose_at(&self, time: f64, scene: &mut Scene) -> bool {
        let moment = self.moment(time);
        let turn = Turn::new(self.anchor, moment);
        if let (true, Some(camera), Some(to)) =
            (self.motion.orbit, &self.camera, scene.cameras.first_mut())
        {
            *to = turn.camera(camera);
        }
        if self.motion.orbit_light {
            for (to, light) in scene.lights.iter_mut().zip(&self.lights) {
                *to = turn.light(light);
            }
        }
        let Some(deform) = self.motion.deform else {
            return false;
        };
        let (vertices, normals) = (&mut scene.mesh.vertices, &mut scene.mesh.normals);
        bend(
            &*deform.at(self.anchor, moment),
            &self.rest,
            vertices,
            normals,
        );
        true
    }

    /// Checks before the first frame that all frames can be rendered.
    ///
    /// # Errors
    /// For the first frame whose camera or lights cannot be rendered.
    pub fn check(&self, settings: &RenderSettings) -> Result<(), ViewError> {
        let frames = 0..self.motion.frame_count.max(1);
        self.check_at(frames.map(f64::from), settings)
    }

    /// [`Self::check`] at the given times, in frames.
    ///
    /// # Errors
    /// For the first time at which the camera or the lights cannot be rendered.
    pub fn check_at(
        &self,
        times: impl IntoIterator<Item = f64>,
        settings: &RenderSettings,
    ) -> Result<(), ViewError> {
        let camera = self.camera.ok_or(ViewError::NoCamera)?;
        for time in times {
            let turn = Turn::new(self.anchor, self.moment(time));
            let camera = if self.motion.orbit {
                turn.camera(&camera)
            } else {
                camera
            };
            camera.to_core(settings.size, settings.sample_count)?;
            camera.check_reach(self.scene_exponent)?;
            for (index, light) in self.lights.iter().enumerate() {
                if self.motion.orbit_light {
                    turn.light(light).to_core(index)?;
                } else {
                    light.to_core(index)?;
                }
            }
        }
        Ok(())
    }

    /// The share of the period that is over at a time, from 0 to 1.
    fn moment(&self, time: f64) -> f64 {
        let count = f64::from(self.motion.frame_count.max(1));
        time.rem_euclid(count) / count
    }
}

#[cfg(all(test, feature = "scenes"))]
mod tests;
