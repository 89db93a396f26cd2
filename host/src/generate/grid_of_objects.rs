//! Many copies of one mesh.

use super::compose::concatenate;
use super::transformed;
use crate::Mesh;
use glam::{Quat, Vec3};

/// Copies of a mesh in a grid, with x fastest. The copy at (i, j, k) is moved by `(i, j, k) * spacing`. Materials are kept,
/// parts are not.
#[must_use]
pub fn grid_of_objects(mesh: &Mesh, counts: [u32; 3], spacing: Vec3) -> Mesh {
    let mut grid = Mesh::default();
    for z in 0..counts[2] {
        for y in 0..counts[1] {
            for x in 0..counts[0] {
                let offset = spacing * Vec3::new(x as f32, y as f32, z as f32);
                let copy = transformed(mesh.clone(), 1.0, Quat::IDENTITY, offset);
                concatenate(&mut grid, &copy);
                grid.materials.extend(&mesh.materials);
            }
        }
    }
    grid
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::assert_solid;
    use crate::generate::cuboid;

    #[test]
    fn every_copy_is_a_solid_of_its_own() {
        let mut one = cuboid(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0));
        one.materials = (0..12).collect();
        let grid = grid_of_objects(&one, [2, 3, 4], Vec3::new(10.0, 20.0, 30.0));
        let components = assert_solid(&grid);
        assert_eq!(components.len(), 24);
        assert!(components.iter().all(|c| c.signed_volume == 6.0));
        assert_eq!(components[1].bounds.min.to_array(), [10.0, 0.0, 0.0]);
        assert_eq!(components[2].bounds.min.to_array(), [0.0, 20.0, 0.0]);
        assert_eq!(components[23].bounds.max.to_array(), [11.0, 42.0, 93.0]);
        assert_eq!(grid.materials[12..24], one.materials);
    }
}
