//! Every changed file is rejected, or its content is sound.

mod hierarchy;

use super::layout::{CHECKSUM, Header, Section, checksum};
use super::*;
use crate::generate::icosphere;
use crate::{
    AreaShape, BuildConfig, Builder, Camera, Light, Material, MeshCodec, NodeCodec, Part, Picture,
    Projection, RenderSettings, Renderer, Up,
};
use glam::Vec3;
use slimbvh_core::Ray;

/// All pairs of codecs, but of the laboratory's only one for each size of nodes: 3, 4, 5 and 7 words.
fn configs() -> Vec<BuildConfig> {
    let mut configs = Vec::new();
    for mesh in MeshCodec::ALL.map(|mesh| mesh.with_step(Some(-12))) {
        let nodes = mesh.nodes();
        let nodes = nodes.filter(|nodes| !["q6", "q8", "q16"].contains(&nodes.name()));
        configs.extend(nodes.map(|nodes| BuildConfig {
            nodes,
            mesh,
            ..BuildConfig::default()
        }));
    }
    configs
}

/// A scene with every kind of content, around a ball on the lattice of step 2^-12.
fn scene(subdivisions: u32) -> Scene {
    let mut mesh = icosphere(Vec3::new(1.0, -2.0, 0.5), 1.0, subdivisions);
    mesh.snap(-12);
    let count = mesh.indices.len() as u32;
    mesh.normals = vec![[0.0, 0.6, 0.8]; mesh.vertices.len()];
    mesh.materials = (0..count).map(|triangle| triangle % 2).collect();
    let part = |name: &str, first_triangle, triangle_count| Part {
        name: name.into(),
        first_triangle,
        triangle_count,
    };
    mesh.parts = vec![
        part("größer", 0, 7),
        part("", 7, 0),
        part("b", 7, count - 7),
    ];
    let camera = Camera {
        eye: [4.0, 1.0, 5.0],
        target: [1.0, -2.0, 0.5],
        up: [0.0, 1.0, 0.0],
        projection: Projection::ThinLens {
            vertical_fov: 40.0,
            radius: 0.125,
            focus_distance: 6.0,
        },
    };
    let parallel = Camera {
        projection: Projection::Orthographic { height: 3.0 },
        ..camera
    };
    Scene {
        mesh,
        materials: vec![
            Material::default(),
            Material {
                base_color: [0.25, 1.0, 0.0],
                mirror: 0.5,
                transmission: 0.75,
                ior: 1.5,
                double_sided: false,
            },
        ],
        cameras: vec![camera, parallel],
        lights: vec![
            Light::Directional {
                direction: [0.0, -1.0, -0.5],
                color: [1.0, 2.0, 3.0],
            },
            Light::Point {
                position: [3.0, 3.0, 3.0],
                color: [9.0; 3],
                range: 40.0,
            },
            Light::disc([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], 0.5, [8.0; 3]),
            Light::Area {
                center: [0.0, 4.0, 0.0],
                half_edges: [[1.0, 0.0, 0.0], [0.0, 0.0, 2.0]],
                shape: AreaShape::Rectangle,
                color: [7.0; 3],
                range: f32::INFINITY,
            },
        ],
        dropped_face_count: 3,
        left_out: Vec::new(),
        origin: [4_649_776.25, -0.5, 1e300],
        up: Up::Z,
    }
}

fn framing() -> Option<Aabb> {
    Some(Aabb {
        min: Vec3::new(-1.0, -2.0, -3.0),
        max: Vec3::new(1.0, 2.0, 4.0),
    })
}

fn saved(subdivisions: u32, config: BuildConfig) -> Vec<u8> {
    let scene = scene(subdivisions);
    let bvh = Builder::new(config)
        .build(&scene.mesh)
        .expect("it is sound");
    again(&scene, &bvh, framing())
}

fn again(scene: &Scene, bvh: &Bvh, framing: Option<Aabb>) -> Vec<u8> {
    let mut bytes = Vec::new();
    let length = write(scene, bvh, framing, &mut bytes).expect("it is sound");
    assert_eq!(length, bytes.len() as u64);
    bytes
}

/// Corrects the checksum.
fn repair(bytes: &mut [u8]) {
    let sum = checksum(bytes);
    bytes[CHECKSUM].copy_from_slice(&sum.to_le_bytes());
}

