//! What the file has and the scene does not is noted.

use super::draft::*;
use super::*;
use serde_json::json;

/// The box with this material.
fn with_material(material: serde_json::Value) -> Draft {
    let mut draft = Draft::new();
    draft.json["materials"] = json!([{"normalTexture": {"index": 7}}, material]);
    draft.primitive()["material"] = json!(1);
    draft
}

fn note(material: serde_json::Value) -> Vec<String> {
    left_out(&with_material(material).load())
}

#[test]
fn materials_in_use_are_noted() {
    assert!(note(json!({})).is_empty());
    assert_eq!(
        note(json!({"emissiveTexture": {"index": 3}})),
        ["1 texture"]
    );
    let textures = json!({
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
        "normalTexture": {"index": 2}, "occlusionTexture": {"index": 1},
        "extensions": {"KHR_materials_transmission": {"transmissionTexture": {"index": 4}}}
    });
    assert_eq!(note(textures), ["4 textures"]);
    assert_eq!(
        note(json!({"emissiveFactor": [0, 0, 0.5]})),
        ["1 material with emission"]
    );
    let coated = json!({"extensions": {"KHR_materials_clearcoat": {}, "KHR_materials_unlit": {}, "KHR_materials_ior": {}}});
    assert_eq!(
        note(coated),
        [
            "1 extension \"KHR_materials_clearcoat\"",
            "1 extension \"KHR_materials_unlit\""
        ]
    );
}

