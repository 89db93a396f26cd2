//! `render` and `animate` with `--nodes`, `--mesh` and `--tolerance`.

use crate::process::Folder;
use serde_json::Value;

const SMALL: [&str; 6] = [
    "render",
    "--size=160x90",
    "-o=x.png",
    "--json=-",
    "--backend=cpu",
    "--light=sun=-1,-2,-1",
];

/// Bytes per node.
const NODES: [(&str, u64); 11] = [
    ("f32", 64),
    ("paper10", 24),
    ("q4", 12),
    ("q6", 16),
    ("q8", 16),
    ("q10", 16),
    ("q12", 20),
    ("q16", 28),
    ("q21", 28),
    ("w4", 128),
    ("w4-64", 64),
];

/// The picture and its JSON report.
fn render(folder: &Folder, options: &[&str]) -> (Vec<u8>, Value) {
    let outcome = folder.run([&SMALL[..], options].concat());
    assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
    let report = serde_json::from_str(&outcome.stdout).expect("it is JSON");
    (folder.read("x.png"), report)
}

#[test]
fn nodes_of_any_size_make_the_same_picture() {
    let folder = Folder::new();
    let (expected, _) = render(&folder, &[]);
    for reduce in ["--reduce=off", "--reduce=on"] {
        let (whole, _) = render(&folder, &[reduce]);
        for (nodes, size) in NODES {
            let option = format!("--nodes={nodes}");
            let (picture, report) = render(&folder, &[&option, reduce]);
            assert!(picture == whole, "{nodes} {reduce}");
            let count = report["nodes"].as_u64().expect("it is a number");
            assert_eq!(report["node_bytes"].as_u64(), Some(size * count), "{nodes}");
            let has_stage = report["build_ms"].get("encode").is_some();
            assert_eq!(has_stage, nodes != "f32", "{nodes}");
        }
    }
    let (picture, _) = render(&folder, &["--nodes=auto"]);
    assert!(picture == expected);
}

/// A mesh on the lattice makes one picture with any nodes and any reduction. A larger tolerance takes fewer bytes.
#[test]
fn a_mesh_on_the_lattice_makes_one_picture_for_each_tolerance() {
    let folder = Folder::new();
    let (expected, plain) = render(&folder, &[]);
    let mut last = plain["triangle_bytes"].as_u64().expect("it is a number") + 1;
    for tolerance in ["--mesh=lattice", "--tolerance=1e-4", "--tolerance=0.5px"] {
        let (picture, report) = render(&folder, &[tolerance, "--cull=on", "--reduce=off"]);
        for more in [
            &["--reduce=on"][..],
            &["--nodes=q6", "--reduce=off"],
            &["--nodes=q21", "--reduce=on", "--without=alone,turns,groups"],
            &["--nodes=w4-64", "--reduce=off"],
            &["--nodes=w4-48", "--reduce=on"],
        ] {
            let options = [&[tolerance, "--cull=on"], more].concat();
            let (other, _) = render(&folder, &options);
            assert!(other == picture, "{options:?}");
        }
        let bytes = report["triangle_bytes"].as_u64().expect("it is a number");
        assert!(bytes < last, "{tolerance}: {bytes}");
        last = bytes;
    }
    let triangles = plain["triangles"].as_u64().expect("it is a number");
    assert!(
        last < 20 * triangles,
        "{last} bytes of {triangles} triangles"
    );
    assert!(!expected.is_empty());
}

#[test]
fn paper10_leaves_render() {
    let folder = Folder::new();
    let (_, report) = render(&folder, &["--mesh=leaf10"]);
    let triangles = report["triangles"].as_u64().expect("it is a number");
    assert_eq!(report["triangle_bytes"].as_u64(), Some(16 * triangles));
    assert_eq!(report["plan"]["surveyed"], false);
}

/// A deforming mesh is moved onto the lattice in every frame, and its tree is refitted there.
#[test]
fn frames_on_a_lattice() {
    let folder = Folder::new();
    let animate = |options: &[&str]| {
        let fixed = [
            "animate",
            "--size=80x45",
            "--frames=3",
            "--orbit",
            "--backend=cpu",
            "--out=x.gif",
        ];
        let outcome = folder.run([&fixed[..], options].concat());
        assert_eq!(
            (outcome.code, outcome.stderr.as_str()),
            (Some(0), ""),
            "{options:?}"
        );
        folder.read("x.gif")
    };
    for motion in ["--deform=wave", "--deform=twist", "--orbit-light"] {
        let whole = animate(&[
            motion,
            "--tolerance=0.5px",
            "--cull=on",
            "--solid",
            "--reduce=off",
        ]);
        let sets = animate(&[
            motion,
            "--tolerance=0.5px",
            "--cull=on",
            "--solid",
            "--reduce=on",
        ]);
        assert!(whole == sets, "{motion}");
        let plain = animate(&[motion, "--update=rebuild"]);
        let coded = animate(&[motion, "--nodes=q10", "--update=refit"]);
        assert!(plain == coded, "{motion}");
        animate(&[motion, "--mesh=leaf10"]);
    }
}
