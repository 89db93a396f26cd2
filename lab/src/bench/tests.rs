use super::equal::Work;
use super::facts::Facts;
use super::findings::{Finding, Verdict, findings};
use super::measure::{Conditions, SceneRecord, mark_front, measure};
use super::only::Only;
use super::page::{escaped, page};
use super::prepared::Prepared;
use super::protocol::Protocol;
use super::report::{Measured, Report};
use super::row::csv;
use super::scaling;
use super::scenes::Subject;
use super::setup::{Knob, Setup, Triangles};
use super::times::{Round, Times};
use crate::measure::rounds::Rounds;
use slimbvh::reduce::Reduce;
use slimbvh::{CodeBits, Mesh, NodeCodec, RenderSettings, Scene};
use slimbvh_cli::backend::Chosen;

const TINY: Protocol = Protocol {
    size: [48, 27],
    rounds: 1,
    mirror_depth: 2,
    crossed: 2,
    terrains: 2,
    small_size: [24, 16],
    samples: &[1, 4],
    lights: 4,
};

/// All setups, measured.
fn measured(
    subject: &Subject,
    chosen: &Chosen,
    protocol: &Protocol,
    threads: usize,
) -> SceneRecord {
    let conditions = Conditions {
        protocol,
        threads,
        only: &Only::default(),
    };
    measure(subject, chosen, &conditions).unwrap()
}

fn report() -> Report {
    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let record = measured(&subject, &Chosen::Cpu, &TINY, 2);
    let machines = vec![("cpu", "a <machine> & \"its\" cores".to_owned())];
    let measured = Measured {
        records: vec![record],
        scaling: scaling::measure(&Chosen::Cpu, &TINY, 2).unwrap(),
    };
    Report::new(
        "slimbvh-lab bench shiny".into(),
        machines,
        TINY,
        2,
        measured,
    )
}

/// The page is XML, embeds its pictures, and loads nothing.
#[test]
fn the_page_is_whole_and_alone() {
    let report = report();
    let html = page(&report).unwrap();
    let options = roxmltree::ParsingOptions {
        allow_dtd: true,
        ..Default::default()
    };
    let document = roxmltree::Document::parse_with_options(&html, options).unwrap();
    let count = |name: &str| {
        document
            .descendants()
            .filter(|node| node.has_tag_name(name))
            .count()
    };
    assert_eq!(count("h2"), 2);
    assert_eq!(count("svg"), 4 + 4);
    assert_eq!(count("tr"), 1 + report.rows.len() + 1 + 4);
    assert!(count("img") >= 2);
    for node in document.descendants() {
        for attribute in node.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            assert!(
                !["href", "srcset", "data", "action"].contains(&name),
                "{name}"
            );
            if name == "src" {
                assert!(value.starts_with("data:image/png;base64,"), "{value}");
            }
        }
    }
    for part in [
        "http", "//", "@import", "url(", "<script", "<link", "NaN", "inf",
    ] {
        let found = html
            .split("base64,")
            .map(|text| text.split_once('"').map_or(text, |(_, rest)| rest));
        let mut texts = std::iter::once(html.split("base64,").next().unwrap()).chain(found.skip(1));
        assert!(texts.all(|text| !text.contains(part)), "{part}");
    }
    // Text from outside is escaped.
    assert!(html.contains("a &lt;machine&gt; &amp; &quot;its&quot; cores"));
    assert_eq!(escaped("<a&\"\n>"), "&lt;a&amp;&quot; &gt;");
}

