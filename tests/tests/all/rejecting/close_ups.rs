//! Cameras so close that all their rays, or the shadow rays from the surfaces that they see, pass where rounding decides.

use super::surroundings::Surroundings;
use glam::DVec3;
use slimbvh::{Camera, Projection};
use slimbvh_core::orientation::Target;
use slimbvh_core::{NO_PRIMITIVE, Ray};
use slimbvh_lab::oracle::Unculled;
use slimbvh_tests::random::Random;

/// A scene at its magnitude: the caller's coordinates times two to the power of `exponent`.
pub struct Sight<'a> {
    pub unculled: &'a Unculled,
    pub surroundings: &'a Surroundings,
    pub exponent: i32,
    /// The tracer's error bound.
    pub d: f64,
}

impl Sight<'_> {
    /// Close-ups of up to `count` silhouettes as the camera sees them, of borders of each target's shadow, and of any edges, in
    /// the caller's unit.
    pub fn close_ups(&self, camera: &Camera, targets: &[Target], count: usize) -> Vec<Camera> {
        let mut random = Random::new(11);
        let (eye, lights) = (&targets[0], &targets[1..]);
        let mut cameras = Vec::new();
        let silhouettes = self.surroundings.edges(Some((eye, self.d)));
        self.look(&mut cameras, camera, count, || {
            point_on(&silhouettes, &mut random)
        });
        let mut random = Random::new(12);
        for light in lights {
            let silhouettes = self.surroundings.edges(Some((light, self.d)));
            self.look(&mut cameras, camera, count, || {
                self.shadow_of(point_on(&silhouettes, &mut random)?, light)
            });
        }
        let mut random = Random::new(13);
        let edges = self.surroundings.edges(None);
        self.look(&mut cameras, camera, count, || {
            point_on(&edges, &mut random)
        });
        cameras
    }

    /// Adds cameras for the visible ones of these points.
    fn look(
        &self,
        cameras: &mut Vec<Camera>,
        camera: &Camera,
        count: usize,
        mut point: impl FnMut() -> Option<DVec3>,
    ) {
        let mut added = 0;
        for _ in 0..30 * count {
            let Some(point) = point() else { continue };
            let reach = self.d * [0.1, 1.0, 8.0, 80.0][added % 4];
            if let Some(close_up) = self.toward(point, camera, reach) {
                cameras.push(close_up);
                added += 1;
            }
            if added == count {
                break;
            }
        }
    }

    /// A camera that sees this far around a point, if the point is not hidden.
    fn toward(&self, point: DVec3, camera: &Camera, reach: f64) -> Option<Camera> {
        let (to_scene, to_caller) = (2f64.powi(self.exponent), 2f64.powi(-self.exponent));
        let old_eye = DVec3::from_array(camera.eye.map(f64::from)) * to_scene;
        let old_target = DVec3::from_array(camera.target.map(f64::from)) * to_scene;
        let eye = match camera.projection {
            Projection::Perspective { .. } | Projection::ThinLens { .. } => old_eye,
            Projection::Orthographic { .. } => point + (old_eye - old_target),
        };
        if !self.is_free(eye, point) {
            return None;
        }
        let caller = |p: DVec3| (p * to_caller).to_array().map(|x| x as f32);
        let half_angle = (reach / eye.distance(point)).atan();
        Some(Camera {
            eye: if eye == old_eye {
                camera.eye
            } else {
                caller(eye)
            },
            target: caller(point),
            projection: match camera.projection {
                Projection::Perspective { .. } => Projection::Perspective {
                    vertical_fov: 2.0 * half_angle.to_degrees() as f32,
                },
                Projection::ThinLens { radius, .. } => Projection::ThinLens {
                    vertical_fov: 2.0 * half_angle.to_degrees() as f32,
                    radius,
                    focus_distance: (eye.distance(point) * to_caller) as f32,
                },
                Projection::Orthographic { .. } => Projection::Orthographic {
                    height: (2.0 * reach * to_caller) as f32,
                },
            },
            ..*camera
        })
    }

    /// The point on a surface where the shadow of a point falls.
    fn shadow_of(&self, point: DVec3, light: &Target) -> Option<DVec3> {
        let source = DVec3::from_array(light.point.map(f64::from));
        let direction = if light.is_position == 1 {
            point - source
        } else {
            -source
        };
        let crossings = self
            .unculled
            .crossings(&ray(point, direction), NO_PRIMITIVE);
        let landing = crossings.iter().find(|crossing| crossing.t > 1e-3)?;
        Some(point + direction * landing.t)
    }

    fn is_free(&self, from: DVec3, to: DVec3) -> bool {
        let crossings = self.unculled.crossings(&ray(from, to - from), NO_PRIMITIVE);
        crossings.first().is_none_or(|first| first.t > 0.9999)
    }
}

fn ray(origin: DVec3, direction: DVec3) -> Ray {
    let narrow = |v: DVec3| v.to_array().map(|x| x as f32);
    Ray::new(narrow(origin), narrow(direction))
}

fn point_on(edges: &[[DVec3; 2]], random: &mut Random) -> Option<DVec3> {
    if edges.is_empty() {
        return None;
    }
    let [a, b] = edges[random.below(edges.len())];
    Some(a + (b - a) * f64::from(random.unit()))
}
