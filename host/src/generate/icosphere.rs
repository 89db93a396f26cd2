//! Spheres of nearly equal triangles.

use super::midpoints::split;
use crate::Mesh;
use glam::Vec3;

/// A sphere of `20 * 4^subdivisions` triangles, from an icosahedron, with smooth normals. All vertices lie on the sphere.
#[must_use]
pub fn icosphere(center: Vec3, radius: f32, subdivisions: u32) -> Mesh {
    // The corners of three golden rectangles.
    let g = (1.0 + 5_f32.sqrt()) / 2.0;
    #[rustfmt::skip]
    let corners = [
        [-1.0, g, 0.0], [1.0, g, 0.0], [-1.0, -g, 0.0], [1.0, -g, 0.0],
        [0.0, -1.0, g], [0.0, 1.0, g], [0.0, -1.0, -g], [0.0, 1.0, -g],
        [g, 0.0, -1.0], [g, 0.0, 1.0], [-g, 0.0, -1.0], [-g, 0.0, 1.0],
    ];
    #[rustfmt::skip]
    let mut indices = vec![
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11],
        [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
        [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9],
        [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
    ];
    let mut normals: Vec<Vec3> = corners.iter().map(|&corner| unit(corner.into())).collect();

    for _ in 0..subdivisions {
        let split = split(&indices, normals.len());
        for [a, b] in split.edges {
            normals.push(unit(normals[a as usize] + normals[b as usize]));
        }
        indices = split.indices;
    }
    Mesh {
        vertices: normals
            .iter()
            .map(|&normal| (center + radius * normal).to_array())
            .collect(),
        indices,
        normals: normals.iter().map(Vec3::to_array).collect(),
        ..Mesh::default()
    }
}

/// Normalizes by division, so that axes come out exact.
fn unit(v: Vec3) -> Vec3 {
    v / v.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::{assert_solid, assert_unit_normals};

    #[test]
    fn counts_volume_and_place() {
        for subdivisions in 0..5 {
            let sphere = icosphere(Vec3::new(1.0, 2.0, 3.0), 2.0, subdivisions);
            assert_unit_normals(&sphere);
            assert_eq!(assert_solid(&sphere).len(), 1);
            assert_eq!(sphere.indices.len(), 20 << (2 * subdivisions));
            assert_eq!(sphere.vertices.len(), 2 + (10 << (2 * subdivisions)));
        }
        let sphere = assert_solid(&icosphere(Vec3::new(1.0, 2.0, 3.0), 2.0, 4));
        let volume = std::f64::consts::PI * 32.0 / 3.0;
        assert!((sphere[0].signed_volume / volume - 1.0).abs() < 0.005);
        assert_eq!(sphere[0].bounds.min.to_array(), [-1.0, 0.0, 1.0]);
        assert_eq!(sphere[0].bounds.max.to_array(), [3.0, 4.0, 5.0]);
    }
}
