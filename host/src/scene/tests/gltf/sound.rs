//! Sound files are read, and those that cannot be decoded are refused by name.

use super::draft::*;
use super::*;
use serde_json::json;

/// The box with other members of the document.
fn with(members: &[(&str, serde_json::Value)]) -> Draft {
    let mut draft = Draft::new();
    for (name, value) in members {
        draft.json[*name] = value.clone();
    }
    draft
}

#[test]
fn attributes_of_applications_are_skipped() {
    let mut draft = Draft::new();
    draft.primitive()["attributes"]["_FEATURE_ID_0"] = json!(0);
    draft.primitive()["attributes"]["TEXCOORD_7"] = json!(99);
    draft.primitive()["attributes"]["CUSTOM"] = json!(1);
    assert_is_box(&draft.load());
}

#[test]
fn what_is_not_read_refuses_nothing() {
    for (member, value) in [
        (
            "animations",
            json!([{"channels": [{"sampler": 9, "target": {"path": "pointer"}}], "samplers": []}]),
        ),
        (
            "animations",
            json!([{"channels": [{"sampler": 0, "target": {"path": 7}}]}, 3]),
        ),
        (
            "skins",
            json!([{"joints": [77], "inverseBindMatrices": 99}]),
        ),
        ("textures", json!([{"source": 99, "sampler": 99}])),
        (
            "images",
            json!([{"uri": "nowhere.png"}, {"bufferView": 99, "mimeType": "image/x"}, {}]),
        ),
        ("samplers", json!([{"magFilter": 1, "wrapS": "x"}])),
        ("cameras", json!([{"type": "fisheye"}, {}])),
        (
            "materials",
            json!([{"extras": {"a": [1]}, "normalTexture": {"index": 99}, "alphaMode": "OTHER"}]),
        ),
        ("extras", json!({"nodes": 1})),
        (
            "extensions",
            json!({"KHR_materials_variants": {"variants": 3}}),
        ),
        (
            "nodes",
            json!([{"mesh": 0}, {"children": [99], "mesh": 99}, {"children": [2]}]),
        ),
        ("accessors", json!(null)),
        ("scenes", json!([{"nodes": [0]}, {"nodes": [99]}, {}])),
    ] {
        let mut draft = Draft::new();
        match value.is_null() {
            // Neither least nor greatest positions are needed, and wrong ones are not read.
            true => draft.json[member][0]["min"] = json!("x"),
            false => draft.json[member] = value,
        }
        assert_is_box(&draft.load());
    }
    // A buffer that only images use may be away; one in use may not.
    let mut draft = Draft::new();
    draft.push(
        "buffers",
        json!({"byteLength": 9, "uri": "https://example.org/a.png"}),
    );
    draft.push("buffers", json!({"byteLength": 9}));
    assert_is_box(&draft.load());
    draft.json["bufferViews"][0]["buffer"] = json!(2);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": buffer 2 has no address, and the file has no binary chunk for it"
    );
}

#[test]
fn scenes_may_be_missing_or_empty() {
    assert_is_box(&with(&[("scenes", json!(null))]).load());
    assert_is_box(&with(&[("scenes", json!([{}, {"nodes": [0]}]))]).load());
    assert_is_box(&with(&[("scenes", json!([{}, {"nodes": [0]}])), ("scene", json!(1))]).load());
    assert_eq!(
        with(&[("scenes", json!([{}, {"nodes": [0]}])), ("scene", json!(0))]).refusal(),
        "\"x.gltf\" holds no triangles, only 1 mesh that no node of the scene has, 1 scene besides the default one"
    );
    assert_eq!(
        with(&[("scene", json!(7))]).refusal(),
        "\"x.gltf\": scene is 7, but the number of scenes is 1"
    );
    assert_eq!(
        with(&[("scenes", json!([{"nodes": [7]}]))]).refusal(),
        "\"x.gltf\": scenes[0].nodes[0] is 7, but the number of nodes is 1"
    );
    // Without scenes, the levels of detail are no roots.
    let levels = json!([{"mesh": 0, "extensions": {"MSFT_lod": {"ids": [1]}}}, {"mesh": 0}]);
    assert_is_box(&with(&[("scenes", json!([])), ("nodes", levels)]).load());
}

