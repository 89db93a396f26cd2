//! Saved hierarchies: `build` writes them, `render` shows them without a build, `info` describes them.

use super::{keys, number, parse};
use crate::files::{TwoTriangles, box_obj};
use crate::process::Folder;

const SIZE: [&str; 4] = ["--size", "160x90", "--backend", "cpu"];

/// Storage options, each tried on the default scene and on one with neither camera nor light.
const STORED: [&[&str]; 8] = [
    &[],
    &["--codes", "63"],
    &["--nodes", "q6"],
    &["--nodes", "w4"],
    &["--nodes", "w4-48", "--mesh", "lattice"],
    &["--nodes", "paper10"],
    &["--mesh", "leaf10"],
    &["--tolerance", "0.4px"],
];

/// `render` makes identical pictures from a scene and from the file that `build` made of it.
#[track_caller]
fn same_picture(folder: &Folder, scene: &[&str], stored: &[&str], view: &[&str]) {
    let built = ["build", "-o", "it.slim", "--size", "160x90"];
    folder.succeed([&built[..], scene, stored].concat());
    let render = ["render", "-o", "scene.png", "--reduce", "off"];
    folder.succeed([&render[..], scene, &SIZE, stored, view].concat());
    let render = ["render", "it.slim", "-o", "saved.png"];
    folder.succeed([&render[..], &SIZE, view].concat());
    assert!(
        folder.read("scene.png") == folder.read("saved.png"),
        "{scene:?} {stored:?} {view:?}"
    );
}

#[test]
fn saved_scenes_make_the_picture_that_the_scene_makes() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    for stored in STORED {
        same_picture(&folder, &[], stored, &[]);
        same_picture(&folder, &["box.obj"], stored, &[]);
    }
    for view in ["normals", "depth", "primitives", "heatmap"] {
        same_picture(&folder, &[], &["--nodes", "q10"], &["--view", view]);
    }
    let sight = [
        "--camera",
        "eye=3,4,5 fov=30",
        "--light",
        "point=5,5,5 color=20,30,40",
        "--spp",
        "3",
    ];
    for scene in [&[][..], &["box.obj"]] {
        same_picture(&folder, scene, &["--nodes", "q8"], &sight);
        same_picture(&folder, scene, &["--tolerance", "0.01"], &sight);
    }
}

/// A default camera fits each picture's size, and frames the mesh as it was before its vertices moved.
#[test]
fn pictures_of_other_shapes_are_the_same_too() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    let moved = ["--tolerance", "0.3"];
    folder.succeed([&["build", "box.obj", "-o", "it.slim"][..], &moved].concat());
    for size in ["40x120", "120x40"] {
        let size = ["--size", size, "--backend", "cpu"];
        let scene = ["render", "box.obj", "-o", "scene.png"];
        folder.succeed([&scene[..], &size, &moved].concat());
        folder.succeed([&["render", "it.slim", "-o", "saved.png"][..], &size].concat());
        assert!(folder.read("scene.png") == folder.read("saved.png"));
    }
    // The same holds for a file built from a slim file.
    folder.succeed(["build", "it.slim", "-o", "again.slim", "--nodes", "q21"]);
    folder.succeed([&["render", "again.slim", "-o", "again.png"][..], &SIZE].concat());
    folder.succeed([&["render", "it.slim", "-o", "saved.png"][..], &SIZE].concat());
    assert!(folder.read("again.png") == folder.read("saved.png"));
}

/// The file keeps the camera and the lights given to `build`.
#[test]
fn what_the_build_is_given_is_kept() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    let sight = [
        "--camera",
        "eye=-3,4,5 target=0,1,1 lens=0.2",
        "--light",
        "sun=1,-1,-1",
    ];
    folder.succeed([&["build", "box.obj"][..], &SIZE[..2], &sight].concat());
    folder.succeed([&["render", "slimbvh.slim", "-o", "saved.png"][..], &SIZE].concat());
    folder.succeed([&["render", "box.obj", "-o", "scene.png"][..], &SIZE, &sight].concat());
    assert!(folder.read("scene.png") == folder.read("saved.png"));
    let info = parse(&folder.succeed(["info", "slimbvh.slim", "--json", "-"]));
    assert_eq!(
        (number(&info, "cameras"), number(&info, "lights")),
        (1.0, 1.0)
    );
}

