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
        "command", "commit", "findings", "machines", "protocol", "rows", "threads", "version",
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
