//! Scene files that are missing, truncated, inconsistent or random.

use super::{folder, refuses, refuses_scene};
use crate::files::{TwoTriangles, gltf_json, noise, ply_header};
use crate::refusal::refusal;

const EXTENSIONS: [&str; 7] = ["gltf", "glb", "obj", "ply", "stl", "off", "slim"];

#[test]
fn no_such_file() {
    let folder = folder();
    for name in ["gone.obj", "no folder/gone.ply", "gone.glb"] {
        refuses_scene(&folder, &[name], &[&format!("\"{name}\"")]);
    }
    // A path cannot lead through a file.
    refuses_scene(
        &folder,
        &["sound.obj/inner.obj"],
        &["\"sound.obj/inner.obj\""],
    );
}

/// The file is looked for before a GPU is: the sentence is about what is missing first.
#[test]
fn a_missing_file_is_told_before_a_missing_gpu() {
    let folder = folder();
    let gpu = ["--backend", "gpu", "--adapter", "no such adapter"];
    for command in [
        &["render", "-o", "new.png"][..],
        &["animate", "--frames", "2"],
    ] {
        for name in ["gone.obj", "gone.slim"] {
            if command[0] == "animate" && name == "gone.slim" {
                continue;
            }
            refuses(
                &folder,
                &[command, &[name], &gpu].concat(),
                &[&format!("\"{name}\"")],
            );
        }
        // With the file it is about the GPU.
        let sentence = refusal(&folder, &[command, &["sound.obj"], &gpu].concat());
        assert!(!sentence.contains("sound.obj"), "{sentence}");
    }
}

#[test]
fn folders_are_not_files() {
    let folder = folder();
    for extension in EXTENSIONS {
        let name = format!("folder.{extension}");
        std::fs::create_dir(folder.path().join(&name)).unwrap();
        refuses_scene(&folder, &[&name], &[&format!("\"{name}\""), "is a folder"]);
    }
}

#[test]
fn extensions_that_nobody_reads() {
    let folder = folder();
    folder.write("scene.fbx", "");
    folder.write("scene", "");
    let readable = "gltf, glb, obj, ply, stl, off and slim";
    refuses_scene(
        &folder,
        &["scene.fbx"],
        &["\"scene.fbx\"", "\"fbx\"", readable],
    );
    refuses_scene(
        &folder,
        &["scene"],
        &["\"scene\"", "no extension", readable],
    );
    refuses_scene(&folder, &[".obj"], &["\".obj\""]);
    refuses_scene(&folder, &["."], &["\".\""]);
}

