//! Small scene files, valid and broken.

/// A closed box of 1 x 2 x 3 whose faces point outward.
pub fn box_obj() -> String {
    let mut text = String::new();
    for corner in 0..8 {
        let pick = |bit: i32, size: i32| (corner >> bit & 1) * size;
        text += &format!("v {} {} {}\n", pick(0, 1), pick(1, 2), pick(2, 3));
    }
    for [a, b, c, d] in BOX_SIDES {
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

/// Corner numbers, which start at 1 as in OBJ. In the number minus 1, bit 0 selects x, bit 1 y and bit 2 z.
const BOX_SIDES: [[u32; 4]; 6] = [
    [1, 5, 7, 3],
    [2, 4, 8, 6],
    [1, 2, 6, 5],
    [3, 7, 8, 4],
    [1, 3, 4, 2],
    [5, 6, 8, 7],
];

/// Two triangles over four vertices.
#[derive(Clone, Copy)]
pub struct TwoTriangles {
    pub vertices: [[f32; 3]; 4],
    pub faces: [[i32; 3]; 2],
}

impl TwoTriangles {
    pub const SOUND: Self = Self {
        vertices: [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 2.0, 0.0],
            [1.0, 2.0, 3.0],
        ],
        faces: [[0, 1, 2], [1, 3, 2]],
    };

    /// The second triangle has a corner whose y is this coordinate.
    pub fn with_coordinate(x: f32) -> Self {
        let mut mesh = Self::SOUND;
        mesh.vertices[3][1] = x;
        mesh
    }

    /// The second triangle has this vertex index.
    pub fn with_index(index: i32) -> Self {
        let mut mesh = Self::SOUND;
        mesh.faces[1][1] = index;
        mesh
    }

    pub fn obj(&self) -> Vec<u8> {
        let mut text = String::new();
        for [x, y, z] in self.vertices {
            text += &format!("v {x} {y} {z}\n");
        }
        for face in self.faces {
            let [a, b, c] = face.map(|index| index + 1);
            text += &format!("f {a} {b} {c}\n");
        }
        text.into()
    }

    pub fn off(&self) -> Vec<u8> {
        let mut text = String::from("OFF\n4 2 0\n");
        for [x, y, z] in self.vertices {
            text += &format!("{x} {y} {z}\n");
        }
        for [a, b, c] in self.faces {
            text += &format!("3 {a} {b} {c}\n");
        }
        text.into()
    }

    pub fn ply_text(&self) -> Vec<u8> {
        let mut text = ply_header("ascii", 4, 2);
        for [x, y, z] in self.vertices {
            text += &format!("{x} {y} {z}\n");
        }
        for [a, b, c] in self.faces {
            text += &format!("3 {a} {b} {c}\n");
        }
        text.into()
    }

    pub fn ply_binary(&self) -> Vec<u8> {
        let mut bytes = ply_header("binary_little_endian", 4, 2).into_bytes();
        bytes.extend(
            self.vertices
                .as_flattened()
                .iter()
                .flat_map(|x| x.to_le_bytes()),
        );
        for face in self.faces {
            bytes.push(3);
            bytes.extend(face.iter().flat_map(|index| index.to_le_bytes()));
        }
        bytes
    }

    pub fn stl(&self) -> Vec<u8> {
        let mut bytes = vec![b' '; 80];
        bytes.extend(2_u32.to_le_bytes());
        for face in self.faces {
            bytes.extend([0; 12]);
            for corner in face.map(|index| self.vertices[index as usize]) {
                bytes.extend(corner.iter().flat_map(|x| x.to_le_bytes()));
            }
            bytes.extend([0; 2]);
        }
        bytes
    }

    /// A binary glTF file.
    pub fn glb(&self) -> Vec<u8> {
        let mut blob: Vec<u8> = self
            .vertices
            .as_flattened()
            .iter()
            .flat_map(|x| x.to_le_bytes())
            .collect();
        blob.extend(
            self.faces
                .as_flattened()
                .iter()
                .flat_map(|index| index.to_le_bytes()),
        );
        let mut json = gltf_json("", 4).into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let chunk =
            |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), kind, bytes].concat();
        let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &blob)].concat();
        let length = (12 + chunks.len()) as u32;
        [
            &b"glTF"[..],
            &2_u32.to_le_bytes(),
            &length.to_le_bytes(),
            &chunks,
        ]
        .concat()
    }
}

/// The header of a PLY file with positions and faces.
pub fn ply_header(encoding: &str, vertex_count: u64, face_count: u64) -> String {
    format!(
        "ply\nformat {encoding} 1.0\nelement vertex {vertex_count}\nproperty float x\nproperty float y\n\
         property float z\nelement face {face_count}\nproperty list uchar int vertex_indices\nend_header\n"
    )
}

/// The JSON of a glTF scene with two triangles. `uri` is a member of the buffer followed by a comma, or empty.
pub fn gltf_json(uri: &str, vertex_count: u64) -> String {
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
        "buffers": [{{{uri} "byteLength": 72}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 24}}],
        "accessors": [{{"bufferView": 0, "componentType": 5126, "count": {vertex_count}, "type": "VEC3",
                        "min": [0, 0, 0], "max": [1, 2, 3]}},
                      {{"bufferView": 1, "componentType": 5125, "count": 6, "type": "SCALAR"}}]}}"#
    )
}

/// Pseudorandom bytes, the same on every call.
pub fn noise(count: usize) -> Vec<u8> {
    let mut state = 0x853c_49e6_748f_ea9b_u64;
    let mut next = || {
        state = state
            .wrapping_mul(0x5851_f42d_4c95_7f2d)
            .wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 56) as u8
    };
    (0..count).map(|_| next()).collect()
}
