//! On which side of a triangle something lies, and when that is certain.

use crate::geometry::float::{PowerOfTwo, abs, gamma, max, min};
use crate::geometry::triangle::Triangle;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// What a triangle may face: a point, a ball, or something infinitely far away. 32 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Target {
    /// Bytes 0–11: a position, the middle of a ball, or the direction to something infinitely far away.
    pub point: [f32; 3],
    /// Bytes 12–15: 1 for a position, 0 for a direction.
    pub is_position: u32,
    /// Bytes 16–19: a ball's radius: a lens, or all lights of a group. 0 for anything else.
    pub radius: f32,
    /// Bytes 20–31: unused.
    pub padding: [u32; 3],
}

const _: () = assert!(size_of::<Target>() == 32);

impl Target {
    /// A point: an eye, a lamp.
    #[inline]
    #[must_use]
    pub const fn position(point: [f32; 3]) -> Self {
        Self {
            point,
            is_position: 1,
            radius: 0.0,
            padding: [0; 3],
        }
    }

    /// Something infinitely far away, in this direction: the sun, a parallel camera.
    #[inline]
    #[must_use]
    pub const fn direction(direction: [f32; 3]) -> Self {
        Self {
            is_position: 0,
            ..Self::position(direction)
        }
    }

    /// All points of a ball.
    #[inline]
    #[must_use]
    pub const fn ball(center: [f32; 3], radius: f32) -> Self {
        Self {
            radius,
            ..Self::position(center)
        }
    }

    /// The target in a scene that is multiplied by a power of two. Directions stay.
    #[inline]
    #[must_use]
    pub fn scaled(&self, scale: &PowerOfTwo) -> Self {
        if self.is_position == 0 {
            return *self;
        }
        Self {
            point: scale.times_each(self.point),
            radius: scale.times(self.radius),
            ..*self
        }
    }
}

/// Signed volume of the parallelepiped of a triangle and a target, positive where the target is in front, and how far
/// from zero it must be for its sign to be certain.
#[derive(Clone, Copy, Debug)]
pub struct Orientation {
    /// `((v1 - v0) × (v2 - v0)) · (target - v0)`, rounded.
    pub volume: f32,
    /// The exact value is no farther away than this, for the whole ball.
    pub error: f32,
}

impl Orientation {
    /// Measures a triangle against a target.
    ///
    /// Each of the six terms is a product of three factors with at most one rounding each, and takes part in two more
    /// products and three sums: `gamma(8)` of the sum of magnitudes. That sum is itself rounded, and products may
    /// underflow: both are covered twice over. A ball adds its radius times the length of the normal.
    ///
    /// No product that feeds a sum is ever fused with it: the same triangle and target give the same bits in
    /// every kernel of a device, so that what one leaves out, no other counts.
    #[inline(always)]
    #[must_use]
    pub fn new(triangle: &Triangle, target: &Target) -> Self {
        let a = triangle.v1 - triangle.v0;
        let b = triangle.v2 - triangle.v0;
        let r = if target.is_position == 1 {
            Vec3::from_array(target.point) - triangle.v0
        } else {
            Vec3::from_array(target.point)
        };
        let opaque_zero = target.padding[0];
        let (xy, yx) = (
            product(a.x, b.y, opaque_zero),
            product(a.y, b.x, opaque_zero),
        );
        let (yz, zy) = (
            product(a.y, b.z, opaque_zero),
            product(a.z, b.y, opaque_zero),
        );
        let (zx, xz) = (
            product(a.z, b.x, opaque_zero),
            product(a.x, b.z, opaque_zero),
        );
        let normal = Vec3::new(yz - zy, zx - xz, xy - yx);
        let volume = dot(r, normal, opaque_zero);

        let terms = Vec3::new(abs(yz) + abs(zy), abs(zx) + abs(xz), abs(xy) + abs(yx));
        let magnitude = dot(Vec3::new(abs(r.x), abs(r.y), abs(r.z)), terms, opaque_zero);
        // Most targets are points.
        let reach = if target.radius == 0.0 {
            0.0
        } else {
            let sum = terms.x + terms.y + terms.z;
            let length = length_bound(normal, opaque_zero) + product(gamma(8), sum, opaque_zero);
            product(
                target.radius,
                product(length, 1.0 + gamma(8), opaque_zero),
                opaque_zero,
            )
        };
        Self {
            volume,
            error: product(gamma(16), magnitude, opaque_zero) + reach + 16.0 * f32::MIN_POSITIVE,
        }
    }

    /// Whether the target is certainly on the front side (`side` 1) or on the back side (`side` −1), all of it.
    #[inline]
    #[must_use]
    pub fn is_certainly_on(&self, side: f32) -> bool {
        self.volume * side > self.error
    }

    /// The side that all of the target is certainly on: 1 for the front, −1 for the back, 0 where none is certain.
    #[inline(always)]
    #[must_use]
    pub fn certain_side(&self) -> i32 {
        self.is_certainly_on(1.0) as i32 - self.is_certainly_on(-1.0) as i32
    }
}

