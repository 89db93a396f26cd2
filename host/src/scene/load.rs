//! Reads a scene from a file.

use super::contain::contain;
use super::vertices::Vertices;
use super::{LeftOut, Light, LoadError, Scene, gltf, obj, off, ply, slim, stl};
use std::cell::RefCell;
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
/// Skins and morph targets are at the file's pose. [`Scene::left_out`] lists what is not read, such as textures and animations.
/// Files that the scene refers to are read too: buffers of a glTF scene, and material libraries of an OBJ scene, which may be
/// missing.
///
/// # Errors
/// If the file cannot be read, does not follow its format, or has a broken face and `options` are not lenient.
pub fn load(path: &Path, options: &LoadOptions) -> Result<Scene, LoadError> {
    let source = Source::new(path, options);
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
    let source = Source::new(path, options);
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
        Ok(found) => finish(found?.into_scene(), &source),
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
    left_out: RefCell<Vec<LeftOut>>,
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

impl From<Scene> for Found {
    fn from(mut scene: Scene) -> Self {
        let wide = |[x, y, z]: [f32; 3]| [f64::from(x), f64::from(y), f64::from(z)];
        let vertices = std::mem::take(&mut scene.mesh.vertices);
        let cameras = scene.cameras.iter();
        let lights = scene.lights.iter().map(|light| match light {
            Light::Directional { .. } => [0.0; 3],
            Light::Point { position: at, .. } | Light::Area { center: at, .. } => wide(*at),
        });
        Self {
            vertices: Vertices::Narrow(vertices),
            cameras: cameras
                .map(|camera| [wide(camera.eye), wide(camera.target)])
                .collect(),
            lights: lights.collect(),
            scene,
        }
    }
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
        // A file in the library's own format has one already.
        if origin == [0.0; 3] {
            return scene;
        }
        let near = |at: &[f64; 3]| [0, 1, 2].map(|i| (at[i] - origin[i]) as f32);
        for (camera, [eye, target]) in scene.cameras.iter_mut().zip(&cameras) {
            (camera.eye, camera.target) = (near(eye), near(target));
        }
        for (light, place) in scene.lights.iter_mut().zip(&lights) {
            match light {
                Light::Directional { .. } => {}
                Light::Point { position: at, .. } | Light::Area { center: at, .. } => {
                    *at = near(place);
                }
            }
        }
        scene.origin = origin;
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
    /// Notes what the file holds and the scene does not.
    pub fn leave_out(&self, what: &str, count: usize) {
        if count == 0 {
            return;
        }
        let mut all = self.left_out.borrow_mut();
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

type Reader = fn(&Source<'_>, Vec<u8>) -> Result<Found, LoadError>;

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
        });
    }
    Ok(scene)
}
