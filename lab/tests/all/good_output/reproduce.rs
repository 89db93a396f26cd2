//! The tables of a paper, measured again.

use super::{keys, number, parse};
use crate::files::box_obj;
use crate::process::Folder;
use serde_json::Value;

const QUICK: [&str; 5] = ["reproduce", "reduced", "--quick", "--backend", "cpu"];

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("it is a list");
    list.iter()
        .map(|x| x.as_f64().expect("it is a number"))
        .collect()
}

/// The rows of a table in a report, cell by cell.
fn rows<'a>(report: &'a str, title: &str) -> Vec<Vec<&'a str>> {
    let (_, table) = report
        .split_once(title)
        .unwrap_or_else(|| panic!("{title} is not in {report}"));
    let lines = table.lines().skip_while(|line| !line.starts_with('|'));
    let lines = lines.take_while(|line| line.starts_with('|'));
    let cells = lines.map(|line| line.trim_matches('|').split('|').map(str::trim).collect());
    cells.collect()
}

#[test]
fn tables_of_one_scene_as_text_markdown_and_json() {
    let folder = Folder::new();
    let options = [
        "--only",
        "doll",
        "--threads",
        "2",
        "--out",
        "doll.md",
        "--json",
        "doll.json",
    ];
    let text = folder.succeed([&QUICK[..], &options].concat());
    assert_eq!(folder.contents().len(), 2);
    for part in [
        "Table I:",
        "Table II:",
        "Table III:",
        "Table IV:",
        "Table VI:",
        "What a ray meets",
        "Sort once",
        "Targets",
        "35,556",
        "2 threads",
        "quick",
        "slimbvh-lab reproduce reduced --quick --only doll --threads 2 --backend cpu",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    // The paper has figures of near lights only for the armadillo, and savings are measured only on it.
    assert!(!text.contains("Savings, on the"), "{text}");
    assert!(
        !text.contains("Table V:") && !text.contains("toasters") && !text.contains("NaN"),
        "{text}"
    );

    let report = parse(&String::from_utf8(folder.read("doll.json")).unwrap());
    let expected = [
        "backend", "command", "machine", "paper", "protocol", "quick", "scenes", "threads",
        "verdicts",
    ];
    let mut found = keys(&report);
    found.sort_unstable();
    assert_eq!(found, expected);
    let scene = &report["scenes"][0];
    assert_eq!(
        (number(scene, "triangles"), number(scene, "seams")),
        (71_450.0, 0.0)
    );
    assert!(scene["stand_in"].is_null());
    let sizes = numbers(&scene["sizes"]);
    assert!(
        sizes[0] + sizes[1] >= 71_450.0 && sizes[2] + sizes[3] >= 71_450.0,
        "{sizes:?}"
    );
    assert!(
        sizes
            .iter()
            .all(|size| (0.45..0.55).contains(&(size / 71_450.0))),
        "{sizes:?}"
    );
    for round in scene["sets"].as_array().unwrap() {
        assert!(number(round, "all") > number(round, "sort"));
        assert_eq!(round["sets"].as_array().unwrap().len(), 4);
    }
    for pictures in scene["pictures"].as_array().unwrap() {
        assert_eq!(pictures["reduced"].as_array().unwrap().len(), 2);
        let default = &pictures["default"][0];
        assert!(number(default, "primary") > 0.0 && number(default, "shadow") > 0.0);
        assert_eq!(number(&default["camera_build"], "division"), 0.0);
        assert!(
            number(
                &pictures["reduced"][0]["rounds"][0]["camera_build"],
                "division"
            ) > 0.0
        );
    }
    // A smaller tree opens fewer nodes, and L- does not include the triangles that the light's rays start on.
    let visits = &scene["visits"];
    let nodes = |of: &str| number(&visits[of], "nodes");
    assert!(
        nodes("primary_reduced") < nodes("primary_whole"),
        "{visits}"
    );
    assert!(nodes("shadow_away") < nodes("shadow_reduced"), "{visits}");

    // The file has the same tables, and all their rows are as long as their heads.
    let file = String::from_utf8(folder.read("doll.md")).unwrap();
    for title in [
        "Table I:",
        "Table II:",
        "Table III:",
        "Table IV:",
        "Table VI:",
        "What a ray meets",
        "Sort once",
    ] {
        let rows = rows(&file, title);
        assert!(rows.len() >= 4, "{title}");
        assert!(rows.iter().all(|row| row.len() == rows[0].len()), "{title}");
    }
    let sizes = rows(&file, "Table I:");
    assert_eq!(sizes[2][..4], ["doll", "printed", "71,450", "35,556"]);
    assert_eq!(sizes[3][..3], ["doll", "ours", "71,450"]);
}

/// Without the file of the armadillo a stand-in is measured, and the report says so.
#[test]
fn what_is_missing_is_stood_in_for() {
    let folder = Folder::new();
    let options = [
        "--only",
        "armadillo",
        "--scenes",
        ".",
        "--out",
        "armadillo.md",
        "--json",
        "-",
    ];
    let report = parse(&folder.succeed([&QUICK[..], &options].concat()));
    let scene = &report["scenes"][0];
    let stand_in = scene["stand_in"].as_str().expect("it is a sentence");
    assert!(
        stand_in.contains("stands in for armadillo.off"),
        "{stand_in}"
    );
    assert_eq!(number(scene, "triangles"), 331_906.0);
    let lights = scene["lights"].as_array().unwrap();
    assert_eq!(lights.len(), 2);
    for (lights, count) in lights.iter().zip([4.0, 9.0]) {
        assert_eq!(number(lights, "lights"), count);
        assert!((number(lights, "share") - 0.694).abs() < 0.005, "{lights}");
        let rows = lights["rows"].as_array().unwrap();
        assert_eq!(rows[0]["triangles"], 331_906);
        assert!(rows.len() >= 4);
    }

    let savings = scene["savings"].as_array().unwrap();
    let names: Vec<&str> = savings
        .iter()
        .map(|saving| saving["saving"].as_str().unwrap())
        .collect();
    let expected = [
        "frustum",
        "away",
        "groups",
        "turns",
        "unseen",
        "alone",
        "dark rays",
    ];
    assert_eq!(names, expected);
    let bytes = |way: &str| number(&savings[3][way], "tree_bytes");
    assert!(bytes("with") < 0.5 * bytes("without"), "{}", savings[3]);
    let rays = |way: &str| number(&savings[6][way], "shadow_rays");
    assert!(rays("with") < 0.5 * rays("without"), "{}", savings[6]);
    let file = String::from_utf8(folder.read("armadillo.md")).unwrap();
    let rows = rows(&file, "Savings, on the");
    assert_eq!(rows.len(), 2 + expected.len());
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
}

const QUICK_COMPRESSED: [&str; 5] = ["reproduce", "compressed", "--quick", "--backend", "cpu"];

/// The report has printed and measured figures, stand-ins for missing files, and verdicts that agree with the figures.
#[test]
fn compressed_trees_as_text_markdown_and_json() {
    let folder = Folder::new();
    let options = [
        "--only",
        "bunny",
        "shiny",
        "--scenes",
        ".",
        "--threads",
        "2",
        "--out",
        "c.md",
        "--json",
        "c.json",
    ];
    let text = folder.succeed([&QUICK_COMPRESSED[..], &options].concat());
    for part in [
        "What a ray touches",
        "Bytes of tree and triangles",
        "Times, ms",
        "Times by stage, ms",
        "Changes of the picture",
        "What a ray touches, by kind of ray",
        "Bits per plane",
        "Targets",
        "stands in for bunny00.off",
        "2 threads",
        "slimbvh-lab reproduce compressed --quick --only shiny bunny --threads 2 --backend cpu",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    assert!(!text.contains("NaN") && !text.contains("-0 %"), "{text}");
    assert!(!text.contains("GPU's buffers"), "{text}");

    let report = parse(&String::from_utf8(folder.read("c.json")).unwrap());
    let expected = [
        "backend", "command", "machine", "paper", "protocol", "quick", "scenes", "threads",
        "verdicts",
    ];
    let mut found = keys(&report);
    found.sort_unstable();
    assert_eq!(found, expected);
    let scenes = report["scenes"].as_array().unwrap();
    check_scene(&scenes[0], "shiny");
    check_scene(&scenes[1], "bunny");

    // Only the paper's codec of triangles lets rays in between triangles.
    let got_in = |method: usize| number(&scenes[1]["methods"][method]["cracks"], "leaked");
    assert!(got_in(2) > 500.0);
    assert!(
        (0..21)
            .filter(|method| *method != 2)
            .all(|method| got_in(method) == 0.0)
    );

    let bytes = |scene: &Value, method: usize| {
        let method = &scene["methods"][method];
        number(method, "node_bytes") + number(method, "triangle_bytes")
    };
    let verdicts = report["verdicts"].as_array().unwrap();
    assert_eq!(verdicts.len(), 20);
    let first = &verdicts[0];
    assert_eq!(number(first, "bound"), 0.6);
    for (measured, scene) in first["measured"].as_array().unwrap().iter().zip(scenes) {
        assert_eq!(measured["scene"], scene["name"]);
        let share = bytes(scene, 6) / bytes(scene, 0);
        assert!((number(measured, "value") - share).abs() < 1e-9 && share < 0.6);
    }

    let file = String::from_utf8(folder.read("c.md")).unwrap();
    for (title, count) in [
        ("What a ray touches", 2 * (2 + 15)),
        ("Bytes of tree and triangles", 2 * 15),
        ("Times, ms", 2 * (3 + 15)),
        ("Times by stage, ms", 2 * 15),
        ("Changes of the picture", 2 * 15),
        ("What a ray touches, by kind of ray", 3 * 15 + 2 * 15),
        ("Bits per plane", 2 * 7),
    ] {
        let rows = rows(&file, &format!("## {title}"));
        assert_eq!(rows.len(), 2 + count, "{title}");
        assert!(rows.iter().all(|row| row.len() == rows[0].len()), "{title}");
    }
    let touched = rows(&file, "## What a ray touches");
    assert_eq!(touched[2][..5], ["shiny", "printed", "NODE", "–", "+9.0 %"]);
}

/// Checks the methods of a scene, in order, and the figures of each.
fn check_scene(scene: &Value, name: &str) {
    let is_shiny = name == "shiny";
    assert_eq!(scene["name"], name);
    assert_eq!(scene["stand_in"].is_null(), is_shiny);
    let methods = scene["methods"].as_array().expect("it is a list");
    let names: Vec<&str> = methods
        .iter()
        .map(|method| method["name"].as_str().expect("it is a name"))
        .collect();
    let expected = [
        "plain",
        "NODE",
        "NODE+MESH",
        "q10",
        "q10, mesh at finest step",
        "q10, mesh to 0.1px",
        "q10, mesh to 0.5px",
        "w4",
        "w4-64",
        "w4-64, mesh at finest step",
        "w4-64, mesh to 0.1px",
        "w4-64, mesh to 0.5px",
        "w4-48, mesh at finest step",
        "w4-48, mesh to 0.1px",
        "w4-48, mesh to 0.5px",
        "q4",
        "q6",
        "q8",
        "q12",
        "q16",
        "q21",
    ];
    assert_eq!(names, expected);
    for (method, name) in methods.iter().zip(names) {
        let has_mesh = name.to_lowercase().contains("mesh");
        assert_eq!(method["moved"].is_null(), !has_mesh, "{method}");
        // Larger boxes change no pixel.
        if !has_mesh {
            assert_eq!(number(&method["differences"], "changed"), 0.0);
        }
        let secondary = number(&method["counts"]["secondary"], "rays");
        assert_eq!(secondary > 0.0, is_shiny);
        assert_eq!(method["cracks"].is_null(), is_shiny);
    }
    let rounds = methods[1]["rounds"].as_array();
    assert_eq!(rounds.map(Vec::len), Some(2));
}

/// Meshes of one's own take the place of the built-in scenes, or stand beside those that are named.
#[test]
fn meshes_of_one_s_own() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    let with = |paper: &'static str, more: &[&'static str]| {
        let begin = ["reproduce", paper, "--quick", "--backend", "cpu"];
        let json = ["--json", "report.json", "--mesh", "box.obj"];
        let text = folder.succeed([&begin[..], &json, more].concat());
        assert!(!text.contains("NaN"), "{text}");
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            text.contains("given by --mesh: the paper has no figures of it"),
            "{text}"
        );
        let report = parse(&String::from_utf8(folder.read("report.json")).unwrap());
        let scenes = report["scenes"].as_array().unwrap().clone();
        let names = scenes
            .iter()
            .map(|scene| scene["name"].as_str().unwrap().to_owned());
        let names: Vec<String> = names.collect();
        let own = &scenes[0];
        assert_eq!(
            (number(own, "triangles"), &own["is_own"]),
            (12.0, &true.into())
        );
        // No target is for such a mesh.
        for verdict in report["verdicts"].as_array().unwrap() {
            let mut measured = verdict["measured"].as_array().unwrap().iter();
            assert!(measured.all(|it| it["scene"] != "box.obj"), "{verdict}");
        }
        (names, report["command"].as_str().unwrap().to_owned())
    };
    let (names, command) = with("reduced", &[]);
    assert_eq!(names, ["box.obj"]);
    let expected = "slimbvh-lab reproduce reduced --quick --mesh box.obj --backend cpu";
    assert_eq!(command, expected);
    let (names, _) = with("compressed", &["--only", "shiny"]);
    assert_eq!(names, ["box.obj", "shiny"]);
}
