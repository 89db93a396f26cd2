//! One box in every format, near zero and far away. Its corners are numbers of `f32` in both places.

use super::*;

const FAR: [f32; 3] = [500_000.0, 4_600_000.0, 1000.0];

fn corners(at: [f32; 3]) -> impl Iterator<Item = [f32; 3]> {
    CORNERS.iter().map(move |c| [0, 1, 2].map(|i| c[i] + at[i]))
}

fn lines(at: [f32; 3], start: &str) -> String {
    let line = |[x, y, z]: [f32; 3]| format!("{start}{x} {y} {z}\n");
    corners(at).map(line).collect()
}

fn faces(start: &str, first: u32) -> String {
    let line = |[a, b, c, d]: [u32; 4]| format!("{start}{a} {b} {c} {d}\n");
    SIDES.map(|side| line(side.map(|v| v + first))).concat()
}

fn obj(at: [f32; 3]) -> Vec<u8> {
    (lines(at, "v ") + &faces("f ", 1)).into()
}

fn off(at: [f32; 3]) -> Vec<u8> {
    ("OFF\n8 6 0\n".to_owned() + &lines(at, "") + &faces("4 ", 0)).into()
}

fn ply(at: [f32; 3]) -> Vec<u8> {
    let mut bytes = b"ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\n\
        property float z\nelement face 6\nproperty list uchar uchar vertex_indices\nend_header\n"
        .to_vec();
    bytes.extend(corners(at).flatten().flat_map(f32::to_le_bytes));
    for side in SIDES {
        bytes.push(4);
        bytes.extend(side.map(|v| v as u8));
    }
    bytes
}

fn triangles() -> impl Iterator<Item = [u32; 3]> {
    SIDES
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
}

fn stl(at: [f32; 3]) -> Vec<u8> {
    let corners: Vec<_> = corners(at).collect();
    let mut bytes = vec![0; 80];
    bytes.extend(12_u32.to_le_bytes());
    for triangle in triangles() {
        bytes.extend([0; 12]);
        let numbers = triangle.iter().flat_map(|&v| corners[v as usize]);
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

/// The buffer of [`gltf`].
fn buffer(at: [f32; 3]) -> Vec<u8> {
    let numbers = corners(at).flatten().flat_map(f32::to_le_bytes);
    numbers
        .chain(triangles().flatten().map(|v| v as u8))
        .collect()
}

/// With a buffer beside, and a place for its node.
fn gltf(buffer: &str, node: [f32; 3]) -> Vec<u8> {
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0, "translation": {node:?}}}], "scenes": [{{"nodes": [0]}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
        "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"}},
            {{"bufferView": 1, "componentType": 5121, "count": 36, "type": "SCALAR"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 96}}, {{"buffer": 0, "byteOffset": 96, "byteLength": 36}}],
        "buffers": [{{"byteLength": 132, "uri": "{buffer}"}}]}}"#
    )
    .into()
}

/// The box in each format; in glTF, moved by its positions, and by its node.
fn all(at: [f32; 3]) -> impl Iterator<Item = (&'static str, Scene)> {
    let files = Files::with("box.obj", obj(at));
    files.put("box.off", off(at));
    files.put("box.ply", ply(at));
    files.put("box.stl", stl(at));
    files.put("there.bin", buffer(at));
    files.put("box.gltf", gltf("there.bin", [0.0; 3]));
    files.put("here.bin", buffer([0.0; 3]));
    files.put("node.gltf", gltf("here.bin", at));
    let names = [
        "box.obj",
        "box.off",
        "box.ply",
        "box.stl",
        "box.gltf",
        "node.gltf",
    ];
    names.into_iter().map(move |name| (name, files.load(name)))
}

/// The box would be two steps of `f32` wide, and so would be the steps of cameras, lights and hits.
#[test]
fn every_format_has_a_local_origin_far_away() {
    for (name, scene) in all(FAR) {
        assert!(scene.origin.iter().all(|x| *x > 0.0), "{name}");
        let mut found: Vec<_> = scene
            .mesh
            .vertices
            .iter()
            .map(|v| scene.to_file(*v))
            .collect();
        found.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        found.dedup();
        let mut expected: Vec<_> = corners(FAR).map(|v| v.map(f64::from)).collect();
        expected.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        assert_eq!(found, expected, "{name}");
    }
}

#[test]
fn no_format_has_a_local_origin_near_zero() {
    for (name, scene) in all([5.0, 46.0, 1.0]) {
        assert_eq!(scene.origin, [0.0; 3], "{name}");
    }
}
