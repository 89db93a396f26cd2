//! The folders of core are in layers: each uses only itself and those before it, so that no circle of imports exists.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The folders of `core/src`, from the lowest layer up, as the docs of `lib.rs` list them.
const ROOMS: [&str; 6] = ["geometry", "build", "trace", "codec", "reduce", "shade"];

/// The Rust files of a folder and of those in it.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("it is a folder") {
        let path = entry.expect("it can be listed").path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            found.push(path);
        }
    }
    found
}

/// The rooms that a text names in paths, above the room that it is in.
fn upward(text: &str, room: usize) -> BTreeSet<&'static str> {
    let above = ROOMS.iter().skip(room + 1).copied();
    let code = text.lines().map(str::trim);
    let code: Vec<&str> = code.filter(|line| !line.starts_with("//")).collect();
    above
        .filter(|name| {
            let path = format!("crate::{name}::");
            code.iter().any(|line| line.contains(&path))
        })
        .collect()
}

#[test]
fn rooms_of_core_use_only_rooms_below() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/src");
    for (room, name) in ROOMS.into_iter().enumerate() {
        let mut own = files(&source.join(name));
        own.push(source.join(name).with_extension("rs"));
        for path in own {
            let text = std::fs::read_to_string(&path).expect("it is text");
            assert_eq!(upward(&text, room), BTreeSet::new(), "{}", path.display());
        }
    }
    let folders = std::fs::read_dir(&source).expect("it is a folder");
    let folders = folders.map(|entry| entry.expect("it can be listed").path());
    let folders = folders.filter(|path| path.is_dir() && !files(path).is_empty());
    assert_eq!(folders.count(), ROOMS.len());
}

/// The control: an import from a room above is found.
#[test]
fn an_upward_import_is_found() {
    let text = "use crate::trace::Skip;\n// crate::shade::view\nuse crate::geometry::ray::Ray;\n";
    assert_eq!(upward(text, 1), BTreeSet::from(["trace"]));
    assert_eq!(upward(text, 2), BTreeSet::new());
}
