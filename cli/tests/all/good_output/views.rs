//! All views of the default scene, and the report on each.

use super::{SMALL, decode, keys, number, parse};
use crate::process::Folder;
use serde_json::Value;

#[test]
fn clustered_trees_make_the_same_pictures() {
    let folder = Folder::new();
    for view in ["color", "normals", "depth", "primitives", "heatmap"] {
        let pictures = ["radix", "clustered"].map(|tree| {
            let options = ["--view", view, "--tree", tree, "-o", "view.png"];
            folder.succeed([&SMALL[..], &["-"], &options].concat());
            folder.read("view.png")
        });
        // As with the codes, only the heat map depends on the tree.
        assert_eq!(pictures[0] == pictures[1], view != "heatmap", "{view}");
    }
}

#[test]
fn all_views_with_both_codes() {
    let folder = Folder::new();
    let triangle_count = slimbvh::generate::default_scene().mesh.indices.len();
    let mut pictures = Vec::new();
    for view in ["color", "normals", "depth", "primitives", "heatmap"] {
        let with_codes = ["30", "63"].map(|codes| {
            let options = [
                "-",
                "--view",
                view,
                "--codes",
                codes,
                "-o",
                "view.png",
                "--threads",
                "2",
            ];
            let report = parse(&folder.succeed([&SMALL[..], &options].concat()));
            check_report(&report, view == "heatmap");
            assert_eq!(number(&report, "triangles"), triangle_count as f64);
            assert_eq!(report["picture"], "view.png");
            let (sides, pixels) = decode(&folder.read("view.png"));
            assert_eq!(sides, [160, 90]);
            pixels
        });
        // Hits do not depend on the tree. Node visits do, and the heat map shows them.
        assert_eq!(with_codes[0] == with_codes[1], view != "heatmap", "{view}");
        pictures.push(with_codes[0].clone());
    }
    for (i, picture) in pictures.iter().enumerate() {
        assert!(
            picture.iter().any(|byte| *byte != picture[0]),
            "picture {i} is blank"
        );
        assert!(
            !pictures[..i].contains(picture),
            "picture {i} is shown twice"
        );
    }
}

/// Checks that a report on the default scene at 160x90 is complete and plausible.
#[track_caller]
fn check_report(report: &Value, counts_visits: bool) {
    let mut expected = vec![
        "scene",
        "picture",
        "width",
        "height",
        "left_out",
        "samples_per_pixel",
        "backend",
        "threads",
        "adapter",
        "triangles",
        "dropped_faces",
        "nodes",
        "build_ms",
        "render_ms",
        "primary_rays",
        "primary_hits",
        "shadow_rays",
        "mirror_rays",
        "mrays_per_second",
        "node_visits",
        "node_bytes",
        "triangle_bytes",
        "mesh_bytes",
        "scratch_bytes",
        "plan",
    ];
    let mut found = keys(report);
    expected.sort_unstable();
    found.sort_unstable();
    assert_eq!(found, expected);

    let [triangles, nodes] = ["triangles", "nodes"].map(|key| number(report, key));
    assert_eq!(report["scene"], "default scene");
    assert_eq!(report["backend"], "cpu");
    assert!(report["adapter"].is_null());
    assert_eq!(number(report, "threads"), 2.0);
    assert_eq!(number(report, "dropped_faces"), 0.0);
    assert_eq!(
        number(report, "primary_rays"),
        160.0 * 90.0 * number(report, "samples_per_pixel")
    );
    assert!(nodes > 0.0 && nodes < triangles);

    // The scene fills most of the picture.
    let hits = number(report, "primary_hits") / number(report, "primary_rays");
    assert!((0.5..1.0).contains(&hits), "{hits}");
    assert!(number(report, "mrays_per_second") > 0.0);
    if counts_visits {
        let visits = number(report, "node_visits") / number(report, "primary_rays");
        assert!((1.0..200.0).contains(&visits), "{visits}");
    } else {
        assert!(report["node_visits"].is_null());
    }

    for key in ["node_bytes", "triangle_bytes", "mesh_bytes"] {
        let bytes = number(report, key) / triangles;
        assert!((4.0..200.0).contains(&bytes), "{key}: {bytes} a triangle");
    }
    assert!(number(report, "scratch_bytes") > 0.0);
    for key in ["build_ms", "render_ms"] {
        let stages = report[key].as_object().expect("it is an object");
        assert!(stages.len() >= 2, "{stages:?}");
        assert!(
            stages
                .values()
                .all(|time| time.as_f64().is_some_and(|ms| (0.0..1e4).contains(&ms)))
        );
    }
}

#[test]
fn lights_and_mirrors_are_counted() {
    let folder = Folder::new();
    let report =
        |options: &[&'static str]| parse(&folder.succeed([&SMALL[..], &["-"], options].concat()));
    let plain = report(&[]);
    assert!(number(&plain, "shadow_rays") > 0.0 && number(&plain, "mirror_rays") > 0.0);
    // The scene has two lights, and each hit has at most one shadow ray per light.
    let hits = number(&plain, "primary_hits") + number(&plain, "mirror_rays");
    assert!(number(&plain, "shadow_rays") <= 2.0 * hits);
    let flat = report(&["--mirror-depth", "0"]);
    assert_eq!(number(&flat, "mirror_rays"), 0.0);
    assert!(number(&flat, "shadow_rays") < number(&plain, "shadow_rays"));
    let one_light = report(&["--mirror-depth", "0", "--light", "sun=0,-1,0"]);
    assert!(number(&one_light, "shadow_rays") <= number(&one_light, "primary_hits"));
    let normals = report(&["--view", "normals"]);
    assert_eq!(number(&normals, "shadow_rays"), 0.0);
    let fine = report(&["--spp", "5"]);
    assert_eq!(number(&fine, "primary_rays"), 5.0 * 160.0 * 90.0);
}
