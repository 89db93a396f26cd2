//! Real meshes, if their files are present.

use slimbvh::Mesh;
use slimbvh::scene::{LoadOptions, load};
use std::io::Write;
use std::path::PathBuf;

/// Reads files from the folder that `SLIMBVH_SCENES` names, each with its name. Prints missing files to stderr.
///
/// # Panics
/// If a file exists but cannot be read.
#[must_use]
pub fn real_meshes(names: &[&str]) -> Vec<(String, Mesh)> {
    let Some(folder) = std::env::var_os("SLIMBVH_SCENES").map(PathBuf::from) else {
        warn(&format!("SLIMBVH_SCENES is not set, not tested: {names:?}"));
        return Vec::new();
    };
    let mut meshes = Vec::new();
    for &name in names {
        let path = folder.join(name);
        if !path.exists() {
            warn(&format!("{} is not there", path.display()));
            continue;
        }
        match load(&path, &LoadOptions::default()) {
            Ok(scene) => meshes.push((name.to_owned(), scene.mesh)),
            Err(error) => panic!("{}: {error}", path.display()),
        }
    }
    meshes
}

/// Prints to stderr directly, as the test harness would capture `eprintln`.
fn warn(what: &str) {
    // An error means that stderr is closed, so it is ignored.
    let _ = writeln!(std::io::stderr(), "SKIPPED: {what}");
}
