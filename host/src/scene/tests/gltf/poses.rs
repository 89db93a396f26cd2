//! Transforms, skins, morph targets and instances.

use super::draft::*;
use super::*;
use serde_json::json;

/// The box 100 times as large, scaled back by the inverse bind matrix of a joint at (5, 0, 0).
pub fn skinned() -> Draft {
    let mut draft = Draft::new();
    let large: Vec<f32> = CORNERS.as_flattened().iter().map(|x| x * 128.0).collect();
    let positions = draft.floats("VEC3", &large);
    let joints = draft.accessor("VEC4", UNSIGNED_BYTE, 8, &[0; 32]);
    let weights = draft.floats("VEC4", &[1.0, 0.0, 0.0, 0.0].repeat(8));
    let small = 1.0 / 128.0;
    let mut matrix = [0.0; 16];
    (matrix[0], matrix[5], matrix[10], matrix[15]) = (small, small, small, 1.0);
    let matrices = draft.floats("MAT4", &matrix);
    let attributes = json!({"POSITION": positions, "JOINTS_0": joints, "WEIGHTS_0": weights});
    draft.primitive()["attributes"] = attributes;
    draft.json["skins"] = json!([{"joints": [1], "inverseBindMatrices": matrices}]);
    draft.json["nodes"] =
        json!([{"mesh": 0, "skin": 0, "scale": [1000, 1000, 1000]}, {"translation": [5, 0, 0]}]);
    draft
}

fn first_vertex(scene: &Scene) -> [f32; 3] {
    scene.mesh.vertices[0]
}

#[test]
fn nested_far_transforms_are_multiplied_in_f64() {
    // The outer node goes far away, and the inner one back and one further.
    let far = [4_201_234.25, -1_203_456.5, 77.0];
    let mut draft = Draft::new();
    let turn = [0.0, 0.0, 0.342_897_807_455_451_34, 0.939_372_712_847_378_9];
    let back = [-2_437_992.465_101_153_6, 3_626_963.069_622_823, -77.0];
    draft.json["scenes"][0]["nodes"] = json!([0, 1]);
    draft.json["nodes"] = json!([
        {"mesh": 0},
        {"translation": far, "rotation": turn, "children": [2]},
        {"translation": back, "rotation": [0.0, 0.0, -turn[2], turn[3]], "mesh": 0, "camera": 0,
         "extensions": {"KHR_lights_punctual": {"light": 0}}}]);
    draft.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1}}]);
    draft.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "point"}]}});
    let scene = draft.load();
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(
        near(extent(&scene), [2.0, 2.0, 3.0]),
        "{:?}",
        extent(&scene)
    );
    assert_eq!(scene.origin, [0.0; 3]);
    assert!(near(scene.cameras[0].eye, [1.0, 0.0, 0.0]));

    // Far away as a whole: around a local origin, with the camera and the light.
    draft.json["scenes"][0]["nodes"] = json!([1]);
    draft.json["nodes"][1]["translation"] = json!([far[0] + 1e7 + 0.3, far[1], far[2]]);
    draft.json["animations"] = json!([{}]);
    let scene = draft.load();
    assert_eq!(
        left_out(&scene),
        ["1 animation", "1 node outside every scene"],
        "noted once"
    );
    assert!(scene.origin[0] > 9e6, "{:?}", scene.origin);
    assert!(near(extent(&scene), [1.0, 2.0, 3.0]));
    let place = 1e7 + 1.3 - scene.origin[0];
    assert!((f64::from(scene.cameras[0].eye[0]) - place).abs() < 1e-6);
    let Light::Point { position, .. } = scene.lights[0] else {
        panic!("{:?}", scene.lights);
    };
    assert!(near(position, scene.cameras[0].eye));
}

#[test]
fn rotations_count_by_their_direction() {
    let mut draft = Draft::new();
    draft.json["nodes"][0]["rotation"] = json!([0, 0, 3, 3]);
    let scene = draft.load();
    let turned = extent(&scene);
    assert!(
        (turned[0] - 2.0).abs() < 1e-6 && (turned[1] - 1.0).abs() < 1e-6,
        "{turned:?}"
    );
    draft.json["nodes"][0]["rotation"] = json!([0, 0, 0, 0]);
    assert_is_box(&draft.load());
}

#[test]
fn joints_place_skinned_meshes() {
    let scene = skinned().load();
    assert_eq!(
        (first_vertex(&scene), extent(&scene)),
        ([5.0, 0.0, 0.0], [1.0, 2.0, 3.0])
    );
    assert_eq!(volume(&scene), 6.0);
    // Without inverse bind matrices, these are identities.
    let mut draft = skinned();
    draft.json["skins"] = json!([{"joints": [1]}]);
    assert_eq!(extent(&draft.load()), [128.0, 256.0, 384.0]);
    // A skin without joints in the mesh, and joints without a skin, leave the mesh at its node.
    let mut draft = skinned();
    draft.json["nodes"][0]
        .as_object_mut()
        .expect("a node")
        .remove("skin");
    assert_eq!(extent(&draft.load()), [128_000.0, 256_000.0, 384_000.0]);
}

