//! Floats to integers by their bits, so that every device finds the same integer; boxes of such integers.

use crate::geometry::aabb::Aabb;
use crate::geometry::float::power_of_two;
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// The multiple of `2^step_exponent` nearest to `x`, ties away from zero, as a count of steps.
///
/// Monotone. No float arithmetic: the significand is shifted. `x` must be finite with `|x| < 2^(step_exponent + 30)`.
///
/// ```text
/// x = ± 1.mmmmmmm… · 2^(biased-127) = ± significand · 2^(max(biased, 1) - 150)
/// ```
#[inline(always)]
#[must_use]
pub const fn to_lattice(x: f32, step_exponent: i32) -> i32 {
    let bits = x.to_bits();
    let biased = (bits >> 23) & 0xff;
    let is_normal = (biased != 0) as u32;
    let significand = (bits & 0x007f_ffff) | (is_normal << 23);
    let shift = step_exponent - (biased as i32 - is_normal as i32 + 1 - 150);

    // Without a branch: one of both shifts is by nothing. Shifts of 25 and more leave nothing, with or without the half.
    let left = if shift < 0 { -shift } else { 0 };
    let right = if shift < 0 {
        0
    } else if shift > 31 {
        31
    } else {
        shift
    };
    let half = (1u32 << right) >> 1;
    let magnitude = (significand.wrapping_shl(left as u32) + half) >> right;
    let sign = bits as i32 >> 31;
    (magnitude as i32 ^ sign) - sign
}

/// The largest multiple of `2^step_exponent` that is not above `x`, as a count of steps.
///
/// Monotone. No operation is ever rounded: a product with a power of two, a cut toward zero, a comparison. `x` must be finite
/// with `|x| < 2^(step_exponent + 30)`, and the exponent from −126 to 0, or `x` 0.
#[inline(always)]
#[must_use]
pub const fn lattice_floor(x: f32, step_exponent: i32) -> i32 {
    let steps = x * power_of_two(-step_exponent);
    let whole = steps as i32;
    whole - (whole as f32 > steps) as i32
}

/// [`lattice_floor`] of four numbers at once.
#[inline(always)]
#[must_use]
pub fn lattice_floors(x: Vec4, step_exponent: i32) -> [i32; 4] {
    let steps = x * power_of_two(-step_exponent);
    let [a, b, c, d] = [
        steps.x as i32,
        steps.y as i32,
        steps.z as i32,
        steps.w as i32,
    ];
    [
        a - (a as f32 > steps.x) as i32,
        b - (b as f32 > steps.y) as i32,
        c - (c as f32 > steps.z) as i32,
        d - (d as f32 > steps.w) as i32,
    ]
}

/// The smallest multiple of `2^step_exponent` that is not below `x`, as a count of steps; as [`lattice_floor`].
#[inline(always)]
#[must_use]
pub const fn lattice_ceil(x: f32, step_exponent: i32) -> i32 {
    let steps = x * power_of_two(-step_exponent);
    let whole = steps as i32;
    whole + ((whole as f32) < steps) as i32
}

/// The whole steps from 0 to `x`, cut toward zero; of a coordinate on the lattice, all its steps.
///
/// Monotone. Two operations, and none is ever rounded but where the outcome is 0 with or without: what is no normal number is less
/// than a step. `x` must be finite with `|x| < 2^(step_exponent + 30)`, and the exponent from −126 to 126.
#[inline(always)]
#[must_use]
pub const fn lattice_steps(x: f32, step_exponent: i32) -> i32 {
    (x * power_of_two(-step_exponent)) as i32
}

/// A box on the lattice, in steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct LatticeBox {
    /// Bytes 0–11: smallest coordinates.
    pub min: [i32; 3],
    /// Bytes 12–23: largest coordinates.
    pub max: [i32; 3],
}

const _: () = assert!(size_of::<LatticeBox>() == 24);