#[test]
fn byte_order_marks_and_filled_chunks_are_read() {
    let text = Draft::new().text();
    assert_is_box(&Files::with("x.gltf", format!("\u{feff}{text}")).load("x.gltf"));
    let mut json = format!("\u{feff}{text}").into_bytes();
    json.resize(json.len().next_multiple_of(4), 0);
    let word = |number: usize| (number as u32).to_le_bytes();
    let mut glb = [
        b"glTF".as_slice(),
        &word(2),
        &word(0),
        &word(json.len()),
        b"JSON",
        &json,
    ]
    .concat();
    glb.extend([&word(3)[..], b"ABCD", &[1, 2, 3, 0]].concat());
    let length = glb.len();
    glb[8..12].copy_from_slice(&word(length));
    let scene = Files::with("x.glb", &glb).load("x.glb");
    assert_is_box(&scene);
    assert_eq!(left_out(&scene), ["1 chunk of unknown types"]);
    let behind = [&glb, &b"behind"[..]].concat();
    let scene = Files::with("x.glb", &behind).load("x.glb");
    assert_is_box(&scene);
    assert_eq!(left_out(&scene)[0], "6 bytes behind the end");
    glb[12..16].copy_from_slice(&word(length));
    assert_eq!(
        Files::with("x.glb", &glb).refusal("x.glb"),
        format!(
            "\"x.glb\": the GLB file cannot be taken apart: a chunk announces {length} bytes, {} are there",
            length - 20
        )
    );
}

#[test]
fn other_versions_are_refused_by_name() {
    let convert = "but slimbvh reads glTF 2.0; convert it, for example with `gltf-pipeline -i in.gltf -o out.glb`";
    let one = r#"{"asset": {"version": "1.0"}, "meshes": {"a": {}}}"#;
    assert_eq!(
        Files::with("x.gltf", one).refusal("x.gltf"),
        format!("\"x.gltf\": the file is glTF 1.0, {convert}")
    );
    let mut glb = binary();
    glb[4] = 1;
    assert_eq!(
        Files::with("x.glb", glb).refusal("x.glb"),
        format!("\"x.glb\": the file is glTF 1, {convert}")
    );
    assert_is_box(&with(&[("asset", json!({"version": 2.0}))]).load());
    assert_is_box(&with(&[("asset", json!({"version": "2.1"}))]).load());
}

#[test]
fn positions_of_every_type() {
    let bytes = |kind: u32| -> Vec<u8> {
        let corners = CORNERS.as_flattened().iter();
        corners
            .flat_map(|&x| match kind {
                BYTE => (-x as i8).to_le_bytes().to_vec(),
                UNSIGNED_BYTE => vec![x as u8],
                SHORT => (-x as i16).to_le_bytes().to_vec(),
                UNSIGNED_SHORT => (x as u16).to_le_bytes().to_vec(),
                5130 => f64::from(x).to_le_bytes().to_vec(),
                _ => x.to_le_bytes().to_vec(),
            })
            .collect()
    };
    for (kind, one) in [
        (BYTE, -127.0),
        (UNSIGNED_BYTE, 255.0),
        (SHORT, -32767.0),
        (UNSIGNED_SHORT, 65535.0),
        (FLOAT, 1.0),
        (5130, 1.0),
    ] {
        for is_share in [false, true] {
            let mut draft = Draft::new();
            let positions = draft.accessor("VEC3", kind, 8, &bytes(kind));
            draft.primitive()["attributes"]["POSITION"] = json!(positions);
            draft.json["accessors"][positions]["normalized"] = json!(is_share);
            let one: f64 = if is_share { one } else { f64::signum(one) };
            draft.json["nodes"][0]["scale"] = json!([one, one, one]);
            let scene = draft.load();
            assert_eq!(extent(&scene), [1.0, 2.0, 3.0], "{kind} {is_share}");
            assert_eq!(volume(&scene).abs().round(), 6.0, "{kind} {is_share}");
        }
    }
}