#[test]
fn transparency_is_noted_where_it_has_an_effect() {
    let alpha = |mode: &str, alpha: f32, texture: bool| {
        let mut material = json!({"alphaMode": mode, "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, alpha]}});
        if texture {
            material["pbrMetallicRoughness"]["baseColorTexture"] = json!({"index": 0});
        }
        note(material)
    };
    let transparent = "1 material with transparency (alphaMode)";
    assert_eq!(alpha("BLEND", 0.5, false), [transparent]);
    assert_eq!(alpha("MASK", 1.0, true), ["1 texture", transparent]);
    assert!(alpha("BLEND", 1.0, false).is_empty());
    assert!(alpha("MASK", 0.75, false).is_empty());
    assert!(alpha("OPAQUE", 0.0, false).is_empty());
}

#[test]
fn what_has_no_alpha_is_invisible() {
    for material in [
        json!({"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.0]}}),
        json!({"alphaMode": "MASK", "alphaCutoff": 0.875, "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.75]}}),
        json!({"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0]}}),
    ] {
        let mut draft = with_material(material);
        draft.push(
            "meshes",
            json!({"primitives": [{"attributes": {"POSITION": 0}}]}),
        );
        draft.json["nodes"] = json!([{"mesh": 0}, {"mesh": 1}]);
        draft.json["scenes"][0]["nodes"] = json!([0, 1]);
        let scene = draft.load();
        assert_eq!(scene.mesh.indices.len(), 2);
        assert_eq!(left_out(&scene)[0], "1 invisible primitive (alpha)");
    }
}

#[test]
fn sides_are_those_of_the_file() {
    let sides = |material| with_material(material).load().material_of(0).double_sided;
    assert!(sides(json!({"doubleSided": true})));
    assert!(!sides(json!({"doubleSided": false})));
    assert!(!sides(json!({})));
    let mut draft = with_material(json!({"doubleSided": true}));
    draft
        .primitive()
        .as_object_mut()
        .expect("a primitive")
        .remove("material");
    let scene = draft.load();
    assert_eq!(scene.materials.len(), 3);
    assert!(!scene.material_of(0).double_sided);
    assert!(Material::default().double_sided);
}

#[test]
fn points_lines_and_colours_are_noted() {
    let mut draft = Draft::new();
    let primitives = draft
        .at("/meshes/0/primitives")
        .as_array_mut()
        .expect("primitives");
    primitives[0]["attributes"]["COLOR_0"] = json!(99);
    primitives.extend([
        json!({"attributes": {"POSITION": 0}, "mode": 0}),
        json!({"attributes": {"POSITION": 0}, "mode": 1}),
        json!({"attributes": {"POSITION": 0}, "mode": 2}),
        json!({"attributes": {"POSITION": 0}, "mode": 3}),
        json!({"attributes": {"NORMAL": 0}}),
    ]);
    let scene = draft.load();
    assert_is_box(&scene);
    assert_eq!(
        left_out(&scene),
        [
            "8 vertex colours",
            "8 points",
            "19 lines",
            "1 primitive without positions"
        ]
    );
    draft.primitive()["mode"] = json!(7);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": meshes[0].primitives[0].mode is 7, which is not a mode of primitives"
    );
}

#[test]
fn animations_lights_and_extensions_are_noted() {
    let mut draft = Draft::new();
    draft.json["animations"] = json!([{}, {}]);
    draft.json["scenes"] = json!([{"nodes": [0]}, {}]);
    draft.json["extensions"] =
        json!({"KHR_lights_punctual": {"lights": [{"type": "spot"}, {"type": "tube"}]}});
    draft.json["nodes"][0]["children"] = json!([1, 2]);
    draft.push(
        "nodes",
        json!({"extensions": {"KHR_lights_punctual": {"light": 0}}}),
    );
    draft.push(
        "nodes",
        json!({"extensions": {"KHR_lights_punctual": {"light": 1}}}),
    );
    draft.json["extensionsUsed"] = json!([
        "ABC_unknown",
        "EXT_lights_image_based",
        "EXT_structural_metadata",
        "KHR_animation_pointer",
        "KHR_lights_punctual",
        "KHR_materials_sheen",
        "KHR_materials_variants",
        "KHR_node_visibility",
        "KHR_texture_transform",
        "KHR_xmp_json_ld",
        "MSFT_lod"
    ]);
    draft.json["extensionsRequired"] = json!(["EXT_lights_image_based", "KHR_materials_sheen"]);
    let scene = draft.load();
    assert_eq!(scene.lights.len(), 1);
    assert_eq!(
        left_out(&scene),
        [
            "1 cone of spot lights",
            "1 light of an unknown type",
            "2 animations",
            "1 scene besides the default one",
            "1 extension \"ABC_unknown\"",
            "1 extension \"EXT_lights_image_based\""
        ]
    );
}

#[test]
fn what_other_nodes_hold_is_noted() {
    let mut draft = Draft::new();
    draft.push("meshes", json!({}));
    draft.push("nodes", json!({"mesh": 1}));
    assert_eq!(
        left_out(&draft.load()),
        ["1 mesh that no node of the scene has"]
    );
    draft.json["nodes"][1]["extensions"] = json!({"KHR_node_visibility": {"visible": false}});
    draft.json["scenes"][0]["nodes"] = json!([0, 1]);
    assert_eq!(
        left_out(&draft.load()),
        ["1 hidden node", "1 mesh that no node of the scene has"]
    );
    let mut draft = Draft::new();
    draft.push("nodes", json!({"mesh": 0}));
    draft.json["nodes"][0]["extensions"] = json!({"MSFT_lod": {"ids": [1]}});
    assert_eq!(left_out(&draft.load()), ["1 level of detail"]);
}

#[test]
fn corners_that_fill_no_triangle_are_noted() {
    for (mode, count, spare) in [(4, 35, 2), (4, 34, 1), (5, 2, 2), (6, 1, 1), (5, 36, 0)] {
        let mut draft = Draft::new();
        let primitive = draft.primitive().clone();
        let primitives = draft.at("/meshes/0/primitives").as_array_mut();
        primitives.expect("primitives").push(primitive);
        let indices = draft.accessor("SCALAR", UNSIGNED_BYTE, count, &vec![0; count]);
        draft.primitive()["indices"] = json!(indices);
        draft.primitive()["mode"] = json!(mode);
        let expected = match spare {
            0 => vec![],
            1 => vec!["1 corner without a triangle".to_owned()],
            _ => vec![format!("{spare} corners without a triangle")],
        };
        assert_eq!(left_out(&draft.load()), expected, "{mode} {count}");
    }
}

#[test]
fn variants_and_undeclared_extensions_are_noted() {
    let mut draft = Draft::new();
    draft.primitive()["extensions"] =
        json!({"KHR_materials_variants": {"mappings": []}, "ABC_primitive": {}});
    draft.json["nodes"][0]["extensions"] = json!({"ABC_node": 3});
    draft.json["extensions"] = json!({"ABC_root": [], "KHR_materials_variants": {}});
    draft.push("nodes", json!({"extensions": {"ABC_elsewhere": {}}}));
    assert_eq!(
        left_out(&draft.load()),
        [
            "1 primitive with material variants",
            "1 extension \"ABC_node\"",
            "1 extension \"ABC_primitive\"",
            "1 extension \"ABC_root\"",
        ]
    );
}

#[test]
fn indices_of_textures_in_any_notation() {
    assert_eq!(
        note(json!({"normalTexture": {"index": 0.0}})),
        ["1 texture"]
    );
    assert_eq!(
        note(json!({"normalTexture": {"index": 2.0}, "occlusionTexture": {"index": 2}})),
        ["1 texture"]
    );
}

#[test]
fn cameras_of_an_unknown_type_are_noted() {
    let mut draft = Draft::new();
    draft.json["cameras"] = json!([{"type": "fisheye"}]);
    draft.json["nodes"][0]["camera"] = json!(0);
    let scene = draft.load();
    assert!(scene.cameras.is_empty());
    assert_eq!(left_out(&scene), ["1 camera of an unknown type"]);
}

#[test]
fn undeclared_extensions_of_every_part_are_noted_once() {
    let mut draft = poses::skinned();
    let unused = draft.floats("VEC3", &[0.0; 3]);
    draft.json["materials"] =
        json!([{"extensions": {"ABC_material": {}}}, {"extensions": {"ABC_unused": {}}}]);
    draft.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1}}]);
    draft.json["nodes"][0]["camera"] = json!(0);
    draft.json["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
    draft.primitive()["material"] = json!(0);
    draft.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "point"}]}});
    // Declared as well.
    draft.json["extensionsUsed"] = json!(["ABC_material", "KHR_lights_punctual"]);
    let positions = draft.primitive()["attributes"]["POSITION"].clone();
    for (path, name) in [
        ("/scenes/0", "ABC_scene"),
        ("/meshes/0", "ABC_mesh"),
        ("/skins/0", "ABC_skin"),
        ("/cameras/0", "ABC_camera"),
        ("/extensions/KHR_lights_punctual/lights/0", "ABC_light"),
        (&*format!("/accessors/{positions}"), "ABC_accessor"),
        (&*format!("/accessors/{unused}"), "ABC_unused"),
        ("/bufferViews/0", "ABC_unused"),
        ("/bufferViews/1", "ABC_view"),
    ] {
        draft.at(path)["extensions"] = json!({ name: {}, "KHR_xmp_json_ld": {} });
    }
    let parts = [
        "material", "accessor", "camera", "light", "mesh", "scene", "skin", "view",
    ];
    let expected = parts.map(|part| format!("1 extension \"ABC_{part}\""));
    assert_eq!(left_out(&draft.load()), expected);
}

