//! Long thin triangles.

use super::random::Random;
use crate::Mesh;

/// Triangles of length 1 and widths from 1 down to 1e-6, spaced evenly by magnitude, in random directions, with their
/// middles in the unit cube.
#[must_use]
pub fn slivers(count: u32, seed: u64) -> Mesh {
    let mut random = Random::new(seed);
    let mut mesh = Mesh::default();
    for triangle in 0..count {
        let along = 0.5 * random.direction();
        let across = along
            .cross(random.direction())
            .normalize_or(along.any_orthonormal_vector());
        let width = 0.1_f32.powf(6.0 * random.unit());
        let middle = random.point();
        let corners = [middle - along, middle + along, middle + width * across];
        mesh.vertices
            .extend(corners.map(|corner| corner.to_array()));
        mesh.indices
            .push([0, 1, 2].map(|corner| 3 * triangle + corner));
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use glam::Vec3;

    #[test]
    fn aspects_reach_a_million() {
        let mesh = slivers(2000, 3);
        assert_eq!(mesh.validate(), Ok(()));
        let analysis = analyze(&mesh);
        assert_eq!(analysis.components.len(), 2000);
        assert_eq!(analysis.degenerate_triangle_count, 0);
        let aspects = mesh.indices.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|v| Vec3::from(mesh.vertices[v as usize]));
            a.distance(b) / c.distance(a.midpoint(b))
        });
        let largest = aspects.clone().fold(0.0, f32::max);
        assert!((5e5..2e6).contains(&largest), "{largest}");
        let thin = aspects.filter(|&aspect| aspect > 1e3).count();
        assert!((900..1100).contains(&thin), "{thin}");
    }

    #[test]
    fn a_seed_gives_one_mesh() {
        assert_eq!(slivers(10, 3), slivers(10, 3));
        assert_ne!(slivers(10, 3), slivers(10, 4));
    }
}
