//! Boxes.

use crate::Mesh;
use glam::Vec3;

/// A box of 12 triangles with 8 shared vertices, shaded flat. `min` must be below `max` on every axis.
#[must_use]
pub fn cuboid(min: Vec3, max: Vec3) -> Mesh {
    // Bit 0 of a corner's number is x, bit 1 y, bit 2 z; 1 is the larger side.
    let pick = |corner: u32, axis: usize| [min, max][(corner >> axis & 1) as usize][axis];
    let squares = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    Mesh {
        vertices: (0..8)
            .map(|corner| [0, 1, 2].map(|axis| pick(corner, axis)))
            .collect(),
        indices: squares
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect(),
        ..Mesh::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::assert_solid;

    #[test]
    fn volume_and_bounds() {
        let solid = cuboid(Vec3::new(-1.0, 10.0, 100.0), Vec3::new(0.0, 12.0, 103.0));
        let component = &assert_solid(&solid)[0];
        assert_eq!(component.triangle_count, 12);
        assert_eq!(component.signed_volume, 6.0);
        assert_eq!(component.bounds.min.to_array(), [-1.0, 10.0, 100.0]);
        assert_eq!(component.bounds.max.to_array(), [0.0, 12.0, 103.0]);
    }
}
