//! Smooth shading normals for a mesh without normals.

use crate::Mesh;
use crate::analysis::weld;
use crate::dvec3::{cross, dot, normalized};

/// Gives every vertex the mean normal of all triangles at its position, weighted by their angles there (Thürmer and
/// Wüthrich, "Computing Vertex Normals from Polygonal Facets", 1998). Vertices at one position get one normal, so seams
/// between them do not show. The normal is zero (flat shading) without a triangle of positive area, or if the mean
/// vanishes.
///
/// # Panics
/// If a triangle refers to a vertex that does not exist.
pub fn smooth_normals(mesh: &mut Mesh) {
    let ids = weld(&mesh.vertices);
    let mut sums = vec![[0.0; 3]; mesh.vertices.len()];
    for triangle in &mesh.indices {
        let corners = triangle.map(|vertex| mesh.vertices[vertex as usize].map(f64::from));
        for corner in 0..3 {
            let [next, last] =
                [1, 2].map(|step| difference(corners[(corner + step) % 3], corners[corner]));
            let normal = cross(next, last);
            let angle = dot(normal, normal).sqrt().atan2(dot(next, last));
            let sum: &mut [f64; 3] = &mut sums[ids[triangle[corner] as usize] as usize];
            for (sum, x) in sum.iter_mut().zip(normalized(normal)) {
                *sum += angle * x;
            }
        }
    }
    mesh.normals = ids
        .iter()
        .map(|&id| normalized(sums[id as usize]).map(|x| x as f32))
        .collect();
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{cuboid, icosphere};
    use glam::Vec3;

    #[test]
    fn the_angles_at_a_cuboids_corner_weigh_alike() {
        let mut mesh = cuboid(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0));
        smooth_normals(&mut mesh);
        let third = (1.0_f32 / 3.0).sqrt();
        assert_eq!(mesh.normals[0], [-third; 3]);
        assert_eq!(mesh.normals[5], [third, -third, third]);
    }

    #[test]
    fn a_sphere_gets_its_own_normals_back() {
        let mut mesh = icosphere(Vec3::new(1.0, 2.0, 3.0), 2.0, 3);
        let expected = mesh.normals.clone();
        smooth_normals(&mut mesh);
        for (found, expected) in mesh.normals.iter().zip(expected) {
            assert!(Vec3::from(*found).distance(expected.into()) < 0.02);
        }
    }

    #[test]
    fn equal_positions_share_a_normal_and_lonely_ones_have_none() {
        let mut mesh = Mesh {
            vertices: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [-0.0, 0.0, 0.0],
                [0.0, 0.0, 1.0],
                [9.0, 9.0, 9.0],
            ],
            indices: vec![[0, 1, 2], [3, 2, 4], [0, 3, 1]],
            ..Mesh::default()
        };
        smooth_normals(&mut mesh);
        let half = 0.5_f32.sqrt();
        assert_eq!(mesh.normals[0], [half, 0.0, half]);
        assert_eq!(mesh.normals[3], mesh.normals[0]);
        assert_eq!(mesh.normals[1], [0.0, 0.0, 1.0]);
        assert_eq!(mesh.normals[5], [0.0; 3]);
    }
}
