//! The scene in a file that holds a hierarchy as well.

use super::load::Source;
use super::{LoadError, Scene};

/// Reads the scene, once all of the file is found sound.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Scene, LoadError> {
    match crate::file::read(&bytes) {
        Ok(saved) => Ok(saved.scene),
        Err(error) => Err(LoadError::Saved {
            file: source.file.clone(),
            error,
        }),
    }
}
