//! Animations on a GPU, which may be a software adapter.

use super::{actions, decode, folder, frames};
use crate::process::Folder;

/// Runs an animation on the adapter and returns its report.
fn run(folder: &Folder, adapter: &str, options: &[&str]) -> serde_json::Value {
    let common = ["animate", "--size=64x36", "--json=-", "--adapter", adapter];
    let outcome = folder.run_with_gpu([&common[..], options].concat());
    assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
    serde_json::from_str(&outcome.stdout).expect("it is JSON")
}

#[test]
fn a_gpu_makes_the_same_frames() {
    let adapters = slimbvh::gpu::adapters();
    let Some(adapter) = adapters.first().map(|adapter| adapter.name.as_str()) else {
        let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
        assert!(!is_required, "REQUIRE_GPU, but there is none");
        eprintln!("THE TESTS OF ANIMATIONS ON A GPU ARE SKIPPED: there is none");
        return;
    };
    let folder = folder(&["cpu", "refit", "rebuild", "auto"]);
    let common = ["--frames=10", "--orbit", "--deform=twist"];
    same_frames(&folder, adapter, &common);
    // Each frame has three shutter times, each with its own tree.
    let common = [&common[..], &["--shutter=0.5", "--shutter-times=3"]].concat();
    let folder = self::folder(&["cpu", "refit", "rebuild", "auto"]);
    same_frames(&folder, adapter, &common);
}

fn same_frames(folder: &Folder, adapter: &str, common: &[&str]) {
    let times = if common.len() > 3 { 3 } else { 1 };
    let options = ["animate", "--size=64x36", "--out=cpu"];
    folder.succeed([&options[..], common].concat());
    let cpu = frames(folder, "cpu", 10);
    let pictures = ["refit", "rebuild", "auto"].map(|update| {
        let options = ["--update", update, "--out", update];
        let report = run(folder, adapter, &[common, &options].concat());
        assert_eq!(report["backend"], "gpu");
        assert_eq!(actions(&report)[0], "rebuilt");
        // The GPU does not compute the SAH cost, so `auto` rebuilds every eighth time.
        let expected: u32 = match update {
            "refit" => 1,
            "rebuild" => 10 * times,
            _ => (10 * times).div_ceil(8),
        };
        assert_eq!(report["totals"]["rebuilt"], expected, "{report}");
        frames(folder, update, 10)
    });
    assert_eq!(pictures[0], pictures[1]);
    assert_eq!(pictures[0], pictures[2]);

    // Rounding may change a byte by one. A ray that grazes an edge may hit what lies behind it.
    for (cpu, gpu) in cpu.iter().zip(&pictures[0]) {
        let (cpu, gpu) = (decode(cpu), decode(gpu));
        let far = cpu.iter().zip(&gpu).filter(|(a, b)| a.abs_diff(**b) > 1);
        assert!(far.count() <= cpu.len() / 200);
    }
    // Negative control: consecutive frames differ.
    let (first, next) = (decode(&cpu[0]), decode(&pictures[0][1]));
    let far = first.iter().zip(&next).filter(|(a, b)| a.abs_diff(**b) > 1);
    assert!(far.count() > first.len() / 20);
}

#[test]
fn a_static_scene_is_built_once() {
    let adapters = slimbvh::gpu::adapters();
    let Some(adapter) = adapters.first() else {
        return;
    };
    let folder = Folder::new();
    let report = run(&folder, &adapter.name, &["--frames=3", "--orbit"]);
    assert_eq!(actions(&report), ["rebuilt", "kept", "kept"]);
}
