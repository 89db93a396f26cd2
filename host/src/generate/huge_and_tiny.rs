//! A tiny model on a huge triangle.

use super::append;
use crate::Mesh;
use crate::analysis::around;
use glam::Vec3;

/// A model on one level triangle that faces up and is about `ratio` times as large as the model's diagonal. The triangle
/// touches the model's lowest point. The parts are "tiny" and "huge"; "huge" has the material after the model's last.
#[must_use]
pub fn huge_and_tiny(tiny: Mesh, ratio: f32) -> Mesh {
    let bounds = around(tiny.vertices.iter().copied());
    let (min, max) = bounds.map_or((Vec3::ZERO, Vec3::ZERO), |bounds| (bounds.min, bounds.max));
    let middle = (0.5 * (min + max)).with_y(min.y);
    let reach = 0.5 * ratio * (max - min).length();
    let corner = |x: f32, z: f32| (middle + reach * Vec3::new(x, 0.0, z)).to_array();
    let huge = Mesh {
        vertices: vec![corner(0.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0)],
        indices: vec![[0, 1, 2]],
        ..Mesh::default()
    };

    let material_count = tiny.materials.iter().max().map_or(1, |last| last + 1);
    let mut mesh = Mesh::default();
    append(&mut mesh, tiny, "tiny", 0);
    append(&mut mesh, huge, "huge", material_count);
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::generate::cuboid;

    #[test]
    fn one_huge_triangle_lies_under_the_model() {
        let tiny = cuboid(Vec3::new(5.0, 6.0, 7.0), Vec3::new(6.0, 8.0, 9.0));
        let mesh = huge_and_tiny(tiny, 1e6);
        assert_eq!(mesh.validate(), Ok(()));
        let components = analyze(&mesh).components;
        assert_eq!(components[0].outward, Some(true));
        let huge = &components[1];
        assert_eq!(huge.triangle_count, 1);
        assert_eq!((huge.bounds.min[1], huge.bounds.max[1]), (6.0, 6.0));
        // The model's diagonal is 3.
        assert_eq!(huge.bounds.max[0] - huge.bounds.min[0], 3e6);
        let [a, b, c] = [8, 9, 10].map(|v| Vec3::from(mesh.vertices[v]));
        assert!((b - a).cross(c - a).y > 0.0);
        assert_eq!(mesh.materials[11..], [0, 1]);
    }
}
