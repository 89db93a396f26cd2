use super::*;

/// The twelve triangles of the box.
fn triangles() -> impl Iterator<Item = [[f32; 3]; 3]> {
    let fan = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d]];
    let place = |corner: u32| CORNERS[corner as usize];
    SIDES.into_iter().flat_map(fan).map(move |t| t.map(place))
}

pub(super) fn text() -> String {
    let mut text = String::from("solid a box\n");
    for triangle in triangles() {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for [x, y, z] in triangle {
            text += &format!("      vertex {x} {y:e} {z}\n");
        }
        text += "    endloop\n  endfacet\n";
    }
    text + "endsolid a box\n"
}

pub(super) fn binary() -> Vec<u8> {
    let mut bytes = b"solid, says the header of this binary file".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(12_u32.to_le_bytes());
    for triangle in triangles() {
        bytes.extend([0; 12]);
        let numbers = triangle.into_iter().flatten();
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn text_and_bytes_read_the_same() {
    let from_text = Files::with("box.stl", text()).load("box.stl");
    let from_bytes = Files::with("box.stl", binary()).load("box.stl");
    assert_is_box(&from_text);
    assert_is_box(&from_bytes);
    assert_eq!(from_text.mesh.vertices.len(), 8, "corners are welded");
    assert_eq!(from_text.mesh.indices, from_bytes.mesh.indices);
    assert_eq!(from_text.mesh.parts[0].name, "a box");
    assert!(from_bytes.mesh.parts.is_empty());
}

#[test]
fn every_solid_is_a_part() {
    let two = format!("{}{}", text(), text().replace("a box", "Another"));
    let scene = Files::with("two.stl", two).load("two.stl");
    assert_eq!(scene.mesh.indices.len(), 24);
    assert_eq!(scene.mesh.vertices.len(), 8);
    let parts = scene.mesh.parts.iter();
    let parts: Vec<_> = parts
        .map(|p| (p.name.as_str(), p.first_triangle, p.triangle_count))
        .collect();
    assert_eq!(parts, [("a box", 0, 12), ("Another", 12, 12)]);
}

#[test]
fn text_is_known_in_any_case_and_without_a_name() {
    let shouted = text().to_uppercase().replace('\n', "\r\n");
    assert_is_box(&Files::with("box.stl", shouted).load("box.stl"));
    let nameless = text().replace(" a box", "");
    let scene = Files::with("box.stl", format!("\n {nameless}\n\n")).load("box.stl");
    assert_is_box(&scene);
    assert!(scene.mesh.parts.is_empty());
    let latin = [b"solid caf\xe9\n", &text().as_bytes()[12..]].concat();
    assert_is_box(&Files::with("box.stl", latin).load("box.stl"));
}

#[test]
fn truncated_files_say_what_is_missing() {
    let whole = binary();
    assert_eq!(
        Files::with("x.stl", &whole[..whole.len() - 60]).refusal("x.stl"),
        "\"x.stl\" ends early, or is not STL: 12 triangles are announced, 10 are there"
    );
    let whole = text();
    assert_eq!(
        Files::with("x.stl", &whole[..whole.len() - 60]).refusal("x.stl"),
        "\"x.stl\" ends early: face 11 is not complete, or \"endsolid\" is missing"
    );
}

#[test]
fn huge_counts_are_not_believed() {
    let mut bytes = binary();
    bytes[..80].fill(b'x');
    bytes[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let scene = Files::with("x.stl", &bytes).load("x.stl");
    assert_is_box(&scene);
    assert_eq!(
        scene.left_out[0].to_string(),
        "4,294,967,283 triangles announced, but missing"
    );
    bytes.push(0);
    assert_eq!(
        Files::with("x.stl", bytes).refusal("x.stl"),
        "\"x.stl\" ends early, or is not STL: 4294967295 triangles are announced, 12 are there"
    );
}

#[test]
fn the_length_counts_where_the_count_does_not_fit() {
    for count in [0_u32, 5, 12] {
        let mut bytes = binary();
        bytes[80..84].copy_from_slice(&count.to_le_bytes());
        let scene = Files::with("x.stl", &bytes).load("x.stl");
        assert_is_box(&scene);
        assert!(scene.left_out.is_empty());
        // Behind the last triangle, anything may follow.
        bytes.extend(b"anything");
        let scene = Files::with("x.stl", &bytes).load("x.stl");
        let triangle_count = if count == 0 { 12 } else { count as usize };
        assert_eq!(scene.mesh.indices.len(), triangle_count);
        let behind = 8 + 50 * (12 - triangle_count);
        let expected = format!("{behind} bytes behind the last triangle");
        assert_eq!(scene.left_out[0].to_string(), expected);
    }
}

#[test]
fn normals_and_colours_are_not_read() {
    let mut bytes = binary();
    bytes[84..88].copy_from_slice(&f32::NAN.to_le_bytes());
    bytes[84 + 48] = 1;
    let scene = Files::with("x.stl", bytes).load("x.stl");
    assert_is_box(&scene);
    assert_eq!(scene.left_out[0].to_string(), "1 facet colour");
    for normal in [
        " normal nan -nan(ind) 1.#QNAN",
        " normal",
        "",
        " normal x y z w",
        "\nnormal 0 0\n1",
    ] {
        let text = text().replace(" normal 0 0 0", normal);
        assert_is_box(&Files::with("x.stl", text).load("x.stl"));
    }
}

#[test]
fn words_of_text_stand_anywhere() {
    for text in [
        text().replace('\n', "\r"),
        text().replace('\n', " "),
        format!(
            "\u{feff}  {}",
            text()
                .replace("solid", "SOLID")
                .replace("vertex 1", "VERTEX 1.0E+00")
        ),
        text()
            .replace("solid a box\n  facet", "facet")
            .replace("endsolid a box", ""),
        text().replace("endsolid a box", "endsolid"),
    ] {
        let scene = Files::with("x.stl", &text).load("x.stl");
        assert_is_box(&scene);
    }
    // Far positions keep their places.
    let far = text()
        .replace("vertex 1", "vertex 4649777.125")
        .replace("vertex 0", "vertex 4649776.125");
    let scene = Files::with("x.stl", far).load("x.stl");
    assert_eq!(volume(&scene), 6.0);
}

#[test]
fn faults_name_the_face() {
    let refusal =
        |old: &str, new: &str| Files::with("x.stl", text().replacen(old, new, 1)).refusal("x.stl");
    assert_eq!(
        refusal("vertex 1 2e0 3", "vertex 1 two 3"),
        "\"x.stl\", line 20: \"two\" is not a number"
    );
    assert_eq!(
        refusal("vertex 1 2e0 3", "vertex 1 nan 3"),
        "\"x.stl\": mesh \"a box\", face 2 has vertex 6 at (1, NaN, 3), which is not finite"
    );
    assert_eq!(
        refusal("outer loop", "outer circle"),
        "\"x.stl\", line 3: \"circle\" is not a word of STL"
    );
    assert_eq!(
        refusal("endsolid a box\n", ""),
        "\"x.stl\" ends early: face 12 is not complete, or \"endsolid\" is missing"
    );
}

#[test]
fn lenient_loading_leaves_broken_faces_out() {
    // Two adjacent ones, and one more.
    let text = text().replace("vertex 1 2e0 3", "vertex 1 nan 3");
    let bad = text
        .split("endfacet")
        .filter(|face| face.contains("nan"))
        .count();
    let scene = Files::with("x.stl", text).load_leniently("x.stl");
    assert_eq!(scene.mesh.indices.len(), 12 - bad);
    assert_eq!(scene.dropped_face_count, bad);
    assert!(bad > 2);

    let mut bytes = binary();
    bytes[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    let files = Files::with("x.stl", bytes);
    assert_eq!(files.load_leniently("x.stl").dropped_face_count, 1);
    assert_eq!(
        files.refusal("x.stl"),
        "\"x.stl\": face 0 has vertex 0 at (NaN, 0, 0), which is not finite"
    );
}

#[test]
fn colours_in_the_header_are_noted() {
    let mut bytes = binary();
    bytes[50..60].copy_from_slice(b"COLOR=abcd");
    let scene = Files::with("x.stl", bytes).load("x.stl");
    assert_is_box(&scene);
    assert_eq!(left_out(&scene), ["1 colour in the header"]);
}

#[test]
fn numbers_beyond_32_bits_are_told_with_their_line() {
    let files = Files::with(
        "x.stl",
        text().replacen("vertex 1 2e0 3", "vertex 1 -2e39 3", 1),
    );
    assert_eq!(
        files.refusal("x.stl"),
        "\"x.stl\", line 20: \"-2e39\" is not a number up to 3.4e38, the largest of 32 bits"
    );
    assert_eq!(files.load_leniently("x.stl").dropped_face_count, 1);
}
