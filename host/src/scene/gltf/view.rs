//! Cameras and lights of a glTF scene. Both look along their node's -z.

use super::super::{Camera, Light, Projection};
use super::{GltfError, json};
use glam::{DAffine3, DVec3};

/// The camera with its eye and its target, which is at distance 1. `None` without a direction, an up direction, or an extent.
pub(super) fn camera(
    projection: Projection,
    transform: DAffine3,
) -> Option<(Camera, [[f64; 3]; 2])> {
    let (eye, forward) = position_and_direction(transform)?;
    let up = transform.transform_vector3(DVec3::Y).try_normalize()?;
    if up.as_vec3().cross(forward.as_vec3()) == glam::Vec3::ZERO {
        return None;
    }
    let camera = Camera {
        eye: eye.as_vec3().to_array(),
        target: (eye + forward).as_vec3().to_array(),
        up: up.as_vec3().to_array(),
        projection,
    };
    Some((camera, [eye.to_array(), (eye + forward).to_array()]))
}

/// The projection; `None` for one of an unknown type.
pub(super) fn projection(
    camera: &json::Camera,
    index: usize,
) -> Result<Option<Projection>, GltfError> {
    let lacking = GltfError::CameraWithoutValues { camera: index };
    let refuse = |member, value: f32, expected| GltfError::CameraExtent {
        camera: index,
        member,
        value: value.to_string(),
        expected,
    };
    match camera.kind.as_str() {
        "perspective" => {
            let yfov = camera.perspective.as_ref().ok_or(lacking)?.yfov;
            let vertical_fov = yfov.to_degrees();
            match vertical_fov > 0.0 && vertical_fov < 180.0 {
                true => Ok(Some(Projection::Perspective { vertical_fov })),
                false => Err(refuse("yfov", yfov, "between 0 and π")),
            }
        }
        "orthographic" => {
            let ymag = camera.orthographic.as_ref().ok_or(lacking)?.ymag;
            let height = 2.0 * ymag.abs();
            match height > 0.0 && height.is_finite() {
                true => Ok(Some(Projection::Orthographic { height })),
                false => Err(refuse("ymag", ymag, "a height")),
            }
        }
        _ => Ok(None),
    }
}

/// The light with its position; a spot as a point. `None` without a direction, or with a color that is not finite.
pub(super) fn light(light: &json::Light, transform: DAffine3) -> Option<(Light, [f64; 3])> {
    let intensity = light.intensity.unwrap_or(1.0);
    let color = light.color.unwrap_or([1.0; 3]);
    let color = color.map(|channel| channel * intensity);
    if !color.iter().all(|channel| channel.is_finite()) {
        return None;
    }
    let position = transform.translation;
    let light = if light.kind == "directional" {
        let (_, direction) = position_and_direction(transform)?;
        Light::Directional {
            direction: direction.as_vec3().to_array(),
            color,
        }
    } else {
        position.as_vec3().is_finite().then_some(Light::Point {
            position: position.as_vec3().to_array(),
            color,
            range: light
                .range
                .filter(|range| *range > 0.0)
                .unwrap_or(f32::INFINITY),
        })?
    };
    Some((light, position.to_array()))
}

fn position_and_direction(transform: DAffine3) -> Option<(DVec3, DVec3)> {
    let position = transform.translation;
    let direction = transform.transform_vector3(DVec3::NEG_Z).try_normalize()?;
    let is_finite = position.as_vec3().is_finite();
    is_finite.then_some((position, direction))
}
