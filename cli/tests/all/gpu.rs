//! The binary on a GPU, which may be a software adapter.

mod saved;

use crate::adapter::adapter;
use crate::process::{Folder, Outcome};

fn sentence(outcome: &Outcome) -> &str {
    assert_eq!(
        (outcome.code, outcome.stdout.as_str()),
        (Some(2), ""),
        "{outcome:?}"
    );
    let sentence = outcome.stderr.strip_suffix('\n').unwrap_or_default();
    assert!(
        sentence.starts_with("error: ") && !sentence.contains('\n'),
        "{outcome:?}"
    );
    sentence
}

/// The number of bytes that differ, and the largest difference.
fn difference(a: &[u8], b: &[u8]) -> (usize, u8) {
    assert_eq!(a.len(), b.len());
    let differences = a.iter().zip(b).map(|(a, b)| a.abs_diff(*b));
    let differ = differences.clone().filter(|&d| d > 0).count();
    (differ, differences.max().unwrap_or(0))
}

fn pixels(folder: &Folder, name: &str) -> Vec<u8> {
    let file = folder.read(name);
    let decoder = png::Decoder::new(std::io::Cursor::new(file));
    let mut reader = decoder.read_info().expect("it is a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("it has a size")];
    reader.next_frame(&mut bytes).expect("it is whole");
    bytes
}

#[test]
fn the_same_command_gives_the_same_picture_on_both_backends() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    for view in ["color", "normals", "depth", "primitives", "heatmap"] {
        let common = ["render", "--size=160x90", "--spp=2", "--view", view];
        let run = |output: &'static str, backend: &[&str]| {
            let arguments = [&common, backend, &["-o", output]].concat();
            let outcome = folder.run_with_gpu(&arguments);
            assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
            pixels(&folder, output)
        };
        let cpu = run("cpu.png", &["--backend=cpu"]);
        let gpu = run("gpu.png", &["--backend=gpu", "--adapter", adapter]);
        let (differ, most) = difference(&cpu, &gpu);
        println!(
            "{view}: {differ} of {} bytes differ, by {most} at most",
            cpu.len()
        );
        // Rounding may change a byte by one. A ray that grazes an edge may hit what lies behind it.
        let steps = cpu.iter().zip(&gpu).filter(|(a, b)| a.abs_diff(**b) > 1);
        assert!(steps.count() <= cpu.len() / 10_000, "{view}: {differ}");
        // Negative control: another field of view changes the picture.
        let other = run(
            "other.png",
            &["--backend=gpu", "--adapter", adapter, "--camera=fov=40"],
        );
        assert!(difference(&cpu, &other).0 > cpu.len() / 100, "{view}");
    }
}

#[test]
fn adapters_are_told_by_any_part_of_their_name() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    let part = adapter.chars().take(5).collect::<String>().to_uppercase();
    let arguments = ["render", "--size=8x8", "--json=-", "--adapter", &part];
    let outcome = folder.run_with_gpu(arguments);
    assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
    let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
    assert_eq!(
        (&report["backend"], &report["adapter"]),
        (&"gpu".into(), &adapter.into())
    );

    let outcome = folder.run_with_gpu(["render", "--adapter", "no such GPU"]);
    let sentence = sentence(&outcome);
    assert!(
        sentence.contains("\"no such GPU\"") && sentence.contains(adapter),
        "{sentence}"
    );
}

#[test]
fn software_computes_only_when_named() {
    let Some(_) = adapter() else { return };
    if slimbvh::gpu::adapters()
        .iter()
        .any(|adapter| !adapter.is_software)
    {
        return;
    }
    let folder = Folder::new();
    let outcome = folder.run_with_gpu(["render", "--backend=gpu"]);
    let said = sentence(&outcome);
    assert!(
        said.contains("only software") && said.contains("by name"),
        "{said}"
    );
    let outcome = folder.run_with_gpu(["render", "--size=8x8", "--json=-"]);
    let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
    assert_eq!(report["backend"], "cpu");
}

#[test]
fn the_list_of_adapters_names_limits_and_features() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    let text = folder.run_with_gpu(["info", "--adapters"]).stdout;
    for part in [adapter, "per binding", "per workgroup", "subgroups of"] {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
    let json = folder
        .run_with_gpu(["info", "--adapters", "--json=-"])
        .stdout;
    let report: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    assert_eq!(report["adapters"][0]["name"], adapter);
}

/// A picture that exceeds this adapter's binding limit is refused before any allocation.
#[test]
fn pictures_larger_than_the_gpu_takes_are_refused() {
    let Some(adapter) = adapter() else { return };
    let limit = slimbvh::gpu::adapters()[0].max_binding_bytes;
    // The depth view stores 8 bytes per sample.
    let spp = (limit / 8 / (64 * 64) + 1).to_string();
    if spp.parse().is_ok_and(|spp: u64| spp > 65536) {
        return;
    }
    let folder = Folder::new();
    let arguments = [
        "render",
        "--size=64x64",
        "--view=depth",
        "--spp",
        &spp,
        "--adapter",
        adapter,
    ];
    let outcome = folder.run_with_gpu(arguments);
    let said = sentence(&outcome);
    for part in [
        "max_storage_buffer_binding_size",
        &limit.to_string(),
        adapter,
        "fewer samples",
    ] {
        assert!(said.contains(part), "{part:?} is not in {said}");
    }
}
