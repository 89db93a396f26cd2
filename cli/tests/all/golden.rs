//! Golden pictures, checked by eye and kept in `tests/golden`. `UPDATE_GOLDEN=1` rewrites them.

use crate::shading_is_right::render;
use slimbvh::generate::default_scene;
use slimbvh::scene::{LoadOptions, load};
use slimbvh::{Picture, RenderSettings, Scene, View};
use slimbvh_core::Aabb;
use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

/// Largest difference allowed in a channel: trigonometry differs between platforms in the last bit.
const TOLERANCE: u8 = 2;

/// One pixel in this many may differ by more, because an edge may fall on its other side.
const PIXELS_FOR_ONE_OUTLIER: usize = 1000;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

/// 8-bit pixels with three or one channels.
#[derive(Clone, PartialEq)]
struct Bytes {
    size: [u32; 2],
    rgb: Vec<u8>,
}

impl Bytes {
    fn of(picture: &Picture) -> Self {
        Self {
            size: [picture.width, picture.height],
            rgb: picture.to_srgb(),
        }
    }

    fn read(path: &Path) -> Result<Self, String> {
        let fault = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let file = File::open(path).map_err(|error| fault(&error))?;
        let mut reader = png::Decoder::new(BufReader::new(file))
            .read_info()
            .map_err(|error| fault(&error))?;
        let mut rgb = vec![0; reader.output_buffer_size().unwrap_or(0)];
        let frame = reader.next_frame(&mut rgb).map_err(|error| fault(&error))?;
        if frame.color_type == png::ColorType::Grayscale {
            rgb = rgb.iter().flat_map(|&gray| [gray; 3]).collect();
        }
        let size = [frame.width, frame.height];
        Ok(Self { size, rgb })
    }

    /// Writes the picture as a PNG file, with one channel if it is gray.
    fn write(&self, path: &Path) {
        let file = File::create(path).expect("the golden pictures are ours to write");
        let mut encoder = png::Encoder::new(BufWriter::new(file), self.size[0], self.size[1]);
        encoder.set_compression(png::Compression::High);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let is_gray = self
            .rgb
            .chunks(3)
            .all(|pixel| pixel[0] == pixel[1] && pixel[1] == pixel[2]);
        let pixels = if is_gray {
            encoder.set_color(png::ColorType::Grayscale);
            self.rgb.iter().step_by(3).copied().collect()
        } else {
            encoder.set_color(png::ColorType::Rgb);
            self.rgb.clone()
        };
        let mut writer = encoder.write_header().expect("the picture has pixels");
        writer
            .write_image_data(&pixels)
            .expect("the pixels fill the picture");
        writer
            .finish()
            .expect("the golden pictures are ours to write");
    }
}

/// Compares pixel by pixel.
fn compare(found: &Bytes, golden: &Bytes) -> Result<(), String> {
    if found.size != golden.size {
        return Err(format!(
            "{:?} pixels instead of {:?}",
            found.size, golden.size
        ));
    }
    let pairs = found.rgb.chunks(3).zip(golden.rgb.chunks(3));
    let differs =
        |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > TOLERANCE);
    let outliers = pairs.filter(differs).count();
    let most = found.rgb.len() / 3 / PIXELS_FOR_ONE_OUTLIER;
    if outliers > most {
        return Err(format!(
            "{outliers} pixels differ by more than {TOLERANCE}; at most {most} may"
        ));
    }
    Ok(())
}

/// Compares with the golden picture of this name, and leaves a differing picture in the temporary folder.
#[track_caller]
fn check(name: &str, picture: &Picture) {
    let path = folder().join(name).with_extension("png");
    let found = Bytes::of(picture);
    if std::env::var_os("UPDATE_GOLDEN").is_some_and(|update| update == "1") {
        found.write(&path);
    }
    if let Err(fault) = Bytes::read(&path).and_then(|golden| compare(&found, &golden)) {
        let left = std::env::temp_dir().join(format!("slimbvh-{name}.png"));
        found.write(&left);
        panic!(
            "{name}: {fault}; see {}, and if it is right, run with UPDATE_GOLDEN=1",
            left.display()
        );
    }
}

