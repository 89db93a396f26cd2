//! The frame of reference of motions: a scene's middle, vertical, floor and size.

use crate::{Camera, Mesh};

/// The middle, the vertical, the floor and the size of a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Anchor {
    /// The middle of the box around all triangles.
    pub center: [f64; 3],
    /// The coordinate that is height.
    pub vertical: usize,
    /// The smallest height.
    pub floor: f64,
    /// Twice the distance from the middle within which half of all corners lie, so that wide ground under small objects
    /// does not dominate. 0 only if at least half of the corners are in the middle.
    pub size: f64,
}

impl Anchor {
    /// The anchor of a sound mesh, seen by this camera. The size of an empty mesh is 0.
    pub fn new(mesh: &Mesh, camera: Option<&Camera>) -> Self {
        let up = camera.map_or([0.0, 1.0, 0.0], |camera| camera.up);
        let vertical = vertical(up);
        let Some(bounds) = mesh.bounds() else {
            return Self {
                vertical,
                ..Self::default()
            };
        };
        let (low, high) = (bounds.min.to_array(), bounds.max.to_array());
        let center: [f64; 3] =
            std::array::from_fn(|axis| 0.5 * (f64::from(low[axis]) + f64::from(high[axis])));
        let mut distances: Vec<f64> = mesh
            .indices
            .iter()
            .map(|triangle| {
                let corner = mesh.vertices[triangle[0] as usize];
                let squares = (0..3).map(|axis| (f64::from(corner[axis]) - center[axis]).powi(2));
                squares.sum::<f64>().sqrt()
            })
            .collect();
        let half = distances.len() / 2;
        let (_, median, _) = distances.select_nth_unstable_by(half, f64::total_cmp);
        Self {
            center,
            vertical,
            floor: low[vertical].into(),
            size: 2.0 * *median,
        }
    }

    /// The two level coordinates, ordered so that a counter-clockwise turn, seen from above, takes the first to the second.
    pub fn level(&self) -> [usize; 2] {
        [(self.vertical + 1) % 3, (self.vertical + 2) % 3]
    }
}

/// The coordinate nearest to a camera's up direction; y if that is zero.
fn vertical(up: [f32; 3]) -> usize {
    let mut vertical = 1;
    for axis in [0, 2] {
        if up[axis].abs() > up[vertical].abs() {
            vertical = axis;
        }
    }
    vertical
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_corners_do_not_stretch_the_size() {
        // Three triangles near the middle, two far out.
        let mesh = Mesh {
            vertices: vec![
                [-100.0, -2.0, -300.0],
                [102.0, 6.0, 304.0],
                [1.0, 2.0, 5.0],
                [1.0, 4.0, 2.0],
                [2.0, 2.0, 2.0],
            ],
            indices: vec![[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 2], [4, 2, 3]],
            ..Mesh::default()
        };
        let anchor = Anchor::new(&mesh, None);
        assert_eq!(anchor.center, [1.0, 2.0, 2.0]);
        assert_eq!((anchor.vertical, anchor.floor, anchor.size), (1, -2.0, 6.0));
        assert_eq!(anchor.level(), [2, 0]);
        assert_eq!(Anchor::new(&Mesh::default(), None).size, 0.0);
    }

    #[test]
    fn the_vertical_is_the_nearest_axis() {
        assert_eq!(vertical([0.0, 0.0, 0.0]), 1);
        assert_eq!(vertical([0.5, 0.8, -0.4]), 1);
        assert_eq!(vertical([0.1, 0.2, -1.0]), 2);
        assert_eq!(vertical([1.0, 0.2, 0.9]), 0);
    }
}
