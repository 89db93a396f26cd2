use super::*;

/// The box with quads, in one of the three encodings, with an element and properties that are skipped.
pub(super) fn sample(encoding: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {encoding} 1.0\ncomment a box of 1×2×3\nelement vertex 8\nproperty float x\n\
         property double y\nproperty short z\nproperty uchar red\nelement extra 2\n\
         property list uchar short numbers\nelement face 6\nproperty uchar flags\n\
         property list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    if encoding == "ascii" {
        for [x, y, z] in CORNERS {
            bytes.extend(format!("{x} {y} {z} 255\n").bytes());
        }
        bytes.extend(b"2 -7 8\n0\n");
        for [a, b, c, d] in SIDES {
            bytes.extend(format!("1 4 {a} {b} {c} {d} \n").bytes());
        }
        return bytes;
    }
    let is_big = encoding == "binary_big_endian";
    let mut put = |mut number: Vec<u8>| {
        if is_big {
            number.reverse();
        }
        bytes.extend(number);
    };
    for [x, y, z] in CORNERS {
        put(x.to_le_bytes().into());
        put(f64::from(y).to_le_bytes().into());
        put((z as i16).to_le_bytes().into());
        put(vec![255]);
    }
    put(vec![2]);
    put((-7_i16).to_le_bytes().into());
    put(8_i16.to_le_bytes().into());
    put(vec![0]);
    for side in SIDES {
        put(vec![1]);
        put(vec![4]);
        for corner in side {
            put(corner.to_le_bytes().into());
        }
    }
    bytes
}

const ENCODINGS: [&str; 3] = ["ascii", "binary_little_endian", "binary_big_endian"];

fn text(vertices: &str, faces: &str) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_index\nend_header\n{vertices}{faces}",
        vertices.lines().count(),
        faces.lines().count()
    )
}

#[test]
fn all_encodings_read_the_same() {
    for encoding in ENCODINGS {
        let scene = Files::with("box.ply", sample(encoding)).load("box.ply");
        assert_is_box(&scene);
        assert_eq!(scene.mesh.vertices, CORNERS);
        assert_eq!(scene.mesh.indices[2..4], [[1, 3, 7], [1, 7, 5]]);
    }
}

#[test]
fn normals_are_read_if_all_three_are_there() {
    let with = |names: [&str; 3]| {
        let properties = names
            .map(|name| format!("property float {name}\n"))
            .concat();
        let text = text("1 0 0 0 3 4\n0 2 0 0 0 0\n0 0 3 0 0 -2\n", "3 0 1 2\n");
        let text = text.replace("float z\n", &format!("float z\n{properties}"));
        Files::with("x.ply", text).load("x.ply").mesh.normals
    };
    assert_eq!(
        with(["nx", "ny", "nz"]),
        [[0.0, 0.6, 0.8], [0.0; 3], [0.0, 0.0, -1.0]]
    );
    assert!(with(["nx", "ny", "other"]).is_empty());
}

#[test]
fn numbers_are_read_as_they_come() {
    let text = text(".5 +1. 1e0\n\n-0 2E-0 0x0\n", "3 0 1 0\n").replace("0x0", "3");
    let text = text.replace("vertex 3", "vertex 2");
    let scene = Files::with("x.ply", text).load("x.ply");
    assert_eq!(scene.mesh.vertices, [[0.5, 1.0, 1.0], [0.0, 2.0, 3.0]]);
}

#[test]
fn truncated_files_say_what_is_missing() {
    let whole = sample("binary_little_endian");
    assert_eq!(
        Files::with("x.ply", &whole[..whole.len() - 19]).refusal("x.ply"),
        "\"x.ply\" ends early: 6 faces are announced, 4 are there"
    );
    let whole = sample("ascii");
    assert_eq!(
        Files::with("x.ply", &whole[..whole.len() - 13]).refusal("x.ply"),
        "\"x.ply\" ends early: 6 faces are announced, 5 are there"
    );
    assert_eq!(
        Files::with("x.ply", &whole[..whole.len() - 5]).refusal("x.ply"),
        "\"x.ply\", line 30: 6 numbers are needed, 4 are there"
    );
    assert_eq!(
        Files::with("x.ply", &whole[..60]).refusal("x.ply"),
        "\"x.ply\" ends within its header"
    );
}