fn picture(scene: &Scene, view: View, sample_count: u32) -> Picture {
    let settings = RenderSettings {
        size: [320, 180],
        sample_count,
        view,
        ..RenderSettings::default()
    };
    render(scene, &settings).0
}

#[test]
fn the_default_scene_in_color() {
    check("color", &picture(&default_scene(), View::Color, 4));
}

#[test]
fn the_default_scene_in_normals() {
    check("normals", &picture(&default_scene(), View::Normals, 1));
}

#[test]
fn the_default_scene_in_depth() {
    check("depth", &picture(&default_scene(), View::Depth, 1));
}

#[test]
fn the_default_scene_in_primitives() {
    check(
        "primitives",
        &picture(&default_scene(), View::Primitives, 1),
    );
}

#[test]
fn the_default_scene_in_heat() {
    check("heatmap", &picture(&default_scene(), View::Heatmap, 1));
}

/// A scene file beside the golden pictures, with a default camera and light where it has none.
fn loaded(name: &str, size: [u32; 2]) -> Scene {
    let mut scene = load(&folder().join(name), &LoadOptions::default()).expect("the file is sound");
    let bounds = scene
        .mesh
        .vertices
        .iter()
        .fold(Aabb::EMPTY, |bounds, &vertex| {
            let point = glam::Vec3::from_array(vertex);
            bounds.union(Aabb {
                min: point,
                max: point,
            })
        });
    scene.complete(Some(bounds), size);
    scene
}

/// Nodes, camera, lights, materials and a mirror of a glTF scene.
#[test]
fn a_gltf_scene() {
    let scene = loaded("tiny.gltf", [320, 180]);
    assert_eq!(
        (
            scene.cameras.len(),
            scene.lights.len(),
            scene.materials.len()
        ),
        (1, 2, 3)
    );
    check("gltf", &picture(&scene, View::Color, 4));
}

/// Polygons and materials of an OBJ scene, under the default camera and light.
#[test]
fn an_obj_scene() {
    check(
        "obj",
        &picture(&loaded("tiny.obj", [320, 180]), View::Color, 4),
    );
}

/// Negative control: the comparison detects a slightly moved object and a slightly dimmed light.
#[test]
fn small_changes_are_seen() {
    let scene = default_scene();
    let golden = Bytes::of(&picture(&scene, View::Color, 4));
    assert_eq!(compare(&golden, &golden), Ok(()));

    let mut moved = scene.clone();
    let brick = scene
        .mesh
        .parts
        .iter()
        .find(|part| part.name == "brick")
        .expect("the scene has a brick");
    let first = brick.first_triangle as usize;
    let faces = &scene.mesh.indices[first..first + brick.triangle_count as usize];
    let vertices: std::collections::BTreeSet<u32> = faces.iter().flatten().copied().collect();
    for vertex in vertices {
        moved.mesh.vertices[vertex as usize][0] += 0.02;
    }
    let fault = compare(&Bytes::of(&picture(&moved, View::Color, 4)), &golden);
    println!("moved: {fault:?}");
    assert!(fault.is_err());

    let mut dimmed = scene.clone();
    if let slimbvh::Light::Point { color, .. } = &mut dimmed.lights[1] {
        *color = color.map(|x| x * 0.9);
    }
    let fault = compare(&Bytes::of(&picture(&dimmed, View::Color, 4)), &golden);
    println!("dimmed: {fault:?}");
    assert!(fault.is_err());

    // The tolerances of the comparison are exact.
    let with = |count: usize, by: u8| {
        let mut other = golden.clone();
        for pixel in other.rgb.chunks_mut(3).take(count) {
            pixel[1] = if pixel[1] > 127 {
                pixel[1] - by
            } else {
                pixel[1] + by
            };
        }
        compare(&other, &golden).is_ok()
    };
    assert!(with(320 * 180, TOLERANCE) && with(57, 100));
    assert!(!with(58, TOLERANCE + 1));
    let smaller = Bytes {
        size: [160, 360],
        ..golden.clone()
    };
    assert!(compare(&smaller, &golden).is_err());
}

#[test]
fn a_missing_golden_picture_is_a_failure() {
    assert!(Bytes::read(&folder().join("no such picture.png")).is_err());
}
