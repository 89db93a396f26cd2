//! The volume enclosed by a closed surface, and whether its sign is certain.

use slimbvh_core::Aabb;
use std::ops::AddAssign;

/// A sum of signed volumes of tetrahedra.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Volume {
    /// The rounded sum.
    pub(crate) signed: f64,
    /// The same sum of the terms' magnitudes, which bounds the rounding errors.
    magnitude: f64,
    triangle_count: usize,
}

impl Volume {
    /// The tetrahedron of a triangle and the origin, positive if the origin is behind the triangle.
    pub(crate) fn tetrahedron(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Self {
        let (mut volume, mut magnitude) = (0.0, 0.0);
        for (x, y, z) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let (positive, negative) = (b[y] * c[z], b[z] * c[y]);
            volume += a[x] * (positive - negative);
            magnitude += a[x].abs() * (positive.abs() + negative.abs());
        }
        Self {
            signed: volume / 6.0,
            magnitude: magnitude / 6.0,
            triangle_count: 1,
        }
    }

    /// Whether the front sides face outward, given the tetrahedra of all triangles of a closed surface, with one common
    /// point. `None` if rounding could change the sign.
    pub(crate) fn outward(&self) -> Option<bool> {
        // A term has fewer than 10 roundings of half an epsilon, and the sum one more for each triangle.
        let error = (self.triangle_count + 10) as f64 * f64::EPSILON * self.magnitude;
        (self.signed.abs() > error).then_some(self.signed > 0.0)
    }
}

impl AddAssign for Volume {
    fn add_assign(&mut self, other: Self) {
        self.signed += other.signed;
        self.magnitude += other.magnitude;
        self.triangle_count += other.triangle_count;
    }
}

/// The point in the middle of a box, which may span all of `f32`.
pub(crate) fn middle(bounds: &Aabb) -> [f64; 3] {
    [0, 1, 2].map(|axis| 0.5 * (f64::from(bounds.min[axis]) + f64::from(bounds.max[axis])))
}

/// Corners relative to a point.
pub(crate) fn seen_from(point: [f64; 3], corners: [[f32; 3]; 3]) -> [[f64; 3]; 3] {
    corners.map(|p| [0, 1, 2].map(|axis| f64::from(p[axis]) - point[axis]))
}
