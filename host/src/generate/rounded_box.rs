//! Boxes with round edges.

use crate::Mesh;
use glam::Vec3;
use std::collections::HashMap;

/// A box with round edges and corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundedBox {
    /// The middle.
    pub center: Vec3,
    /// Half the length of each side.
    pub half: Vec3,
    /// The edges' radius, above 0 and below the smallest half side.
    pub radius: f32,
    /// Cells along each side, at least 6.
    pub cells: [u32; 3],
    /// Which sides are divided finely.
    pub sides: Sides,
}

/// Which sides of a [`RoundedBox`] are divided into cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// All six, into two triangles a cell.
    AllFine,
    /// All but the bottom and the back (-y and -z). These are fans with one triangle for each cell along their borders.
    CoarseBehind,
}

/// A rounded box with smooth normals. With cells x, y and z it has `4 * (x * y + x * z + y * z)` triangles; with a coarse
/// bottom and back, `2 * (x * y + x * z) + 4 * y * z` on the other sides, and `4 * x + 2 * y + 2 * z` on these.
#[must_use]
pub fn rounded_box(shape: &RoundedBox) -> Mesh {
    let mut grid = Grid {
        shape: RoundedBox {
            cells: shape.cells.map(|cells| cells.max(6)),
            ..*shape
        },
        known: HashMap::new(),
        mesh: Mesh::default(),
    };
    for axis in 0..3 {
        for far in [0, 1] {
            let is_coarse = shape.sides == Sides::CoarseBehind && axis > 0 && far == 0;
            if is_coarse {
                grid.add_fan(axis);
            } else {
                grid.add_cells(axis, far);
            }
        }
    }
    grid.mesh
}

/// Vertices by their grid places on the box, counted in lines along each side.
struct Grid {
    shape: RoundedBox,
    known: HashMap<[u32; 3], u32>,
    mesh: Mesh,
}

impl Grid {
    /// One of the two sides across an axis, in cells.
    fn add_cells(&mut self, axis: usize, far: u32) {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let cells = self.shape.cells;
        for j in 0..cells[v] {
            for i in 0..cells[u] {
                let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[di, dj]| {
                    let mut place = [0; 3];
                    place[axis] = far * cells[axis];
                    (place[u], place[v]) = (i + di, j + dj);
                    self.vertex(place)
                });
                let [a, b, c, d] = corners;
                self.mesh.indices.extend(if far == 1 {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, c, b], [a, d, c]]
                });
            }
        }
    }

    /// The near side across an axis, as a fan around its middle.
    fn add_fan(&mut self, axis: usize) {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let (across, along) = (self.shape.cells[u], self.shape.cells[v]);
        // The border, clockwise as seen from the positive end of the axis, which is the other side.
        let border = (0..along)
            .map(|j| [0, j])
            .chain((0..across).map(|i| [i, along]))
            .chain((0..along).map(|j| [across, along - j]))
            .chain((0..across).map(|i| [across - i, 0]));
        let border: Vec<u32> = border
            .map(|[i, j]| {
                let mut place = [0; 3];
                (place[u], place[v]) = (i, j);
                self.vertex(place)
            })
            .collect();
        let mut normal = Vec3::ZERO;
        normal[axis] = -1.0;
        let middle = self.mesh.vertices.len() as u32;
        let position = self.shape.center + normal * self.shape.half;
        self.mesh.vertices.push(position.to_array());
        self.mesh.normals.push(normal.to_array());
        for (i, &from) in border.iter().enumerate() {
            let to = border[(i + 1) % border.len()];
            self.mesh.indices.push([middle, from, to]);
        }
    }

    /// The vertex at a place, added on first use.
    fn vertex(&mut self, place: [u32; 3]) -> u32 {
        let (shape, mesh) = (&self.shape, &mut self.mesh);
        *self.known.entry(place).or_insert_with(|| {
            let on_box = Vec3::from_array([0, 1, 2].map(|axis| line(shape, axis, place[axis])));
            let inner = shape.half - Vec3::splat(shape.radius);
            let nearest = on_box.clamp(-inner, inner);
            let normal = (on_box - nearest).normalize_or(on_box);
            mesh.vertices
                .push((shape.center + nearest + shape.radius * normal).to_array());
            mesh.normals.push(normal.to_array());
            mesh.vertices.len() as u32 - 1
        })
    }
}

/// The position of a line along an axis. A sixth of the cells at either end goes to the round edges.
fn line(shape: &RoundedBox, axis: usize, line: u32) -> f32 {
    let (cells, half, radius) = (shape.cells[axis], shape.half[axis], shape.radius);
    let margin = cells / 6;
    let from_end = line.min(cells - line);
    let distance = if from_end <= margin {
        // Equal angles of the round edge.
        let angle = std::f32::consts::FRAC_PI_4 * (1.0 - from_end as f32 / margin as f32);
        half - radius + radius * angle.tan()
    } else {
        let share = (from_end - margin) as f32 / (cells - 2 * margin) as f32;
        (half - radius) * (1.0 - 2.0 * share)
    };
    match (2 * line).cmp(&cells) {
        std::cmp::Ordering::Less => -distance,
        std::cmp::Ordering::Equal => 0.0,
        std::cmp::Ordering::Greater => distance,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::{assert_solid, assert_unit_normals};

    const SHAPE: RoundedBox = RoundedBox {
        center: Vec3::new(3.0, 4.0, 5.0),
        half: Vec3::new(1.0, 2.0, 3.0),
        radius: 0.5,
        cells: [20, 31, 42],
        sides: Sides::AllFine,
    };

    #[test]
    fn solid_with_the_volume_of_a_rounded_box() {
        let mesh = rounded_box(&SHAPE);
        assert_unit_normals(&mesh);
        let component = &assert_solid(&mesh)[0];
        assert_eq!(component.triangle_count, 4 * (20 * 31 + 20 * 42 + 31 * 42));
        // The inner box, six slabs, twelve quarters of cylinders, eight eighths of a ball.
        let (x, y, z, r) = (1.0_f64, 3.0, 5.0, 0.5);
        let pi = std::f64::consts::PI;
        let volume = x * y * z
            + 2.0 * r * (x * y + x * z + y * z)
            + pi * r * r * (x + y + z)
            + 4.0 / 3.0 * pi * r * r * r;
        assert!((component.signed_volume / volume - 1.0).abs() < 0.003);
        assert_eq!(component.bounds.min, SHAPE.center - SHAPE.half);
        assert_eq!(component.bounds.max, SHAPE.center + SHAPE.half);
    }

    #[test]
    fn a_coarse_back_closes_it_too() {
        let shape = RoundedBox {
            sides: Sides::CoarseBehind,
            ..SHAPE
        };
        let mesh = rounded_box(&shape);
        assert_unit_normals(&mesh);
        let component = &assert_solid(&mesh)[0];
        let fine = 2 * (20 * 31 + 20 * 42) + 4 * 31 * 42;
        assert_eq!(component.triangle_count, fine + 4 * 20 + 2 * 31 + 2 * 42);
        let whole = &assert_solid(&rounded_box(&SHAPE))[0];
        assert!((component.signed_volume / whole.signed_volume - 1.0).abs() < 0.05);
    }
}
