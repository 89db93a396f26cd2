use super::*;
use crate::{Material, Part};

/// The box with quads, in two groups with a material each.
pub(super) fn sample() -> String {
    let mut text = String::from("# a box of 1×2×3\nmtllib box.mtl\n");
    for [x, y, z] in CORNERS {
        text += &format!("v {x} {y} {z}\n");
    }
    text += "vt 0 0\nvn 0 0 2\ng left and right\nusemtl red\n";
    for (index, side) in SIDES.iter().enumerate() {
        if index == 2 {
            text += "o others\nusemtl mirror\n";
        }
        let [a, b, c, d] = side.map(|corner| corner + 1);
        text += &match index {
            // Four ways to name the same corners.
            0 => format!("f {a} {b} {c} {d}\n"),
            1 => format!("f {a}/1 {b}/1 {c}/1 {d}/1\n"),
            2 => format!("f {a}//1 {b}//1 {c}//1 {d}//1\n"),
            3 => format!("f {a}/1/1 {b}/1/1 {c}/1/1 {d}/1/1\n"),
            _ => {
                let [a, b, c, d] = [a, b, c, d].map(|corner| corner as i32 - 9);
                format!("f {a}//-1 {b}//-1 {c}//-1 {d}//-1\n")
            }
        };
    }
    text + "l 1 2 3 4\np 1\n"
}

const LIBRARY: &str = "newmtl red\nKd 0.75 0.25 0\nmap_Kd a.png\n\nnewmtl mirror\nKd 0 0.5 7\nKs 0.25 0.5 0.125\nillum 3\n";

#[test]
fn quads_groups_and_relative_indices() {
    let scene = Files::with("box.obj", sample()).load("box.obj");
    assert_is_box(&scene);
    assert!(scene.materials.is_empty() && scene.mesh.materials.is_empty());
    let part = |name: &str, first_triangle, triangle_count| Part {
        name: name.into(),
        first_triangle,
        triangle_count,
    };
    assert_eq!(
        scene.mesh.parts,
        [part("left and right", 0, 4), part("others", 4, 8)]
    );
    // The first group has no normals; in the second they have length 1.
    assert_eq!(scene.mesh.normals[0], [0.0; 3]);
    assert_eq!(scene.mesh.normals.last(), Some(&[0.0, 0.0, 1.0]));
}

#[test]
fn materials_come_from_the_library_beside() {
    let files = Files::with("box.obj", sample().replacen("usemtl red", "", 1));
    files.put("box.mtl", LIBRARY);
    let scene = files.load("box.obj");
    assert_eq!(
        scene.materials,
        [
            Material {
                base_color: [0.75, 0.25, 0.0],
                mirror: 0.0,
                ..Material::default()
            },
            Material {
                base_color: [0.0, 0.5, 1.0],
                mirror: 0.5,
                ..Material::default()
            },
            Material::default(),
        ]
    );
    assert_eq!(scene.mesh.materials, [2, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1]);
}

#[test]
fn glass_comes_from_the_library_too() {
    let files = Files::with("box.obj", sample());
    files.put(
        "box.mtl",
        "newmtl red\nKd 0.1 0.2 0.3\nTf 0.5 0.75 2\nNi 1.25\nillum 7\nnewmtl mirror\nillum 6\nTf xyz 1 1 1\nNi\n",
    );
    let glass = |base_color, ior| Material {
        base_color,
        transmission: 1.0,
        ior,
        ..Material::default()
    };
    let materials = files.load("box.obj").materials;
    assert_eq!(
        materials,
        [glass([0.5, 0.75, 1.0], 1.25), glass([1.0; 3], 1.5)]
    );
}

#[test]
fn libraries_may_be_broken() {
    let files = Files::with("box.obj", sample());
    files.put(
        "box.mtl",
        b"newmtl\nnewmtl red\nKd 1 2\nKd 1 zwei 3\nillum many\nKs\nd\nmap_Kd\n\xff\nnewmtl mirror\n",
    );
    let scene = files.load("box.obj");
    assert_eq!(scene.materials, [Material::default(); 2]);
    let files = Files::with("box.obj", sample().replace("box.mtl", "."));
    let refusal = files.refusal("box.obj");
    assert!(
        refusal.ends_with("is a folder or a device; name a file"),
        "{refusal}"
    );
}

#[test]
fn faces_outside_of_groups_have_no_part() {
    let scene = Files::with("x.obj", "v 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\n").load("x.obj");
    assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
    assert!(scene.mesh.parts.is_empty() && scene.mesh.normals.is_empty());
}

