//! Meshes of one's own, from files.

use anyhow::Result;
use slimbvh::Scene;
use slimbvh::scene::{LoadOptions, load};
use std::path::{Path, PathBuf};

/// A scene from a file in one of the library's formats.
#[derive(Clone, Debug)]
pub struct Own {
    /// The file's name, without its folder.
    pub name: String,
    pub scene: Scene,
}

impl Own {
    /// # Errors
    /// If the file cannot be loaded, or holds no triangles.
    pub fn load(path: &Path) -> Result<Self> {
        Ok(Self {
            name: name(path),
            scene: load(path, &LoadOptions::default())?,
        })
    }

    /// All files, in order.
    pub fn load_all(paths: &[PathBuf]) -> Result<Vec<Self>> {
        paths.iter().map(|path| Self::load(path)).collect()
    }
}

/// The file's name, without its folder.
pub fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
