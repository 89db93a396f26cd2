//! The point that a ray hits: where it is, how well that is known, and which way it faces.

use crate::geometry::float::{abs, exponent, gamma, max, next_down, next_up, power_of_two};
use crate::geometry::ray::Hit;
use crate::geometry::triangle::Triangle;
use crate::geometry::watertight::weights;
use glam::Vec3;

/// A hit point. All in the scene's magnitude.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The triangle that was hit.
    pub triangle: Triangle,
    /// The point, rounded.
    pub position: Vec3,
    /// Bound on the position's error, by axis.
    pub error: Vec3,
    /// Unit normal of the triangle, on the side that the ray came from.
    pub normal: Vec3,
    /// Unit normal for shading, on the same side.
    pub shading_normal: Vec3,
    /// 1 where the ray came from the front, −1 where from the back.
    pub side: f32,
}

impl Surface {
    /// The point that a ray with this direction hits. `normals` are the corners' shading normals; zero asks for flat
    /// shading.
    #[must_use]
    pub fn new(triangle: Triangle, hit: &Hit, direction: Vec3, normals: [Vec3; 3]) -> Self {
        let w = weights(hit.u, hit.v);
        let (a, b, c) = (triangle.v0 * w.x, triangle.v1 * w.y, triangle.v2 * w.z);
        let position = a + b + c;
        // Three products, two sums, and weights whose sum is 1 within a few roundings (after Pharr, Jakob, Humphreys,
        // section 6.8).
        let error = (absolute(a) + absolute(b) + absolute(c)) * gamma(12);

        let front = normalize(triangle.normal());
        let side = if front.dot(direction) > 0.0 {
            -1.0
        } else {
            1.0
        };
        let normal = front * side;
        let smooth = normals[0] * w.x + normals[1] * w.y + normals[2] * w.z;
        let smooth = normalize(smooth) * side;
        // Smooth normals may point away from a triangle seen at a grazing angle.
        let shading_normal = if smooth.dot(normal) > 0.0 {
            smooth
        } else {
            normal
        };
        Self {
            triangle,
            position,
            error,
            normal,
            shading_normal,
            side,
        }
    }

    /// Where a ray leaves the surface on the side it came from: far enough along the normal that the rounded position
    /// lies outside, whatever its error was.
    #[inline]
    #[must_use]
    pub fn leave(&self) -> Vec3 {
        beside(self.position, self.error, self.normal)
    }

    /// Where a ray leaves the surface on the other side, which it passed to: [`Self::leave`] against the normal.
    #[inline]
    #[must_use]
    pub fn enter(&self) -> Vec3 {
        beside(self.position, self.error, -self.normal)
    }
}

/// Off a surface, on the side of one of its two unit normals: beyond everything within the error, by axis, around the position.
#[inline]
pub(crate) fn beside(position: Vec3, error: Vec3, normal: Vec3) -> Vec3 {
    // The largest error counts for all axes: on an axis-aligned plane through 0 its own would be 0.
    let error = max(max(error.x, error.y), error.z);
    let sizes = absolute(normal);
    let origin = position + normal * (error * (sizes.x + sizes.y + sizes.z));
    Vec3::new(
        away(origin.x, normal.x),
        away(origin.y, normal.y),
        away(origin.z, normal.z),
    )
}

/// Rounds on in a direction.
#[inline]
fn away(x: f32, direction: f32) -> f32 {
    if direction > 0.0 {
        next_up(x)
    } else if direction < 0.0 {
        next_down(x)
    } else {
        x
    }
}

#[inline]
fn absolute(v: Vec3) -> Vec3 {
    Vec3::new(abs(v.x), abs(v.y), abs(v.z))
}

/// The unit vector along `v`, also where its squared length would underflow; zero where no component is in the normal
/// range.
#[inline]
#[must_use]
pub fn normalize(v: Vec3) -> Vec3 {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if largest < f32::MIN_POSITIVE {
        return Vec3::ZERO;
    }
    let half = exponent(largest) / 2;
    let v = v * power_of_two(-half) * power_of_two(half - exponent(largest));
    v / v.length()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn tiny_vectors_have_directions() {
        let unit = normalize(Vec3::new(3e-30, -4e-30, 0.0));
        assert!((unit - Vec3::new(0.6, -0.8, 0.0)).length() < 1e-6);
        assert_eq!(normalize(Vec3::ZERO), Vec3::ZERO);
        assert!((normalize(Vec3::splat(3e38)).length() - 1.0).abs() < 1e-6);
    }

    fn wide(v: Vec3) -> [f64; 3] {
        v.to_array().map(f64::from)
    }

    /// How far a point is in front of a triangle's plane, times twice its area.
    pub(crate) fn height(corners: &[[f64; 3]; 3], point: [f64; 3]) -> f64 {
        let from_first = |p: [f64; 3]| core::array::from_fn(|axis| p[axis] - corners[0][axis]);
        let (a, b, r): ([f64; 3], [f64; 3], [f64; 3]) = (
            from_first(corners[1]),
            from_first(corners[2]),
            from_first(point),
        );
        let normal = [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ];
        normal[0] * r[0] + normal[1] * r[1] + normal[2] * r[2]
    }

    fn vector() -> impl Strategy<Value = Vec3> {
        proptest::array::uniform3(-1.0f32..1.0).prop_map(Vec3::from_array)
    }

    proptest! {
        #[test]
        fn rays_leave_on_the_right_side(v0 in vector(), v1 in vector(), v2 in vector(), d in vector(), u in 0.0f32..1.0, v in 0.0f32..1.0) {
            let triangle = Triangle { v0, v1, v2 };
            prop_assume!(triangle.normal().length() > 1e-3);
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let hit = Hit { t: 1.0, u, v, primitive: 0 };
            let surface = Surface::new(triangle, &hit, d, [Vec3::ZERO; 3]);
            prop_assert!(surface.normal.dot(d) <= 1e-6);
            let corners = [v0, v1, v2].map(wide);
            let height = |p: Vec3| height(&corners, wide(p)) * f64::from(surface.side);
            let (left, entered) = (height(surface.leave()), height(surface.enter()));
            prop_assert!(left > 0.0 && entered < 0.0, "{left} {entered}");
        }
    }
}
