//! What moves, and where it is in each frame.

use super::anchor::Anchor;
use super::deform::{Deform, Rest, bend};
use super::turn::Turn;
use crate::{Camera, Light, RenderSettings, Scene, ViewError};
use slimbvh_core::bounds::scene_exponent;

/// What moves. Nothing does by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Motion {
    /// Frames of one round; 0 counts as 1.
    pub frame_count: u32,
    /// The camera goes round the middle of the scene, counter-clockwise from above: a turntable.
    pub orbit: bool,
    /// The lights go round it.
    pub orbit_light: bool,
    /// The mesh bends.
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
    /// Motion of a scene as it is now, whose mesh is [valid](crate::Mesh::validate). Only the first camera moves. The
    /// vertical is the coordinate axis nearest to the camera's up.
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

    /// Moves the scene, which must be the one that this was made for, to where it is in a frame. Returns whether vertices
    /// moved; they did not if only the camera and the lights did.
    ///
    /// In frame 0 camera and lights are where they were at first.
    pub fn pose(&self, frame: u32, scene: &mut Scene) -> bool {
        self.pose_at(f64::from(frame), scene)
    }

    /// [`Self::pose`] at any time, in frames: 2.5 is halfway from frame 2 to frame 3. It must be finite.
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

    /// Whether all frames can be seen, told before the first one is made.
    ///
    /// # Errors
    /// The first frame's whose camera or lights make no picture.
    pub fn check(&self, settings: &RenderSettings) -> Result<(), ViewError> {
        let frames = 0..self.motion.frame_count.max(1);
        self.check_at(frames.map(f64::from), settings)
    }

    /// [`Self::check`] at some times, in frames.
    ///
    /// # Errors
    /// The first time's whose camera or lights make no picture.
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

    /// How much of the round is over at a time, from 0 to 1.
    fn moment(&self, time: f64) -> f64 {
        let count = f64::from(self.motion.frame_count.max(1));
        time.rem_euclid(count) / count
    }
}

#[cfg(all(test, feature = "scenes"))]
mod tests;