#[test]
fn faults_name_line_face_and_vertex() {
    let vertices = "1 0 0\n0 2 0\n0 0 3\n";
    let refusal = |text: String| Files::with("x.ply", text).refusal("x.ply");
    assert_eq!(
        refusal(text(vertices, "3 0 1 2\n3 0 1 3\n")),
        "\"x.ply\", line 14: face 1 names vertex 3, but there are only 3 vertices"
    );
    assert_eq!(
        refusal(text(vertices, "3 0 1 2.5\n")),
        "\"x.ply\", line 13: \"2.5\" is not an index"
    );
    assert_eq!(
        refusal(text(vertices, "-3 0 1 2\n")),
        "\"x.ply\", line 13: \"-3\" is not a count"
    );
    assert_eq!(
        refusal(text("1 0 0\n0 zwei 0\n0 0 3\n", "3 0 1 2\n")),
        "\"x.ply\", line 11: \"zwei\" is not a number"
    );
    let mut binary = sample("binary_big_endian");
    let last = binary.len() - 1;
    binary[last] = 200;
    assert_eq!(
        Files::with("x.ply", binary).refusal("x.ply"),
        "\"x.ply\": face 5 names vertex 200, but there are only 8 vertices"
    );
}

#[test]
fn headers_must_make_sense() {
    let good = text("1 0 0\n0 2 0\n0 0 3\n", "3 0 1 2\n");
    let refusal =
        |old: &str, new: &str| Files::with("x.ply", good.replace(old, new)).refusal("x.ply");
    assert_eq!(
        refusal("property float y", "property quad y"),
        "\"x.ply\", line 5: the header line \"property quad y\" is not understood"
    );
    assert_eq!(
        refusal("property float y", "property float why"),
        "\"x.ply\" has no property \"y\" of element \"vertex\""
    );
    assert_eq!(
        refusal("vertex_index", "corners"),
        "\"x.ply\" has no list \"vertex_indices\" of element \"face\""
    );
    assert_eq!(
        refusal("element vertex", "element point"),
        "\"x.ply\" has no element \"vertex\""
    );
    assert_eq!(
        refusal("format ascii 1.0\n", ""),
        "\"x.ply\": No format line found."
    );
    assert_eq!(
        Files::with("x.ply", "solid\n").refusal("x.ply"),
        "\"x.ply\", line 1: the header line \"solid\" is not understood"
    );
    let cloud =
        text("1 0 0\n", "").replace("element face 0\nproperty list uchar int vertex_index\n", "");
    assert_eq!(
        Files::with("x.ply", cloud).refusal("x.ply"),
        "\"x.ply\" holds no triangles"
    );
}

#[test]
fn huge_counts_are_not_believed() {
    let good = text("1 0 0\n0 2 0\n0 0 3\n", "3 0 1 2\n");
    let refusal = |text: String| Files::with("x.ply", text).refusal("x.ply");
    assert_eq!(
        refusal(good.replace("face 1", "face 4000000000")),
        "\"x.ply\" ends early: 4000000000 faces are announced, 1 are there"
    );
    let binary = good
        .replace("ascii", "binary_little_endian")
        .replace("vertex 3", "vertex 4000000000");
    assert_eq!(
        refusal(binary),
        "\"x.ply\" ends early: 4000000000 vertices are announced, 2 are there"
    );
    assert_eq!(
        refusal(good.replace("3 0 1 2", "4000000000 0 1 2")),
        "\"x.ply\", line 13: 4000000001 numbers are needed, 4 are there"
    );
    // An element without properties takes no bytes, so its count costs nothing.
    let nothing = good.replace(
        "element face",
        "element nothing 18446744073709551615\nelement face",
    );
    assert_eq!(
        Files::with("x.ply", nothing)
            .load("x.ply")
            .mesh
            .indices
            .len(),
        1
    );
}

#[test]
fn lenient_loading_leaves_broken_faces_out() {
    let text = text(
        "1 0 0\n0 2 0\n0 0 3\nnan 0 0\n",
        "3 0 1 2\n3 0 1 3\n4 0 1 2 4\n3 -1 0 1\n",
    );
    let files = Files::with("x.ply", text.clone());
    let scene = files.load_leniently("x.ply");
    assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
    assert_eq!(scene.dropped_face_count, 3);
    let files = Files::with("x.ply", text.replace("2 4\n", "2 2\n").replace("-1", "1"));
    assert_eq!(
        files.refusal("x.ply"),
        "\"x.ply\": face 1 has vertex 3 at (NaN, 0, 0), which is not finite"
    );
}
