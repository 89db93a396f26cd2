//! Reports of `info` on meshes.

use super::{keys, number, parse};
use crate::files::box_obj;
use crate::process::Folder;
use serde_json::Value;

/// Runs `info` on an OBJ file and returns its only component.
fn component(folder: &Folder, text: &str) -> Value {
    folder.write("solid.obj", text);
    let info = parse(&folder.succeed(["info", "solid.obj", "--json", "-"]));
    assert_eq!(info["scene"], "solid.obj");
    let components = info["components"].as_array().expect("it is a list");
    assert_eq!(components.len(), 1, "{info}");
    components[0].clone()
}

#[test]
fn info_tells_solids_from_shells() {
    let folder = Folder::new();
    let solid = component(&folder, &box_obj());
    assert_eq!(
        keys(&solid),
        [
            "closed",
            "consistently_wound",
            "extent",
            "outward",
            "triangles",
            "volume"
        ]
    );
    assert_eq!(number(&solid, "triangles"), 12.0);
    assert_eq!(
        [
            &solid["closed"],
            &solid["consistently_wound"],
            &solid["outward"]
        ],
        [true; 3].map(Value::from).each_ref()
    );
    assert_eq!(number(&solid, "volume"), 6.0);
    assert_eq!(
        solid["extent"],
        serde_json::json!({"min": [0.0, 0.0, 0.0], "max": [1.0, 2.0, 3.0]})
    );

    // Reverse all faces.
    let flipped = box_obj().lines().map(flip).collect::<String>();
    let flipped = component(&folder, &flipped);
    assert_eq!(
        (&flipped["closed"], &flipped["outward"]),
        (&true.into(), &false.into())
    );
    assert_eq!(number(&flipped, "volume"), -6.0);

    // Remove one triangle, then reverse it instead.
    let text = box_obj();
    let (open, last) = text.trim_end().rsplit_once('\n').unwrap();
    let turned = format!("{open}\n{}", flip(last));
    let open = component(&folder, open);
    assert_eq!(
        (
            &open["closed"],
            &open["consistently_wound"],
            &open["outward"]
        ),
        (&false.into(), &true.into(), &Value::Null)
    );
    assert_eq!(number(&open, "triangles"), 11.0);
    let turned = component(&folder, &turned);
    assert_eq!(
        (&turned["closed"], &turned["consistently_wound"]),
        (&false.into(), &false.into())
    );
}

/// Numbers of extents have as many digits as floats, and the sizes no more than the corners.
#[test]
fn extents_have_the_digits_of_floats() {
    let folder = Folder::new();
    folder.write(
        "small.obj",
        "v 0 0 0\nv 0.06539202 0 0\nv 0 0.1 0.3\nf 1 2 3\n",
    );
    let text = folder.succeed(["info", "small.obj"]);
    let extent = text.lines().find(|line| line.starts_with("extent"));
    assert_eq!(
        extent,
        Some("extent      0.06539202 x 0.1 x 0.3 from (0, 0, 0) to (0.06539202, 0.1, 0.3)")
    );
    // Sizes that no float holds are told as well.
    folder.write("large.obj", "v -3e38 0 0\nv 3e38 0 0\nv 0 1 0\nf 1 2 3\n");
    let text = folder.succeed(["info", "large.obj"]);
    let extent = text.lines().find(|line| line.starts_with("extent"));
    assert!(
        extent.is_some_and(|line| line.contains(" 6") && !line.contains("inf")),
        "{text}"
    );
}

/// Reverses the winding of a face in an OBJ line.
fn flip(line: &str) -> String {
    match line.split_whitespace().collect::<Vec<_>>()[..] {
        ["f", a, b, c] => format!("f {a} {c} {b}\n"),
        _ => format!("{line}\n"),
    }
}

#[test]
fn info_on_the_default_scene() {
    let folder = Folder::new();
    let info = parse(&folder.succeed(["info", "--json", "-"]));
    let scene = slimbvh::generate::default_scene();
    let counts = [
        ("triangles", scene.mesh.indices.len()),
        ("vertices", scene.mesh.vertices.len()),
        ("materials", scene.materials.len()),
        ("cameras", 1),
        ("lights", 2),
        ("dropped_faces", 0),
        ("degenerate_triangles", 0),
        ("duplicate_triangles", 0),
    ];
    for (key, count) in counts {
        assert_eq!(info[key], count, "{key}");
    }
    // All closed components face outward, and there are at least six: the sphere flake alone is many.
    let components = info["components"].as_array().unwrap();
    let closed = components
        .iter()
        .filter(|component| component["closed"] == true);
    assert!(
        closed.clone().count() >= 6 && closed.clone().all(|component| component["outward"] == true)
    );

    let text = folder.succeed(["info"]);
    let all = folder.succeed(["info", "--all"]);
    assert!(text.contains("(--all lists them)") && !all.contains("(--all lists them)"));
    assert_eq!(
        all.lines().filter(|line| line.contains("wound")).count(),
        components.len()
    );
}