#[test]
fn joints_may_be_anywhere_in_the_forest() {
    let mut draft = skinned();
    draft.json["nodes"][1] = json!({"children": [2], "translation": [0, 7, 0]});
    draft.push(
        "nodes",
        json!({"translation": [5, 0, 0], "scale": [2, 2, 2]}),
    );
    draft.json["skins"][0]["joints"] = json!([2]);
    let scene = draft.load();
    assert_eq!(
        (first_vertex(&scene), extent(&scene)),
        ([5.0, 7.0, 0.0], [2.0, 4.0, 6.0])
    );
    draft.json["nodes"][2]["children"] = json!([1]);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": node 1 is reached twice; nodes must form trees"
    );
    draft.json["skins"][0]["joints"] = json!([9]);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": skins[0].joints[0] is 9, but the number of nodes is 3"
    );
    draft.json["nodes"][0]["skin"] = json!(4);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": nodes[0].skin is 4, but the number of skins is 1"
    );
}

#[test]
fn mirroring_joints_keep_the_front_outside() {
    let mut draft = skinned();
    draft.json["nodes"][1] = json!({"scale": [-1, 1, 1]});
    assert_eq!(volume(&draft.load()), 6.0);
}

/// Two joints, at the origin and at (8, 0, 0), share every vertex.
fn between(weights: &[f32], joints: &[u8], is_second_set: bool) -> Draft {
    let mut draft = Draft::new();
    let weights = draft.floats("VEC4", &weights.repeat(8));
    let joints = draft.accessor("VEC4", UNSIGNED_BYTE, 8, &joints.repeat(8));
    let none = draft.floats("VEC4", &[0.0; 32]);
    draft.json["skins"] = json!([{"joints": [1, 2]}]);
    draft.json["nodes"] = json!([{"mesh": 0, "skin": 0}, {}, {"translation": [8, 0, 0]}]);
    let attributes = &mut draft.primitive()["attributes"];
    let set = usize::from(is_second_set);
    (attributes["JOINTS_0"], attributes["WEIGHTS_0"]) = (json!(joints), json!(none));
    attributes[format!("JOINTS_{set}")] = json!(joints);
    attributes[format!("WEIGHTS_{set}")] = json!(weights);
    draft
}

#[test]
fn weights_share_every_vertex() {
    for is_second_set in [false, true] {
        for (weights, x) in [
            ([0.75, 0.25, 0.0, 0.0], 2.0),
            // The sum need not be 1.
            ([1.5, 0.5, 0.0, 0.0], 2.0),
            ([0.0, 0.25, 0.0, 0.0], 8.0),
            // Without a weight, the first joint.
            ([0.0, 0.0, 0.0, 0.0], 0.0),
        ] {
            // An index without a weight is not used.
            let scene = between(&weights, &[0, 1, 9, 9], is_second_set).load();
            assert_eq!(first_vertex(&scene), [x, 0.0, 0.0], "{weights:?}");
            assert_eq!(extent(&scene), [1.0, 2.0, 3.0]);
        }
    }
}

#[test]
fn joints_and_weights_of_every_type() {
    for (kind, size) in [(UNSIGNED_BYTE, 1), (UNSIGNED_SHORT, 2)] {
        let mut draft = between(&[0.0; 4], &[0, 1, 0, 0], false);
        let bytes = |numbers: [u16; 4]| -> Vec<u8> {
            let number = |x: u16| x.to_le_bytes()[..size].to_vec();
            numbers
                .into_iter()
                .flat_map(number)
                .collect::<Vec<u8>>()
                .repeat(8)
        };
        let joints = draft.accessor("VEC4", kind, 8, &bytes([0, 1, 0, 0]));
        let weights = draft.accessor("VEC4", kind, 8, &bytes([192, 64, 0, 0]));
        draft.json["accessors"][weights]["normalized"] = json!(true);
        draft.primitive()["attributes"]["JOINTS_0"] = json!(joints);
        draft.primitive()["attributes"]["WEIGHTS_0"] = json!(weights);
        assert_eq!(first_vertex(&draft.load()), [2.0, 0.0, 0.0]);
    }
}

