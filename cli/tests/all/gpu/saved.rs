//! Saved hierarchies on a GPU: uploaded without a build.

use super::{adapter, difference, pixels, sentence};
use crate::process::Folder;

/// Codecs that the GPU supports.
const STORED: [&[&str]; 6] = [
    &[],
    &["--nodes", "w4-64"],
    &["--tolerance", "0.4px"],
    &["--nodes", "w4", "--codes", "63"],
    &["--nodes", "paper10"],
    &["--mesh", "leaf10"],
];

const SIZE: [&str; 2] = ["--size", "160x90"];

/// The picture equals that of a build on the same GPU byte for byte, and that of the CPU up to rounding.
#[test]
fn saved_scenes_make_the_picture_that_a_build_makes() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    let render = |arguments: &[&str]| {
        let output = ["-o", "it.png"];
        let outcome = folder.run_with_gpu([&["render"], arguments, &SIZE, &output].concat());
        assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
        (pixels(&folder, "it.png"), outcome.stdout)
    };
    let on_gpu = ["--backend=gpu", "--adapter", adapter];
    let mut pictures = Vec::new();
    for stored in STORED {
        folder.succeed([&["build", "-o", "it.slim"], &SIZE[..], stored].concat());
        let (saved, said) = render(&[&["it.slim"], &on_gpu[..]].concat());
        let parts = ["\nload ", "upload", adapter];
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        assert!(
            !said.contains("\nbuild ") && !said.contains("topology"),
            "{said}"
        );
        let built = [&["--reduce=off"], &on_gpu[..], stored].concat();
        let (built, _) = render(&built);
        assert!(saved == built, "{stored:?}");
        let (cpu, _) = render(&["it.slim", "--backend=cpu"]);
        let (differ, most) = difference(&cpu, &saved);
        assert!(
            differ <= cpu.len() / 1000 && most <= 1,
            "{stored:?} {differ} {most}"
        );
        pictures.push(saved);
    }
    // Negative control: a tolerance of 0.4 pixels, and triangles of 10 bits, change some pixels.
    for moved in [2, 5] {
        assert!(pictures[0] != pictures[moved], "{:?}", STORED[moved]);
    }
    let other = ["it.slim", "--camera=fov=40", "--adapter", adapter];
    let (other, _) = render(&other);
    assert!(difference(&pictures[5], &other).0 > other.len() / 100);
}

#[test]
fn other_views_and_reports_are_made_of_saved_scenes() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    folder.succeed(["build", "-o", "it.slim", "--nodes", "w4-64"]);
    let render = [
        "render",
        "it.slim",
        "--view=heatmap",
        "--json=-",
        "--explain",
    ];
    let report = |backend: &[&str]| {
        let outcome = folder.run_with_gpu([&render, &SIZE[..], backend].concat());
        assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
        serde_json::from_str::<serde_json::Value>(&outcome.stdout).expect("it is JSON")
    };
    let gpu = report(&["--adapter", adapter]);
    let cpu = report(&["--backend", "cpu"]);
    assert_eq!(
        (&gpu["backend"], &gpu["adapter"]),
        (&"gpu".into(), &adapter.into())
    );
    let times = gpu["build_ms"].as_object().expect("it is an object");
    assert_eq!(times.keys().collect::<Vec<_>>(), ["load", "upload"]);
    for same in [
        "nodes",
        "node_bytes",
        "triangle_bytes",
        "triangles",
        "primary_rays",
    ] {
        assert_eq!(gpu[same], cpu[same], "{same}");
    }
    let visits = |report: &serde_json::Value| report["node_visits"].as_f64().expect("a number");
    assert!((visits(&gpu) / visits(&cpu) - 1.0).abs() < 1e-3);
}

/// The error is one sentence that names the codec and the remedy.
#[test]
fn codecs_that_only_the_cpu_has_are_refused() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    for (nodes, said) in [("q10", "q10 nodes"), ("q16", "q16 nodes")] {
        folder.succeed(["build", "-o", "it.slim", "--nodes", nodes]);
        let before = folder.contents();
        let arguments = ["render", "it.slim", "--backend=gpu", "--adapter", adapter];
        let outcome = folder.run_with_gpu(arguments);
        let sentence = sentence(&outcome);
        for part in [
            said,
            "\"it.slim\"",
            "--backend cpu",
            "other --nodes",
            "w4-64 or w4-48",
        ] {
            assert!(sentence.contains(part), "{part:?} is not in {sentence}");
        }
        assert!(folder.contents() == before);
        // The remedy works.
        folder.succeed(["build", "it.slim", "-o", "other.slim", "--nodes", "w4-64"]);
        let advised = ["render", "other.slim", "--size=16x9", "--adapter", adapter];
        assert_eq!(folder.run_with_gpu(advised).code, Some(0));
        folder.succeed(["render", "it.slim", "--size=16x9", "--backend", "cpu"]);
    }
}
