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
        b"newmtl\nnewmtl red\nKd 1\nKd 1 zwei 3\nillum many\nKs\nd\nmap_Kd\n\xff\nnewmtl mirror\n",
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
        "\"x.obj\", line 7: face 1 names vertex 0, but there are only 3 vertices"
    );
    assert_eq!(
        refusal(&format!("{good}f 1//1 2//1 3//5\n")),
        "\"x.obj\", line 7: face 1 names normal 5, but there are only 1 normals"
    );
    assert_eq!(
        refusal(&format!("{good}f 1 2 x\n")),
        "\"x.obj\", line 7: face parse error"
    );
    assert_eq!(
        refusal(&format!("{good}f\n")),
        "\"x.obj\", line 7: face parse error"
    );
    assert_eq!(
        refusal(&format!("{good}v 1 2\n")),
        "\"x.obj\", line 7: position parse error"
    );
    assert_eq!(
        refusal("v nan 0 0\nv 0 2 0\nv 0 0 3\ng thing\nf 1 2 3\n"),
        "\"x.obj\": mesh \"thing\", face 0 has vertex 0 at (NaN, 0, 0), which is not finite"
    );
    assert_eq!(refusal("v 1 0 0\n"), "\"x.obj\" holds no triangles");
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
        "\"x.obj\" holds no triangles; 1 broken faces were left out"
    );
}

#[test]
fn text_need_not_be_utf_8() {
    let bytes = [b"# caf\xe9\n".as_slice(), sample().as_bytes()].concat();
    assert_is_box(&Files::with("box.obj", bytes).load("box.obj"));
}
