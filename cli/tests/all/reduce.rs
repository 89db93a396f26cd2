//! `render` with `--cull`, `--reduce`, `--solid` and `--explain`.

use crate::process::{Folder, Outcome};
use serde_json::Value;

/// Valid combinations of switches, and whether each of them surveys the surfaces.
const COMBINATIONS: [(&[&str], bool); 10] = [
    (&[], false),
    (&["--reduce=auto"], false),
    (&["--reduce=off"], false),
    (&["--reduce=on"], true),
    (&["--cull=on"], true),
    (&["--cull=on", "--reduce=auto"], true),
    (&["--cull=on", "--reduce=off"], true),
    (&["--cull=on", "--reduce=on"], true),
    (&["--cull=off", "--reduce=auto"], false),
    (&["--cull=off", "--reduce=off"], false),
];

const SMALL: [&str; 5] = ["render", "--size=80x45", "-o=x.png", "--json=-", "--spp=2"];

fn report(outcome: &Outcome) -> Value {
    assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
    serde_json::from_str(&outcome.stdout).expect("it is JSON")
}

/// Renders with all combinations. All pictures with a survey are identical, and so are all pictures without one.
fn check(backend: &[&str], run: impl Fn(&Folder, Vec<&str>) -> Outcome) {
    let folder = Folder::new();
    let mut pictures: [Vec<Vec<u8>>; 2] = Default::default();
    for (switches, is_surveyed) in COMBINATIONS {
        for solid in [&[][..], &["--solid"]] {
            let options = [&SMALL[..], backend, switches, solid, &["--explain"]].concat();
            let report = report(&run(&folder, options));
            let plan = &report["plan"];
            assert_eq!(plan["surveyed"], is_surveyed, "{switches:?}: {plan}");
            let has_seams = plan["survey_ms"].get("seams").is_some();
            assert_eq!(has_seams, is_surveyed && solid.is_empty(), "{plan}");
            // The default scene has mirrors and parts that are not closed.
            assert_eq!(plan["whole_tree"], true);
            let trees = plan["targets"].as_array().expect("they are a list");
            assert_eq!(trees.len(), 3, "a camera and two lights: {plan}");
            if switches.contains(&"--reduce=on") {
                assert!(trees.iter().all(|tree| tree["tree"] == "set"), "{plan}");
                assert_eq!(plan["reducible_triangles"], 100_952);
            }
            let whole = report["triangles"].as_f64().expect("it is a number");
            let mut in_trees = whole;
            for tree in trees {
                let count = tree["triangles"].as_f64().expect("it is a number");
                if tree["tree"] == "set" {
                    in_trees += count;
                    let estimate = tree["estimated_share"].as_f64().unwrap_or(0.0);
                    let share = count / whole;
                    assert!((share - estimate).abs() < 0.05, "{share} {estimate}");
                    assert!((0.4..0.7).contains(&share), "{share}");
                }
            }
            assert_eq!(report["triangle_bytes"].as_f64(), Some(40.0 * in_trees));
            let picture = folder.read("x.png");
            pictures[usize::from(is_surveyed)].push(picture);
        }
    }
    for pictures in &pictures {
        assert!(pictures.iter().all(|picture| *picture == pictures[0]));
    }
}

#[test]
fn every_combination_renders() {
    check(&["--backend=cpu"], |folder, options| folder.run(options));
}

#[cfg(feature = "gpu")]
#[test]
fn every_combination_renders_on_a_gpu() {
    let adapters = slimbvh::gpu::adapters();
    let Some(adapter) = adapters.first() else {
        let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
        assert!(!is_required, "REQUIRE_GPU, but there is none");
        eprintln!("THE TESTS OF PLANS ON A GPU ARE SKIPPED: there is none");
        return;
    };
    check(&["--adapter", &adapter.name], |folder, options| {
        folder.run_with_gpu(options)
    });
}

/// `--explain` prints one line per decision after the summary.
#[test]
fn plans_are_explained() {
    let folder = Folder::new();
    let common = ["render", "--size=80x45", "--explain"];
    let run = |options: &[&str]| folder.succeed([&common, options].concat());
    let text = run(&["--reduce=on"]);
    for part in [
        "reducible  96 of 101 components, 100,952 triangles",
        "stay whole 5 components, 20,480 triangles: not closed",
        "camera     a set of its own: keeps about ",
        "light 2    a set of its own: ",
        "whole tree is built, for mirrors",
        "kept       camera ",
        "took       survey ",
    ] {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
    let text = run(&["--reduce=on", "--mirror-depth=0"]);
    assert!(text.contains("whole tree is not built"), "{text}");
    let text = run(&["--reduce=off", "--cull=on"]);
    assert!(text.contains("because reduction is off"), "{text}");
    let text = run(&[]);
    assert!(
        text.contains("nothing    is left out: a survey of the surfaces takes about"),
        "{text}"
    );
    assert!(text.contains("took       no survey"), "{text}");
    // Without `--explain` there is no plan in the text.
    let text = folder.succeed(["render", "--size=80x45", "--reduce=on"]);
    assert!(!text.contains("whole tree"), "{text}");
}

#[test]
fn bad_values_are_refused() {
    let folder = Folder::new();
    for (options, part) in [
        (&["--cull=maybe"][..], "--cull"),
        (&["--cull"], "--cull"),
        (&["--reduce=some"], "--reduce"),
        (&["--reduce="], "--reduce"),
        (&["--solid=yes"], "--solid"),
        (&["--explain=all"], "--explain"),
        (&["--cull=off", "--reduce=on"], "leave one of them out"),
    ] {
        let outcome = folder.run([&["render"], options].concat());
        assert_eq!((outcome.code, outcome.stdout.as_str()), (Some(2), ""));
        assert!(outcome.stderr.starts_with("error: "), "{outcome:?}");
        assert!(outcome.stderr.contains(part), "{outcome:?}");
    }
    assert!(folder.contents().is_empty());
}
