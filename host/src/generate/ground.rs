//! Level ground.

use crate::Mesh;

/// A square of `size` a side in the plane y = 0 around the origin, facing up: `cells` × `cells` squares of two triangles
/// each. Shaded flat. 0 cells count as 1.
#[must_use]
pub fn ground(size: f32, cells: u32) -> Mesh {
    height_field(size, cells, |_, _| 0.0)
}

/// As [`ground`], at `height(x, z)`.
pub(super) fn height_field(size: f32, cells: u32, height: impl Fn(f32, f32) -> f32) -> Mesh {
    let cells = cells.max(1);
    let at = |step: u32| size * (step as f32 / cells as f32 - 0.5);
    let place = |row, column| {
        let (x, z) = (at(column), at(row));
        [x, height(x, z), z]
    };
    let squares = (0..cells).flat_map(|row| (0..cells).map(move |column| (row, column)));
    Mesh {
        vertices: (0..=cells)
            .flat_map(|row| (0..=cells).map(move |column| (row, column)))
            .map(|(row, column)| place(row, column))
            .collect(),
        indices: squares
            .flat_map(|(row, column)| {
                let near = row * (cells + 1) + column;
                let far = near + cells + 1;
                [[near, far, near + 1], [near + 1, far, far + 1]]
            })
            .collect(),
        ..Mesh::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use glam::Vec3;

    #[test]
    fn open_level_and_facing_up() {
        let mesh = ground(8.0, 4);
        let analysis = analyze(&mesh);
        assert_eq!((mesh.indices.len(), mesh.vertices.len()), (32, 25));
        let component = &analysis.components[0];
        assert_eq!(component.triangle_count, 32);
        assert!(!component.closed && component.consistently_wound);
        assert_eq!(component.outward, None);
        assert_eq!(component.bounds.min.to_array(), [-4.0, 0.0, -4.0]);
        assert_eq!(component.bounds.max.to_array(), [4.0, 0.0, 4.0]);
        for triangle in &mesh.indices {
            let [a, b, c] = triangle.map(|v| Vec3::from(mesh.vertices[v as usize]));
            assert_eq!((b - a).cross(c - a), Vec3::new(0.0, 4.0, 0.0));
        }
        assert_eq!(ground(8.0, 0), ground(8.0, 1));
    }
}