#[test]
fn nodes_outside_every_scene_are_noted() {
    let mut draft = Draft::new();
    draft.json["nodes"] = json!([
        {"mesh": 0, "extensions": {"MSFT_lod": {"ids": [1]}}},
        // A level of detail with a child, and a node of another scene with a child.
        {"children": [2]},
        {"mesh": 0},
        {"children": [4]},
        {"mesh": 0, "camera": 0},
        // Of no scene: those that hold something count.
        {"children": [6, 7, 8, 9]},
        {"mesh": 0},
        {"camera": 0},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}},
        {}
    ]);
    draft.json["scenes"] = json!([{"nodes": [0]}, {"nodes": [3]}]);
    let scene = draft.load();
    assert_is_box(&scene);
    assert_eq!(
        left_out(&scene),
        [
            "1 level of detail",
            "1 scene besides the default one",
            "3 nodes outside every scene"
        ]
    );
}

#[test]
fn all_chunks_and_bytes_that_are_not_read_are_noted() {
    let mut glb = binary();
    let sound = left_out(&Files::with("x.glb", &glb).load("x.glb"));
    let word = |number: usize| (number as u32).to_le_bytes();
    // A second binary chunk, half a chunk's header, and bytes behind the announced length.
    glb.extend([&word(4)[..], b"BIN\0", &[1, 2, 3, 4]].concat());
    glb.extend([0; 4]);
    let length = glb.len();
    glb[8..12].copy_from_slice(&word(length));
    glb.extend([7; 5]);
    let found = left_out(&Files::with("x.glb", &glb).load("x.glb"));
    let expected = [
        "9 bytes behind the end",
        "1 chunk after the first of their type",
    ];
    assert_eq!(found[..2], expected);
    assert_eq!(found[2..], sound);
}