/// Rays from all around, toward the vertices and past them.
fn rays(scene: &Scene) -> impl Iterator<Item = Ray> {
    let targets = scene.mesh.vertices.iter().take(12);
    let eyes = [[4.0, 1.0, 5.0], [1.0, -2.0, 0.5], [-9.0, -2.0, 0.5]];
    targets.flat_map(move |target| {
        eyes.map(|eye: [f32; 3]| Ray::new(eye, [0, 1, 2].map(|axis| target[axis] - eye[axis])))
    })
}

/// Uses the loaded scene in every way: rays, pictures, decoding, and refits into other codecs.
fn use_it(saved: &mut Saved, is_thorough: bool) {
    let Saved { scene, bvh, .. } = saved;
    assert_eq!(bvh.validate_over(&scene.mesh), Ok(()));
    for ray in rays(scene) {
        let hit = bvh.closest_hit(ray);
        assert_eq!(bvh.any_hit(ray), hit.is_hit());
        assert_eq!(bvh.nearest_hits::<4>(&ray)[0].t.to_bits(), hit.t.to_bits());
        assert!(!hit.is_hit() || (hit.primitive as usize) < scene.mesh.indices.len());
    }
    if !is_thorough {
        return;
    }
    scene.complete(scene.mesh.bounds(), [4, 3]);
    let settings = RenderSettings {
        size: [4, 3],
        ..RenderSettings::default()
    };
    let mut picture = Picture::default();
    let rendered = Renderer::new().render(scene, bvh, &settings, &mut picture, |_| {});
    // The camera may be too far away; no other error is allowed.
    assert!(rendered.is_ok() || scene.cameras[0].check_reach(bvh.scene_exponent).is_err());
    let decoded = bvh.decoded();
    assert_eq!(decoded.validate(), Ok(()));
    if bvh.triangle_count() == bvh.mesh_triangle_count() {
        let names = ["paper10", "q10", "w4-64"];
        for nodes in names.into_iter().filter_map(NodeCodec::named) {
            let config = BuildConfig {
                nodes,
                ..BuildConfig::default()
            };
            let mut refitted = bvh.clone();
            let outcome = Builder::new(config).refit(&scene.mesh, &mut refitted);
            assert!(outcome.is_ok());
            assert_eq!(refitted.validate_over(&scene.mesh), Ok(()));
        }
    }
}

#[test]
fn what_is_read_is_what_was_written() {
    for config in configs() {
        for subdivisions in [0, 2] {
            let bytes = saved(subdivisions, config);
            let mut read = read(&bytes).expect("it was just written");
            let before = scene(subdivisions);
            assert_eq!(read.scene.mesh, before.mesh);
            assert_eq!(read.scene.materials, before.materials);
            assert_eq!(read.scene.cameras, before.cameras);
            assert_eq!(read.scene.lights, before.lights);
            assert_eq!(read.scene.dropped_face_count, before.dropped_face_count);
            assert_eq!(read.scene.origin, before.origin);
            assert_eq!(read.scene.up, before.up);
            assert_eq!(read.framing, framing());
            assert_eq!(read.bvh.codecs(), (config.nodes, config.mesh));
            assert!(again(&read.scene, &read.bvh, read.framing) == bytes);
            use_it(&mut read, true);
        }
    }
}

#[test]
fn empty_and_tiny_meshes_are_saved_too() {
    for config in configs() {
        for count in 0..6 {
            let mut scene = Scene::default();
            scene.mesh.vertices = vec![[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.25, 0.0]];
            scene.mesh.indices = vec![[0, 1, 2]; count];
            let bvh = Builder::new(config)
                .build(&scene.mesh)
                .expect("it is sound");
            let bytes = again(&scene, &bvh, None);
            let mut read = read(&bytes).expect("it was just written");
            assert!(again(&read.scene, &read.bvh, None) == bytes);
            use_it(&mut read, true);
        }
    }
}

/// Parts of files are at the documented addresses.
#[test]
fn bytes_lie_where_the_layout_says() {
    let bytes = saved(2, BuildConfig::default());
    let word =
        |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    assert_eq!(bytes[..8], *b"\x89SLIM\r\n\x1a");
    assert_eq!(bytes[8..12], [4, 3, 2, 1]);
    assert_eq!(
        [word(12), word(20), word(24), word(28)],
        [2, 13, bytes.len() as u32, 0]
    );
    let mut end = 64 + 13 * 32_usize;
    for section in 0..13 {
        let at = 64 + 32 * section;
        assert_eq!(word(at), section as u32 + 1);
        let begin = word(at + 8) as usize;
        assert_eq!(begin, end.next_multiple_of(256));
        end = begin + word(at + 16) as usize;
    }
    assert_eq!(end, bytes.len());
    // The last word of the first triangle in leaf order is its index in the mesh.
    let at = word(64 + 32 * 12 + 8) as usize + 36;
    assert!(word(at) < 320);
    let vertex = word(64 + 8) as usize;
    assert_eq!(f32::from_bits(word(vertex)), scene(2).mesh.vertices[0][0]);
}