#[test]
fn broken_skins_are_refused() {
    let draft = between(&[0.5, 0.5, 0.0, 0.0], &[0, 2, 0, 0], false);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": mesh \"node 0\", vertex 0 follows joint 2, but skin 0 has only 2 joints"
    );
    assert_eq!(
        Files::with("x.gltf", draft.text()).refusal_with("x.gltf", &lenient()),
        "\"x.gltf\" holds no triangles; 12 broken faces were left out"
    );
    let mut draft = skinned();
    draft.json["skins"][0]["joints"] = json!([1, 1]);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": skin 0 has 1 inverse bind matrices for 2 joints"
    );
    let mut draft = skinned();
    let weights = draft.floats("VEC4", &[1.0; 28]);
    draft.primitive()["attributes"]["WEIGHTS_0"] = json!(weights);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": mesh \"node 0\" has 7 weights for 8 positions"
    );
}

/// The box with a target that moves corner 0 by (-2, 0, 0), by a sparse accessor.
fn morphed() -> Draft {
    let mut draft = Draft::new();
    let place = draft.accessor("SCALAR", UNSIGNED_BYTE, 1, &[0]);
    let moved = draft.floats("VEC3", &[-2.0, 0.0, 0.0]);
    let view =
        |draft: &Draft, accessor: usize| draft.json["accessors"][accessor]["bufferView"].clone();
    let sparse = json!({
        "count": 1,
        "indices": {"bufferView": view(&draft, place), "componentType": 5121},
        "values": {"bufferView": view(&draft, moved)}
    });
    let target = json!({"componentType": 5126, "count": 8, "type": "VEC3", "sparse": sparse});
    let target = draft.push("accessors", target);
    // The second target is broken, but has no weight.
    draft.primitive()["targets"] = json!([{"POSITION": target}, {"POSITION": 99}]);
    draft
}

#[test]
fn morph_targets_count_by_their_weights() {
    let mut draft = morphed();
    assert_is_box(&draft.load());
    draft.at("/meshes/0")["weights"] = json!([0.5, 0]);
    assert_eq!(first_vertex(&draft.load()), [-1.0, 0.0, 0.0]);
    assert_eq!(draft.load().mesh.vertices[1], CORNERS[1]);
    // The node's weights come first.
    draft.at("/nodes/0")["weights"] = json!([0.25, 0]);
    assert_eq!(first_vertex(&draft.load()), [-0.5, 0.0, 0.0]);
    draft.at("/nodes/0")["weights"] = json!([0.25, 1]);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": meshes[0].primitives[0].targets[1].POSITION is 99, but the number of accessors is 5"
    );
    draft.json["accessors"][4]["count"] = json!(7);
    draft.at("/nodes/0")["weights"] = json!([1]);
    assert_eq!(
        draft.refusal(),
        "\"x.gltf\": mesh \"node 0\" has 7 morph target positions for 8 positions"
    );
}

#[test]
fn normals_follow_targets_and_joints() {
    let mut draft = skinned();
    let normals = draft.floats("VEC3", &[1.0, 0.0, 0.0].repeat(8));
    let turned = draft.floats("VEC3", &[-1.0, 2.0, 0.0].repeat(8));
    draft.primitive()["attributes"]["NORMAL"] = json!(normals);
    assert_eq!(draft.load().mesh.normals, [[1.0, 0.0, 0.0]; 8]);
    draft.primitive()["targets"] = json!([{"NORMAL": turned}]);
    draft.at("/meshes/0")["weights"] = json!([1]);
    assert_eq!(draft.load().mesh.normals, [[0.0, 1.0, 0.0]; 8]);
    // First the target, then the joint: a quarter turn about z.
    draft.json["nodes"][1]["rotation"] = json!([0, 0, 1, 1]);
    let [x, y, z] = draft.load().mesh.normals[0];
    assert!(
        (x + 1.0).abs() < 1e-6 && y.abs() < 1e-6 && z == 0.0,
        "{x} {y} {z}"
    );
}

#[test]
fn targets_move_before_joints() {
    let mut draft = skinned();
    let moved = draft.floats("VEC3", &[128.0, 0.0, 0.0].repeat(8));
    draft.primitive()["targets"] = json!([{"POSITION": moved}]);
    draft.at("/meshes/0")["weights"] = json!([1]);
    assert_eq!(first_vertex(&draft.load()), [6.0, 0.0, 0.0]);
}

/// The box at five places.
fn instanced(attributes: serde_json::Value) -> Draft {
    let mut draft = Draft::new();
    let places: Vec<f32> = (0..5).flat_map(|i| [3.0 * i as f32, 0.0, 0.0]).collect();
    assert_eq!(draft.floats("VEC3", &places), 2);
    assert_eq!(draft.floats("VEC3", &[2.0; 15]), 3);
    let turn = [0, 0, 90, 90_u8].repeat(5);
    assert_eq!(draft.accessor("VEC4", BYTE, 5, &turn), 4);
    assert_eq!(draft.floats("VEC4", &[0.0, 0.0, 0.5, 0.5].repeat(5)), 5);
    assert_eq!(draft.floats("VEC3", &[1.0; 12]), 6);
    draft.json["accessors"][4]["normalized"] = json!(true);
    draft.json["nodes"][0] = json!({"name": "box", "mesh": 0, "translation": [0, 10, 0],
        "extensions": {"EXT_mesh_gpu_instancing": {"attributes": attributes}}});
    draft
}

