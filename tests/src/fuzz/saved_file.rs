//! For any bytes behind the header of a saved hierarchy, with its scene or alone, with a corrected checksum, a file that is read is
//! sound, is written again byte for byte, and can be traced and refitted.

use slimbvh::scene::slim::{Saved, read, read_hierarchy, write, write_hierarchy};
use slimbvh::{BuildConfig, Builder, LatticeBits, MeshCodec, NodeCodec, WideStore};
use slimbvh_core::Ray;

/// Bytes of the header and the record of the scene.
const HEAD_BYTES: usize = 480;

/// See the module.
///
/// # Panics
/// If a file that was read is not sound.
pub fn saved_file(data: &[u8]) {
    // Unchanged; the reader seldom gets beyond the header.
    if let Ok(saved) = read(data) {
        assert_writes(&saved, data);
    }
    let bytes = repaired(data);
    hierarchy_alone(&bytes);
    let Ok(saved) = read(&bytes) else { return };
    assert_writes(&saved, &bytes);
    let mesh = &saved.scene.mesh;
    for target in mesh.vertices.iter().take(16) {
        for eye in [[0.0; 3], [3.0, -2.0, 1.0]] {
            let ray = Ray::new(eye, [0, 1, 2].map(|axis| target[axis] - eye[axis]));
            let hit = saved.bvh.closest_hit(ray);
            assert_eq!(saved.bvh.any_hit(ray), hit.is_hit());
            assert!(!hit.is_hit() || (hit.primitive as usize) < mesh.indices.len());
        }
    }
    if saved.bvh.triangle_count() == saved.bvh.mesh_triangle_count() {
        let own = saved.bvh.codecs();
        let q10 = (NodeCodec::Lattice(LatticeBits::Q10), MeshCodec::F32);
        let wide = (NodeCodec::Wide(WideStore::Exact), MeshCodec::F32);
        for (nodes, codec) in [q10, wide, own] {
            let config = BuildConfig {
                nodes,
                mesh: codec,
                ..BuildConfig::default()
            };
            let mut bvh = saved.bvh.clone();
            let refitted = Builder::new(config).refit(mesh, &mut bvh);
            assert!(refitted.is_ok(), "it was built over this mesh");
            assert_eq!(bvh.validate_over(mesh), Ok(()));
        }
    }
}

/// The same without a mesh, if the file holds a hierarchy alone.
fn hierarchy_alone(bytes: &[u8]) {
    let Ok(bvh) = read_hierarchy(bytes) else {
        return;
    };
    let mut written = Vec::new();
    let outcome = write_hierarchy(&bvh, &mut written);
    assert!(outcome.is_ok() && written == bytes);
    assert_eq!(bvh.decoded().validate(), Ok(()));
    let count = bvh.mesh_triangle_count();
    for direction in [[1.0, 0.5, 0.25], [-1.0, 2.0, 0.0], [0.0, 0.0, -1.0]] {
        for eye in [[0.0; 3], [3.0, -2.0, 1.0]] {
            let ray = Ray::new(eye, direction);
            let hit = bvh.closest_hit(ray);
            assert_eq!(bvh.any_hit(ray), hit.is_hit());
            assert!(!hit.is_hit() || (hit.primitive as usize) < count);
        }
    }
}

fn assert_writes(saved: &Saved, bytes: &[u8]) {
    let mut written = Vec::new();
    let outcome = write(&saved.scene, &saved.bvh, saved.framing, &mut written);
    assert!(outcome.is_ok() && written == bytes);
}

/// Corrects header and checksum, so that the reader looks at the rest.
fn repaired(data: &[u8]) -> Vec<u8> {
    let mut bytes = data.to_vec();
    bytes.resize(data.len().max(HEAD_BYTES), 0);
    let length = bytes.len() as u64;
    bytes[..8].copy_from_slice(b"\x89SLIM\r\n\x1a");
    bytes[8..12].copy_from_slice(&0x0102_0304_u32.to_le_bytes());
    bytes[12..16].copy_from_slice(&2_u32.to_le_bytes());
    bytes[24..32].copy_from_slice(&length.to_le_bytes());
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(&bytes[..16]);
    checksum.update(&bytes[20..]);
    bytes[16..20].copy_from_slice(&checksum.finalize().to_le_bytes());
    bytes
}