#[test]
fn every_changed_byte_is_found() {
    for config in configs() {
        let sound = saved(0, config);
        for at in 0..sound.len() {
            for mask in [0x01, 0x10, 0x80, 0xff] {
                let mut bytes = sound.clone();
                bytes[at] ^= mask;
                assert!(read(&bytes).is_err(), "{config:?} {at} {mask}");
            }
        }
    }
}

/// Hierarchies in the laboratory's codecs are read with it, and refused by name without.
#[test]
fn codecs_of_the_laboratory_are_read_there_only() {
    let mut bytes = saved(1, BuildConfig::default());
    let record = 64 + 32 * (Section::Hierarchy as usize - 1);
    let begin = bytes[record + 8..record + 12]
        .try_into()
        .map(u32::from_le_bytes);
    let begin = begin.expect("it has four bytes") as usize;
    for (word, tag) in [2u32, 10].iter().enumerate() {
        bytes[begin + 4 * word..][..4].copy_from_slice(&tag.to_le_bytes());
    }
    repair(&mut bytes);
    let error = read(&bytes).expect_err("nodes are in full");
    if cfg!(feature = "lab") {
        assert!(matches!(error, FileError::ItemBytes { .. }), "{error}");
    } else {
        assert_eq!(error, FileError::LabCodec { bits: 10 });
        for word in ["q10", "w4-48", "`lab`"] {
            assert!(error.to_string().contains(word), "{error}");
        }
    }
}

#[test]
fn files_cut_or_grown_anywhere_are_refused() {
    for config in configs() {
        let sound = saved(0, config);
        for length in 0..sound.len() {
            let cut = read(&sound[..length]).err();
            assert!(
                matches!(
                    cut,
                    Some(FileError::HeaderCut { .. } | FileError::Length { .. })
                ),
                "{length} {cut:?}"
            );
            // The same with a matching header.
            let mut bytes = sound[..length].to_vec();
            if length >= size_of::<Header>() {
                bytes[24..32].copy_from_slice(&(length as u64).to_le_bytes());
                repair(&mut bytes);
                assert!(read(&bytes).is_err(), "{length}");
            }
        }
        let mut grown = sound.clone();
        grown.push(0);
        assert!(matches!(read(&grown), Err(FileError::Length { .. })));
        grown[24..32].copy_from_slice(&(sound.len() as u64 + 1).to_le_bytes());
        repair(&mut grown);
        assert!(matches!(read(&grown), Err(FileError::End { .. })));
    }
}

/// Each byte of a small file changed in several ways, and each word set to numbers that are hard to get right, with the checksum
/// put right.
#[test]
fn whatever_passes_with_a_right_checksum_is_sound() {
    let mut accepted = 0;
    let mut refused = 0;
    let mut try_it = |mut bytes: Vec<u8>, what: &dyn Fn() -> String| {
        repair(&mut bytes);
        match read(&bytes) {
            Err(_) => refused += 1,
            Ok(mut saved) => {
                let written = again(&saved.scene, &saved.bvh, saved.framing);
                assert!(written == bytes, "{}", what());
                use_it(&mut saved, accepted % 16 == 0);
                accepted += 1;
            }
        }
    };
    for config in configs() {
        let sound = saved(1, config);
        for at in 0..sound.len() {
            for mask in [0x01, 0x80, 0xff] {
                let mut bytes = sound.clone();
                bytes[at] ^= mask;
                try_it(bytes, &|| format!("{config:?} byte {at} ^ {mask}"));
            }
        }
        for at in (0..sound.len() - 3).step_by(4) {
            for word in [
                0,
                1,
                4,
                0x7fff_ffff,
                0x8000_0000,
                u32::MAX,
                f32::NAN.to_bits(),
                f32::INFINITY.to_bits(),
                f32::MAX.to_bits(),
                (1u32 << 24) + 1,
            ] {
                let mut bytes = sound.clone();
                bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
                try_it(bytes, &|| format!("{config:?} word at {at} = {word:x}"));
            }
        }
    }
    println!("{accepted} accepted, {refused} refused");
    // Materials, lights, and slack of boxes may differ.
    assert!(accepted > 1000 && refused > 5 * accepted);
}