/// The bars of the page have the numbers of its table, and every row names machine and commit.
#[test]
fn bars_have_the_numbers_of_the_table() {
    let report = report();
    let html = page(&report).unwrap();
    let options = roxmltree::ParsingOptions {
        allow_dtd: true,
        ..Default::default()
    };
    let document = roxmltree::Document::parse_with_options(&html, options).unwrap();
    let of = |name: &'static str| -> Vec<String> {
        let nodes = document
            .descendants()
            .filter(|node| node.has_tag_name(name));
        let texts = nodes.filter_map(|node| node.text().map(|text| text.trim().to_owned()));
        texts.collect()
    };
    let (labels, cells) = (of("text"), of("td"));
    for row in &report.rows {
        let number = super::report::ms(row.frame_ms);
        assert!(cells.contains(&number), "{}: {number}", row.setup);
        let has_bar = row.knob != Knob::Crossed;
        assert!(
            !has_bar || labels.contains(&number),
            "{}: {number}",
            row.setup
        );
        assert_eq!(row.machine, "a <machine> & \"its\" cores");
        assert_eq!(row.commit, report.commit.clone().unwrap_or_default());
        let parts = [
            row.plan_ms,
            row.build_ms,
            row.encode_ms,
            row.primary_ms,
            row.shadow_ms,
            row.reflection_ms,
            row.rest_ms,
        ];
        let sum: f64 = parts.iter().sum();
        assert!((sum / row.frame_ms - 1.0).abs() < 1e-9, "{}", row.setup);
    }
}

/// Setups with the same work are measured once and named; others are not taken for equal.
#[test]
fn no_work_is_measured_twice() {
    let report = report();
    let [scene] = &report.records[..] else {
        unreachable!("there is one scene");
    };
    let names: Vec<&str> = scene.setups.iter().map(|it| it.name.as_str()).collect();
    for equal in &scene.equal {
        assert!(!names.contains(&equal.setup.as_str()), "{equal:?}");
        assert!(names.contains(&equal.measured_as.as_str()), "{equal:?}");
    }
    let texts = [report.text(), page(&report).unwrap()];
    for text in texts.map(|text| text.replace("&quot;", "\"").replace('\n', " ")) {
        assert!(text.contains("\"reduce off\" (default)"), "{text}");
    }

    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let settings = RenderSettings {
        size: TINY.size,
        ..RenderSettings::default()
    };
    let work = |setup: Setup| Work::new(&Prepared::new(setup, &subject.scene, settings)).unwrap();
    let usual = Setup::usual(2);
    assert!(work(usual).is_same(&work(Setup::plain(2))));
    for (knob, setup) in Setup::one_at_a_time(2, 2) {
        if matches!(knob, Knob::Default | Knob::Reduce) {
            continue;
        }
        assert!(!work(setup).is_same(&work(usual)), "{knob:?}");
    }
    let reduced = Setup {
        reduce: Reduce::On,
        ..usual
    };
    assert!(!work(reduced).is_same(&work(usual)));
}

/// Nothing is concluded from times that spread too much, or of which there are too few; from steady ones it is.
#[test]
fn conclusions_need_more_than_the_spread() {
    let report = report();
    // One round.
    assert!(report.rows.iter().all(|row| !row.is_clear));
    let about_times = |finding: &&Finding| finding.text.contains("default's time");
    let mut found = report.findings.iter().filter(about_times).peekable();
    assert!(found.peek().is_some());
    for finding in found {
        assert_eq!(finding.verdict, Verdict::Open, "{}", finding.text);
        assert!(
            finding.text.contains("within the spread"),
            "{}",
            finding.text
        );
    }

    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let only = Only::new(&["nodes q10".into()], 2, 2).unwrap();
    let conditions = Conditions {
        protocol: &TINY,
        threads: 2,
        only: &only,
    };
    let mut scene = measure(&subject, &Chosen::Cpu, &conditions).unwrap();
    let with = |ratios: [f64; 3]| {
        let usual = Times {
            primary: 8.0,
            ..Times::default()
        };
        let own = |ratio| Times {
            primary: 8.0 * ratio,
            ..Times::default()
        };
        Rounds(Vec::from(ratios.map(|ratio| Round {
            usual,
            own: own(ratio),
        })))
    };
    for (ratios, verdict) in [
        ([0.5, 0.51, 0.52], Verdict::Wins),
        ([0.5, 0.9, 1.9], Verdict::Open),
        ([0.93, 0.94, 1.02], Verdict::Open),
        ([1.5, 1.51, 1.52], Verdict::Loses),
    ] {
        for record in &mut scene.setups {
            let is_it = record.name.starts_with("nodes q10");
            record.rounds = with(if is_it { ratios } else { [1.0; 3] });
            record.usual_ms = 8.0;
        }
        mark_front(&mut scene.setups);
        let tracing = findings(&scene).into_iter();
        let tracing: Vec<Finding> = tracing
            .filter(|it| it.text.starts_with("Tracing nodes of 10 bits"))
            .collect();
        assert_eq!(tracing.len(), 1);
        assert_eq!(tracing[0].verdict, verdict, "{}", tracing[0].text);
        let says_so = tracing[0].text.contains("within the spread");
        assert_eq!(says_so, verdict == Verdict::Open, "{}", tracing[0].text);
        // It is smaller than the default, whose place on the front is sure only if it is clearly slower.
        let usual = &scene.setups[0];
        let is_sure = usual.on_front && usual.front_is_clear;
        assert_eq!(is_sure, verdict == Verdict::Loses, "{ratios:?}");
    }
}

