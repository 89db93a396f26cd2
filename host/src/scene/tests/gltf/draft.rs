//! Documents under construction.

use super::*;
use serde_json::{Value, json};

/// The codes of component types.
pub const BYTE: u32 = 5120;
pub const UNSIGNED_BYTE: u32 = 5121;
pub const SHORT: u32 = 5122;
pub const UNSIGNED_SHORT: u32 = 5123;
pub const FLOAT: u32 = 5126;

/// A document, and its only buffer.
#[derive(Clone)]
pub struct Draft {
    pub json: Value,
    buffer: Vec<u8>,
}

impl Draft {
    /// The box in node 0: accessors 0 (positions) and 1 (indices).
    pub fn new() -> Self {
        let mut draft = Self {
            json: json!({
                "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                "accessors": [], "bufferViews": [], "buffers": [{}]
            }),
            buffer: Vec::new(),
        };
        draft.floats("VEC3", CORNERS.as_flattened());
        let fan = |[a, b, c, d]: [u32; 4]| [a, b, c, a, c, d];
        let indices = SIDES.into_iter().flat_map(fan);
        let indices: Vec<u8> = indices.map(|index| index as u8).collect();
        draft.accessor("SCALAR", UNSIGNED_BYTE, 36, &indices);
        draft
    }

    /// Adds an accessor with a view of its own.
    pub fn accessor(&mut self, shape: &str, kind: u32, count: usize, bytes: &[u8]) -> usize {
        while !self.buffer.len().is_multiple_of(4) {
            self.buffer.push(0);
        }
        let view = self.push(
            "bufferViews",
            json!({"buffer": 0, "byteOffset": self.buffer.len(), "byteLength": bytes.len()}),
        );
        self.buffer.extend(bytes);
        self.push(
            "accessors",
            json!({"bufferView": view, "componentType": kind, "count": count, "type": shape}),
        )
    }

    pub fn floats(&mut self, shape: &str, numbers: &[f32]) -> usize {
        let width = match shape {
            "SCALAR" => 1,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        self.accessor(shape, FLOAT, numbers.len() / width, &bytes)
    }

    pub fn push(&mut self, list: &str, item: Value) -> usize {
        if self.json[list].is_null() {
            self.json[list] = json!([]);
        }
        let list = self.json[list].as_array_mut().expect("a list");
        list.push(item);
        list.len() - 1
    }

    /// The member at a path, such as `/nodes/0`.
    pub fn at(&mut self, path: &str) -> &mut Value {
        self.json.pointer_mut(path).expect(path)
    }

    /// The primitive of the box.
    pub fn primitive(&mut self) -> &mut Value {
        self.at("/meshes/0/primitives/0")
    }

    pub fn text(&self) -> String {
        let mut json = self.json.clone();
        if json["buffers"][0]["uri"].is_null() {
            let uri = format!("data:;base64,{}", base64(&self.buffer));
            json["buffers"][0] = json!({"byteLength": self.buffer.len(), "uri": uri});
        }
        json.to_string()
    }

    pub fn load(&self) -> Scene {
        Files::with("x.gltf", self.text()).load("x.gltf")
    }

    pub fn refusal(&self) -> String {
        Files::with("x.gltf", self.text()).refusal("x.gltf")
    }
}

/// The box's size along x, y and z.
pub fn extent(scene: &Scene) -> [f32; 3] {
    let bounds = scene.mesh.bounds().expect("triangles");
    (bounds.max - bounds.min).to_array()
}

/// A document with a skin, morph targets, instances, sparse accessors and extensions.
pub fn every_part() -> String {
    let mut draft = poses::skinned();
    let normals = draft.floats("VEC3", CORNERS.as_flattened());
    let moved = draft.floats("VEC3", &[0.5; 24]);
    let places = draft.floats("VEC3", &[0.0, 0.0, 0.0, 0.0, 5.0, 0.0]);
    let turns = draft.accessor("VEC4", BYTE, 2, &[0, 0, 0, 127, 0, 127, 0, 0]);
    let sparse = json!({"count": 1, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}});
    draft.json["accessors"][moved]["sparse"] = sparse;
    draft.primitive()["attributes"]["NORMAL"] = json!(normals);
    draft.primitive()["targets"] = json!([{"POSITION": moved, "NORMAL": moved}]);
    draft.at("/meshes/0")["weights"] = json!([0.5]);
    let attributes = json!({"TRANSLATION": places, "ROTATION": turns});
    let node = draft.push(
        "nodes",
        json!({"mesh": 1, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": attributes}}}),
    );
    draft.push(
        "meshes",
        json!({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}),
    );
    draft.push(
        "materials",
        json!({"alphaMode": "BLEND", "emissiveFactor": [1, 0, 0], "normalTexture": {"index": 0}}),
    );
    draft.json["scenes"][0]["nodes"] = json!([0, node]);
    draft.json["extensionsUsed"] = json!(["EXT_mesh_gpu_instancing", "ABC_unknown"]);
    draft.text()
}
