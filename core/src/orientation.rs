//! On which side of a triangle something lies, and when that is certain.

use crate::float::{abs, gamma};
use crate::triangle::Triangle;
use glam::Vec3;

/// What a triangle may face.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Target {
    /// A position, or the direction to something infinitely far away.
    pub point: Vec3,
    /// 1 for a position, 0 for a direction.
    pub is_position: u32,
}

/// Signed volume of the parallelepiped of a triangle and a target, positive where the target is in front, and a bound
/// on its error.
#[derive(Clone, Copy, Debug)]
pub struct Orientation {
    /// `((v1 - v0) × (v2 - v0)) · (target - v0)`, rounded.
    pub volume: f32,
    /// The exact value is no farther away than this.
    pub error: f32,
}

impl Orientation {
    /// Measures a triangle against a target.
    ///
    /// Each of the six terms is a product of three factors with at most one rounding each, and takes part in two more
    /// products and three sums: `gamma(8)` of the sum of magnitudes. That sum is itself rounded, and products may
    /// underflow: both are covered twice over.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle, target: &Target) -> Self {
        let a = triangle.v1 - triangle.v0;
        let b = triangle.v2 - triangle.v0;
        let r = if target.is_position == 1 {
            target.point - triangle.v0
        } else {
            target.point
        };
        let volume = r.x * (a.y * b.z - a.z * b.y)
            + r.y * (a.z * b.x - a.x * b.z)
            + r.z * (a.x * b.y - a.y * b.x);
        let magnitude = abs(r.x) * (abs(a.y * b.z) + abs(a.z * b.y))
            + abs(r.y) * (abs(a.z * b.x) + abs(a.x * b.z))
            + abs(r.z) * (abs(a.x * b.y) + abs(a.y * b.x));
        Self {
            volume,
            error: gamma(16) * magnitude + 16.0 * f32::MIN_POSITIVE,
        }
    }

    /// Whether the target is certainly on the front side (`side` 1) or on the back side (`side` −1).
    #[inline]
    #[must_use]
    pub fn is_certainly_on(&self, side: f32) -> bool {
        self.volume * side > self.error
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The exact sign, for coordinates that are small multiples of a power of two.
    fn exact_sign(t: [[i64; 3]; 3], p: [i64; 3]) -> i64 {
        let d = |q: [i64; 3]| [q[0] - t[0][0], q[1] - t[0][1], q[2] - t[0][2]].map(i128::from);
        let (a, b, r) = (d(t[1]), d(t[2]), d(p));
        let volume = r[0] * (a[1] * b[2] - a[2] * b[1])
            + r[1] * (a[2] * b[0] - a[0] * b[2])
            + r[2] * (a[0] * b[1] - a[1] * b[0]);
        volume.signum() as i64
    }

    /// Coordinates up to 2^24, most of them near a common plane.
    fn coordinate() -> impl Strategy<Value = i64> {
        prop_oneof![-8i64..8, (1i64 << 23)..(1 << 24), -(1i64 << 24)..-(1 << 23)]
    }

    fn point() -> impl Strategy<Value = [i64; 3]> {
        proptest::array::uniform3(coordinate())
    }

    fn vector(p: [i64; 3]) -> Vec3 {
        Vec3::new(p[0] as f32, p[1] as f32, p[2] as f32)
    }

    proptest! {
        #[test]
        fn what_is_certain_is_right(t in proptest::array::uniform3(point()), p in point(), shift in -3i64..3) {
            let triangle = Triangle { v0: vector(t[0]), v1: vector(t[1]), v2: vector(t[2]) };
            let near_plane = [t[0][0] + t[1][0] - t[2][0] + shift, t[0][1] + t[1][1] - t[2][1], t[0][2] + t[1][2] - t[2][2]];
            for p in [p, near_plane, t[1]] {
                let point = vector(p);
                // Only exactly representable points are asked about.
                prop_assume!([point.x as i64, point.y as i64, point.z as i64] == p);
                let orientation = Orientation::new(&triangle, &Target { point, is_position: 1 });
                let sign = exact_sign(t, p);
                prop_assert!(!orientation.is_certainly_on(1.0) || sign > 0);
                prop_assert!(!orientation.is_certainly_on(-1.0) || sign < 0);
            }
        }
    }

    #[test]
    fn plain_cases_are_certain() {
        let triangle = Triangle {
            v0: Vec3::ZERO,
            v1: Vec3::X,
            v2: Vec3::Y,
        };
        let above = Target {
            point: Vec3::new(5.0, 7.0, 0.001),
            is_position: 1,
        };
        assert!(Orientation::new(&triangle, &above).is_certainly_on(1.0));
        let sun = Target {
            point: Vec3::new(1.0, 0.0, -1e-3),
            is_position: 0,
        };
        assert!(Orientation::new(&triangle, &sun).is_certainly_on(-1.0));
        let level = Target {
            point: Vec3::new(1.0, 0.0, 0.0),
            is_position: 0,
        };
        let orientation = Orientation::new(&triangle, &level);
        assert!(!orientation.is_certainly_on(1.0) && !orientation.is_certainly_on(-1.0));
    }
}
