//! Random triangles without structure.

use super::random::Random;
use crate::Mesh;
use glam::Vec3;

/// Random triangles in the unit cube that share nothing. Each lies in a cube of `count^(-1/3)` a side, so a ray hits a
/// number of triangles proportional to the number of such cubes that it crosses.
#[must_use]
pub fn soup(count: u32, seed: u64) -> Mesh {
    let mut random = Random::new(seed);
    let size = (count as f32).cbrt().recip();
    let mut mesh = Mesh::default();
    for triangle in 0..count {
        let min = (1.0 - size) * random.point();
        for _ in 0..3 {
            let corner = min + size * random.point();
            mesh.vertices.push(corner.min(Vec3::ONE).to_array());
        }
        mesh.indices
            .push([0, 1, 2].map(|corner| 3 * triangle + corner));
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;

    #[test]
    fn triangles_share_nothing_and_stay_in_the_cube() {
        let mesh = soup(1000, 5);
        assert_eq!(mesh.validate(), Ok(()));
        let analysis = analyze(&mesh);
        assert_eq!(analysis.components.len(), 1000);
        assert_eq!(analysis.welded_vertex_count, 3000);
        assert_eq!(analysis.degenerate_triangle_count, 0);
        for component in &analysis.components {
            for axis in 0..3 {
                let (min, max) = (component.bounds.min[axis], component.bounds.max[axis]);
                assert!(0.0 <= min && max <= 1.0 && max - min <= 0.100_001);
            }
        }
    }

    #[test]
    fn a_seed_gives_one_mesh() {
        assert_eq!(soup(10, 5), soup(10, 5));
        assert_ne!(soup(10, 5), soup(10, 6));
        assert_eq!(soup(0, 5), Mesh::default());
    }
}
