//! Unusual scene files.

use super::{decode, number, parse};
use crate::files::{TwoTriangles, box_obj};
use crate::process::Folder;

#[test]
fn lenient_drops_broken_faces_and_counts_them() {
    let folder = Folder::new();
    let broken = [
        TwoTriangles::with_coordinate(f32::NAN),
        TwoTriangles::with_coordinate(f32::INFINITY),
    ];
    for mesh in broken {
        for (name, bytes) in [
            ("bad.obj", mesh.obj()),
            ("bad.off", mesh.off()),
            ("text.ply", mesh.ply_text()),
            ("bad.ply", mesh.ply_binary()),
            ("bad.stl", mesh.stl()),
            ("bad.glb", mesh.glb()),
        ] {
            drops_one(&folder, name, &bytes);
        }
    }
    for index in [4, -9, i32::MAX - 1] {
        let mesh = TwoTriangles::with_index(index);
        drops_one(&folder, "bad.obj", &mesh.obj());
        drops_one(&folder, "bad.off", &mesh.off());
        drops_one(&folder, "text.ply", &mesh.ply_text());
        drops_one(&folder, "bad.ply", &mesh.ply_binary());
        drops_one(&folder, "bad.glb", &mesh.glb());
    }
}

/// One of two faces is dropped, and `info` and `render` report it.
#[track_caller]
fn drops_one(folder: &Folder, name: &str, bytes: &[u8]) {
    folder.write(name, bytes);
    let text = folder.succeed(["info", "--lenient", name]);
    assert!(text.contains("1 broken face"), "{name}: {text}");
    for command in [&["info"][..], &["render", "--size", "16x9"]] {
        let report =
            parse(&folder.succeed([command, &["--lenient", name, "--json", "-"]].concat()));
        assert_eq!(
            (&report["triangles"], &report["dropped_faces"]),
            (&1.into(), &1.into()),
            "{name}"
        );
    }
}

#[test]
fn unusual_names_and_all_options_at_once() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("ä folder")).unwrap();
    folder.write("ä folder/größe 1.OBJ", box_obj());
    let name = "ä folder/größe 1.OBJ";
    let report = folder.succeed([
        "render",
        name,
        "--lenient",
        "-o",
        "ä folder/ö.PNG",
        "--size",
        "64X48",
        "--spp",
        "2",
        "--threads",
        "2",
        "--backend",
        "cpu",
        "--view",
        "color",
        "--camera",
        "eye=5,6,7; target=0.5,1,1.5; up=0,0,1; height=6",
        "--light",
        "sun=-1,-2,-3 color=1,2,3",
        "--light",
        "point=4,4,4 color=9,9,9 range=20",
        "--mirror-depth",
        "1",
        "--codes",
        "63",
        "--json",
        "-",
    ]);
    let report = parse(&report);
    assert_eq!(
        (&report["scene"], &report["picture"]),
        (&name.into(), &"ä folder/ö.PNG".into())
    );
    assert_eq!(
        (&report["width"], &report["height"]),
        (&64.into(), &48.into())
    );
    assert!(number(&report, "primary_hits") > 500.0);
    assert_eq!(decode(&folder.read("ä folder/ö.PNG")).0, [64, 48]);
}
