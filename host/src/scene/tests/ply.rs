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
        refusal("list uchar int vertex_index", "list uchar float texcoord"),
        "\"x.ply\" has no list \"vertex_indices\" of element \"face\""
    );
    assert_eq!(
        refusal("element vertex", "element point"),
        "\"x.ply\" has no element \"vertex\""
    );
    assert_eq!(
        refusal("format ascii 1.0\n", ""),
        "\"x.ply\" has no format line"
    );
    assert_eq!(
        Files::with("x.ply", "sold\n").refusal("x.ply"),
        "\"x.ply\", line 1: the header line \"sold\" is not understood"
    );
    let cloud =
        text("1 0 0\n", "").replace("element face 0\nproperty list uchar int vertex_index\n", "");
    assert_eq!(
        Files::with("x.ply", cloud).refusal("x.ply"),
        "\"x.ply\" holds no triangles, only 1 point"
    );
}

#[test]
fn huge_counts_are_not_believed() {
    let good = text("1 0 0\n0 2 0\n0 0 3\n", "3 0 1 2\n");
    let refusal = |text: String| Files::with("x.ply", text).refusal("x.ply");
    assert_eq!(
        refusal(good.replace("face 1", "face 4000000000")),
        "\"x.ply\" ends early: 4000000000 faces are announced, 1 is there"
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

/// The box as text, with these rows.
fn box_text(rows: &str) -> String {
    text("", "")
        .replace("vertex 0", "vertex 8")
        .replace("face 0", "face 6")
        + rows
}

fn numbers() -> Vec<String> {
    let vertices = CORNERS.iter().flatten().map(ToString::to_string);
    let faces = SIDES.iter().flat_map(|side| [4].iter().chain(side));
    vertices.chain(faces.map(ToString::to_string)).collect()
}

#[test]
fn rows_may_take_several_lines_and_lines_several_rows() {
    let numbers = numbers();
    for in_line in [1, 2, 5, 7, 1000] {
        let lines = numbers.chunks(in_line).map(|words| words.join(" "));
        let rows: Vec<String> = lines.collect();
        for end in ["\n", "\r\n", "\r", "\n\n"] {
            let text = box_text(&rows.join(end));
            assert_is_box(&Files::with("box.ply", text).load("box.ply"));
        }
    }
    // Words behind a row that is a line are skipped, and told.
    let rows = String::from_utf8(sample("ascii")).expect("ASCII");
    let spare = rows.replace(" 255\n", " 255 7 7\n");
    let scene = Files::with("box.ply", spare).load("box.ply");
    assert_is_box(&scene);
    assert_eq!(left_out(&scene)[3..], ["8 rows with spare words"]);
    // One number too few is a fault in any case.
    let text = box_text(&numbers[1..].join("\n"));
    assert!(
        Files::with("x.ply", text)
            .refusal("x.ply")
            .contains("line 10: 3 numbers are needed, 1 is there")
    );
}

#[test]
fn headers_end_in_all_ways_and_say_what_they_like() {
    for encoding in ENCODINGS {
        let whole = sample(encoding);
        let text = String::from_utf8_lossy(&whole);
        let end = text.find("end_header\n").expect("a header") + 11;
        // Lossy text is longer only behind the header and its multiplication signs.
        let header = text[..end].replace("1×2×3", "1x2x3");
        let rows = &whole[whole.len() - (whole.len() - (header.len() + 2))..];
        for (mark, line_end) in [("", "\n"), ("\u{feff}", "\n"), ("", "\r\n"), ("", "\r")] {
            let header = header
                .replace("comment", "obj_info x\n\ncomment")
                .replace('\n', line_end);
            let mut bytes = [mark.as_bytes(), header.as_bytes(), rows].concat();
            assert_is_box(&Files::with("box.ply", &bytes).load("box.ply"));
            // Latin-1 in a comment.
            let comment = bytes
                .windows(5)
                .position(|w| w == b"a box")
                .expect("a comment");
            bytes[comment] = 0xe9;
            assert_is_box(&Files::with("box.ply", &bytes).load("box.ply"));
        }
    }
    // With CR alone, a line feed is the first byte of the rows.
    let mut bytes = b"ply\rformat binary_little_endian 1.0\relement first 1\rproperty uchar n\relement vertex 3\rproperty float x\rproperty float y\rproperty float z\relement face 1\rproperty list uchar uchar vertex_index\rend_header\r\n".to_vec();
    for x in [1_f32, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0] {
        bytes.extend(x.to_le_bytes());
    }
    bytes.extend([3, 0, 1, 2]);
    assert_eq!(
        Files::with("x.ply", bytes).load("x.ply").mesh.indices,
        [[0, 1, 2]]
    );
}

#[test]
fn a_property_may_be_there_twice() {
    let text = text("1 0 0 9\n0 2 0 9\n0 0 3 9\n", "3 0 1 2 1 5\n")
        .replace("property float z\n", "property float z\nproperty float x\n")
        .replace(
            "vertex_index\n",
            "vertex_index\nproperty list int int vertex_index\n",
        );
    let scene = Files::with("x.ply", text).load("x.ply");
    assert_eq!(
        scene.mesh.vertices,
        [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]
    );
    assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
}

#[test]
fn faces_may_come_before_vertices() {
    for encoding in ["ascii", "binary_little_endian"] {
        let header = format!(
            "ply\nformat {encoding} 1.0\nelement face 1\nproperty list uint8 uint8 vertex_indices\nelement vertex 3\n\
             property double x\nproperty double y\nproperty double z\nend_header\n"
        );
        let places = [1_f64, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0];
        let rows = match encoding {
            "ascii" => b"3 0 1 2\n1 0 0\n0 2 0\n0 0 3\n".to_vec(),
            _ => [3, 0, 1, 2]
                .into_iter()
                .chain(places.iter().flat_map(|x| x.to_le_bytes()))
                .collect(),
        };
        let mut bytes = [header.as_bytes(), &rows].concat();
        let scene = Files::with("x.ply", &bytes).load("x.ply");
        assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
        if encoding != "ascii" {
            bytes[header.len() + 3] = 7;
            assert_eq!(
                Files::with("x.ply", bytes).refusal("x.ply"),
                "\"x.ply\": face 0 names vertex 7, but there are only 3 vertices"
            );
        }
    }
}

#[test]
fn strips_turn_every_other_triangle() {
    let vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
    let strips = |rows: &str| text(vertices, rows).replace("element face", "element tristrips");
    let load = |rows: &str| {
        Files::with("x.ply", strips(rows))
            .load("x.ply")
            .mesh
            .indices
    };
    assert_eq!(load("4 0 1 2 3\n"), [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(
        load("8 0 1 2 3 -1 3 2 1\n"),
        [[0, 1, 2], [2, 1, 3], [3, 2, 1]]
    );
    assert_eq!(
        load("4 0 1 2 4294967295\n3 1 3 2\n"),
        [[0, 1, 2], [1, 3, 2]]
    );
    // A seam of equal corners.
    assert_eq!(load("7 0 1 2 2 1 1 3\n"), [[0, 1, 2]]);
    let refusal = Files::with("x.ply", strips("4 0 1 2 9\n")).refusal("x.ply");
    assert!(refusal.contains("face 0 names vertex 9"), "{refusal}");
}

#[test]
fn what_is_not_drawn_is_noted() {
    let text = text("1 0 0 9\n0 2 0 9\n0 0 3 9\n", "3 0 1 2\n")
        .replace(
            "property float z\n",
            "property float z\nproperty uchar red\n",
        )
        .replace(
            "element face",
            "comment TextureFile a.png\nelement edge 2\nproperty int vertex1\nelement face",
        );
    let text = text.replace("9\n3 0", "9\n0\n1\n3 0");
    let scene = Files::with("x.ply", text).load("x.ply");
    assert_eq!(
        left_out(&scene),
        ["1 texture", "3 vertex colours", "2 edges"]
    );
}

#[test]
fn properties_that_are_not_read_are_noted() {
    let load = |properties: &str, values: &str| {
        let rows = ["1 0 0", "0 2 0", "0 0 3"].map(|row| format!("{row} {values}\n"));
        let text = text(&rows.concat(), "3 0 1 2\n").replace(
            "property float z\n",
            &format!("property float z\n{properties}"),
        );
        left_out(&Files::with("x.ply", text).load("x.ply"))
    };
    let floats = |names: &[&str]| -> String {
        let all = names.iter().map(|name| format!("property float {name}\n"));
        all.collect()
    };
    assert_eq!(load(&floats(&["s", "t"]), "0 0"), ["3 texture coordinates"]);
    assert_eq!(load(&floats(&["alpha"]), "0"), ["3 vertex colours"]);
    assert_eq!(
        load(&floats(&["quality"]), "0"),
        ["1 vertex property (quality)"]
    );
    assert_eq!(
        load(&floats(&["a1", "a2", "a3", "a4", "a5"]), "0 0 0 0 0"),
        ["5 vertex properties (a1, a2, a3, a4, …)"]
    );
    assert!(load(&floats(&["nx", "ny", "nz"]), "0 0 1").is_empty());
    assert_eq!(
        load(&floats(&["nx", "ny"]), "0 0"),
        ["2 vertex properties (nx, ny)"]
    );
    let faces = text("1 0 0\n0 2 0\n0 0 3\n", "3 0 1 2 6 0 0 0 0 0 0 7\n").replace(
        "vertex_index\n",
        "vertex_index\nproperty list uchar float texcoord\nproperty int flags\n",
    );
    assert_eq!(
        left_out(&Files::with("x.ply", faces).load("x.ply")),
        ["1 texture coordinate", "1 face property (flags)"]
    );
}

#[test]
fn what_stands_behind_the_rows_is_noted() {
    let good = text("1 0 0\n0 2 0\n0 0 3\n", "3 0 1 2\n");
    let notes = |bytes: Vec<u8>| left_out(&Files::with("x.ply", bytes).load("x.ply"));
    assert!(notes(format!("{good}\n  \n").into()).is_empty());
    let more = format!("{good}3 0 1 2\n3 2 1 0\n");
    assert_eq!(notes(more.into()), ["2 lines behind the end"]);
    let spare = good.replace("3 0 1 2", "3 0 1 2 2");
    assert_eq!(notes(spare.into()), ["1 row with spare words"]);
    for encoding in &ENCODINGS[1..] {
        let mut bytes = sample(encoding);
        let before = notes(bytes.clone());
        bytes.extend(b"behind");
        let after = notes(bytes);
        assert_eq!(after[..before.len()], before);
        assert_eq!(after[before.len()..], ["6 bytes behind the end"]);
    }
}

#[test]
fn the_only_list_of_whole_numbers_has_the_corners() {
    let named =
        text("1 0 0\n0 2 0\n0 0 3\n", "3 0 1 2\n").replace("vertex_index", "vertex_indexes");
    let scene = Files::with("x.ply", named).load("x.ply");
    assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
    assert!(scene.left_out.is_empty());
}

#[test]
fn lenient_loading_drops_faces_with_broken_words() {
    let text = text(
        "1 0 0\n0 2 0\n0 0 3\n0 abc 0\n0 1\n",
        "3 0 1 2\n3 0 1 3\n3 0 x 1\n3 2 1 0\n3 0 1\n3 0 1 4\n",
    );
    let files = Files::with("x.ply", text);
    let scene = files.load_leniently("x.ply");
    assert_eq!(scene.mesh.indices, [[0, 1, 2], [2, 1, 0]]);
    assert_eq!(scene.dropped_face_count, 4);
    assert_eq!(
        files.refusal("x.ply"),
        "\"x.ply\", line 13: \"abc\" is not a number"
    );
}

#[test]
fn numbers_beyond_32_bits_are_told_with_their_place() {
    let far = text("1 0 0\n0 1e39 0\n0 0 3\n", "3 0 1 2\n3 0 2 2\n");
    let files = Files::with("x.ply", &far);
    assert_eq!(
        files.refusal("x.ply"),
        "\"x.ply\", line 11: \"1e39\" is not a number up to 3.4e38, the largest of 32 bits"
    );
    assert_eq!(files.load_leniently("x.ply").mesh.indices, [[0, 2, 2]]);
    let header = far.split("1 0 0").next().expect("a header");
    let mut bytes = header
        .replace("ascii", "binary_little_endian")
        .replace("float", "double")
        .into_bytes();
    for x in [1.0, 0.0, 0.0, 0.0, -1e39, 0.0, 0.0, 0.0, 3.0] {
        bytes.extend(f64::to_le_bytes(x));
    }
    for face in [[0, 1, 2], [0, 2, 2_i32]] {
        bytes.push(3);
        bytes.extend(face.map(i32::to_le_bytes).as_flattened());
    }
    let files = Files::with("x.ply", bytes);
    assert_eq!(
        files.refusal("x.ply"),
        "\"x.ply\": vertex 1 holds -1e39, which is not a number up to 3.4e38, the largest of 32 bits"
    );
    assert_eq!(files.load_leniently("x.ply").mesh.indices, [[0, 2, 2]]);
}