#[test]
fn names_with_line_ends_and_escapes_stay_in_one_line() {
    let folder = folder();
    refuses_scene(&folder, &["two\nlines.obj"], &["lines.obj"]);
    refuses_scene(&folder, &["two\nlines.fbx"], &["lines.fbx"]);
    refuses_scene(&folder, &["red \u{1b}[31m.obj"], &[".obj"]);
    // Names inside a file may hold escapes, too.
    let words = "\u{1b}[31mred";
    folder.write(
        "words.off",
        format!("OFF\n3 1 0\n{words} 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    );
    refuses_scene(&folder, &["words.off"], &["line 3", "red"]);
    let long = "long ".repeat(1000);
    let part = |name: &str| format!("o {name}\nv 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\n");
    folder.write("long.obj", part(&long));
    refuses_scene(
        &folder,
        &["long.obj"],
        &["\"long.obj\"", "mesh \"long", "NaN"],
    );
    let strange = |text: &str| format!(r#"{{"asset": "{text}"}}"#);
    folder.write("long.gltf", strange(&long));
    refuses_scene(&folder, &["long.gltf"], &["\"long.gltf\"", "JSON", "long"]);
    folder.write("bell.obj", part("ring \u{7} the bell"));
    refuses_scene(
        &folder,
        &["bell.obj"],
        &["\"bell.obj\"", "mesh \"ring", "NaN"],
    );
}

#[test]
fn noise_of_all_kinds() {
    let folder = folder();
    let text = "this is not a mesh, whatever the extension says\n".repeat(50);
    for extension in EXTENSIONS {
        for (kind, bytes) in [
            ("empty", Vec::new()),
            ("zeros", vec![0; 4096]),
            ("noise", noise(4096)),
            ("text", text.clone().into_bytes()),
            ("line", vec![b'1'; 100_000]),
        ] {
            let name = format!("{kind}.{extension}");
            folder.write(&name, bytes);
            refuses_scene(&folder, &[&name], &[&format!("\"{name}\"")]);
        }
    }
}

#[test]
fn one_format_under_the_name_of_another() {
    let folder = folder();
    let sound = TwoTriangles::SOUND;
    let files = [
        ("obj", sound.obj()),
        ("off", sound.off()),
        ("ply", sound.ply_text()),
        ("ply", sound.ply_binary()),
        ("glb", sound.glb()),
        ("stl", sound.stl()),
    ];
    for (own, bytes) in files {
        for extension in EXTENSIONS.iter().filter(|&&other| other != own) {
            // A GLB file may be named gltf.
            if (own, *extension) != ("glb", "gltf") {
                let name = format!("scene.{extension}");
                folder.write(&name, &bytes);
                refuses_scene(&folder, &[&name], &[&format!("\"{name}\"")]);
            }
        }
    }
}

#[test]
fn cut_text() {
    let folder = folder();
    let cut = |bytes: Vec<u8>, end: &[u8]| bytes.strip_suffix(end).expect("it ends so").to_owned();
    folder.write(
        "face.ply",
        cut(TwoTriangles::SOUND.ply_text(), b"3 1 3 2\n"),
    );
    refuses_scene(
        &folder,
        &["face.ply"],
        &["\"face.ply\" ends early", "2 faces", "1 "],
    );
    let faces = b"0 0 0\n1 0 0\n0 2 0\n1 2 3\n3 0 1 2\n3 1 3 2\n";
    folder.write("none.ply", cut(TwoTriangles::SOUND.ply_text(), faces));
    refuses_scene(
        &folder,
        &["none.ply"],
        &["\"none.ply\" ends early", "4 vertices", "0 "],
    );
    folder.write("head.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    refuses_scene(&folder, &["head.ply"], &["\"head.ply\"", "header"]);
    folder.write("face.off", cut(TwoTriangles::SOUND.off(), b"3 1 3 2\n"));
    refuses_scene(
        &folder,
        &["face.off"],
        &["\"face.off\" ends early", "2 faces", "1 "],
    );
    folder.write("corner.off", cut(TwoTriangles::SOUND.off(), b" 2\n"));
    refuses_scene(
        &folder,
        &["corner.off"],
        &["\"corner.off\", line 8", "4 numbers", "3 "],
    );
}

#[test]
fn cut_bytes() {
    let folder = folder();
    let sound = TwoTriangles::SOUND;
    for (name, bytes) in [
        ("cut.ply", sound.ply_binary()),
        ("cut.stl", sound.stl()),
        ("cut.glb", sound.glb()),
    ] {
        let step = bytes.len() / 12;
        for length in (0..bytes.len()).step_by(step).chain([bytes.len() - 1]) {
            folder.write(name, &bytes[..length]);
            refuses_scene(&folder, &[name], &[&format!("\"{name}\"")]);
        }
    }
}

#[test]
fn indices_out_of_range() {
    let folder = folder();
    let [beyond, negative] = [4, -9].map(TwoTriangles::with_index);
    for (name, bytes, expected) in [
        ("beyond.obj", beyond.obj(), ["line 6", "5", "4 vertices"]),
        (
            "zero.obj",
            TwoTriangles::with_index(-1).obj(),
            ["line 6", "vertex 0", "count from 1"],
        ),
        (
            "negative.obj",
            negative.obj(),
            ["line 6", "-8", "4 vertices"],
        ),
        (
            "beyond.off",
            beyond.off(),
            ["line 8", "vertex 4", "4 vertices"],
        ),
        (
            "negative.off",
            negative.off(),
            ["line 8", "-9", "4 vertices"],
        ),
        (
            "beyond.ply",
            beyond.ply_text(),
            ["line 15", "vertex 4", "4 vertices"],
        ),
        (
            "negative.ply",
            negative.ply_text(),
            ["line 15", "-9", "4 vertices"],
        ),
        (
            "binary.ply",
            beyond.ply_binary(),
            ["face 1", "vertex 4", "4 vertices"],
        ),
        (
            "below.ply",
            negative.ply_binary(),
            ["face 1", "-9", "4 vertices"],
        ),
        (
            "beyond.glb",
            beyond.glb(),
            ["face 1", "vertex 4", "4 vertices"],
        ),
    ] {
        let file = format!("\"{name}\"");
        folder.write(name, bytes);
        refuses_scene(
            &folder,
            &[name],
            &[&[file.as_str()], &expected[..]].concat(),
        );
    }
}

#[test]
fn corners_that_are_not_finite() {
    let folder = folder();
    for (x, word) in [
        (f32::NAN, "NaN"),
        (f32::INFINITY, "inf"),
        (f32::NEG_INFINITY, "-inf"),
    ] {
        let mesh = TwoTriangles::with_coordinate(x);
        for (name, bytes) in [
            ("bad.obj", mesh.obj()),
            ("bad.off", mesh.off()),
            ("text.ply", mesh.ply_text()),
            ("binary.ply", mesh.ply_binary()),
            ("bad.stl", mesh.stl()),
            ("bad.glb", mesh.glb()),
        ] {
            folder.write(name, bytes);
            let file = format!("\"{name}\"");
            refuses_scene(&folder, &[name], &[&file, "face 1", word, "not finite"]);
        }
    }
}

#[test]
fn lenient_still_wants_a_triangle() {
    let folder = folder();
    let mut mesh = TwoTriangles::with_coordinate(f32::NAN);
    mesh.faces[0][2] = 3;
    for (name, bytes) in [
        ("bad.obj", mesh.obj()),
        ("bad.off", mesh.off()),
        ("bad.ply", mesh.ply_binary()),
        ("bad.stl", mesh.stl()),
        ("bad.glb", mesh.glb()),
    ] {
        folder.write(name, bytes);
        let file = format!("\"{name}\"");
        refuses_scene(
            &folder,
            &["--lenient", name],
            &[&file, "no triangles", "2 broken faces"],
        );
    }
}

#[test]
fn nothing_to_draw() {
    let folder = folder();
    let mut no_triangles = vec![0; 80];
    no_triangles.extend(0_u32.to_le_bytes());
    let empty = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}]}"#;
    for (name, bytes) in [
        ("empty.obj", b"# nothing\nv 0 0 0\n".to_vec()),
        ("empty.off", b"OFF\n0 0 0\n".to_vec()),
        ("empty.ply", ply_header("ascii", 0, 0).into_bytes()),
        ("empty.stl", no_triangles),
        ("text.stl", b"solid nothing\nendsolid nothing\n".to_vec()),
        ("empty.gltf", empty.into()),
    ] {
        folder.write(name, bytes);
        refuses_scene(&folder, &[name], &[&format!("\"{name}\""), "no triangles"]);
    }
}

