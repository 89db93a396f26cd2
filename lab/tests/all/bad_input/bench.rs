//! Unknown scenes, empty scenes, and reports that cannot be written.

use super::{folder, refuses, refuses_usage};

const QUICK: [&str; 2] = ["bench", "--quick"];

#[test]
fn scenes_that_there_are_none_of() {
    let folder = folder();
    folder.write("empty.obj", "");
    for (scene, expected) in [
        (
            "spher",
            "there is neither a file \"spher\" nor a generated scene of that name; those are default, shiny",
        ),
        ("missing.ply", "missing.ply"),
        ("empty.obj", "empty.obj"),
    ] {
        refuses(
            &folder,
            &[&QUICK[..], &["sphere", scene]].concat(),
            &[expected],
        );
    }
}

#[test]
fn backends_and_threads() {
    let folder = folder();
    refuses_usage(
        &folder,
        &[&QUICK[..], &["--backend", "cpu,tpu"]].concat(),
        &["tpu", "cpu, gpu"],
    );
    refuses_usage(
        &folder,
        &[&QUICK[..], &["--threads", "0"]].concat(),
        &["--threads"],
    );
    refuses(
        &folder,
        &[&QUICK[..], &["--adapter", "some"]].concat(),
        &["--adapter \"some\" needs a GPU, but --backend names none"],
    );
}

#[test]
fn setups_cameras_sizes_and_rounds() {
    let folder = folder();
    let with = |more: &[&'static str]| [&QUICK[..], &["sound.obj"], more].concat();
    refuses(
        &folder,
        &with(&["--only", "nodes,fast"]),
        &["--only \"fast\" names no setup", "reduce, lights, nodes"],
    );
    refuses_usage(&folder, &with(&["--camera", "eye=1,2"]), &["--camera"]);
    refuses(
        &folder,
        &with(&["--camera", "eye=0,0,0 target=0,0,0"]),
        &["--camera in sound.obj"],
    );
    refuses_usage(&folder, &with(&["--size", "0x9"]), &["--size"]);
    refuses_usage(&folder, &with(&["--rounds", "0"]), &["--rounds"]);
}

/// Files are looked for before an adapter is.
#[test]
fn a_missing_scene_is_told_before_a_missing_gpu() {
    let folder = folder();
    let gpu = ["--backend", "gpu", "--adapter", "no such adapter"];
    refuses(
        &folder,
        &[&QUICK[..], &["gone.obj"], &gpu].concat(),
        &["\"gone.obj\""],
    );
}

#[test]
fn reports_without_a_place() {
    let folder = folder();
    for (place, expected) in [
        (
            "no folder/report",
            "cannot make the folder \"no folder/report\"",
        ),
        ("sound.obj", "cannot make the folder \"sound.obj\""),
    ] {
        let arguments = [&QUICK[..], &["sound.obj", "--out", place]].concat();
        refuses(&folder, &arguments, &[expected]);
    }
}