impl LatticeBox {
    /// A box with nothing in it but the origin; all bits zero.
    pub const ZERO: Self = Self {
        min: [0; 3],
        max: [0; 3],
    };

    /// The smallest box on the lattice that holds another, whose coordinates are less than `2^(step_exponent + 30)`.
    #[inline(always)]
    #[must_use]
    pub fn around(bounds: &Aabb, step_exponent: i32) -> Self {
        let (a, b) = (bounds.min, bounds.max);
        let floor = |x: f32| lattice_floor(x, step_exponent);
        let ceil = |x: f32| lattice_ceil(x, step_exponent);
        Self {
            min: [floor(a.x), floor(a.y), floor(a.z)],
            max: [ceil(b.x), ceil(b.y), ceil(b.z)],
        }
    }

    /// The smallest box that holds both.
    #[inline(always)]
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.min, self.max);
        let ([d, e, f], [u, v, w]) = (other.min, other.max);
        Self {
            min: [a.min(d), b.min(e), c.min(f)],
            max: [x.max(u), y.max(v), z.max(w)],
        }
    }

    /// Whether the whole of `other` lies inside.
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        let mut contains = true;
        for axis in 0..3 {
            contains &= self.min[axis] <= other.min[axis] && self.max[axis] >= other.max[axis];
        }
        contains
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn known_values() {
        assert_eq!(to_lattice(0.0, -10), 0);
        assert_eq!(to_lattice(-0.0, -10), 0);
        assert_eq!(to_lattice(1.5, 0), 2);
        assert_eq!(to_lattice(-1.5, 0), -2);
        assert_eq!(to_lattice(1.25, -2), 5);
        assert_eq!(to_lattice(0.49999997, 0), 0);
        assert_eq!(to_lattice(0.5, 0), 1);
        assert_eq!(to_lattice(1024.0, -19), 1 << 29);
        assert_eq!(to_lattice(f32::from_bits(3), -149), 3);
    }

    #[test]
    fn floors_and_ceilings_of_known_values() {
        for (x, e, floor, ceil) in [
            (0.0, -10, 0, 0),
            (-0.0, -10, 0, 0),
            (1.5, 0, 1, 2),
            (-1.5, 0, -2, -1),
            (1e-30, 0, 0, 1),
            (-1e-30, 0, -1, 0),
            (f32::from_bits(1), -24, 0, 1),
            (0.75, -24, 3 << 22, 3 << 22),
            (1.0, -24, 1 << 24, 1 << 24),
        ] {
            assert_eq!(
                (lattice_floor(x, e), lattice_ceil(x, e)),
                (floor, ceil),
                "{x} {e}"
            );
        }
    }

    proptest! {
        #[test]
        fn nearest_step(x in -1.0f32..1.0, e in -24i32..0) {
            let exact = f64::from(x) * 2f64.powi(-e);
            prop_assert_eq!(f64::from(to_lattice(x, e)), exact.round());
        }

        #[test]
        fn nothing_comes_between_a_number_and_its_floor_and_ceiling(x in prop_oneof![-1.0f32..1.0, -1e-6f32..1e-6], e in -24i32..=0) {
            let exact = f64::from(x) * 2f64.powi(-e);
            prop_assert_eq!(f64::from(lattice_floor(x, e)), exact.floor());
            prop_assert_eq!(f64::from(lattice_ceil(x, e)), exact.ceil());
            let on_floor = lattice_floor(x, e);
            let four = lattice_floors(Vec4::new(x, -x, 0.0, 1.0), e);
            prop_assert_eq!(four, [on_floor, -lattice_ceil(x, e), 0, lattice_floor(1.0, e)]);
            let on = lattice_floor(x, e);
            prop_assert_eq!(lattice_steps(on as f32 * 2f32.powi(e), e), on);
        }

        #[test]
        fn monotone(a in -1.0f32..1.0, b in -1.0f32..1.0, e in -24i32..0) {
            prop_assert_eq!(a <= b, a <= b && to_lattice(a, e) <= to_lattice(b, e));
        }
    }
}
