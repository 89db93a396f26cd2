use super::*;

/// The box, with its sides as quads and a colour for each.
pub(super) fn sample() -> String {
    let mut text = String::from("OFF\n# a box of 1×2×3\n8 6 0\n\n");
    for [x, y, z] in CORNERS {
        text += &format!("{x} {y} {z}\n");
    }
    for [a, b, c, d] in SIDES {
        text += &format!("4 {a} {b} {c} {d} 255 0 128 # side\n");
    }
    text
}

#[test]
fn quads_become_triangles() {
    let scene = Files::with("box.off", sample()).load("box.off");
    assert_is_box(&scene);
    assert_eq!(scene.mesh.vertices, CORNERS);
    assert_eq!(scene.mesh.indices[..2], [[0, 4, 6], [0, 6, 2]]);
}

#[test]
fn counts_may_stand_behind_the_keyword_and_lines_end_as_they_like() {
    let text = sample()
        .replace("OFF\n# a box of 1×2×3\n8 6 0", "OFF 8 6")
        .replace('\n', "\r\n");
    assert_is_box(&Files::with("box.off", text).load("box.off"));
}

#[test]
fn normals_are_read_and_colours_passed_over() {
    let text = "CNOFF 3 2\n1 0 0 0 0 2 1 1 1 1\n0 2 0 0 3 4 1 1 1 1\n0 0 3 0 0 0 1 1 1 1\n3 0 1 2\n2 0 1\n";
    let scene = Files::with("x.off", text).load("x.off");
    assert_eq!(
        scene.mesh.vertices,
        [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]
    );
    assert_eq!(
        scene.mesh.normals,
        [[0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [0.0; 3]]
    );
    assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
}

#[test]
fn faults_name_line_and_face() {
    let refusal = |text: String| Files::with("a.off", text).refusal("a.off");
    assert_eq!(
        refusal(sample().replace("4 2 6 7 3", "4 2 6 9 3")),
        "\"a.off\", line 16: face 3 names vertex 9, but there are only 8 vertices"
    );
    assert_eq!(
        refusal(sample().replace("4 2 6 7 3", "4 2 6 -1 3")),
        "\"a.off\", line 16: face 3 names vertex -1, but there are only 8 vertices"
    );
    assert_eq!(
        refusal(sample().replace("4 2 6 7 3 255 0 128", "9 2 6 7 3")),
        "\"a.off\", line 16: 10 numbers are needed, 5 are there"
    );
    assert_eq!(
        refusal(sample().replace("1 0 3\n", "1 zero 3\n")),
        "\"a.off\", line 10: \"zero\" is not a number"
    );
    assert_eq!(
        refusal(sample().replace("1 0 3\n", "1 0\n")),
        "\"a.off\", line 10: 3 numbers are needed, 2 are there"
    );
    assert_eq!(
        refusal(sample().replace("8 6 0", "8 7 0")),
        "\"a.off\" ends early: 7 faces are announced, 6 are there"
    );
    assert_eq!(
        refusal("OFF\n8 -1 0\n".into()),
        "\"a.off\", line 2: \"-1\" is not a count"
    );
}

#[test]
fn huge_counts_are_not_believed() {
    assert_eq!(
        Files::with("a.off", "OFF\n4000000000 1 0\n0 0 0\n").refusal("a.off"),
        "\"a.off\" ends early: 4000000000 vertices are announced, 1 is there"
    );
    assert_eq!(
        Files::with("a.off", "OFF\n1 1\n0 0 0\n18446744073709551615 0 0").refusal("a.off"),
        "\"a.off\", line 4: 18446744073709551615 numbers are needed, 3 are there"
    );
}

#[test]
fn other_kinds_are_refused() {
    let refusal = |text: &str| Files::with("a.off", text).refusal("a.off");
    let rest = "slimbvh reads OFF text with the prefixes C, N and ST";
    assert_eq!(
        refusal("4OFF\n"),
        format!("\"a.off\" begins with \"4OFF\"; {rest}")
    );
    assert_eq!(
        refusal("OFF BINARY\n"),
        format!("\"a.off\" begins with \"OFF BINARY\"; {rest}")
    );
    for header in ["nOFF", "py", "-8", "OFFLINE"] {
        let expected = format!("\"a.off\" begins with \"{header}\"; {rest}");
        assert_eq!(refusal(&format!("{header} 1\n")), expected);
    }
}

#[test]
fn lenient_loading_leaves_broken_faces_out() {
    let text = sample()
        .replace("4 2 6 7 3", "4 2 6 9 3")
        .replace("1 0 3\n", "nan 0 3\n");
    let files = Files::with("a.off", text);
    // Dropped: a quad, which is one face, and the four triangles with corner 5.
    let scene = files.load_leniently("a.off");
    assert_eq!(scene.mesh.indices.len(), 6);
    assert_eq!(scene.dropped_face_count, 5);
    assert!(scene.mesh.indices.iter().all(|face| !face.contains(&5)));
    let refusal = files.refusal("a.off");
    assert!(refusal.contains("vertex 9"), "{refusal}");

    let files = Files::with("b.off", sample().replace("1 0 3\n", "nan 0 3\n"));
    assert_eq!(
        files.refusal("b.off"),
        "\"b.off\": face 3 has vertex 5 at (NaN, 0, 3), which is not finite"
    );
}

#[test]
fn text_need_not_be_utf_8() {
    let bytes = [b"OFF # caf\xe9\n".as_slice(), &sample().as_bytes()[4..]].concat();
    assert_is_box(&Files::with("box.off", bytes).load("box.off"));
    let refusal = Files::with("a.off", b"OFF\n1 1\n0 \xe9 0").refusal("a.off");
    assert_eq!(refusal, "\"a.off\", line 3: \"\u{fffd}\" is not a number");
}

#[test]
fn headers_have_many_forms() {
    for header in [
        "OFF8 6 0",
        "8 6 0",
        "OFF\n8\n6\n0",
        "OFF 8\n6 0",
        "OFF\r\n\r\n8 6",
        "COFF8 6 0",
        "STOFF\n8 6 0",
        "\u{feff}OFF # comment\n# another\n8 6 0",
    ] {
        let text = sample().replace("OFF\n# a box of 1×2×3\n8 6 0", header);
        for text in [text.replace('\n', "\r"), text] {
            let scene = Files::with("box.off", &text).load("box.off");
            assert_is_box(&scene);
            assert_eq!(left_out(&scene), ["6 face colours"]);
        }
    }
}

#[test]
fn rows_may_take_several_lines_and_lines_several_rows() {
    let numbers = sample().replace("255 0 128 # side", "");
    let numbers: Vec<&str> = numbers
        .lines()
        .skip(2)
        .flat_map(str::split_whitespace)
        .collect();
    for in_line in [2, 5, 1000] {
        let lines = numbers[3..].chunks(in_line).map(|words| words.join(" "));
        let text = format!("OFF 8 6 0\n{}", lines.collect::<Vec<_>>().join("\n"));
        assert_is_box(&Files::with("box.off", text).load("box.off"));
    }
}

#[test]
fn vertex_colours_are_noted() {
    let text = "OFF 3 1 0\n1 0 0 255 0 0\n0 2 0 0 0 0 255\n0 0 3\n3 0 1 2\n";
    let scene = Files::with("x.off", text).load("x.off");
    assert_eq!(scene.left_out[0].to_string(), "2 vertex colours");
}

#[test]
fn what_is_not_read_is_noted() {
    let notes = |text: &str| left_out(&Files::with("x.off", text).load("x.off"));
    let faces = "3 0 1 2\n";
    let rows = |more: &str| format!("1 0 0{more}\n0 2 0{more}\n0 0 3{more}\n{faces}");
    assert_eq!(
        notes(&format!("STOFF 3 1 0\n{}", rows(" 0 1"))),
        ["3 texture coordinates"]
    );
    assert_eq!(
        notes(&format!("CSTOFF 3 1 0\n{}", rows(" 255 0 0 1 0 1"))),
        ["3 vertex colours", "3 texture coordinates"]
    );
    for spare in [" 1", " 1 2"] {
        assert_eq!(
            notes(&format!("OFF 3 1 0\n{}", rows(spare))),
            ["3 vertices with spare numbers"]
        );
    }
    assert_eq!(
        notes(&format!("OFF 3 1 0\n{}3 2 1 0\n\n", rows(""))),
        ["1 line behind the end"]
    );
}

#[test]
fn coloured_vertices_may_share_lines() {
    for colour in ["255 0 0 255", "1 0 0"] {
        let text = format!("COFF 3 1 0\n1 0 0 {colour} 0 2 0 {colour}\n0 0 3 {colour}\n3 0 1 2\n");
        let scene = Files::with("x.off", text).load("x.off");
        assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
        assert_eq!(scene.mesh.vertices[1], [0.0, 2.0, 0.0]);
        assert_eq!(left_out(&scene), ["3 vertex colours"]);
    }
}

#[test]
fn lenient_loading_drops_faces_with_broken_words() {
    let text =
        "OFF 5 5 0\n1 0 0\n0 2 0\n0 0 3\n0 abc 0\n0 1\n3 0 1 2\n3 0 1 3\n3 0 x 1\n3 0 1\n3 0 1 4\n";
    let files = Files::with("x.off", text);
    let scene = files.load_leniently("x.off");
    assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
    assert_eq!(scene.dropped_face_count, 4);
    assert_eq!(
        files.refusal("x.off"),
        "\"x.off\", line 5: \"abc\" is not a number"
    );
}
