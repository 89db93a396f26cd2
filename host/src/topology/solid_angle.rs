//! The winding number of a surface around a point, by solid angles.

use crate::analysis::seen_from;

/// The sum of the solid angles of triangles at a point, halved, so that a closed surface spans 2π (van Oosterom and
/// Strackee 1983, "The Solid Angle of a Plane Triangle").
#[derive(Clone, Copy, Debug, Default)]
pub struct SolidAngle {
    half: f64,
    /// A bound on the error of `half`; infinite if the point may lie on a triangle.
    error: f64,
}

/// A bound on the rounding errors of both terms of the formula, divided by the product of the distances: at most 30
/// successive roundings of sums of magnitudes below 4.
const TERM_ERROR: f64 = 64.0 * f64::EPSILON;

/// This many small angles are added by multiplying complex numbers: each is below an eighth, so the sum stays below π.
const LONGEST_PRODUCT: u32 = 16;

impl SolidAngle {
    /// The solid angle of triangles at a point, positive from behind.
    pub fn of(triangles: impl Iterator<Item = [[f32; 3]; 3]>, point: [f64; 3]) -> Self {
        let mut sum = Self::default();
        let (mut product, mut factor_count) = ((1.0, 0.0), 0);
        for corners in triangles {
            let (x, y) = term(seen_from(point, corners));
            let size = (x * x + y * y).sqrt();
            // Near the branch cut, if the point may be on the triangle, either sign is possible.
            if x.is_nan() || (x <= TERM_ERROR && y.abs() <= TERM_ERROR) {
                sum.error = f64::INFINITY;
                return sum;
            }
            // The second term covers the product or the arc tangent, and the sum.
            sum.error += 2.0 * TERM_ERROR / size + 16.0 * f64::EPSILON;

            if y.abs() * 8.0 < x {
                product = (product.0 * x - product.1 * y, product.0 * y + product.1 * x);
                factor_count += 1;
                if factor_count == LONGEST_PRODUCT {
                    sum.half += f64::atan2(product.1, product.0);
                    (product, factor_count) = ((1.0, 0.0), 0);
                }
            } else {
                sum.half += f64::atan2(y, x);
            }
        }
        sum.half += f64::atan2(product.1, product.0);
        sum
    }

    /// The sum of both.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            half: self.half + other.half,
            error: self.error + other.error,
        }
    }

    /// The winding number of the surface around the point: 0 outside, 1 inside a solid whose front sides face outward.
    /// `None` if uncertain, and for open surfaces.
    #[must_use]
    pub fn winding_number(&self) -> Option<i32> {
        const TOLERANCE: f64 = 0.01;
        let turns = self.half / std::f64::consts::TAU;
        let whole = turns.round();
        let is_certain = (turns - whole).abs() + self.error < TOLERANCE;
        is_certain.then_some(whole as i32)
    }
}

/// Denominator and numerator of the tangent of half the solid angle, both divided by the product of the three distances.
/// NaN if a corner lies at the point.
fn term([a, b, c]: [[f64; 3]; 3]) -> (f64, f64) {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [length_a, length_b, length_c] = [a, b, c].map(|v| dot(v, v).sqrt());
    let volume = a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0]);
    let size = length_a * length_b * length_c;
    let sum = size + dot(a, b) * length_c + dot(b, c) * length_a + dot(c, a) * length_b;
    let scale = 1.0 / size;
    (sum * scale, volume * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron whose front sides face outward.
    const SOLID: [[[f32; 3]; 3]; 4] = {
        let [o, x, y, z] = [
            [0.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [0.0, 3.0, 0.0],
            [0.0, 0.0, 5.0],
        ];
        [[o, y, x], [o, z, y], [o, x, z], [x, y, z]]
    };

    fn winding_number(triangles: &[[[f32; 3]; 3]], point: [f64; 3]) -> Option<i32> {
        SolidAngle::of(triangles.iter().copied(), point).winding_number()
    }

    #[test]
    fn inside_outside_and_on_the_border() {
        assert_eq!(winding_number(&SOLID, [0.3, 0.2, 0.4]), Some(1));
        assert_eq!(winding_number(&SOLID, [0.3, 0.2, -0.4]), Some(0));
        assert_eq!(winding_number(&SOLID, [0.3, 0.2, 1e-9]), Some(1));
        assert_eq!(winding_number(&SOLID, [0.3, 0.2, -1e-9]), Some(0));
        assert_eq!(winding_number(&SOLID, [0.3, 0.2, 0.0]), None);
        assert_eq!(winding_number(&SOLID, [0.3, 0.0, 0.0]), None);
        assert_eq!(winding_number(&SOLID, [2.0, 0.0, 0.0]), None);
        // In the plane of a side, but outside of it.
        assert_eq!(winding_number(&SOLID, [-1.0, 2.0, 0.0]), Some(0));
        assert_eq!(winding_number(&SOLID[..3], [0.3, 0.2, 0.4]), None);
    }

    #[test]
    fn products_of_small_angles_do_not_lose_turns() {
        // A pyramid's floor of many thin triangles.
        let count = 1000;
        let rim = |i: u32| {
            let (sin, cos) =
                (std::f64::consts::TAU * f64::from(i % count) / f64::from(count)).sin_cos();
            [cos as f32, sin as f32, 0.0]
        };
        let mut triangles = Vec::new();
        for i in 0..count {
            triangles.push([rim(i), rim(i + 1), [0.0, 0.0, 1.0]]);
            triangles.push([rim(i + 1), rim(i), [0.0, 0.0, -0.5]]);
        }
        assert_eq!(winding_number(&triangles, [0.1, 0.2, 0.3]), Some(1));
        assert_eq!(winding_number(&triangles, [0.1, 0.2, 1.3]), Some(0));
        let twice: Vec<_> = triangles.iter().chain(&triangles).copied().collect();
        assert_eq!(winding_number(&twice, [0.1, 0.2, 0.3]), Some(2));
    }
}
