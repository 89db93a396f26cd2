//! Cameras and lights of a glTF scene. Both look along their node's -z.

use super::super::{Camera, Light, Projection};
use glam::{Mat4, Vec3};
use gltf::camera::Projection as GltfProjection;
use gltf::khr_lights_punctual::Kind;

/// The camera, with its target at distance 1. `None` without a direction, an up direction, or an extent.
pub(super) fn camera(camera: &gltf::Camera<'_>, transform: Mat4) -> Option<Camera> {
    let (eye, forward) = position_and_direction(transform)?;
    let up = transform.transform_vector3(Vec3::Y).try_normalize()?;
    if up.cross(forward) == Vec3::ZERO {
        return None;
    }
    let projection = match camera.projection() {
        GltfProjection::Perspective(p) => {
            let vertical_fov = p.yfov().to_degrees();
            (vertical_fov > 0.0 && vertical_fov < 180.0)
                .then_some(Projection::Perspective { vertical_fov })
        }
        GltfProjection::Orthographic(o) => {
            let height = 2.0 * o.ymag().abs();
            (height > 0.0 && height.is_finite()).then_some(Projection::Orthographic { height })
        }
    }?;
    Some(Camera {
        eye: eye.to_array(),
        target: (eye + forward).to_array(),
        up: up.to_array(),
        projection,
    })
}

/// The light; a spot as a point. `None` without a direction, or with a color that is not finite.
pub(super) fn light(
    light: &gltf::khr_lights_punctual::Light<'_>,
    transform: Mat4,
) -> Option<Light> {
    let color = light.color().map(|channel| channel * light.intensity());
    if !color.iter().all(|channel| channel.is_finite()) {
        return None;
    }
    match light.kind() {
        Kind::Directional => {
            let (_, direction) = position_and_direction(transform)?;
            Some(Light::Directional {
                direction: direction.to_array(),
                color,
            })
        }
        Kind::Point | Kind::Spot { .. } => {
            let position = transform.w_axis.truncate();
            position.is_finite().then_some(Light::Point {
                position: position.to_array(),
                color,
                range: light
                    .range()
                    .filter(|range| *range > 0.0)
                    .unwrap_or(f32::INFINITY),
            })
        }
    }
}

fn position_and_direction(transform: Mat4) -> Option<(Vec3, Vec3)> {
    let position = transform.w_axis.truncate();
    let direction = transform.transform_vector3(Vec3::NEG_Z).try_normalize()?;
    position.is_finite().then_some((position, direction))
}
