mod draft;
mod notes;
mod poses;
mod sound;

pub(super) use draft::every_part;

use super::*;
use crate::{Camera, Light, Material, Part, Projection};

/// The box's corners, then the indices of its triangles.
fn box_buffer() -> Vec<u8> {
    let corners = CORNERS.into_iter().flatten().flat_map(f32::to_le_bytes);
    let fan = |[a, b, c, d]: [u32; 4]| [a, b, c, a, c, d];
    let indices = SIDES.into_iter().flat_map(fan);
    corners
        .chain(indices.flat_map(|index| (index as u16).to_le_bytes()))
        .collect()
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let number = (0..3).fold(0_u32, |n, i| {
            n << 8 | u32::from(chunk.get(i).copied().unwrap_or(0))
        });
        for digit in 0..4 {
            let value = (number >> (18 - 6 * digit)) & 63;
            text.push(if digit > chunk.len() {
                '='
            } else {
                char::from(DIGITS[value as usize])
            });
        }
    }
    text
}

/// A scene with a box, a mirrored and moved copy of it, a camera and two lights.
pub(super) fn sample() -> String {
    let buffer = box_buffer();
    format!(
        r#"{{
"asset": {{"version": "2.0"}},
"extensionsUsed": ["KHR_lights_punctual"],
"extensionsRequired": ["KHR_lights_punctual", "KHR_texture_basisu"],
"extensions": {{"KHR_lights_punctual": {{"lights": [
  {{"type": "directional", "color": [1, 0.5, 0.25], "intensity": 2}},
  {{"type": "spot", "intensity": 3, "range": 7, "spot": {{}}}}]}}}},
"scene": 0,
"scenes": [{{"nodes": [0, 2]}}],
"nodes": [
  {{"name": "first", "mesh": 0, "children": [1]}},
  {{"mesh": 0, "scale": [-1, 1, 1], "translation": [10, 0, 0]}},
  {{"translation": [4, 5, 6], "rotation": [0, 0.70710678, 0, 0.70710678], "children": [3, 4], "camera": 0}},
  {{"extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}},
  {{"extensions": {{"KHR_lights_punctual": {{"light": 1}}}}, "translation": [0, 1, 0], "camera": 1}}],
"cameras": [
  {{"type": "perspective", "perspective": {{"yfov": 0.5, "znear": 0.1}}}},
  {{"type": "orthographic", "orthographic": {{"xmag": 2, "ymag": 1.5, "znear": 0, "zfar": 9}}}}],
"materials": [
  {{"pbrMetallicRoughness": {{"baseColorFactor": [0.75, 0.5, 0.25, 1], "metallicFactor": 0.625, "roughnessFactor": 0.125}}}},
  {{"pbrMetallicRoughness": {{"metallicFactor": 1, "roughnessFactor": 0.5}}}}],
"meshes": [{{"name": "box", "primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "material": 0}}]}}],
"accessors": [
  {{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 2, 3]}},
  {{"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}}],
"bufferViews": [
  {{"buffer": 0, "byteLength": 96}},
  {{"buffer": 0, "byteOffset": 96, "byteLength": 72}}],
"buffers": [{{"byteLength": 168, "uri": "data:application/octet-stream;base64,{}"}}]
}}"#,
        base64(&buffer)
    )
}

/// The sample as one binary file.
pub(super) fn binary() -> Vec<u8> {
    let (head, uri) = sample()
        .split_once(r#", "uri": "#)
        .map(|(a, b)| (a.to_owned(), b.to_owned()))
        .expect("a uri");
    let mut json = head
        + uri
            .split_once('"')
            .and_then(|(_, rest)| rest.split_once('"'))
            .expect("quotes")
            .1;
    while json.len() % 4 != 0 {
        json.push(' ');
    }
    let buffer = box_buffer();
    let length = 12 + 8 + json.len() + 8 + buffer.len();
    let word = |number: usize| (number as u32).to_le_bytes();
    [
        b"glTF".as_slice(),
        &word(2),
        &word(length),
        &word(json.len()),
        b"JSON",
        json.as_bytes(),
        &word(buffer.len()),
        b"BIN\0",
        &buffer,
    ]
    .concat()
}

fn refusal(old: &str, new: &str) -> String {
    let changed = sample().replacen(old, new, 1);
    assert_ne!(changed, sample(), "{old} is not in the sample");
    Files::with("x.gltf", changed).refusal("x.gltf")
}

fn load_changed(old: &str, new: &str) -> Scene {
    Files::with("x.gltf", sample().replacen(old, new, 1)).load("x.gltf")
}

#[test]
fn nodes_are_flattened_and_mirrored_ones_turned() {
    let scene = Files::with("box.gltf", sample()).load("box.gltf");
    let mesh = &scene.mesh;
    assert_eq!((mesh.vertices.len(), mesh.indices.len()), (16, 24));
    assert_eq!(volume(&scene), 12.0, "both boxes have their front outside");
    assert_eq!(mesh.vertices[9], [9.0, 0.0, 0.0]);
    let part = |name: &str, first_triangle| Part {
        name: name.into(),
        first_triangle,
        triangle_count: 12,
    };
    // A node without a name has its mesh's.
    assert_eq!(mesh.parts, [part("first", 0), part("box", 12)]);
    assert_eq!(mesh.materials, [0; 24]);
    assert_eq!(
        scene.materials,
        [
            Material {
                base_color: [0.75, 0.5, 0.25],
                mirror: 0.625,
                double_sided: false,
                ..Material::default()
            },
            Material {
                base_color: [1.0; 3],
                mirror: 0.0,
                double_sided: false,
                ..Material::default()
            }
        ]
    );
}

#[test]
fn what_transmits_is_glass() {
    let scene = load_changed(
        r#""metallicFactor": 1, "roughnessFactor": 0.5}"#,
        r#""metallicFactor": 0}, "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75}, "KHR_materials_ior": {"ior": 1.25}}"#,
    );
    let expected = Material {
        base_color: [1.0; 3],
        transmission: 0.75,
        ior: 1.25,
        double_sided: false,
        ..Material::default()
    };
    assert_eq!(scene.materials[1], expected);
    let plain = load_changed(r#""metallicFactor": 1"#, r#""metallicFactor": 0"#);
    assert_eq!(
        (plain.materials[1].transmission, plain.materials[1].ior),
        (0.0, 1.5)
    );
}

#[test]
fn cameras_and_lights_follow_their_nodes() {
    let scene = Files::with("box.gltf", sample()).load("box.gltf");
    // A quarter turn about y takes -z to -x.
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
    let [first, second] = &scene.cameras[..] else {
        panic!("{:?}", scene.cameras);
    };
    assert_eq!(first.eye, [4.0, 5.0, 6.0]);
    assert!(near(first.target, [3.0, 5.0, 6.0]), "{first:?}");
    assert!(near(first.up, [0.0, 1.0, 0.0]));
    assert_eq!(
        first.projection,
        Projection::Perspective {
            vertical_fov: 0.5_f32.to_degrees()
        }
    );
    assert_eq!(
        *second,
        Camera {
            eye: [4.0, 6.0, 6.0],
            projection: Projection::Orthographic { height: 3.0 },
            ..*second
        }
    );
    let [Light::Directional { direction, color }, point] = &scene.lights[..] else {
        panic!("{:?}", scene.lights);
    };
    assert!(near(*direction, [-1.0, 0.0, 0.0]), "{direction:?}");
    assert_eq!(*color, [2.0, 1.0, 0.5]);
    assert_eq!(
        *point,
        Light::Point {
            position: [4.0, 6.0, 6.0],
            color: [3.0; 3],
            range: 7.0
        }
    );
}

#[test]
fn buffers_may_be_in_the_file_or_beside() {
    let expected = Files::with("box.gltf", sample()).load("box.gltf").mesh;
    assert_eq!(
        Files::with("box.glb", binary()).load("box.glb").mesh,
        expected
    );

    let uri = format!(
        "data:application/octet-stream;base64,{}",
        base64(&box_buffer())
    );
    let files = Files::with("box.gltf", sample().replace(&uri, "the%20box.bin"));
    files.put("the box.bin", box_buffer());
    assert_eq!(files.load("box.gltf").mesh, expected);
    files.put("the box.bin", &box_buffer()[..100]);
    assert_eq!(
        files.refusal("box.gltf"),
        "\"box.gltf\": buffer 0 announces 168 bytes, 100 are there"
    );
    std::fs::remove_file(files.path("the box.bin")).expect("the buffer");
    assert_eq!(
        files.refusal("box.gltf"),
        "cannot read \"the box.bin\": No such file or directory (os error 2)"
    );
    assert_eq!(
        refusal(
            "data:application/octet-stream;base64,",
            "https://example.org/"
        ),
        "\"x.gltf\": buffer 0 is at \"https://example.org/AAAAAAAAAAAAAAAAAACA…\"; files beside the scene and base64 data are read"
    );
}

#[test]
fn primitives_without_indices_strips_and_fans() {
    let indices = r#""indices": 1, "#;
    assert_eq!(
        load_changed(indices, "").mesh.indices[..2],
        [[0, 1, 2], [3, 4, 5]]
    );
    assert_eq!(
        load_changed(indices, r#""mode": 5, "#).mesh.indices[..3],
        [[0, 1, 2], [1, 3, 2], [2, 3, 4]]
    );
    assert_eq!(
        load_changed(indices, r#""mode": 6, "#).mesh.indices[..2],
        [[1, 2, 0], [2, 3, 0]]
    );
    assert_eq!(
        refusal(indices, r#""mode": 3, "#),
        "\"x.gltf\" holds no triangles, only 14 lines, 1 cone of spot lights"
    );
}

#[test]
fn normals_are_turned_with_their_node() {
    // Positions serve as normals; corner 0 has none.
    let scene = load_changed(r#""POSITION": 0"#, r#""POSITION": 0, "NORMAL": 0"#);
    assert_eq!(scene.mesh.normals[0], [0.0; 3]);
    assert_eq!(scene.mesh.normals[1], [1.0, 0.0, 0.0]);
    assert_eq!(scene.mesh.normals[9], [-1.0, 0.0, 0.0]);
    assert_eq!(scene.mesh.normals[10], [0.0, 1.0, 0.0]);
}

#[test]
fn sparse_accessors_replace_elements() {
    // Bytes 96 and 98 of the buffer are indices 0 and 4, and bytes 12 to 36 the corners (1, 0, 0) and (0, 2, 0).
    let sparse = r#""count": 8, "sparse": {"count": 2, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0, "byteOffset": 12}}"#;
    let scene = load_changed(r#""count": 8"#, sparse);
    assert_eq!(scene.mesh.vertices[0], [1.0, 0.0, 0.0]);
    assert_eq!(scene.mesh.vertices[4], [0.0, 2.0, 0.0]);
    assert_eq!(scene.mesh.vertices[5], CORNERS[5]);
    let hollow = sparse.replace("\"count\": 8", "\"count\": 8000000000");
    assert_eq!(
        refusal(
            r#""bufferView": 0, "componentType": 5126, "count": 8"#,
            &format!(r#""componentType": 5126, {hollow}"#)
        ),
        "\"x.gltf\": accessor 0 announces 8000000000 elements without a buffer view"
    );
    assert_eq!(
        refusal(
            r#""count": 8"#,
            &sparse.replace("\"count\": 8", "\"count\": 3")
        ),
        "\"x.gltf\": accessor 0 replaces element 4, but there are only 3"
    );
}

#[test]
fn quantized_positions_are_read() {
    let bytes: Vec<u8> = [[0, 0, 0], [255, 0, 0], [0, 51, 0]].concat();
    let text = format!(
        r#"{{"asset": {{"version": "2.0"}}, "extensionsRequired": ["KHR_mesh_quantization"], "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
        "accessors": [{{"bufferView": 0, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 9}}],
        "buffers": [{{"byteLength": 9, "uri": "data:;base64,{}"}}]}}"#,
        base64(&bytes)
    );
    let scene = Files::with("x.gltf", text).load("x.gltf");
    assert_eq!(
        scene.mesh.vertices,
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.2, 0.0]]
    );
    assert_eq!(scene.mesh.parts[0].name, "node 0");
    assert!(scene.mesh.materials.is_empty());
    assert!(!scene.material_of(0).double_sided);
}

#[test]
fn accessors_must_keep_to_their_buffers() {
    assert_eq!(
        refusal(r#""count": 36"#, r#""count": 4000000000"#),
        "\"x.gltf\": accessor 1 ends at byte 8000000000 of buffer view 1, which has 72"
    );
    assert_eq!(
        refusal(
            r#""count": 36"#,
            r#""count": 36, "byteOffset": 18446744073709551615"#
        ),
        "\"x.gltf\": accessor 1 ends at byte 18446744073709551615 of buffer view 1, which has 72"
    );
    assert_eq!(
        refusal(r#""byteLength": 72"#, r#""byteLength": 73"#),
        "\"x.gltf\": buffer view 1 ends at byte 169 of buffer 0, which has 168"
    );
    assert_eq!(
        refusal(
            r#""byteLength": 96"#,
            r#""byteLength": 96, "byteStride": 8"#
        ),
        "\"x.gltf\": accessor 0 has elements of 12 bytes every 8 bytes"
    );
    assert_eq!(
        refusal(r#""VEC3""#, r#""VEC2""#),
        "\"x.gltf\": accessor 0 holds VEC2 of FLOAT, but vectors of three numbers are needed"
    );
    assert_eq!(
        refusal(r#""bufferView": 1, "#, r#""bufferView": 2, "#),
        "\"x.gltf\": accessors[1].bufferView is 2, but the number of buffer views is 2"
    );
    assert_eq!(
        refusal(r#""componentType": 5123"#, r#""componentType": 5124"#),
        "\"x.gltf\": accessors[1].componentType is 5124, which is not a component type"
    );
    assert_eq!(
        refusal(r#""count": 8"#, r#""count": 3"#),
        "\"x.gltf\": mesh \"first\", face 0 names vertex 4, but there are only 3 vertices"
    );
}

#[test]
fn references_to_nothing_are_refused() {
    assert_eq!(
        refusal(r#""POSITION": 0"#, r#""POSITION": 9"#),
        "\"x.gltf\": meshes[0].primitives[0].attributes.POSITION is 9, but the number of accessors is 2"
    );
    assert_eq!(
        refusal(r#""type": "perspective""#, r#""type": "orthographic""#),
        "\"x.gltf\": camera 0 lacks the values of its type"
    );
    assert_eq!(
        refusal(
            r#""KHR_lights_punctual": {"light": 1}"#,
            r#""KHR_lights_punctual": {"light": 2}"#
        ),
        "\"x.gltf\": nodes[4].extensions.KHR_lights_punctual.light is 2, but the number of lights is 2"
    );
    let mut short = binary();
    short[8..12].copy_from_slice(&[11, 0, 0, 0]);
    assert_eq!(
        Files::with("x.glb", short).refusal("x.glb"),
        "\"x.glb\": the GLB file cannot be taken apart: its header announces 11 bytes"
    );
    let whole = binary();
    assert_eq!(
        Files::with("x.glb", &whole[..whole.len() - 8]).refusal("x.glb"),
        format!(
            "\"x.glb\" ends early: {} bytes are announced, {} are there",
            whole.len(),
            whole.len() - 8
        )
    );
}

#[test]
fn nodes_must_form_trees() {
    assert_eq!(
        refusal(r#""translation": [10, 0, 0]"#, r#""children": [0]"#),
        "\"x.gltf\": node 0 is reached twice; nodes must form trees"
    );
    // A deep tree: each node is the parent of the next, and the last has the mesh.
    let depth = 100_000;
    let chain: String = (1..depth)
        .map(|child| format!(r#"{{"children": [{child}]}}, "#))
        .collect();
    let text = sample();
    let (before, rest) = text
        .split_once(r#""nodes": ["#)
        .and_then(|(a, b)| Some((a, b.split_once(r#""nodes": ["#)?)))
        .map(|(a, (_, c))| (a, c))
        .expect("nodes");
    let (_, behind) = rest.split_once("],\n\"cameras\"").expect("cameras");
    let deep =
        format!(r#"{before}"nodes": [0]}}], "nodes": [{chain}{{"mesh": 0}}], "cameras"{behind}"#);
    assert_is_box(&Files::with("x.gltf", deep).load("x.gltf"));
}

#[test]
fn unknown_required_extensions_are_refused() {
    assert_eq!(
        refusal("\"KHR_texture_basisu\"", "\"KHR_gaussian_splatting\""),
        "\"x.gltf\": the file requires the extension \"KHR_gaussian_splatting\", which slimbvh does not know; export it without that extension"
    );
}

#[test]
fn lenient_loading_leaves_broken_things_out() {
    let text = sample()
        .replace(r#""count": 8"#, r#""count": 7"#)
        .replace(r#""yfov": 0.5"#, r#""yfov": 0"#);
    let scene = Files::with("x.gltf", &text).load_leniently("x.gltf");
    // Corner 7 is in both triangles of three sides, in each box.
    assert_eq!(scene.mesh.indices.len(), 12);
    assert_eq!(scene.dropped_face_count, 12);
    assert_eq!(scene.cameras.len(), 1);
    assert_eq!(left_out(&scene)[0], "1 camera without an extent");
    assert_eq!(
        refusal(r#""yfov": 0.5"#, r#""yfov": 0"#),
        "\"x.gltf\": camera 0 has yfov 0, which is not between 0 and π"
    );
    assert_eq!(
        refusal(r#""ymag": 1.5"#, r#""ymag": 0"#),
        "\"x.gltf\": camera 1 has ymag 0, which is not a height"
    );
    assert_eq!(
        refusal("\"translation\": [4, 5, 6]", "\"scale\": [0, 0, 0]"),
        "\"x.gltf\": node 2 has a camera that points nowhere or is not finite"
    );
    assert_eq!(
        refusal("[10, 0, 0]", "[1e39, 0, 0]"),
        "\"x.gltf\": mesh \"box\", face 0 has vertex 8 at (inf, 0, 0), which is not finite"
    );
}
