//! The report of `stress`.

use super::{keys, parse};
use crate::files::{TwoTriangles, box_obj};
use crate::process::Folder;

#[test]
fn one_family_as_text_and_json() {
    let folder = Folder::new();
    let arguments = ["stress", "--quick", "--only", "soup", "--json", "soup.json"];
    let text = folder.succeed(arguments);
    for part in [
        "By family",
        "By codec",
        "none missed, false or wrong",
        "40 ulps",
        "q10+lattice",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    assert!(
        text.lines().all(|line| line.chars().count() <= 120),
        "{text}"
    );
    let json = parse(&String::from_utf8_lossy(&folder.read("soup.json")));
    let rows = json["rows"].as_array().expect("there are rows");
    assert_eq!(rows.len(), 8);
    let expected = [
        "adrift",
        "backend",
        "codec",
        "depth",
        "example",
        "false_hits",
        "family",
        "magnitude",
        "missed",
        "moved",
        "moved_bound",
        "plane_error_ulps",
        "rays",
        "reduction",
        "stack",
        "t_error_ulps",
        "time_ms",
        "tracer",
        "wrong_primitive",
    ];
    assert_eq!(keys(&rows[0]), expected);
}

/// Rows of other tracers are shown, and only slimbvh's rows decide the exit code.
#[test]
fn rows_of_others_are_shown_beside_ours() {
    let folder = Folder::new();
    let json = folder.succeed(["stress", "--quick", "--only", "soup", "--json", "-"]);
    let others = json
        .replace("\"slimbvh\"", "\"other\"")
        .replace("\"missed\": 0", "\"missed\": 7");
    folder.write("others.json", &others);
    let arguments = [
        "stress",
        "--quick",
        "--only",
        "flat",
        "--with",
        "others.json",
    ];
    let text = folder.succeed(arguments);
    assert!(
        text.contains("other cpu") && text.contains("Faults"),
        "{text}"
    );

    folder.write("ours.json", others.replace("\"other\"", "\"slimbvh\""));
    let outcome = folder.run(["stress", "--quick", "--only", "flat", "--with", "ours.json"]);
    assert_eq!(outcome.code, Some(1), "{outcome:?}");
    assert!(outcome.stdout.contains("56 at fault"), "{}", outcome.stdout);
}

/// Meshes of one's own take the place of the built-in families, or stand beside them, and the report says which.
#[test]
fn meshes_of_one_s_own() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    folder.write("two.ply", TwoTriangles::SOUND.ply_text());
    let stress = |more: &[&str]| {
        let json = [&["stress", "--quick", "--json", "-"], more].concat();
        let report = parse(&folder.succeed(json));
        let rows = report["rows"].as_array().expect("there are rows");
        let families = rows.iter().filter_map(|row| row["family"].as_str());
        let mut families: Vec<String> = families.map(str::to_owned).collect();
        families.dedup();
        let scenes = report["scenes"].as_str().expect("it is a text");
        (families, scenes.to_owned(), report["command"].clone())
    };
    let (families, scenes, command) = stress(&["box.obj", "two.ply"]);
    assert_eq!(families, ["box.obj", "two.ply"]);
    assert_eq!(scenes, "meshes of one's own only: box.obj, two.ply");
    let expected = "slimbvh-lab stress box.obj two.ply --quick --backend cpu";
    assert_eq!(command, expected);
    let (families, scenes, _) = stress(&["box.obj", "--only", "soup"]);
    assert_eq!(families, ["box.obj", "soup"]);
    let expected =
        "meshes of one's own (box.obj), and built-in families with \"soup\" in their names";
    assert_eq!(scenes, expected);
    let (families, scenes, _) = stress(&["--only", "soup"]);
    assert_eq!(families, ["soup"]);
    assert_eq!(scenes, "built-in families with \"soup\" in their names");
    let text = folder.succeed(["stress", "box.obj", "--quick"]);
    assert!(text.contains("meshes of one's own only: box.obj"), "{text}");
}
