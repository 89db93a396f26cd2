//! Every knob is measured and reported.

use super::{decode, keys, number, parse};
use crate::files::TwoTriangles;
use crate::process::Folder;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;

#[test]
fn a_page_a_table_and_json_of_a_tiny_scene() {
    let folder = Folder::new();
    folder.write("two <b>.obj", TwoTriangles::SOUND.obj());
    let arguments = [
        "bench",
        "two <b>.obj",
        "--quick",
        "--threads",
        "2",
        "--out",
        "report",
    ];
    let text = folder.succeed(arguments);
    for part in [
        "slimbvh-lab bench two <b>.obj --quick --threads 2",
        "2 threads",
        "320×180",
        "default",
        "reduce on",
        "nodes q10, mesh lattice 0.5px",
        "1 thread",
        "byte for byte",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    assert!(!text.contains("NaN"), "{text}");
    let names: Vec<String> = folder.contents().into_keys().collect();
    let expected = [
        "\"report\"",
        "\"report/bench.csv\"",
        "\"report/bench.json\"",
        "\"report/index.html\"",
        "\"two <b>.obj\"",
    ];
    assert_eq!(names, expected);

    let report = parse(&String::from_utf8(folder.read("report/bench.json")).unwrap());
    let mut found = keys(&report);
    found.sort_unstable();
    let expected = [
        "command", "commit", "equal", "findings", "machines", "protocol", "rows", "threads",
        "version",
    ];
    assert_eq!(found, expected);
    let rows = report["rows"].as_array().unwrap();
    let table = folder.read("report/bench.csv");
    let mut table = csv::Reader::from_reader(&table[..]);
    assert_eq!(table.records().map(Result::unwrap).count(), rows.len());
    for row in rows {
        assert_eq!(row["scene"], "two <b>.obj");
        assert!(number(row, "frame_ms") > 0.0, "{row}");
        assert_eq!(number(row, "primary_rays"), f64::from(320 * 180), "{row}");
    }
    assert!(rows.len() >= 18, "{}", rows.len());

    // The page embeds its pictures, and names are escaped.
    let page = String::from_utf8(folder.read("report/index.html")).unwrap();
    assert!(page.contains("two &lt;b&gt;.obj") && !page.contains("two <b>"));
    let (_, picture) = page.split_once("data:image/png;base64,").unwrap();
    let (picture, _) = picture.split_once('"').unwrap();
    let (size, pixels) = decode(&BASE64_STANDARD.decode(picture).unwrap());
    assert_eq!(size, [320, 180]);
    assert!(pixels.iter().any(|byte| *byte != pixels[0]));
}

/// The camera, the size, the rounds and the choice of setups of the command line count, and the report's command names them.
#[test]
fn one_s_own_camera_size_rounds_and_setups() {
    let folder = Folder::new();
    folder.write("two.obj", TwoTriangles::SOUND.obj());
    let run = |camera: &str, out: &str| {
        folder.succeed([
            "bench",
            "two.obj",
            "--only",
            "update,nodes q10",
            "--camera",
            camera,
            "--size",
            "64x36",
            "--rounds",
            "4",
            "--threads",
            "1",
            "--out",
            out,
        ])
    };
    let text = run("eye=0,0,9 height=4", "near");
    for part in [
        "--only \"update,nodes q10\" --camera \"eye=0,0,9 height=4\" --size 64x36 --rounds 4",
        "64×36 pixels",
        "median over 4 pictures",
    ] {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(part), "{part} is not in {text}");
    }
    let report = |out: &str| {
        let bytes = folder.read(format!("{out}/bench.json"));
        parse(&String::from_utf8(bytes).unwrap())
    };
    let near = report("near");
    let rows = near["rows"].as_array().unwrap();
    for row in rows {
        assert_eq!(number(row, "primary_rays"), f64::from(64 * 36));
        assert_eq!(
            row["commit"].as_str().map(str::is_empty),
            Some(near["commit"].is_null())
        );
        assert!(!row["machine"].as_str().unwrap().is_empty());
    }
    let names: Vec<&str> = rows
        .iter()
        .filter_map(|row| row["setup"].as_str())
        .collect();
    assert_eq!(names[..2], ["default", "nodes q10"]);
    assert_eq!(names.last(), Some(&"refit"));
    assert!(!names.contains(&"63-bit codes"), "{names:?}");
    // From farther away fewer rays hit, so that fewer are traced to lights.
    run("eye=0,0,9 height=400", "far");
    let shadow = |report: &serde_json::Value| number(&report["rows"][0], "shadow_rays");
    assert!(shadow(&report("far")) < shadow(&near));
}

/// If `--scaling` is given and no scene is named, only growth is measured.
#[test]
fn growth_by_itself() {
    let folder = Folder::new();
    let arguments = [
        "bench",
        "--quick",
        "--scaling",
        "--threads",
        "1",
        "--out",
        "growth",
    ];
    let text = folder.succeed(arguments);
    for part in [
        "more triangles on the CPU",
        "100,352",
        "more lights on the CPU",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    assert!(!text.contains("errors") && !text.contains("NaN"), "{text}");
    let report = parse(&String::from_utf8(folder.read("growth/bench.json")).unwrap());
    assert_eq!(report["rows"].as_array().map(Vec::len), Some(0));
    let scaling = report["scaling"].as_array().unwrap();
    let all = ["triangles", "rays", "lights"];
    assert_eq!(scaling.iter().map(|it| &it["of"]).collect::<Vec<_>>(), all);
    for point in scaling[0]["points"].as_array().unwrap() {
        assert!(
            number(point, "build_ms") > 0.0 && number(point, "rounds") == 3.0,
            "{point}"
        );
    }
}
