//! The loaders, through [`load`] and files on disk.

mod far;
mod gltf;
mod mutation;
mod obj;
mod off;
mod ply;
mod stl;

use super::{Format, LoadError, LoadOptions, Scene, load};
use std::path::PathBuf;
use tempfile::TempDir;

/// Corners of a box of 1×2×3; bits 0, 1 and 2 of a corner's number are its places along x, y and z.
const CORNERS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 2.0, 0.0],
    [1.0, 2.0, 0.0],
    [0.0, 0.0, 3.0],
    [1.0, 0.0, 3.0],
    [0.0, 2.0, 3.0],
    [1.0, 2.0, 3.0],
];

/// Its sides, counter-clockwise from outside.
const SIDES: [[u32; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];

/// A folder of files for one test.
struct Files(TempDir);

impl Files {
    fn new() -> Self {
        Self(TempDir::new().expect("a temporary folder"))
    }

    /// A folder with one file.
    fn with(name: &str, bytes: impl AsRef<[u8]>) -> Self {
        let files = Self::new();
        files.put(name, bytes);
        files
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, bytes: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), bytes).expect("a file in the temporary folder");
    }

    fn load_with(&self, name: &str, options: &LoadOptions) -> Result<Scene, LoadError> {
        load(&self.path(name), options)
    }

    fn load(&self, name: &str) -> Scene {
        self.load_with(name, &LoadOptions::default())
            .unwrap_or_else(|error| panic!("{error}"))
    }

    fn load_leniently(&self, name: &str) -> Scene {
        self.load_with(name, &lenient())
            .unwrap_or_else(|error| panic!("{error}"))
    }

    /// The message of the error, without the folder.
    fn refusal_with(&self, name: &str, options: &LoadOptions) -> String {
        let folder = format!("{}/", self.0.path().display());
        match self.load_with(name, options) {
            Ok(_) => panic!("{name} is loaded"),
            Err(error) => error.to_string().replace(&folder, ""),
        }
    }

    fn refusal(&self, name: &str) -> String {
        self.refusal_with(name, &LoadOptions::default())
    }
}

fn lenient() -> LoadOptions {
    LoadOptions {
        lenient: true,
        ..LoadOptions::default()
    }
}

/// What the scene leaves out, in words.
fn left_out(scene: &Scene) -> Vec<String> {
    scene.left_out.iter().map(ToString::to_string).collect()
}

/// The sum of a sixth of every triangle's determinant: the volume of a closed, counter-clockwise surface.
fn volume(scene: &Scene) -> f32 {
    let mesh = &scene.mesh;
    let corner = |vertex: u32| glam::Vec3::from_array(mesh.vertices[vertex as usize]);
    let six_times = |[a, b, c]: [u32; 3]| corner(a).dot(corner(b).cross(corner(c)));
    mesh.indices.iter().map(|t| six_times(*t)).sum::<f32>() / 6.0
}

/// Checks that the scene is the box of 1×2×3.
fn assert_is_box(scene: &Scene) {
    assert_eq!(scene.mesh.indices.len(), 12);
    assert_eq!(volume(scene), 6.0);
    for vertex in &scene.mesh.vertices {
        assert!(CORNERS.contains(vertex), "{vertex:?}");
    }
    assert_eq!(scene.mesh.validate(), Ok(()));
}

#[test]
fn the_extension_tells_the_format_in_any_case() {
    let files = Files::with("BOX.OFF", off::sample());
    assert_is_box(&files.load("BOX.OFF"));
    files.put("x.abc", "");
    assert_eq!(
        files.refusal("x.abc"),
        "\"x.abc\" has the extension \"abc\"; slimbvh reads gltf, glb, obj, ply, stl, off and slim"
    );
    assert_eq!(
        files.refusal("box"),
        "\"box\" has no extension; slimbvh reads gltf, glb, obj, ply, stl, off and slim"
    );
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let files = Files::new();
    assert_eq!(
        files.refusal("x.ply"),
        "cannot read \"x.ply\": No such file or directory (os error 2)"
    );
    std::fs::create_dir(files.path("folder.obj")).expect("a folder");
    assert_eq!(
        files.refusal("folder.obj"),
        "\"folder.obj\" is a folder or a device; name a file"
    );
}

#[test]
fn larger_files_than_allowed_are_not_read() {
    let files = Files::with("box.off", off::sample());
    let size = off::sample().len() as u64;
    let options = |max_file_bytes| LoadOptions {
        max_file_bytes,
        ..LoadOptions::default()
    };
    assert_is_box(
        &files
            .load_with("box.off", &options(size))
            .unwrap_or_else(|error| panic!("{error}")),
    );
    assert_eq!(
        files.refusal_with("box.off", &options(size - 1)),
        format!(
            "\"box.off\" has {size} bytes; at most {} bytes are read",
            size - 1
        )
    );
}

#[test]
fn empty_files_of_every_format_are_refused() {
    for extension in ["gltf", "glb", "obj", "ply", "stl", "off", "slim"] {
        let name = format!("x.{extension}");
        let refusal = Files::with(&name, "").refusal(&name);
        assert_eq!(refusal, format!("\"{name}\" is empty"));
    }
}

#[test]
fn files_of_another_format_than_their_name_says_are_told_so() {
    let glb = b"glTF\x02\0\0\0\x0c\0\0\0";
    let cases: [(&str, &[u8], &str); 6] = [
        ("x.stl", glb, "is not STL: it looks like glTF"),
        ("x.ply", glb, "is not PLY: it looks like glTF"),
        ("x.obj", b"ply\nformat", "is not OBJ: it looks like PLY"),
        ("x.off", b"solid x\n", "is not OFF: it looks like STL"),
        ("x.gltf", b"OFF\n1 0", "is not glTF: it looks like OFF"),
        ("x.slim", b"{}", "is not slim: it looks like glTF"),
    ];
    for (name, bytes, expected) in cases {
        let refusal = Files::with(name, bytes).refusal(name);
        assert_eq!(refusal, format!("\"{name}\" {expected}"));
    }
    let text = Files::with("x.stl", "v 0 0 0\nf 1 2 3\n".repeat(40));
    assert_eq!(
        text.refusal("x.stl"),
        "\"x.stl\" is not STL: it is text that does not begin with \"solid\" or \"facet\""
    );
    // A name that is wrong hides no sound file: the option tells its format.
    let files = Files::with("x.stl", off::sample());
    let off = LoadOptions {
        format: Some(Format::Off),
        ..LoadOptions::default()
    };
    assert_is_box(&files.load_with("x.stl", &off).expect("a box"));
}