/// A product that no compiler fuses with a sum: `opaque_zero` is always 0, hidden from the compiler.
#[inline(always)]
pub(crate) fn product(x: f32, y: f32, opaque_zero: u32) -> f32 {
    f32::from_bits((x * y).to_bits() ^ opaque_zero)
}

#[inline(always)]
pub(crate) fn dot(a: Vec3, b: Vec3, opaque_zero: u32) -> f32 {
    product(a.x, b.x, opaque_zero) + product(a.y, b.y, opaque_zero) + product(a.z, b.z, opaque_zero)
}

/// No less than a vector's length, and at most 13 % more, but for rounding: with its magnitudes in falling order,
/// `√(a² + b² + c²) ≤ a + (√2 − 1) b + (√3 − √2) c`. No root, whose rounding differs from device to device.
#[inline(always)]
fn length_bound(v: Vec3, opaque_zero: u32) -> f32 {
    let (x, y, z) = (abs(v.x), abs(v.y), abs(v.z));
    let largest = max(x, max(y, z));
    let smallest = min(x, min(y, z));
    let between = max(min(x, y), min(max(x, y), z));
    largest + product(0.414_214, between, opaque_zero) + product(0.317_838, smallest, opaque_zero)
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
                let orientation = Orientation::new(&triangle, &Target::position(point.to_array()));
                let sign = exact_sign(t, p);
                prop_assert!(!orientation.is_certainly_on(1.0) || sign > 0);
                prop_assert!(!orientation.is_certainly_on(-1.0) || sign < 0);
                let certain = i64::from(orientation.certain_side());
                prop_assert!(certain == sign || (certain == 0 && !orientation.is_certainly_on(sign as f32)));
            }
        }
    }

    proptest! {
        /// Each product is rounded before it is summed: 53 bits hold any product of two floats.
        #[test]
        fn no_product_is_fused_with_a_sum(t in proptest::array::uniform3(proptest::array::uniform3(-1.0f32..1.0)), p in proptest::array::uniform3(-1.0f32..1.0)) {
            let [v0, v1, v2] = t.map(Vec3::from_array);
            let (a, b, r) = (v1 - v0, v2 - v0, Vec3::from_array(p) - v0);
            let rounded = |x: f32, y: f32| (f64::from(x) * f64::from(y)) as f32;
            let across = |x: f32, y: f32, z: f32, w: f32| rounded(x, y) - rounded(z, w);
            let normal = [
                across(a.y, b.z, a.z, b.y),
                across(a.z, b.x, a.x, b.z),
                across(a.x, b.y, a.y, b.x),
            ];
            let volume = rounded(r.x, normal[0]) + rounded(r.y, normal[1]) + rounded(r.z, normal[2]);
            let orientation = Orientation::new(&Triangle { v0, v1, v2 }, &Target::position(p));
            prop_assert_eq!(orientation.volume.to_bits(), volume.to_bits());
        }
    }

    /// Lights in front of a triangle, to the side, and a ball that its plane cuts.
    #[test]
    fn a_ball_is_on_a_side_only_as_a_whole() {
        let triangle = Triangle {
            v0: Vec3::new(1.0, 2.0, 3.0),
            v1: Vec3::new(1.0, 2.5, 3.0),
            v2: Vec3::new(1.0, 2.0, 4.0),
        };
        for (x, radius, is_certain) in [(4.0, 2.5, true), (4.0, 3.5, false), (1.5, 0.25, true)] {
            let front = Target::ball([x, 7.0, -5.0], radius);
            let orientation = Orientation::new(&triangle, &front);
            assert_eq!(orientation.is_certainly_on(1.0), is_certain, "{x} {radius}");
            assert!(!orientation.is_certainly_on(-1.0));
            let back = Target::ball([2.0 - x, 7.0, -5.0], radius);
            let orientation = Orientation::new(&triangle, &back);
            assert_eq!(
                orientation.is_certainly_on(-1.0),
                is_certain,
                "{x} {radius}"
            );
        }
    }

    proptest! {
        #[test]
        fn the_bound_of_a_length_is_no_less_and_little_more(v in proptest::array::uniform3(-1e3f32..1e3)) {
            let v = Vec3::from_array(v);
            let exact = v.to_array().map(f64::from).iter().map(|x| x * x).sum::<f64>().sqrt();
            let bound = f64::from(length_bound(v, 0));
            prop_assert!(bound >= exact * (1.0 - 1e-6) && bound <= exact * 1.1285 + 1e-6);
        }
    }

    #[test]
    fn plain_cases_are_certain() {
        let triangle = Triangle {
            v0: Vec3::ZERO,
            v1: Vec3::X,
            v2: Vec3::Y,
        };
        let above = Target::position([5.0, 7.0, 0.001]);
        assert!(Orientation::new(&triangle, &above).is_certainly_on(1.0));
        let sun = Target::direction([1.0, 0.0, -1e-3]);
        assert!(Orientation::new(&triangle, &sun).is_certainly_on(-1.0));
        let level = Target::direction([1.0, 0.0, 0.0]);
        let orientation = Orientation::new(&triangle, &level);
        assert!(!orientation.is_certainly_on(1.0) && !orientation.is_certainly_on(-1.0));
    }
}