/// Both tables have the same rows, with equal numbers.
#[test]
fn tables_have_the_same_rows() {
    let report = report();
    let bytes = csv(&report.rows).unwrap();
    let json = serde_json::to_value(&report).unwrap();
    let rows = json["rows"].as_array().unwrap();
    let mut reader = csv::Reader::from_reader(&bytes[..]);
    let names = reader.headers().unwrap().clone();
    let records: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), rows.len());
    for (record, row) in records.iter().zip(rows) {
        let row = row.as_object().unwrap();
        assert_eq!(row.len(), names.len());
        for (name, cell) in names.iter().zip(record) {
            match &row[name] {
                serde_json::Value::String(text) => assert_eq!(text, cell, "{name}"),
                serde_json::Value::Bool(value) => assert_eq!(value.to_string(), cell, "{name}"),
                number => {
                    let expected = number
                        .as_f64()
                        .unwrap_or_else(|| panic!("{name}: {number}"));
                    assert_eq!(expected, cell.parse::<f64>().unwrap(), "{name}");
                }
            }
        }
    }
}

/// Lossless setups change no pixel, lossy ones do, and trees take the bytes of their codecs.
#[test]
fn setups_are_what_they_are_called() {
    let report = report();
    let of = |setup: &str| {
        let mut rows = report.rows.iter();
        rows.find(|row| row.setup == setup)
            .unwrap_or_else(|| panic!("{setup}"))
    };
    let usual = of("default");
    assert_eq!(
        (usual.image_rmse, usual.ssim, usual.frame_ratio > 0.0),
        (0.0, 1.0, true)
    );
    for name in [
        "nodes q10",
        "nodes paper10",
        "nodes w4",
        "nodes w4-64",
        "63-bit codes",
        "refit",
        "1 thread",
    ] {
        let row = of(name);
        assert_eq!((row.changed_pixels, row.ssim), (0.0, 1.0), "{name}");
        assert_eq!(row.primary_rays, 48 * 27);
    }
    assert_eq!(of("nodes q10").node_bytes * 64, usual.node_bytes * 16);
    assert!(of("nodes q10").bytes_per_ray < usual.bytes_per_ray);
    assert!(of("nodes q4").box_tests_per_ray >= usual.box_tests_per_ray);
    let coarse = of("nodes q10, mesh lattice 2px");
    assert!(
        coarse.vertex_moved_most > 0.0 && coarse.vertex_moved_most <= coarse.vertex_moved_bound
    );
    assert!(coarse.vertex_moved_rms < coarse.vertex_moved_most);
    assert!(coarse.image_rmse > 0.0 && coarse.ssim < 1.0);
    assert_eq!(of("refit").update, "refit");
    // A refitted tree keeps the order of the untwisted scene, so that its boxes are no tighter.
    assert!(of("refit").sah_cost >= usual.sah_cost * 0.999);
    assert!(usual.peak_bytes > usual.resident_bytes);
    assert!(
        report
            .findings
            .iter()
            .all(|it| it.verdict != Verdict::Fails)
    );
}