#[test]
fn instances_become_parts() {
    let mut draft = instanced(json!({"TRANSLATION": 2, "_ID": 99}));
    let scene = draft.load();
    assert_eq!((extent(&scene), volume(&scene)), ([13.0, 2.0, 3.0], 30.0));
    assert_eq!(first_vertex(&scene), [0.0, 10.0, 0.0]);
    let names: Vec<&str> = scene.mesh.parts.iter().map(|part| &*part.name).collect();
    assert_eq!(names, ["box 1", "box 2", "box 3", "box 4", "box 5"]);
    assert!(
        scene
            .mesh
            .parts
            .iter()
            .all(|part| part.triangle_count == 12)
    );
    draft.json["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    assert_eq!(draft.load().mesh, scene.mesh);
    assert_eq!(left_out(&scene), ["1 value of instances by _ID"]);
    let own = instanced(json!({"_COLOR_0": 5})).load();
    assert_is_at_node(&own);
    assert_eq!(left_out(&own), ["5 values of instances by _COLOR_0"]);
}

#[test]
fn instances_are_scaled_turned_and_moved() {
    let scaled = instanced(json!({"TRANSLATION": 2, "SCALE": 3})).load();
    assert_eq!(extent(&scaled), [14.0, 4.0, 6.0]);
    for turns in [4, 5] {
        let turned = extent(&instanced(json!({"ROTATION": turns, "TRANSLATION": 2})).load());
        assert!(
            (turned[0] - 14.0).abs() < 1e-5 && (turned[1] - 1.0).abs() < 1e-5,
            "{turned:?}"
        );
    }
    assert_is_at_node(&instanced(json!({})).load());
}

fn assert_is_at_node(scene: &Scene) {
    assert_eq!(
        (extent(scene), scene.mesh.indices.len()),
        ([1.0, 2.0, 3.0], 12)
    );
}

#[test]
fn broken_instances_are_refused() {
    assert_eq!(
        instanced(json!({"TRANSLATION": 2, "SCALE": 6})).refusal(),
        "\"x.gltf\": node 0 has 4 instances by SCALE, but 5 by the others"
    );
    assert_eq!(
        instanced(json!({"TRANSLATION": 99})).refusal(),
        "\"x.gltf\": nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.TRANSLATION is 99, but the number of accessors is 7"
    );
    assert_eq!(
        instanced(json!({"ROTATION": 2})).refusal(),
        "\"x.gltf\": accessor 2 holds VEC3 of FLOAT, but quaternions of floats or signed shares are needed"
    );
}

/// Instances are counted before they fill the memory.
#[test]
fn too_many_instances_are_refused_at_once() {
    let mut draft = Draft::new();
    let faces = 100_000;
    let indices = draft.accessor("SCALAR", UNSIGNED_BYTE, 3 * faces, &vec![0; 3 * faces]);
    draft.primitive()["indices"] = json!(indices);
    let places = json!({"componentType": 5126, "count": 60_000, "type": "VEC3"});
    let places = draft.push("accessors", places);
    draft.json["nodes"][0]["extensions"] =
        json!({"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}});
    let message = draft.refusal();
    assert!(message.contains("6000000000"), "{message}");
}

/// So are those of many nodes, none of which has too many alone.
#[test]
fn too_many_instances_of_all_nodes_are_refused_at_once() {
    let mut draft = Draft::new();
    let places = json!({"componentType": 5126, "count": 60_000, "type": "VEC3"});
    let places = draft.push("accessors", places);
    let node = json!({"mesh": 0, "extensions":
        {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}}});
    draft.json["nodes"] = json!(vec![node.clone(); 2000]);
    draft.json["scenes"] = json!(null);
    let message = draft.refusal();
    assert!(message.contains("1440000000"), "{message}");
    draft.json["nodes"] = json!([node]);
    assert_eq!(draft.load().mesh.parts.len(), 60_000);
}

#[test]
fn hidden_nodes_are_not_shown() {
    let mut draft = Draft::new();
    draft.json["scenes"][0]["nodes"] = json!([0, 1]);
    let hidden = json!({"KHR_node_visibility": {"visible": false}});
    draft.push("nodes", json!({"children": [2], "extensions": hidden}));
    draft.push(
        "nodes",
        json!({"mesh": 0, "extensions": {"KHR_node_visibility": {"visible": true}}}),
    );
    assert_is_box(&draft.load());
}
