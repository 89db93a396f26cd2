//! Reads a scene from a file.

use super::contain::contain;
use super::vertices::Vertices;
use super::{Format, LeftOut, Light, LoadError, Scene, gltf, obj, off, ply, slim, stl};
use std::cell::RefCell;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Kinds of what a scene leaves out that are told apart, at most: a file can name many.
const MOST_KINDS: usize = 32;

/// How to load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoadOptions {
    /// Drops broken faces instead of rejecting the file; [`Scene::dropped_face_count`] is their number.
    pub lenient: bool,
    /// The largest file that is read, in bytes. A glTF scene's buffers together have the same limit.
    pub max_file_bytes: u64,
    /// The format; `None` for that of the extension.
    pub format: Option<Format>,
}

impl Default for LoadOptions {
    fn default() -> Self {
        Self {
            lenient: false,
            max_file_bytes: 4 << 30,
            format: None,
        }
    }
}

/// Loads a scene from a file. The extension gives the format, if `options` do not: gltf, glb, obj, ply, stl, off or slim. The mesh is
/// [valid](crate::Mesh::validate) and has at least one triangle.
///
/// Skins and morph targets are at the file's pose. [`Scene::left_out`] lists what is not read, such as textures and animations.
/// Files that the scene refers to are read too: buffers of a glTF scene, and material libraries of an OBJ scene, which may be
/// missing.
///
/// # Errors
/// If the file cannot be read, does not follow its format, or has a broken face and `options` are not lenient.
pub fn load(path: &Path, options: &LoadOptions) -> Result<Scene, LoadError> {
    let source = Source::new(path, options);
    let format = format(&source)?;
    let bytes = read_file(path, options.max_file_bytes)?;
    parse(source, format, bytes)
}

/// [`load`] for a file in memory. The path gives the format, if `options` do not, and the folder of files that the scene refers to; no file need
/// exist there.
///
/// # Errors
/// Those of [`load`].
pub fn load_bytes(path: &Path, bytes: Vec<u8>, options: &LoadOptions) -> Result<Scene, LoadError> {
    let source = Source::new(path, options);
    let format = format(&source)?;
    parse(source, format, bytes)
}

/// Parses with the reader of a format, and checks the result.
fn parse(source: Source<'_>, format: Format, bytes: Vec<u8>) -> Result<Scene, LoadError> {
    if bytes.is_empty() {
        return Err(LoadError::Empty { file: source.file });
    }
    let like = Format::of_mark(&bytes).filter(|like| *like != format);
    let read = || {
        let read = match format {
            Format::Gltf => gltf::read,
            Format::Obj => obj::read,
            Format::Ply => ply::read,
            Format::Stl => stl::read,
            Format::Off => off::read,
            // It has its origin already, and a hierarchy over what lies around it.
            Format::Slim => return slim::read_scene(&source, &bytes),
        };
        read(&source, bytes).map(Found::into_scene)
    };
    match contain(read) {
        Ok(read) => match (read.and_then(|scene| finish(scene, &source)), like) {
            (Err(_), Some(like)) => Err(LoadError::OtherFormat {
                file: source.file,
                format: format.name(),
                like: like.name(),
            }),
            (read, _) => read,
        },
        Err(message) => Err(LoadError::Panicked {
            file: source.file,
            format: format.name(),
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
    pub left_out: RefCell<Vec<LeftOut>>,
}

/// What a reader finds. Positions in `f64` are apart from the scene, whose own are ignored then.
#[derive(Default)]
pub(super) struct Found {
    pub scene: Scene,
    pub vertices: Vertices,
    /// The eye and the target of each camera.
    pub cameras: Vec<[[f64; 3]; 2]>,
    /// The place of each light that has one; anything for others.
    pub lights: Vec<[f64; 3]>,
}

impl Found {
    /// The scene around its local origin.
    fn into_scene(self) -> Scene {
        let Self {
            mut scene,
            vertices,
            cameras,
            lights,
        } = self;
        let (vertices, origin) = vertices.narrowed(&scene.mesh.indices);
        scene.mesh.vertices = vertices;
        if origin == [0.0; 3] {
            return scene;
        }
        scene.origin = origin;
        for (place, [eye, target]) in cameras.into_iter().enumerate() {
            let [eye, target] = [eye, target].map(|at| scene.to_local(at));
            if let Some(camera) = scene.cameras.get_mut(place) {
                (camera.eye, camera.target) = (eye, target);
            }
        }
        for (place, at) in lights.into_iter().enumerate() {
            let near = scene.to_local(at);
            match scene.lights.get_mut(place) {
                None | Some(Light::Directional { .. }) => {}
                Some(Light::Point { position: at, .. } | Light::Area { center: at, .. }) => {
                    *at = near;
                }
            }
        }
        scene
    }
}

impl<'a> Source<'a> {
    fn new(path: &'a Path, options: &'a LoadOptions) -> Self {
        Self {
            path,
            file: path.display().to_string(),
            options,
            left_out: RefCell::default(),
        }
    }
}

impl Source<'_> {
    /// Notes what the file holds and the scene does not. Kinds beyond the first are one.
    pub fn leave_out(&self, what: &str, count: usize) {
        if count == 0 {
            return;
        }
        let mut all = self.left_out.borrow_mut();
        let is_known = all.iter().any(|known| known.what == what);
        let what = match is_known || all.len() < MOST_KINDS {
            true => what,
            false => "other things",
        };
        match all.iter_mut().find(|known| known.what == what) {
            Some(known) => known.count += count,
            None => all.push(LeftOut {
                what: what.to_owned(),
                count,
            }),
        }
    }

    /// A path in the file, relative to the file.
    pub fn beside(&self, relative: impl AsRef<Path>) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(relative)
    }
}

/// The format by the options, else by the extension.
fn format(source: &Source<'_>) -> Result<Format, LoadError> {
    let given = source.options.format.or(Format::of_path(source.path));
    given.ok_or_else(|| {
        let file = source.file.clone();
        match source.path.extension() {
            None => LoadError::NoExtension { file },
            Some(extension) => LoadError::UnknownExtension {
                file,
                extension: extension.to_string_lossy().into_owned(),
            },
        }
    })
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
    scene.left_out.append(&mut source.left_out.borrow_mut());
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
            point_count: scene.mesh.vertices.len(),
            left_out: scene.left_out,
        });
    }
    Ok(scene)
}
