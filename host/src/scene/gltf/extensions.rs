//! The effect of extensions that are not read, by their names.

use super::super::load::Source;
use super::json::Root;
use crate::text::excerpt;
use std::collections::BTreeSet;

/// The effect of an extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    /// It is read, or no picture depends on it.
    None,
    /// It is a texture's or a material's, which are noted where they are used.
    OfMaterials,
    /// It changes colors.
    Looks,
    /// It may change geometry.
    Unknown,
}

/// Extensions that are read, or that no picture depends on. A `*` stands for any end.
const WITHOUT_EFFECT: [&str; 33] = [
    "AGI_*",
    "EXT_feature_metadata",
    "EXT_instance_features",
    "EXT_mesh_features",
    "EXT_mesh_gpu_instancing",
    "EXT_mesh_manifold",
    "EXT_meshopt_compression",
    "EXT_structural_metadata",
    "FB_*",
    "GODOT_*",
    "KHR_accessor_float64",
    "KHR_animation_pointer",
    "KHR_audio*",
    "KHR_collision_shapes",
    "KHR_draco_mesh_compression",
    "KHR_implicit_shapes",
    "KHR_interactivity",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_node_visibility",
    "KHR_physics_*",
    "KHR_rigid_bodies",
    "KHR_xmp*",
    "MOZ_*",
    "MSFT_audio_emitter",
    "MSFT_lod",
    "MSFT_physics",
    "MSFT_screencoverage",
    "OMI_*",
    "VRMC_springBone*",
];

/// Extensions of textures and materials.
const OF_MATERIALS: [&str; 9] = [
    "ADOBE_materials_*",
    "EXT_materials_*",
    "EXT_texture_*",
    "KHR_materials_*",
    "KHR_texture_*",
    "KHR_techniques_webgl",
    "MSFT_packing_*",
    "MSFT_texture_*",
    "VRMC_materials_*",
];

/// Extensions that change colors.
const LOOKS: [&str; 9] = [
    "CESIUM_primitive_outline",
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "KHR_blend",
    "KHR_environment_map",
    "KHR_lights_environment",
    "KHR_lights_image_based",
    "VRM",
    "VRMC_vrm",
];

/// Extensions of materials that are read, or whose effect has a note of its own.
const MATERIALS_READ: [&str; 4] = [
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_variants",
];

/// The effect of the extension of this name.
pub(super) fn effect(name: &str) -> Effect {
    let is_in = |list: &[&str]| list.iter().any(|known| is_match(known, name));
    if is_in(&WITHOUT_EFFECT) {
        Effect::None
    } else if is_in(&OF_MATERIALS) {
        Effect::OfMaterials
    } else if is_in(&LOOKS) {
        Effect::Looks
    } else {
        Effect::Unknown
    }
}

/// Whether a material's extension changes its color in a way that is not read.
pub(super) fn changes_material(name: &str) -> bool {
    !MATERIALS_READ.contains(&name)
}

/// Notes extensions that are not read, whether they are declared or not. `names` are those of nodes and primitives; those of materials
/// are noted already.
pub(super) fn note(root: &Root, names: &BTreeSet<String>, source: &Source<'_>) {
    let declared = root.extensions_used.iter();
    let declared = declared.chain(root.extensions_required.iter());
    let names = names.iter().chain(declared.map(|(_, name)| name));
    let names = names.chain(root.extensions.others.keys());
    let names = names.chain(root.scenes.needed().flat_map(|it| it.extensions.keys()));
    let names = names.chain(root.meshes.needed().flat_map(|it| it.extensions.keys()));
    let names = names.chain(root.skins.needed().flat_map(|it| it.extensions.keys()));
    let names = names.chain(root.cameras.needed().flat_map(|it| it.extensions.keys()));
    let lights = root.extensions.lights.lights.needed();
    let names = names.chain(lights.flat_map(|it| it.extensions.keys()));
    let accessors = root.accessors.needed();
    let names = names.chain(accessors.flat_map(|it| it.extensions.keys()));
    let views = root.buffer_views.needed();
    let names = names.chain(views.flat_map(|it| it.extensions.keys()));
    let names = names.chain(root.buffers.needed().flat_map(|it| it.extensions.keys()));
    for name in names.collect::<BTreeSet<&String>>() {
        let what = format!("extension \"{}\"", excerpt(name));
        let is_told = source.left_out.borrow().iter().any(|it| it.what == what);
        if matches!(effect(name), Effect::Looks | Effect::Unknown) && !is_told {
            source.leave_out(&what, 1);
        }
    }
}

fn is_match(known: &str, name: &str) -> bool {
    match known.strip_suffix('*') {
        Some(start) => name.starts_with(start),
        None => name == known,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extensions_have_the_effect_of_their_kind() {
        assert_eq!(effect("EXT_structural_metadata"), Effect::None);
        assert_eq!(effect("KHR_xmp_json_ld"), Effect::None);
        assert_eq!(effect("KHR_materials_clearcoat"), Effect::OfMaterials);
        assert_eq!(effect("KHR_texture_basisu"), Effect::OfMaterials);
        assert_eq!(effect("EXT_lights_image_based"), Effect::Looks);
        assert_eq!(effect("KHR_gaussian_splatting"), Effect::Unknown);
        assert_eq!(effect("KHR_lights_punctual_2"), Effect::Unknown);
        assert!(changes_material("KHR_materials_clearcoat"));
        assert!(!changes_material("KHR_materials_ior"));
    }
}
