//! The committed shader modules and their record.

use anyhow::{Context, Result, ensure};
use std::path::{Path, PathBuf};

/// Folders of committed modules, from the root of the repository.
const FOLDERS: [&str; 2] = ["host/shaders", "host/examples/own_shader"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The committed record.
pub fn record() -> PathBuf {
    root().join("bench/record/shaders.csv")
}

/// A module of the library, by its kernel's name.
pub fn kernel(name: &str) -> PathBuf {
    root().join(FOLDERS[0]).join(name).with_extension("spv")
}

/// All committed modules, in the order of their names.
pub fn committed() -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for folder in FOLDERS {
        let folder = root().join(folder);
        let entries =
            std::fs::read_dir(&folder).with_context(|| format!("cannot read {folder:?}"))?;
        for entry in entries {
            let path = entry?.path();
            if path.extension().is_some_and(|extension| extension == "spv") {
                files.push(path);
            }
        }
    }
    ensure!(!files.is_empty(), "there are no committed modules");
    files.sort_by(|a, b| a.file_name().cmp(&b.file_name()));
    Ok(files)
}

/// A module's name.
pub fn name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
