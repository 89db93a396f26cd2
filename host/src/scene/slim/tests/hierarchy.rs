//! Files of a hierarchy alone: every changed file is rejected, or its hierarchy is sound.

use super::{configs, rays, repair, saved, scene};
use crate::scene::slim::layout::Section;
use crate::scene::slim::{FileError, read, read_hierarchy, write_hierarchy};
use crate::{BuildConfig, Builder, Bvh, MeshCodec, NodeCodec};

fn alone(bvh: &Bvh) -> Vec<u8> {
    let mut bytes = Vec::new();
    let length = write_hierarchy(bvh, &mut bytes).expect("it is sound");
    assert_eq!(length, bytes.len() as u64);
    bytes
}

fn built(subdivisions: u32, config: BuildConfig) -> Bvh {
    let mesh = scene(subdivisions).mesh;
    Builder::new(config).build(&mesh).expect("it is sound")
}

/// The first byte of a section.
fn begin(bytes: &[u8], section: Section) -> usize {
    let record = 64 + 32 * (section as usize - 1);
    let word = bytes[record + 8..record + 12]
        .try_into()
        .map(u32::from_le_bytes);
    word.expect("it has four bytes") as usize
}

#[test]
fn the_hierarchy_that_is_read_is_the_one_written() {
    for config in configs() {
        for subdivisions in [0, 2] {
            let bvh = built(subdivisions, config);
            let bytes = alone(&bvh);
            let read = read_hierarchy(&bytes).expect("it was just written");
            let scene = scene(subdivisions);
            assert_eq!(read.codecs(), (config.nodes, config.mesh));
            assert_eq!(read.validate_over(&scene.mesh), Ok(()));
            assert!(alone(&read) == bytes);
            for ray in rays(&scene) {
                assert_eq!(read.closest_hit(ray), bvh.closest_hit(ray));
            }
            // The mesh is not in the file.
            let with_scene = saved(subdivisions, config).len();
            assert!(bytes.len() + 12 * scene.mesh.indices.len() < with_scene);
        }
    }
}

/// Each of the two readers refuses the other's file, and names the right one.
#[test]
fn files_with_and_without_a_scene_are_told_apart() {
    let config = BuildConfig::default();
    let without = alone(&built(1, config));
    let refusal = read(&without).expect_err("it has no scene");
    assert_eq!(refusal, FileError::NoScene);
    assert!(
        refusal.to_string().contains("slim::read_hierarchy"),
        "{refusal}"
    );
    let with = saved(1, config);
    let refusal = read_hierarchy(&with).expect_err("it has a scene");
    assert_eq!(refusal, FileError::HasScene);
    assert!(refusal.to_string().contains("slim::read`"), "{refusal}");
    // Facts of a scene without geometry are no hierarchy alone.
    let mut with = without;
    let dropped = begin(&with, Section::Scene) + 32;
    with[dropped] = 1;
    repair(&mut with);
    assert_eq!(read_hierarchy(&with).err(), Some(FileError::HasScene));
}

/// An empty tree over an empty mesh is an empty scene's, too: both readers take it.
#[test]
fn hierarchies_over_nothing_are_saved_too() {
    for config in configs() {
        let bvh = Builder::new(config).build(&crate::Mesh::default());
        let bytes = alone(&bvh.expect("it is sound"));
        assert!(read_hierarchy(&bytes).is_ok() && read(&bytes).is_ok());
    }
}

#[test]
fn every_changed_byte_is_found() {
    for config in configs() {
        let sound = alone(&built(0, config));
        assert!(read_hierarchy(&sound).is_ok());
        for at in 0..sound.len() {
            for mask in [0x01, 0x80, 0xff] {
                let mut bytes = sound.clone();
                bytes[at] ^= mask;
                assert!(read_hierarchy(&bytes).is_err(), "{config:?} {at} {mask}");
            }
        }
        for length in 0..sound.len() {
            assert!(read_hierarchy(&sound[..length]).is_err(), "{length}");
        }
    }
}

/// Each word of a small file set to numbers that are hard to get right, with the checksum put right: whatever is read can be
/// traced and is written again byte for byte.
#[test]
fn whatever_passes_with_a_right_checksum_is_sound() {
    let (mut accepted, mut refused) = (0, 0);
    for config in configs() {
        let scene = scene(1);
        let sound = alone(&built(1, config));
        for at in (0..sound.len() - 3).step_by(4) {
            for word in [0, 1, 0x8000_0000, u32::MAX, 0x7fc0_0000, f32::MAX.to_bits()] {
                let mut bytes = sound.clone();
                bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
                repair(&mut bytes);
                let Ok(bvh) = read_hierarchy(&bytes) else {
                    refused += 1;
                    continue;
                };
                accepted += 1;
                assert!(alone(&bvh) == bytes, "{config:?} word at {at} = {word:x}");
                assert_eq!(bvh.decoded().validate(), Ok(()));
                for ray in rays(&scene).take(6) {
                    let hit = bvh.closest_hit(ray);
                    assert_eq!(bvh.any_hit(ray), hit.is_hit());
                    assert!(!hit.is_hit() || (hit.primitive as usize) < bvh.mesh_triangle_count());
                }
            }
        }
    }
    // Triangles may lie elsewhere within their boxes.
    assert!(
        accepted > 100 && refused > 2 * accepted,
        "{accepted} {refused}"
    );
}

/// Planted: a box that its triangles leave, and a triangle that is in two leaves. A triangle elsewhere within its box is found by
/// who has the mesh.
#[test]
fn planted_faults_are_found() {
    let config = BuildConfig::default();
    let sound = alone(&built(1, config));
    let spoilt = |section: Section, offset: usize, word: u32| {
        let mut bytes = sound.clone();
        let at = begin(&bytes, section) + offset;
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        repair(&mut bytes);
        read_hierarchy(&bytes)
    };
    assert!(
        spoilt(Section::Triangles, 36, 80).is_err(),
        "of 80 triangles"
    );
    let second = begin(&sound, Section::Triangles) + 40 + 36;
    let number = sound[second..second + 4].try_into().map(u32::from_le_bytes);
    let refusal = spoilt(Section::Triangles, 36, number.expect("it has four bytes"));
    assert!(refusal.is_err(), "a triangle is there twice");
    // The first corner of the first triangle, at another one.
    let corner = begin(&sound, Section::Triangles) + 12;
    let moved = u32::from_le_bytes([
        sound[corner],
        sound[corner + 1],
        sound[corner + 2],
        sound[corner + 3],
    ]);
    let read = spoilt(Section::Triangles, 0, moved).expect("it is within its box");
    assert!(read.validate_over(&scene(1).mesh).is_err());
    assert!(spoilt(Section::Triangles, 0, 9e9f32.to_bits()).is_err());
}

/// What is not sound is not written.
#[test]
fn unsound_hierarchies_are_not_written() {
    let mut bvh = built(1, BuildConfig::default());
    bvh.scene_exponent += 1;
    let mut bytes = Vec::new();
    assert!(write_hierarchy(&bvh, &mut bytes).is_err());
    assert!(bytes.is_empty());
    let (nodes, mesh) = (NodeCodec::F32, MeshCodec::F32);
    assert_eq!(bvh.codecs(), (nodes, mesh));
}