#[test]
fn four_thousand_million_of_everything() {
    let folder = folder();
    let many = 4_000_000_000;
    let some_bytes = [0; 1000];
    let mut stl = vec![0; 80];
    stl.extend(u32::MAX.to_le_bytes());
    stl.extend(some_bytes);
    // Of whole triangles the length is believed.
    stl.push(0);
    let list = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
                property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n";
    let list = [
        list.as_bytes(),
        &[0; 36],
        &u32::MAX.to_le_bytes(),
        &some_bytes,
    ]
    .concat();
    let uri = format!(
        r#""uri": "data:application/octet-stream;base64,{}","#,
        "A".repeat(96)
    );
    for (name, bytes, number) in [
        (
            "text.ply",
            ply_header("ascii", many, 1).into_bytes(),
            "4000000000",
        ),
        (
            "binary.ply",
            [
                ply_header("binary_little_endian", many, 1).as_bytes(),
                &some_bytes,
            ]
            .concat(),
            "4000000000",
        ),
        (
            "faces.ply",
            [ply_header("ascii", 1, many).as_bytes(), b"0 0 0\n"].concat(),
            "4000000000",
        ),
        (
            "largest.ply",
            ply_header("ascii", u64::MAX, 1).into_bytes(),
            "",
        ),
        ("list.ply", list, ""),
        (
            "vertices.off",
            b"OFF\n4000000000 1 0\n0 0 0\n".to_vec(),
            "4000000000",
        ),
        (
            "faces.off",
            b"OFF\n1 4000000000 0\n0 0 0\n".to_vec(),
            "4000000000",
        ),
        (
            "corners.off",
            b"OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n".to_vec(),
            "4000000001",
        ),
        ("faces.stl", stl, "4294967295"),
        ("vertices.gltf", gltf_json(&uri, many).into_bytes(), ""),
    ] {
        folder.write(name, bytes);
        refuses_scene(&folder, &[name], &[&format!("\"{name}\""), number]);
    }
}
