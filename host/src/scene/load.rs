//! Reads a scene from a file.

use super::contain::contain;
use super::{LoadError, Scene, gltf, obj, off, ply, slim, stl};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// How to load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoadOptions {
    /// Drops broken faces instead of rejecting the file; [`Scene::dropped_face_count`] is their number.
    pub lenient: bool,
    /// The largest file that is read, in bytes. A glTF scene's buffers together have the same limit.
    pub max_file_bytes: u64,
}

impl Default for LoadOptions {
    fn default() -> Self {
        Self {
            lenient: false,
            max_file_bytes: 4 << 30,
        }
    }
}

/// Loads a scene from a file. The extension gives the format: gltf, glb, obj, ply, stl, off or slim. The mesh is
/// [valid](crate::Mesh::validate) and has at least one triangle.
///
/// Textures, animations and skins are ignored. Files that the scene refers to are read too: buffers of a glTF scene, and
/// material libraries of an OBJ scene, which may be missing.
///
/// # Errors
/// If the file cannot be read, does not follow its format, or has a broken face and `options` are not lenient.
pub fn load(path: &Path, options: &LoadOptions) -> Result<Scene, LoadError> {
    let source = Source {
        path,
        file: path.display().to_string(),
        options,
    };
    let reader = reader(&source)?;
    let bytes = read_file(path, options.max_file_bytes)?;
    parse(source, reader, bytes)
}

/// [`load`] for a file in memory. The path gives the format, and the folder of files that the scene refers to; no file need
/// exist there.
///
/// # Errors
/// Those of [`load`].
pub fn load_bytes(path: &Path, bytes: Vec<u8>, options: &LoadOptions) -> Result<Scene, LoadError> {
    let source = Source {
        path,
        file: path.display().to_string(),
        options,
    };
    let reader = reader(&source)?;
    parse(source, reader, bytes)
}

/// Parses with one of the readers, and checks the result.
fn parse(
    source: Source<'_>,
    (format, read): (&'static str, Reader),
    bytes: Vec<u8>,
) -> Result<Scene, LoadError> {
    match contain(|| read(&source, bytes)) {
        Ok(scene) => finish(scene?, &source),
        Err(message) => Err(LoadError::Panicked {
            file: source.file,
            format,
            message,
        }),
    }
}

/// The inputs of every reader besides the file's bytes.
pub(super) struct Source<'a> {
    /// The path as given.
    pub path: &'a Path,
    /// The path, for messages.
    pub file: String,
    /// The options.
    pub options: &'a LoadOptions,
}

impl Source<'_> {
    /// A path in the file, relative to the file.
    pub fn beside(&self, relative: impl AsRef<Path>) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(relative)
    }
}

type Reader = fn(&Source<'_>, Vec<u8>) -> Result<Scene, LoadError>;

/// The format's name and reader, by the file's extension.
fn reader(source: &Source<'_>) -> Result<(&'static str, Reader), LoadError> {
    let Some(extension) = source.path.extension() else {
        return Err(LoadError::NoExtension {
            file: source.file.clone(),
        });
    };
    let extension = extension.to_string_lossy();
    match extension.to_ascii_lowercase().as_str() {
        "gltf" | "glb" => Ok(("glTF", gltf::read)),
        "obj" => Ok(("OBJ", obj::read)),
        "ply" => Ok(("PLY", ply::read)),
        "stl" => Ok(("STL", stl::read)),
        "off" => Ok(("OFF", off::read)),
        "slim" => Ok(("slim", slim::read_scene)),
        _ => Err(LoadError::UnknownExtension {
            file: source.file.clone(),
            extension: extension.into_owned(),
        }),
    }
}

/// A file's bytes, if it is a regular file of at most this size.
pub(super) fn read_file(path: &Path, limit_bytes: u64) -> Result<Vec<u8>, LoadError> {
    let file = || path.display().to_string();
    let cannot_read = |error| LoadError::Read {
        file: file(),
        error,
    };
    let too_large = |size_bytes| LoadError::TooLarge {
        file: file(),
        size_bytes,
        limit_bytes,
    };

    // Check before opening: opening a pipe waits for a writer.
    let metadata = std::fs::metadata(path).map_err(cannot_read)?;
    if !metadata.is_file() {
        return Err(LoadError::NotAFile { file: file() });
    }
    if metadata.len() > limit_bytes {
        return Err(too_large(metadata.len()));
    }
    let mut bytes = Vec::with_capacity(metadata.len() as usize);
    let opened = File::open(path).map_err(cannot_read)?;
    opened
        .take(limit_bytes.saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(cannot_read)?;
    // The file may have grown since.
    if bytes.len() as u64 > limit_bytes {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// Checks a reader's result.
fn finish(mut scene: Scene, source: &Source<'_>) -> Result<Scene, LoadError> {
    if source.options.lenient {
        scene.dropped_face_count += scene.mesh.drop_unsound_faces();
    }
    scene.mesh.validate().map_err(|error| LoadError::Mesh {
        file: source.file.clone(),
        error,
    })?;
    if scene.mesh.indices.is_empty() {
        return Err(LoadError::NoTriangles {
            file: source.file.clone(),
            dropped_face_count: scene.dropped_face_count,
        });
    }
    Ok(scene)
}
