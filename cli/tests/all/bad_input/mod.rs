//! Whatever is wrong with the input, the answer is exit code 2 and one sentence that names it. Nothing else is written.

mod options;
mod places;
mod saved;
mod scenes;

use crate::process::Folder;
use crate::refusal::{folder, refuses, refuses_usage};

/// Both commands refuse a scene file, and neither a new picture nor an older one is touched.
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
