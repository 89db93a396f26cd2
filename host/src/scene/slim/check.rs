//! The check of saved content: a picture can be made of it.

use super::error::ContentError;
use crate::{Aabb, Bvh, Scene};

/// Checks a scene, a hierarchy over it, and the box for the default camera.
pub fn check(scene: &Scene, bvh: &Bvh, framing: Option<Aabb>) -> Result<(), ContentError> {
    let mesh = &scene.mesh;
    mesh.validate()?;
    let is_finite = |v: &[f32; 3]| v.iter().all(|x| x.is_finite());
    if let Some(vertex) = mesh.normals.iter().position(|normal| !is_finite(normal)) {
        return Err(ContentError::Normal { vertex });
    }
    // Without materials there is one default material.
    let count = scene.materials.len().max(1);
    let mut used = mesh.materials.iter();
    if let Some(triangle) = used.position(|&material| material as usize >= count) {
        return Err(ContentError::NoSuchMaterial {
            triangle,
            material: mesh.materials[triangle],
            count,
        });
    }
    for (material, it) in scene.materials.iter().enumerate() {
        let mut shares = it.base_color.iter().chain([&it.mirror, &it.transmission]);
        if !shares.all(|share| (0.0..=1.0).contains(share)) || !it.ior.is_finite() {
            return Err(ContentError::Material { material });
        }
    }
    for (part, it) in mesh.parts.iter().enumerate() {
        let length = it.name.len();
        if u32::try_from(length).is_err() {
            return Err(ContentError::LongName { part, length });
        }
    }
    for (camera, it) in scene.cameras.iter().enumerate() {
        it.to_core([1, 1], 1)
            .map_err(|error| ContentError::Camera { camera, error })?;
    }
    for (index, light) in scene.lights.iter().enumerate() {
        light.to_core(index).map_err(ContentError::Light)?;
    }
    if framing.is_some_and(|framing| !is_box(&framing)) {
        return Err(ContentError::Framing);
    }
    bvh.validate_over(mesh)?;
    Ok(())
}

fn is_box(bounds: &Aabb) -> bool {
    let (low, high) = (bounds.min, bounds.max);
    low.is_finite() && high.is_finite() && low.cmple(high).all()
}
