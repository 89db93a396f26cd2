//! Subdivision of meshes.

use super::midpoints::split;
use crate::Mesh;
use glam::Vec3;

/// Splits every triangle into four in its plane, `levels` times. Shared edges stay shared, including those shared only by
/// equal positions, so a closed mesh stays closed. Normals are interpolated; materials and parts are kept.
#[must_use]
pub fn subdivide(mesh: &Mesh, levels: u32) -> Mesh {
    refine(mesh, levels, |positions, _| {
        0.5 * positions[0] + 0.5 * positions[1]
    })
}

/// As [`subdivide`], with the surface curved to fit the normals: new vertices are the edge midpoints of PN triangles
/// (Vlachos and others, "Curved PN Triangles", 2001). Edges stay shared if their normals are equal. A mesh without normals
/// stays flat.
#[must_use]
pub fn subdivide_curved(mesh: &Mesh, levels: u32) -> Mesh {
    refine(mesh, levels, |[a, b], [normal_a, normal_b]| {
        let side = b - a;
        let bulge = side.dot(normal_b) * normal_b - side.dot(normal_a) * normal_a;
        0.5 * a + 0.5 * b + 0.125 * bulge
    })
}

/// Places new vertices by `middle(positions, normals)`, which must not depend on the order of the two ends.
fn refine(mesh: &Mesh, levels: u32, middle: impl Fn([Vec3; 2], [Vec3; 2]) -> Vec3) -> Mesh {
    let mut mesh = mesh.clone();
    for _ in 0..levels {
        let split = split(&mesh.indices, mesh.vertices.len());
        for edge in split.edges {
            let ends = edge.map(|vertex| vertex as usize);
            let positions = ends.map(|end| Vec3::from(mesh.vertices[end]));
            let mut normals = [Vec3::ZERO; 2];
            if !mesh.normals.is_empty() {
                normals = ends.map(|end| Vec3::from(mesh.normals[end]));
                mesh.normals.push(middle_normal(normals).to_array());
            }
            mesh.vertices.push(middle(positions, normals).to_array());
        }
        mesh.indices = split.indices;
        mesh.materials = mesh.materials.iter().flat_map(|&m| [m; 4]).collect();
        for part in &mut mesh.parts {
            part.first_triangle *= 4;
            part.triangle_count *= 4;
        }
    }
    mesh
}

/// The direction halfway; zero (flat shading) if either is zero.
fn middle_normal([a, b]: [Vec3; 2]) -> Vec3 {
    if a == Vec3::ZERO || b == Vec3::ZERO {
        return Vec3::ZERO;
    }
    (a + b).normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::assert_solid;
    use crate::generate::{append, cuboid, icosphere, smooth_normals, teapot};

    #[test]
    fn a_solid_stays_solid_with_four_times_the_triangles() {
        let mut mesh = Mesh::default();
        let solid = cuboid(Vec3::new(1.0, 2.0, 3.0), Vec3::new(2.0, 4.0, 6.0));
        append(&mut mesh, solid, "cuboid", 0);
        append(&mut mesh, icosphere(Vec3::ZERO, 0.5, 0), "sphere", 1);
        let fine = subdivide(&mesh, 2);
        let components = assert_solid(&fine);
        assert_eq!(components[0].triangle_count, 20 * 16);
        assert_eq!(components[1].triangle_count, 12 * 16);
        assert_eq!(components[1].signed_volume, 6.0);
        // V - E + F = 2 for each of two solids.
        assert_eq!(fine.vertices.len(), 4 + fine.indices.len() / 2);
        assert_eq!(fine.parts[1].first_triangle, 12 * 16);
        assert_eq!(fine.materials[12 * 16 - 1..12 * 16 + 1], [0, 1]);
        assert_eq!(subdivide(&mesh, 0), mesh);
    }

    #[test]
    fn edges_shared_by_position_stay_shared() {
        let coarse = teapot();
        let seams = |mesh: &Mesh| crate::analysis::analyze(mesh).components;
        let fine = subdivide_curved(&coarse, 1);
        let counts: Vec<usize> = seams(&fine).iter().map(|c| c.triangle_count).collect();
        let expected: Vec<usize> = seams(&coarse)
            .iter()
            .map(|c| 4 * c.triangle_count)
            .collect();
        assert_eq!(counts, expected);
    }

    #[test]
    fn curved_subdivision_of_an_icosahedron_nears_the_sphere() {
        let mut coarse = icosphere(Vec3::ZERO, 1.0, 0);
        smooth_normals(&mut coarse);
        let components = assert_solid(&subdivide_curved(&coarse, 3));
        // The unit sphere has 4.19, an icosahedron 2.54.
        let volume = components[0].signed_volume;
        assert!((3.6..4.0).contains(&volume), "{volume}");
    }
}
