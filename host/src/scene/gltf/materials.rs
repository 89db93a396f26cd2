//! Materials of a glTF scene.

use super::super::Material;
use super::super::faces::share;
use super::super::load::Source;
use super::extensions::changes_material;
use super::json;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeSet;

/// The material of primitives without one.
pub(super) fn without() -> Material {
    Material {
        double_sided: false,
        ..Material::default()
    }
}

/// The base color; a smooth metal as a mirror; a transmitting material as glass, rough or not.
pub(super) fn convert(material: &json::Material) -> Material {
    const LEAST_METALLIC: f32 = 0.5;
    const MOST_ROUGH: f32 = 0.2;
    let pbr = &material.pbr_metallic_roughness;
    let [r, g, b, _] = pbr.base_color_factor.unwrap_or([1.0; 4]);
    let metallic = pbr.metallic_factor.unwrap_or(1.0);
    let is_mirror = metallic >= LEAST_METALLIC && pbr.roughness_factor.unwrap_or(1.0) <= MOST_ROUGH;
    let number = |extension: &str, member: &str| {
        let extension = material.extensions.get(extension)?;
        Some(extension.get(member)?.as_f64()? as f32)
    };
    Material {
        base_color: [r, g, b].map(share),
        mirror: match is_mirror {
            true => share(metallic),
            false => 0.0,
        },
        transmission: share(
            number("KHR_materials_transmission", "transmissionFactor").unwrap_or(0.0),
        ),
        ior: number("KHR_materials_ior", "ior").unwrap_or(Material::default().ior),
        double_sided: material.double_sided.unwrap_or(false),
    }
}

/// The opacity of the whole material, which textures and vertex colours can only lower.
fn alpha(material: &json::Material) -> f32 {
    let color = material.pbr_metallic_roughness.base_color_factor;
    color.map_or(1.0, |[_, _, _, alpha]| alpha)
}

/// Whether nothing is seen of the material: its alpha is below the cutoff of its mask, or zero where it is blended.
pub(super) fn is_invisible(material: &json::Material) -> bool {
    match material.alpha_mode.as_deref() {
        Some("MASK") => alpha(material) < material.alpha_cutoff.unwrap_or(0.5),
        Some("BLEND") => alpha(material) <= 0.0,
        _ => false,
    }
}

/// Whether something is seen through the material, though not by transmission.
fn is_transparent(material: &json::Material) -> bool {
    let has_texture = texture(&material.pbr_metallic_roughness.base_color_texture).is_some();
    match material.alpha_mode.as_deref() {
        Some("MASK") => has_texture,
        Some("BLEND") => has_texture || alpha(material) < 1.0,
        _ => false,
    }
}

/// Notes what materials in use have, and pictures do not show.
pub(super) fn note<'m>(materials: impl Iterator<Item = &'m json::Material>, source: &Source<'_>) {
    let (mut all_textures, mut all_extensions) = (BTreeSet::new(), BTreeSet::new());
    let (mut transparent, mut emissive) = (0, 0);
    for material in materials {
        let pbr = &material.pbr_metallic_roughness;
        let own = [
            &pbr.base_color_texture,
            &pbr.metallic_roughness_texture,
            &material.normal_texture,
            &material.occlusion_texture,
            &material.emissive_texture,
        ];
        all_textures.extend(own.into_iter().filter_map(texture));
        for (name, extension) in &material.extensions {
            textures_within(extension, &mut all_textures);
            if changes_material(name) {
                all_extensions.insert(name.as_str());
            }
        }
        transparent += usize::from(is_transparent(material));
        let emission = material.emissive_factor.unwrap_or_default();
        emissive += usize::from(emission.iter().any(|channel| *channel > 0.0));
    }
    source.leave_out("textures", all_textures.len());
    source.leave_out("materials with transparency (alphaMode)", transparent);
    source.leave_out("materials with emission", emissive);
    for name in all_extensions {
        let what = format!("extension \"{}\"", crate::text::excerpt(name));
        source.leave_out(&what, 1);
    }
}

/// The index of a texture.
fn texture(info: &Value) -> Option<usize> {
    let index = info.get("index")?;
    Some(json::Index::deserialize(index).ok()?.0)
}

/// Collects the textures of an extension: members such as `clearcoatTexture`.
fn textures_within(extension: &Value, found: &mut BTreeSet<usize>) {
    match extension {
        Value::Object(members) => {
            for (name, member) in members {
                match texture(member).filter(|_| name.ends_with("Texture")) {
                    Some(index) => drop(found.insert(index)),
                    None => textures_within(member, found),
                }
            }
        }
        Value::Array(items) => {
            for item in items {
                textures_within(item, found);
            }
        }
        _ => {}
    }
}
