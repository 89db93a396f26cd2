//! For any bytes as a scene's file, the reader returns an error of one sentence, or a scene that can be built, traced and
//! rendered. No reader panics, not even where the loader would contain the panic.

use crate::oracle::brute::Parts;
use slimbvh::scene::{LoadError, LoadOptions, load_bytes};
use slimbvh::{BuildConfig, Builder, Picture, Ray, RenderSettings, Renderer, Scene, View};
use std::path::{Path, PathBuf};

/// glTF, text or binary.
///
/// # Panics
/// As the module says.
pub fn load_gltf(data: &[u8]) {
    check(Path::new("nowhere/x.gltf"), data);
}

/// OBJ. The bytes after the first zero are the material library `x.mtl`.
///
/// # Panics
/// As the module says.
pub fn load_obj(data: &[u8]) {
    let mut halves = data.splitn(2, |byte| *byte == 0);
    let (text, library) = (halves.next().unwrap_or_default(), halves.next());
    let Some(library) = library else {
        return check(Path::new("nowhere/x.obj"), text);
    };
    let folder = folder_with(library);
    check(&folder.join("x.obj"), text);
    let removed = std::fs::remove_dir_all(&folder);
    assert!(removed.is_ok(), "{removed:?}");
}

/// OFF.
///
/// # Panics
/// As the module says.
pub fn load_off(data: &[u8]) {
    check(Path::new("nowhere/x.off"), data);
}

/// PLY, text or binary.
///
/// # Panics
/// As the module says.
pub fn load_ply(data: &[u8]) {
    check(Path::new("nowhere/x.ply"), data);
}

/// STL, text or binary.
///
/// # Panics
/// As the module says.
pub fn load_stl(data: &[u8]) {
    check(Path::new("nowhere/x.stl"), data);
}

/// A temporary folder of this process with a library of materials.
fn folder_with(library: &[u8]) -> PathBuf {
    let name = format!("slimbvh-fuzz-{}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    let written = std::fs::create_dir_all(&folder)
        .and_then(|()| std::fs::write(folder.join("x.mtl"), library));
    assert!(written.is_ok(), "{written:?}");
    folder
}

fn check(path: &Path, data: &[u8]) {
    for lenient in [false, true] {
        let options = LoadOptions {
            lenient,
            max_file_bytes: 1 << 20,
            ..LoadOptions::default()
        };
        match load_bytes(path, data.to_vec(), &options) {
            Ok(scene) => use_it(scene),
            Err(LoadError::Panicked { message, .. }) => panic!("a reader panicked: {message}"),
            Err(error) => {
                let sentence = error.to_string();
                assert!(!sentence.contains('\n'), "{sentence}");
            }
        }
    }
}

/// Builds a tree, traces from the middle of the scene's box, and renders.
fn use_it(mut scene: Scene) {
    let mesh = &scene.mesh;
    assert_eq!(mesh.validate(), Ok(()));
    assert!(!mesh.indices.is_empty());
    let material_count = scene.materials.len().max(1);
    let mut materials = mesh.materials.iter();
    assert!(materials.all(|&material| (material as usize) < material_count));
    let built = Builder::new(BuildConfig::default()).build(mesh);
    let bvh = built.expect("the mesh is sound");
    let bounds = mesh.bounds().expect("there are triangles");
    let eye = (bounds.min * 0.5 + bounds.max * 0.5).to_array();
    for corner in mesh.indices.iter().flatten().take(6) {
        let target = mesh.vertices[*corner as usize];
        let ray = Ray::new(eye, [0, 1, 2].map(|axis| target[axis] - eye[axis]));
        let parts = Parts::from(&bvh);
        assert!(parts.ask_tree(&ray).same_bits(&parts.ask_all(&ray)));
    }

    // The only allowed failure is an error for an invalid camera or light.
    let settings = RenderSettings {
        size: [3, 2],
        sample_count: 1,
        view: View::Color,
        mirror_depth: 2,
        dark_rays: false,
    };
    scene.complete(Some(bounds), settings.size);
    let mut picture = Picture::default();
    let rendered = Renderer::new().render(&scene, &bvh, &settings, &mut picture, |_| {});
    assert!(rendered.is_err() || picture.pixels.len() == 6);
}