#[test]
fn builds_are_reported() {
    let folder = Folder::new();
    let text = folder.succeed(["build", "--nodes", "q10", "--threads", "2"]);
    for word in ["slimbvh.slim", "topology", "nodes q10", "write", "MiB"] {
        assert!(text.contains(word), "{word} is not in {text}");
    }
    let report = parse(&folder.succeed(["build", "--tolerance", "0.1", "--json", "-"]));
    let expected = [
        "build_ms",
        "dropped_faces",
        "file",
        "file_bytes",
        "left_out",
        "mesh_bytes",
        "node_bytes",
        "node_codec",
        "nodes",
        "scene",
        "scratch_bytes",
        "step_exponent",
        "threads",
        "triangle_bytes",
        "triangle_codec",
        "triangles",
        "write_ms",
    ];
    assert_eq!(keys(&report), expected);
    let size = folder.read("slimbvh.slim").len() as f64;
    assert_eq!(number(&report, "file_bytes"), size);
    assert_eq!(report["triangle_codec"], "lattice");
    assert_eq!(
        number(&report, "node_bytes"),
        48.0 * number(&report, "nodes")
    );
    // No other file is left behind.
    assert_eq!(folder.contents().len(), 1);
}

#[test]
fn info_tells_of_hierarchies() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    folder.succeed(["build", "box.obj", "-o", "box.SLIM", "--mesh", "leaf10"]);
    let text = folder.succeed(["info", "box.SLIM"]);
    for word in [
        "12, of which",
        "hierarchy",
        "nodes paper10",
        "triangles leaf10",
        "closed",
    ] {
        assert!(text.contains(word), "{word} is not in {text}");
    }
    let info = parse(&folder.succeed(["info", "box.SLIM", "--json", "-"]));
    let hierarchy = &info["hierarchy"];
    assert_eq!(number(hierarchy, "triangles"), 12.0);
    assert_eq!(number(hierarchy, "triangle_bytes"), 12.0 * 16.0);
    assert_eq!(hierarchy["node_codec"], "paper10");
    let plain = parse(&folder.succeed(["info", "box.obj", "--json", "-"]));
    assert!(plain.get("hierarchy").is_none());
    assert_eq!(plain["components"], info["components"]);
}

#[test]
fn saved_scenes_render_with_a_report() {
    let folder = Folder::new();
    folder.succeed(["build", "-o", "it.slim"]);
    let options = [
        "--reduce", "auto", "--cull", "off", "--nodes", "f32", "--mesh", "f32",
    ];
    let render = ["render", "it.slim", "--size", "160x90"];
    let text = folder.succeed([&render[..], &options, &["--explain"]].concat());
    assert!(
        text.contains("\nload ") && !text.contains("\nbuild "),
        "{text}"
    );
    assert!(text.contains("the file holds one tree"), "{text}");
    let report = parse(&folder.succeed([&render[..], &["--json", "-"]].concat()));
    assert_eq!(keys(&report["build_ms"]), ["load"]);
    assert_eq!(report["backend"], "cpu");
    assert!(number(&report, "primary_hits") > 1000.0);
}

/// `animate` accepts a slim file as a scene and builds its own trees.
#[test]
fn saved_scenes_can_be_animated() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    folder.succeed(["build", "box.obj", "-o", "box.slim"]);
    let animate = |scene| {
        let options = [
            "--frames",
            "2",
            "--orbit",
            "--size",
            "32x18",
            "--backend",
            "cpu",
        ];
        folder.succeed([&["animate", scene, "--out", "it.gif"][..], &options].concat());
        folder.read("it.gif")
    };
    assert!(animate("box.obj") == animate("box.slim"));
}

/// The file keeps the count of dropped faces.
#[test]
fn dropped_faces_stay_dropped() {
    let folder = Folder::new();
    folder.write("bad.off", TwoTriangles::with_index(7).off());
    let report = parse(&folder.succeed(["build", "bad.off", "--lenient", "--json", "-"]));
    assert_eq!(number(&report, "dropped_faces"), 1.0);
    let info = parse(&folder.succeed(["info", "slimbvh.slim", "--json", "-"]));
    assert_eq!(number(&info, "dropped_faces"), 1.0);
}

/// A new file replaces an older one whole.
#[test]
fn files_replace_files() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    folder.write("box.slim", vec![1; 1 << 20]);
    folder.succeed(["build", "box.obj", "-o", "box.slim"]);
    let first = folder.read("box.slim");
    assert!(first.len() < 1 << 16);
    folder.succeed(["build", "box.obj", "-o", "box.slim", "--threads", "1"]);
    assert!(
        folder.read("box.slim") == first,
        "the same input, the same bytes"
    );
    assert_eq!(folder.contents().len(), 2);
}
