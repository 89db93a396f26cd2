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
