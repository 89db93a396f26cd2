//! Unknown families, unreadable rows, and adapters without a GPU backend.

use super::{folder, refuses, refuses_usage};

#[test]
fn families_and_backends_that_there_are_none_of() {
    let folder = folder();
    refuses(
        &folder,
        &["stress", "--only", "cubes"],
        &["no family", "cubes"],
    );
    refuses_usage(&folder, &["stress", "--backend", "cpu,tpu"], &["tpu"]);
    let adapter = ["stress", "--backend", "cpu", "--adapter", "x"];
    refuses(&folder, &adapter, &["--adapter", "--backend gpu"]);
}

#[test]
fn rows_of_others_that_are_none() {
    let folder = folder();
    refuses(
        &folder,
        &["stress", "--with", "nowhere.json"],
        &["nowhere.json"],
    );
    folder.write("broken.json", "{\"rows\": [{\"tracer\": 7}]}");
    refuses(
        &folder,
        &["stress", "--with", "broken.json"],
        &["broken.json", "rows"],
    );
}

#[test]
fn reports_without_a_place() {
    let folder = folder();
    let json = ["stress", "--json", "nowhere/rows.json"];
    refuses(&folder, &json, &["there is no folder", "nowhere"]);
    let taken = ["stress", "--with", "kept.png", "--json", "kept.png"];
    refuses(&folder, &taken, &["kept.png", "another use"]);
}

/// Meshes are read before any work, and before an adapter is opened.
#[test]
fn meshes_that_cannot_be_read() {
    let folder = folder();
    folder.write("empty.obj", "");
    let gpu = ["--backend", "gpu", "--adapter", "no such adapter"];
    for (name, expected) in [("gone.glb", "\"gone.glb\""), ("empty.obj", "is empty")] {
        let arguments = [&["stress", "sound.obj", name][..], &gpu].concat();
        refuses(&folder, &arguments, &[expected]);
    }
}