#[test]
fn faults_name_line_and_face() {
    let refusal = |text: &str| Files::with("x.obj", text).refusal("x.obj");
    let good = "v 1 0 0\nv 0 2 0\nv 0 0 3\nvn 0 0 1\n\nf 1 2 3\n";
    assert_eq!(
        refusal(&format!("{good}f 1 2 9\n")),
        "\"x.obj\", line 7: face 1 names vertex 9, but there are only 3 vertices"
    );
    assert_eq!(
        refusal(&format!("{good}f 1 2 -4\n")),
        "\"x.obj\", line 7: face 1 names vertex -4, but there are only 3 vertices"
    );
    assert_eq!(
        refusal(&format!("{good}f 1 2 0\n")),
        "\"x.obj\", line 7: face 1 names vertex 0, but vertices count from 1"
    );
    assert_eq!(
        refusal(&format!("{good}f 1//1 2//1 3//5\n")),
        "\"x.obj\", line 7: face 1 names normal 5, but there is only 1 normal"
    );
    assert_eq!(
        refusal(&format!("{good}f 1 2 x\n")),
        "\"x.obj\", line 7: \"x\" is not a corner such as 3, 3/1, 3//2 or 3/1/2"
    );
    assert_eq!(
        refusal(&format!("{good}f\n")),
        "\"x.obj\", line 7: 3 numbers are needed, 0 are there"
    );
    assert_eq!(
        refusal(&format!("{good}v 1 2\n")),
        "\"x.obj\", line 7: 3 numbers are needed, 2 are there"
    );
    assert_eq!(
        refusal("v nan 0 0\nv 0 2 0\nv 0 0 3\ng thing\nf 1 2 3\n"),
        "\"x.obj\": mesh \"thing\", face 0 has vertex 0 at (NaN, 0, 0), which is not finite"
    );
    assert_eq!(
        refusal("v 1 0 0\nsurf 0 1 0 1 1\nl 1 1\n"),
        "\"x.obj\" holds no triangles, only 1 point, 1 line, 1 free-form surface"
    );
    assert_eq!(refusal("# nothing\n"), "\"x.obj\" holds no triangles");
    assert_eq!(
        refusal("v 0 0 0\nv 1 0 0\np 1\nl 1 2\n"),
        "\"x.obj\" holds no triangles, only 1 line, 1 point"
    );
}

#[test]
fn lenient_loading_leaves_broken_faces_out() {
    let text = "v 1 0 0\nv 0 2 0\nv 0 0 3\nv inf 0 0\ng a\nf 1 2 3\nf 1 2 9\nf\nf 1 2 x\nf 1 2 4\nf 1//1 2//1 3//1\n";
    let scene = Files::with("x.obj", text).load_leniently("x.obj");
    assert_eq!(scene.mesh.indices.len(), 1);
    assert_eq!(scene.dropped_face_count, 5);
    assert_eq!(scene.mesh.parts[0].triangle_count, 1);
    assert_eq!(
        Files::with("x.obj", "v 0 0 0\nf 1 2 3\n").refusal_with("x.obj", &lenient()),
        "\"x.obj\" holds no triangles; 1 broken face was left out"
    );
}

#[test]
fn text_need_not_be_utf_8() {
    let bytes = [b"# caf\xe9\n".as_slice(), sample().as_bytes()].concat();
    assert_is_box(&Files::with("box.obj", bytes).load("box.obj"));
}

/// What is left out, as it is printed.
#[test]
fn lines_end_and_go_on_in_all_ways() {
    let plain = sample().replace("mtllib box.mtl\n", "");
    for text in [
        format!("\u{feff}{plain}"),
        plain.replace('\n', "\r\n"),
        plain.replace('\n', "\r"),
        plain.replace("f 5 6", "f 5\\\n 6"),
        plain.replace(" 3 7", " \\  \r\n3 \\\n\t7"),
        plain.replace("\nf", " # comment \\\nf"),
        plain.replace(' ', "  \t"),
    ] {
        let scene = Files::with("box.obj", &text).load("box.obj");
        assert_is_box(&scene);
    }
    let utf_16 = plain.encode_utf16().flat_map(u16::to_le_bytes);
    let utf_16: Vec<u8> = [0xff, 0xfe].into_iter().chain(utf_16).collect();
    assert_is_box(&Files::with("box.obj", utf_16).load("box.obj"));
    // The line of a fault is that of the file.
    let text = "v 0 0 \\\n 0\r\nv 1 0 0\r\nf 1 2 \\\r\n 9\r\n";
    let refusal = Files::with("x.obj", text).refusal("x.obj");
    assert!(
        refusal.contains("line 4: face 0 names vertex 9"),
        "{refusal}"
    );
}

