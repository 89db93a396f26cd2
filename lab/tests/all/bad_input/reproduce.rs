//! Unknown papers, unknown scenes, and reports that cannot be written.

use super::{folder, refuses, refuses_usage};

const REDUCED: [&str; 3] = ["reproduce", "reduced", "--quick"];

#[test]
fn papers_and_scenes_that_there_are_none_of() {
    let folder = folder();
    refuses_usage(&folder, &["reproduce", "widened"], &["widened"]);
    let only = [&REDUCED[..], &["--only", "dolls"]].concat();
    refuses_usage(
        &folder,
        &only,
        &["dolls", "doll, toasters, 24-cell, armadillo, dragon"],
    );
    refuses_usage(&folder, &[&REDUCED[..], &["--only"]].concat(), &["--only"]);
    refuses_usage(
        &folder,
        &[&REDUCED[..], &["--threads", "0"]].concat(),
        &["--threads"],
    );
}

#[test]
fn folders_of_scenes() {
    let folder = folder();
    for (scenes, expected) in [("nowhere", "\"nowhere\""), ("sound.obj", "\"sound.obj\"")] {
        let arguments = [&REDUCED[..], &["--scenes", scenes]].concat();
        refuses(&folder, &arguments, &["there is no folder", expected]);
    }
    refuses_usage(
        &folder,
        &[&REDUCED[..], &["--scenes", ""]].concat(),
        &["--scenes"],
    );
}

/// A broken scene file is an error, and no stand-in replaces it.
#[test]
fn broken_scenes_are_told() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("models")).unwrap();
    folder.write("models/armadillo.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
    let arguments = [&REDUCED[..], &["--scenes", "models", "--only", "armadillo"]].concat();
    refuses(&folder, &arguments, &["armadillo.off"]);
}

#[test]
fn reports_without_a_place() {
    let folder = folder();
    folder.write("kept.md", "an older report");
    for (option, place, expected) in [
        ("--out", "no folder/new.md", "\"no folder\""),
        ("--out", "new.txt", "\"new.txt\" does not end in .md"),
        ("--out", "new", "\"new\" does not end in .md"),
        ("--json", "no folder/new.json", "\"no folder\""),
        ("--json", "sound.obj/new.json", "\"sound.obj\""),
    ] {
        let arguments = [&REDUCED[..], &["--only", "doll", option, place]].concat();
        refuses(&folder, &arguments, &[expected]);
    }
    let same = [&REDUCED[..], &["--out", "kept.md", "--json", "./kept.md"]].concat();
    refuses(&folder, &same, &["has another use already"]);
}

#[test]
fn gpus_that_are_not_there() {
    let folder = folder();
    for paper in [REDUCED, ["reproduce", "compressed", "--quick"]] {
        let named = [&paper[..], &["--adapter", "no such GPU"]].concat();
        refuses(&folder, &named, &["GPU"]);
        refuses(
            &folder,
            &[&paper[..], &["--backend", "gpu"]].concat(),
            &["GPU"],
        );
        let both = [&paper[..], &["--adapter", "x", "--backend", "cpu"]].concat();
        refuses(&folder, &both, &["--adapter", "leave one out"]);
    }
}

/// Both papers refuse the same input.
#[test]
fn compressed_trees_without_a_place_or_scenes() {
    const COMPRESSED: [&str; 3] = ["reproduce", "compressed", "--quick"];
    let folder = folder();
    let with = |options: &[&'static str]| [&COMPRESSED[..], options].concat();
    refuses_usage(
        &folder,
        &with(&["--only", "rabbit"]),
        &["rabbit", "shiny, bunny, dragon, asian-dragon"],
    );
    let nowhere = with(&["--scenes", "nowhere"]);
    refuses(&folder, &nowhere, &["there is no folder", "\"nowhere\""]);
    let text = with(&["--only", "shiny", "--out", "new.txt"]);
    refuses(&folder, &text, &["\"new.txt\" does not end in .md"]);
    let json = with(&["--only", "shiny", "--json", "no folder/new.json"]);
    refuses(&folder, &json, &["\"no folder\""]);
    std::fs::create_dir(folder.path().join("models")).unwrap();
    folder.write("models/bunny00.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
    let broken = with(&["--scenes", "models", "--only", "bunny"]);
    refuses(&folder, &broken, &["bunny00.off"]);
}

/// Meshes are read before any work, and before an adapter is opened.
#[test]
fn meshes_that_cannot_be_read() {
    let folder = folder();
    for paper in ["reduced", "compressed"] {
        let arguments = [
            "reproduce",
            paper,
            "--backend",
            "gpu",
            "--adapter",
            "no such",
        ];
        let arguments = [&arguments[..], &["--mesh", "gone.glb"]].concat();
        refuses(&folder, &arguments, &["\"gone.glb\""]);
    }
}