/// With next to nothing to measure, the report holds no NaN and no infinity.
#[test]
fn one_triangle_that_nobody_sees() {
    let mut scene = Scene {
        mesh: Mesh {
            vertices: vec![[1.0, 2.0, 3.0], [5.0, 2.0, 3.0], [1.0, 4.0, 3.0]],
            indices: vec![[0, 1, 2]],
            ..Mesh::default()
        },
        ..Scene::default()
    };
    scene.complete(scene.mesh.bounds(), TINY.size);
    let camera = &mut scene.cameras[0];
    camera.target = [0, 1, 2].map(|axis| 2.0 * camera.eye[axis] - camera.target[axis]);
    let name = "one triangle".into();
    let subject = Subject { name, scene };
    let measured = Measured {
        records: vec![measured(&subject, &Chosen::Cpu, &TINY, 1)],
        scaling: Vec::new(),
    };
    let report = Report::new("slimbvh-lab bench".into(), Vec::new(), TINY, 1, measured);
    for text in [report.text(), page(&report).unwrap()] {
        assert!(
            !text.contains("NaN") && !text.contains(">inf") && !text.contains(" inf"),
            "{text}"
        );
    }
    let json = serde_json::to_string(&report.rows).unwrap();
    assert!(!json.contains("null"), "{json}");
}

/// Moves of 10-bit corners are measured with codes of either length, which put triangles in different orders.
#[test]
fn corners_of_ten_bits_are_compared_in_any_order() {
    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let mut moves = Vec::new();
    for codes in [CodeBits::Bits30, CodeBits::Bits63] {
        let setup = Setup {
            nodes: NodeCodec::Paper10,
            mesh: Triangles::Leaf10,
            codes,
            ..Setup::plain(2)
        };
        assert!(setup.is_possible());
        let settings = RenderSettings {
            size: TINY.size,
            ..RenderSettings::default()
        };
        let prepared = Prepared::new(setup, &subject.scene, settings);
        moves.push(Facts::new(&prepared).unwrap().moves);
    }
    assert!(
        moves.iter().all(|it| it.rms > 0.0 && it.most <= it.bound),
        "{moves:?}"
    );
}

/// Any GPU. Without one the test is skipped with a notice, or fails under `REQUIRE_GPU`.
#[cfg(feature = "gpu")]
fn any_gpu() -> Option<slimbvh::gpu::Gpu> {
    use slimbvh::gpu::{AdapterChoice, Gpu, adapters};
    let Some(adapter) = adapters().into_iter().next() else {
        let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
        assert!(!is_required, "REQUIRE_GPU, but there is none");
        eprintln!("THE TEST OF BENCH ON A GPU IS SKIPPED: there is none");
        return None;
    };
    Some(Gpu::open(&AdapterChoice::Named(adapter.name)).unwrap())
}

/// On a GPU those setups are measured that it has kernels for, and lossless ones change no pixel.
#[cfg(feature = "gpu")]
#[test]
fn setups_on_a_gpu() {
    let Some(gpu) = any_gpu() else { return };
    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let protocol = Protocol { crossed: 0, ..TINY };
    let record = measured(&subject, &Chosen::Gpu(gpu), &protocol, 2);
    assert_eq!(record.backend, "gpu");
    let names: Vec<&str> = record.setups.iter().map(|it| it.name.as_str()).collect();
    let expected = [
        "default",
        "reduce on",
        "nodes paper10",
        "nodes w4",
        "nodes w4-64",
        "nodes paper10, mesh leaf10",
        "nodes w4-48, mesh lattice",
        "nodes w4-64, mesh lattice",
        "nodes w4-48, mesh lattice 0.1px",
        "nodes w4-64, mesh lattice 0.1px",
        "nodes w4-48, mesh lattice 0.5px",
        "nodes w4-64, mesh lattice 0.5px",
        "nodes w4-48, mesh lattice 2px",
        "nodes w4-64, mesh lattice 2px",
        "63-bit codes",
    ];
    assert_eq!(names, expected);
    let equal: Vec<_> = record
        .equal
        .iter()
        .map(|it| (&*it.setup, &*it.measured_as))
        .collect();
    let expected = [
        ("reduce off", "default"),
        ("reduce on, lights apart", "reduce on"),
    ];
    assert_eq!(equal, expected);
    for it in &record.setups {
        assert!(
            it.frame() > 0.0 && it.peak_bytes > it.facts.resident_bytes(),
            "{}",
            it.name
        );
        let is_same = it.likeness.changed_pixels == 0.0;
        assert!(is_same || !it.setup.is_lossless(), "{}", it.name);
    }
}