#[test]
fn faces_may_come_before_their_vertices() {
    let text =
        "g a\nf 1 2 3\nf 1 2 9\ng b\nf 1//1 2//1 3//1\nv 1 0 0\nv 0 2 0\nv 0 0 3\nvn 0 0 1\n";
    let files = Files::with("x.obj", text);
    assert_eq!(
        files.refusal("x.obj"),
        "\"x.obj\", line 3: face 1 names vertex 9, but there are only 3 vertices"
    );
    let scene = files.load_leniently("x.obj");
    assert_eq!((scene.mesh.indices.len(), scene.dropped_face_count), (2, 1));
    let parts = scene.mesh.parts.iter();
    let parts: Vec<_> = parts.map(|p| (&*p.name, p.first_triangle)).collect();
    assert_eq!(parts, [("a", 0), ("b", 1)]);
}

#[test]
fn weights_and_colours_may_follow_a_position() {
    let text = "v 1 0 0 1 0 0\nv 0 2 0\nv 0 0 3 1.0\nv 1 1 1 1 .5 .5 .5\nf 1 2 3 # x\nf 2 3 4#y\n";
    let scene = Files::with("x.obj", text).load("x.obj");
    assert_eq!(scene.mesh.indices, [[0, 1, 2], [1, 2, 3]]);
    assert_eq!(left_out(&scene), ["2 vertex colours"]);
}

#[test]
fn normals_may_be_no_numbers() {
    let text = "v 1 0 0\nv 0 2 0\nv 0 0 3\nvn 1.#QNAN -1.#IND 0\nvn 0 -nan(ind) 0\nvn 0 0 2\nf 1//1 2//2 3//3\n";
    let scene = Files::with("x.obj", text).load("x.obj");
    assert_eq!(scene.mesh.normals, [[0.0; 3], [0.0; 3], [0.0, 0.0, 1.0]]);
}

#[test]
fn positions_are_read_in_f64() {
    let text = |x: f64| {
        let v = |dx: f64, y: f64| format!("v {} {y} 0\n", x + dx);
        format!("{}{}{}f 1 2 3\n", v(0.0, 0.0), v(0.125, 0.0), v(0.0, 0.25))
    };
    let far = Files::with("x.obj", text(4_649_776.375)).load("x.obj");
    let near = Files::with("x.obj", text(0.0)).load("x.obj");
    assert_ne!(far.origin, [0.0; 3]);
    for (far_vertex, near) in far.mesh.vertices.iter().zip(&near.mesh.vertices) {
        let x = f64::from(far_vertex[0]) + far.origin[0] - 4_649_776.375;
        assert_eq!(x, f64::from(near[0]));
    }
}

#[test]
fn libraries_are_found_by_all_their_names() {
    const BLUE: &str = "newmtl blue\nKd 0 0 1\n";
    const RED: &str = "newmtl red # 1\nKd 1 0 0\n";
    let load = |line: &str, files: &[(&str, &str)]| {
        let folder = Files::with(
            "x.obj",
            format!("{line}\nv 1 0 0\nv 0 2 0\nv 0 0 3\nusemtl blue\nf 1 2 3\n"),
        );
        for (name, text) in files {
            folder.put(name, text);
        }
        folder.load("x.obj")
    };
    for (line, name) in [
        ("mtllib none.mtl b.mtl", "b.mtl"),
        ("mtllib none.mtl\nmtllib b.mtl", "b.mtl"),
        ("mtllib my house.mtl", "my house.mtl"),
        ("mtllib none.mtl my house.mtl", "my house.mtl"),
        ("mtllib \"my house.mtl\"", "my house.mtl"),
        ("mtllib C:\\models\\b.mtl", "b.mtl"),
        ("mtllib .\\b.mtl", "b.mtl"),
        ("mtllib b.mtl\r", "b.mtl"),
        ("mtllib no_extension", "no_extension"),
    ] {
        let scene = load(line, &[(name, BLUE)]);
        assert_eq!(scene.materials[0].base_color, [0.0, 0.0, 1.0], "{line}");
        assert_eq!(scene.mesh.materials, [0], "{line}");
        let missing = "1 missing material library \"none.mtl\"";
        let expected = if line.contains("none") {
            vec![missing]
        } else {
            vec![]
        };
        assert_eq!(left_out(&scene), expected, "{line}");
    }
    // The last material of a name counts; without a library no face has one.
    let both = [("a.mtl", RED), ("b.mtl", BLUE)];
    assert_eq!(load("mtllib a.mtl b.mtl", &both).mesh.materials, [1]);
    let scene = load("mtllib a.mtl", &both[..1]);
    assert_eq!(scene.materials.len(), 2);
    assert_eq!(left_out(&scene), ["1 material that no library has"]);
    let scene = load("mtllib a.mtl c.mtl c.mtl", &[]);
    assert_eq!(left_out(&scene).len(), 3);
}