#[test]
fn compressed_geometry_is_refused_by_the_extensions_name() {
    let unpack = "which slimbvh cannot decode; unpack the file, for example with `gltf-transform copy in.glb out.glb`";
    let mut draft = Draft::new();
    draft.primitive()["extensions"] =
        json!({"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}});
    draft.json["extensionsUsed"] = json!(["KHR_draco_mesh_compression"]);
    // Accessors with data are a fallback.
    assert_is_box(&draft.load());
    assert!(draft.load().left_out.is_empty());
    for required in [json!([]), json!(["KHR_draco_mesh_compression"])] {
        for accessor in [0, 1] {
            let mut draft = draft.clone();
            draft.json["extensionsRequired"] = required.clone();
            draft.json["accessors"][accessor]
                .as_object_mut()
                .expect("an accessor")
                .remove("bufferView");
            assert_eq!(
                draft.refusal(),
                format!(
                    "\"x.gltf\": meshes[0].primitives[0] is compressed by KHR_draco_mesh_compression, {unpack}"
                )
            );
        }
    }

    for name in ["EXT_meshopt_compression", "KHR_meshopt_compression"] {
        let mut draft = Draft::new();
        let view = json!({"buffer": 1, "byteOffset": 0, "byteLength": 9, "mode": "TRIANGLES"});
        draft.json["bufferViews"][1]["extensions"] = json!({ name: view });
        // A buffer with data is a fallback.
        assert_is_box(&draft.load());
        draft.push(
            "buffers",
            json!({"byteLength": 9999, "extensions": {name: {"fallback": true}}}),
        );
        draft.json["bufferViews"][1]["buffer"] = json!(1);
        draft.json["extensionsRequired"] = json!([name]);
        assert_eq!(
            draft.refusal(),
            format!("\"x.gltf\": bufferViews[1] is compressed by {name}, {unpack}")
        );
    }
}

#[test]
fn shared_positions_are_read_where_triangles_use_them() {
    let mut draft = Draft::new();
    let two = draft.accessor("SCALAR", UNSIGNED_BYTE, 3, &[7, 2, 4]);
    *draft.primitive() = json!({"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": two});
    let mesh = draft.load().mesh;
    assert_eq!(mesh.vertices, [CORNERS[2], CORNERS[4], CORNERS[7]]);
    assert_eq!(mesh.indices, [[2, 0, 1]]);
    assert_eq!(mesh.normals[..2], [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let wrong = draft.accessor("SCALAR", UNSIGNED_BYTE, 6, &[7, 2, 4, 7, 2, 8]);
    draft.primitive()["indices"] = json!(wrong);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": mesh \"node 0\", face 1 names vertex 8, but there are only 8 vertices"
    );
    let scene = Files::with("x.gltf", draft.text()).load_leniently("x.gltf");
    assert_eq!((scene.mesh.indices.len(), scene.dropped_face_count), (1, 1));
}

#[test]
fn what_nothing_refers_to_may_be_broken() {
    let broken = [json!({}), json!(7), json!({"name": [1]})];
    for list in [
        "accessors",
        "bufferViews",
        "buffers",
        "cameras",
        "materials",
        "meshes",
        "skins",
    ] {
        for item in &broken {
            let mut draft = Draft::new();
            draft.push(list, item.clone());
            assert_is_box(&draft.load());
        }
    }
    for member in [
        json!({"bufferView": "x"}),
        json!({"byteOffset": -1, "componentType": 5126, "count": 1.5}),
    ] {
        let mut draft = Draft::new();
        draft.push("accessors", member);
        assert_is_box(&draft.load());
    }
    // A node of no scene, names that are none, and lists that are none.
    let mut draft = Draft::new();
    draft.push("nodes", json!({"mesh": "x", "children": 3}));
    draft.json["nodes"][0]["name"] = json!(7);
    draft.at("/meshes/0")["name"] = json!({});
    draft.json["skins"] = json!("x");
    draft.json["cameras"] = json!(3.5);
    draft.json["materials"] = json!({"a": [1]});
    draft.json["extensionsUsed"] = json!([7, "KHR_materials_ior"]);
    draft.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [3, {"type": 4}]}});
    assert_is_box(&draft.load());
}

#[test]
fn what_is_broken_and_referred_to_is_named() {
    let mut draft = Draft::new();
    draft.json["accessors"][1] = json!({"componentType": 5121, "type": "SCALAR"});
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": item 1 of the accessors cannot be read: missing field `count`"
    );
    let mut draft = Draft::new();
    draft.json["bufferViews"][0]["byteLength"] = json!("96");
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": item 0 of the buffer views cannot be read: invalid type: string \"96\", expected a whole number that is not negative"
    );
    let mut draft = Draft::new();
    draft.json["nodes"][0]["translation"] = json!([1, 2]);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": item 0 of the nodes cannot be read: invalid length 2, expected an array of length 3"
    );
    for text in ["[]", "[7", "\"x\""] {
        let refusal = Files::with("x.gltf", text).refusal("x.gltf");
        assert!(
            refusal.starts_with("\"x.gltf\": the JSON is not glTF 2.0: "),
            "{refusal}"
        );
    }
}

#[test]
fn texts_need_not_be_utf8() {
    for place in ["\"nodes\":[{", "{"] {
        let text = Draft::new().text();
        let start = text.find(place).expect(place) + place.len();
        let (head, rest) = text.split_at(start);
        let text = [
            head.as_bytes(),
            b"\"extras\":\"\xa9 2020\",",
            rest.as_bytes(),
        ]
        .concat();
        assert_is_box(&Files::with("x.gltf", text).load("x.gltf"));
    }
}

#[test]
fn extensions_of_a_wrong_type_count_as_none() {
    for value in [json!([]), json!(7), json!({"KHR_lights_punctual": 7})] {
        assert_is_box(&with(&[("extensions", value)]).load());
    }
    for path in [
        "/scenes/0",
        "/meshes/0",
        "/meshes/0/primitives/0",
        "/accessors/0",
        "/bufferViews/0",
        "/materials/0",
    ] {
        let mut draft = Draft::new();
        draft.json["materials"] = json!([{}]);
        draft.primitive()["material"] = json!(0);
        draft.at(path)["extensions"] = json!([]);
        assert_is_box(&draft.load());
    }
}
