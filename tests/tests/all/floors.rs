//! The rooms of a crate are ordered: a room uses only rooms below it, so there are no circles. A room is a file or a folder
//! beside `lib.rs`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The rooms of the library, lowest first.
const HOST: &[&str] = &[
    "dvec3",
    "text",
    "parallel",
    "stopwatch",
    "stages",
    "mesh",
    "analysis",
    "collect",
    "tree",
    "topology",
    "scene",
    "picture",
    "config",
    "tolerance",
    "generate",
    "backend",
    "cpu",
    "gpu",
    "animate",
    "reduce",
    "views",
    "frame",
    "internals",
];

/// The rooms of core, lowest first.
const CORE: &[&str] = &[
    "launch", "geometry", "build", "trace", "codec", "reduce", "shade",
];

/// The crate's code by path from its `src`, without tests and comments.
fn sources(crate_folder: &str) -> BTreeMap<String, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .join(crate_folder)
        .join("src");
    let mut sources = BTreeMap::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(&folder).expect("the folder is there");
        let mut paths: Vec<PathBuf> = entries.map(|e| e.expect("readable").path()).collect();
        paths.sort();
        for path in paths {
            let name = path.file_stem().unwrap_or_default();
            if name == "tests" {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&path).expect("it is text");
                let lines = text.lines().take_while(|line| *line != "#[cfg(test)]");
                let lines = lines.map(|line| line.split("//").next().unwrap_or_default());
                let from_root = path.strip_prefix(&root).expect("it is below");
                let code: Vec<&str> = lines.collect();
                sources.insert(from_root.display().to_string(), code.join("\n"));
            }
        }
    }
    sources
}

/// The room of each name that `lib.rs` re-exports: `pub use room::{Name, Other};`.
fn handed_on(lib: &str) -> BTreeMap<String, String> {
    let mut rooms = BTreeMap::new();
    for statement in lib.split(';') {
        let Some((_, path)) = statement.split_once("use ") else {
            continue;
        };
        let Some((room, names)) = path.split_once("::") else {
            continue;
        };
        let names = names.split(|c: char| !c.is_alphanumeric() && c != '_');
        for name in names.filter(|name| !name.is_empty()) {
            rooms.insert(name.to_owned(), room.trim().to_owned());
        }
    }
    rooms
}

/// The first names after a path to the crate's root: one name, or a list in braces.
fn first_names(rest: &str) -> Vec<&str> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let Some(list) = rest.strip_prefix('{') else {
        let end = rest.find(|c| !is_name(c)).unwrap_or(rest.len());
        return vec![&rest[..end]];
    };
    // Take the first name of each item on the outermost level of the list.
    let (mut names, mut depth, mut begin) = (Vec::new(), 0, Some(0));
    for (at, c) in list.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => {
                names.extend(begin.map(|begin| list[begin..at].trim()));
                break;
            }
            '}' => depth -= 1,
            ',' if depth == 0 => {
                names.extend(begin.map(|begin| list[begin..at].trim()));
                begin = Some(at + 1);
                continue;
            }
            ':' if depth == 0 => {
                names.extend(begin.take().map(|begin| list[begin..at].trim()));
            }
            _ => {}
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// The room of a file, and its depth in modules.
fn place(path: &str) -> (&str, usize) {
    let room = path.split('/').next().unwrap_or_default();
    let room = room.strip_suffix(".rs").unwrap_or(room);
    let parts = path.split('/').count();
    (room, parts - usize::from(path.ends_with("/mod.rs")))
}

/// Each use of a room that is not below the user's.
fn upward(floors: &[&str], sources: &BTreeMap<String, String>) -> Vec<String> {
    let handed_on = handed_on(&sources["lib.rs"]);
    let floor = |room: &str| floors.iter().position(|name| *name == room);
    let mut found = Vec::new();
    for (path, code) in sources.iter().filter(|(path, _)| *path != "lib.rs") {
        let (room, depth) = place(path);
        let Some(own) = floor(room) else {
            found.push(format!("{path}: {room} has no floor"));
            continue;
        };
        let out = "super::".repeat(depth);
        for to_root in ["crate::", &out] {
            for (at, _) in code.match_indices(to_root) {
                let before = code[..at].chars().next_back();
                if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':' || c == '$') {
                    continue;
                }
                for name in first_names(&code[at + to_root.len()..]) {
                    let used = handed_on.get(name).map_or(name, String::as_str);
                    // A name that is neither a room nor re-exported from one comes from another crate or is a macro.
                    if used != room && floor(used).is_some_and(|used| used > own) {
                        found.push(format!("{path} uses {used} ({name})"));
                    }
                }
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

#[test]
fn rooms_use_only_rooms_below_them() {
    for (crate_folder, floors) in [("host", HOST), ("core", CORE)] {
        let found = upward(floors, &sources(crate_folder));
        assert!(found.is_empty(), "{crate_folder}: {found:#?}");
    }
}

/// The negative control: uses of a higher room are found in every way to write them.
#[test]
fn a_use_of_a_higher_room_is_found() {
    let planted = [
        "use crate::frame::Frames;",
        "use crate::{\n    Stages,\n    frame,\n};",
        "use crate::{text::excerpt, Frames, Stages};",
        "fn f() { crate::frame::f() }",
        "use super::frame::Frames;",
        "use super::{Stages, Frames};",
    ];
    let lib = "mod frame;\npub use frame::{FrameConfig, Frames};\npub use stages::Stages;\n";
    for code in planted {
        let sources = [("lib.rs", lib), ("mesh.rs", code), ("stages.rs", "")];
        let sources = sources.map(|(path, code)| (path.to_owned(), code.to_owned()));
        let found = upward(&["stages", "text", "mesh", "frame"], &sources.into());
        assert_eq!(found.len(), 1, "{code}: {found:?}");
    }
    let deep = [
        ("lib.rs", lib),
        ("mesh/snap.rs", "use super::super::Frames; use super::f;"),
    ];
    let deep = deep.map(|(path, code)| (path.to_owned(), code.to_owned()));
    assert_eq!(upward(&["mesh", "frame"], &deep.into()).len(), 1);
    let fine = [
        ("lib.rs", lib),
        (
            "frame.rs",
            "use crate::{Stages, mesh::Mesh}; use crate::frame;",
        ),
    ];
    let fine = fine.map(|(path, code)| (path.to_owned(), code.to_owned()));
    assert!(upward(&["stages", "mesh", "frame"], &fine.into()).is_empty());
}