#[test]
fn what_is_not_drawn_is_noted() {
    let files = Files::with(
        "x.obj",
        "mtllib x.mtl\nvt 0 0\nvt 1 1\ns 1\ns off\ns 2\ns 1\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\nf 1 2\nl 1 2\nl 2 3\np 1 2 3\ncurv 0 1 1 2\ncall other.obj\n",
    );
    files.put(
        "x.mtl",
        "newmtl a\nmap_Kd -s 1 1 1 a.png\nbump b.png\nKe 0 1 0\nd 0.5\nnewmtl b\nKe 0 0 0\nd 1\nTr 0\nnewmtl c\nTr 0.25\n",
    );
    let scene = files.load("x.obj");
    assert_eq!(
        left_out(&scene),
        [
            "2 texture coordinates",
            "2 lines",
            "3 points",
            "1 free-form curve",
            "2 smoothing groups",
            "1 unknown statement",
            "2 textures",
            "2 transparent materials",
            "1 emissive material",
            "1 face with fewer than three corners",
        ]
    );
    let with_normals = Files::with(
        "x.obj",
        "s 1\nvn 0 0 1\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1//1 2//1 3//1\n",
    );
    assert!(with_normals.load("x.obj").left_out.is_empty());
}

#[test]
fn many_missing_libraries_are_told_in_short() {
    let names: String = (0..100).map(|i| format!("mtllib {i}.mtl\n")).collect();
    let text = format!("{names}v 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\n");
    let scene = Files::with("x.obj", text).load("x.obj");
    let total: usize = scene.left_out.iter().map(|left| left.count).sum();
    assert_eq!((scene.left_out.len(), total), (33, 100));
}

#[test]
fn concave_polygons_are_cut_along_their_ears() {
    // An L, from a corner whose fan leaves it; a square with a square hole by a bridge; a dart.
    let l = "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 2 3 4 5 6 1\n";
    let keyhole = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n";
    let dart = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 2 3 4 1\n";
    for (text, area, count) in [(l, 5.0, 4), (keyhole, 12.0, 8), (dart, 4.0, 2)] {
        let mesh = Files::with("x.obj", text).load("x.obj").mesh;
        assert_eq!(mesh.indices.len(), count, "{text}");
        let doubles = mesh.indices.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|i| glam::Vec3::from(mesh.vertices[i as usize]));
            (b - a).cross(c - a).z
        });
        let doubles: Vec<f32> = doubles.collect();
        assert!(doubles.iter().all(|double| *double >= 0.0), "{doubles:?}");
        assert_eq!(doubles.iter().sum::<f32>(), 2.0 * area, "{text}");
    }
}

#[test]
fn materials_tell_what_they_hold_besides() {
    let notes = |library: &str| {
        let files = Files::with(
            "x.obj",
            "mtllib x.mtl\nv 1 0 0\nv 0 2 0\nv 0 0 3\nusemtl a\nf 1 2 3\n",
        );
        files.put("x.mtl", format!("newmtl a\n{library}\n"));
        left_out(&files.load("x.obj"))
    };
    for model in 0..=10 {
        let expected: &[&str] = match model {
            4 | 5 | 8..=10 => &["1 material with illumination model 4, 5, 8, 9 or 10"],
            _ => &[],
        };
        assert_eq!(notes(&format!("illum {model}")), expected, "{model}");
    }
    for keyword in ["Pr", "Pm", "Ps", "Pc", "aniso"] {
        let expected = ["1 material with roughness, metal, sheen or coats"];
        assert_eq!(notes(&format!("{keyword} 0.5")), expected);
        assert!(notes(&format!("{keyword} 0.0")).is_empty());
    }
    assert_eq!(notes("Tf 0.5 1 1"), ["1 transmission filter"]);
    assert!(notes("Tf 0.5 1 1\nillum 6").is_empty());
    assert!(notes("Tf 1 1 1\nNi 1.5\nillum 2").is_empty());
    for colour in ["Kd spectral a.rfl 1", "Ks xyz 0.1 0.2 0.3"] {
        assert_eq!(notes(colour), ["1 spectral colour"]);
    }
}

#[test]
fn lenient_loading_drops_faces_with_broken_vertices() {
    for (broken, refusal) in [
        ("v 1 abc 2", "\"abc\" is not a number"),
        ("v 1 2", "3 numbers are needed, 2 are there"),
        (
            "v 1 1e39 2",
            "\"1e39\" is not a number up to 3.4e38, the largest of 32 bits",
        ),
    ] {
        let text = format!("v 1 0 0\nv 0 2 0\nv 0 0 3\n{broken}\nf 1 2 3\nf 1 2 4\n");
        let files = Files::with("x.obj", text);
        assert_eq!(
            files.refusal("x.obj"),
            format!("\"x.obj\", line 4: {refusal}")
        );
        let scene = files.load_leniently("x.obj");
        assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
        assert_eq!(scene.dropped_face_count, 1);
    }
}