/// Exchanged sections, with a correct checksum.
#[test]
fn sections_elsewhere_are_refused() {
    let sound = saved(1, BuildConfig::default());
    for section in 0..13 {
        for (field, name) in [
            (0, "kind"),
            (4, "item"),
            (8, "begin"),
            (16, "length"),
            (20, "high"),
        ] {
            for change in [1, 256, u32::MAX, u32::MAX - 255] {
                let mut bytes = sound.clone();
                let at = 64 + 32 * section + field;
                let word = [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]];
                let word = u32::from_le_bytes(word).wrapping_add(change);
                bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
                repair(&mut bytes);
                assert!(read(&bytes).is_err(), "{name} of {section}");
            }
        }
    }
}

#[test]
fn refusals_say_what_is_wrong() {
    let sound = saved(0, BuildConfig::default());
    let refusal = |bytes: &[u8]| read(bytes).map(|_| ()).unwrap_err().to_string();
    let spoilt = |at: usize, with: &[u8]| {
        let mut bytes = sound.clone();
        bytes[at..at + with.len()].copy_from_slice(with);
        bytes
    };
    assert_eq!(
        refusal(b""),
        "it ends within its header: it has 0 bytes of 480"
    );
    assert!(refusal(b"solid cube\n  facet").contains("begins with \"solid cube\u{fffd}"));
    assert!(refusal(b"\x89PNG\r\n\x1a\n").contains("PNG"));
    assert!(refusal(&spoilt(8, &[1, 2, 3, 4])).contains("big-endian"));
    for version in [1, 7] {
        let refusal = refusal(&spoilt(12, &[version]));
        assert!(refusal.contains(&format!(
            "version {version}, and this slimbvh reads version 2"
        )));
    }
    assert!(refusal(&sound[..1000]).contains("ends early"));
    assert!(refusal(&spoilt(777, &[9])).contains("damaged"));
    let mut bytes = spoilt(500, &[1]);
    repair(&mut bytes);
    assert_eq!(
        refusal(&bytes),
        "byte 500 is not 0, but all bytes between the sections must be"
    );
}

/// Invalid content is not written.
#[test]
fn what_is_not_sound_is_not_written() {
    let sound = scene(1);
    let bvh = Builder::default().build(&sound.mesh).expect("it is sound");
    let refusal = |spoil: &dyn Fn(&mut Scene)| {
        let mut scene = sound.clone();
        spoil(&mut scene);
        let mut bytes = Vec::new();
        let error = write(&scene, &bvh, None, &mut bytes)
            .map(|_| ())
            .unwrap_err();
        assert!(bytes.is_empty());
        error.to_string()
    };
    let moved = refusal(&|scene| scene.mesh.vertices[5][0] *= 0.5);
    assert!(
        moved.contains("other corners") || moved.contains("other bounds"),
        "{moved}"
    );
    let fewer = refusal(&|scene| {
        scene.mesh.indices.pop();
        scene.mesh.materials.pop();
        scene.mesh.parts.clear();
    });
    assert!(fewer.contains("79 triangles"), "{fewer}");
    assert!(refusal(&|scene| scene.mesh.materials[9] = 2).contains("triangle 9 has material 2"));
    assert!(refusal(&|scene| scene.mesh.normals[3][1] = f32::NAN).contains("vertex 3"));
    assert!(refusal(&|scene| scene.materials[1].mirror = 1.5).contains("material 1"));
    assert!(refusal(&|scene| scene.cameras[1].up[0] = f32::NAN).contains("camera 2"));
    let dark = |scene: &mut Scene| {
        scene.lights[0] = Light::Directional {
            direction: [0.0; 3],
            color: [1.0; 3],
        };
    };
    assert!(refusal(&dark).contains("light 1"));
}

/// A full disk is an error; the partly written file stays.
#[test]
fn errors_of_the_system_are_told() {
    struct Full(usize);
    impl std::io::Write for Full {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0 = self
                .0
                .checked_sub(bytes.len())
                .ok_or(std::io::ErrorKind::StorageFull)?;
            Ok(bytes.len())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let scene = scene(1);
    let bvh = Builder::default().build(&scene.mesh).expect("it is sound");
    for room in [0, 500, 3000] {
        let outcome = write(&scene, &bvh, None, Full(room));
        assert!(matches!(outcome, Err(WriteError::Io(_))));
    }
}
