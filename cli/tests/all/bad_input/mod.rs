//! Bad input: the binary exits with code 2 and one sentence that names the fault, and writes no file.

mod options;
mod places;
mod saved;
mod scenes;

use crate::process::Folder;
use crate::refusal::{folder, refuses, refuses_usage};

/// `info` and `render` refuse a scene file and write neither a new picture nor over an existing one.
#[track_caller]
fn refuses_scene(folder: &Folder, arguments: &[&str], expected: &[&str]) {
    refuses(folder, &[&["info"], arguments].concat(), expected);
    refuses(
        folder,
        &[&["render", "-o", "new.png"], arguments].concat(),
        expected,
    );
    refuses(
        folder,
        &[&["render", "-o", "kept.png"], arguments].concat(),
        expected,
    );
}
