//! Numbers of one ray, or of several at once: the same arithmetic either way.

use crate::float;
use core::array::from_fn;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use glam::{BVec4A, Vec4};

/// A number for each lane: `f32` for one, [`Wide`] for several.
pub trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Zero in all lanes.
    const ZERO: Self;

    /// A yes or no for each lane.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + Not<Output = Self::Mask>;

    /// The same in all lanes.
    fn splat(x: f32) -> Self;

    /// The smaller in each lane.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The larger in each lane.
    #[must_use]
    fn max(self, other: Self) -> Self;

    /// Without its sign.
    #[must_use]
    fn abs(self) -> Self;

    /// Where it is smaller or equal.
    fn at_most(self, other: Self) -> Self::Mask;

    /// Where it is larger or equal.
    fn at_least(self, other: Self) -> Self::Mask;

    /// One number where the mask says yes, another where it says no.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Whether a mask says yes anywhere.
    fn any(mask: Self::Mask) -> bool;
}

impl Lanes for f32 {
    const ZERO: Self = 0.0;

    type Mask = bool;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        x
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        float::min(self, other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        float::max(self, other)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        float::abs(self)
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> bool {
        self >= other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
}

/// Numbers of several rays, 32 at most.
///
/// Each lane computes what `f32` does, to the bit, but for `min` and `max` of what is no number. [`Eight`] does so
/// everywhere; hosts have types of their own where a processor has wider registers.
pub trait Wide<const LANES: usize>: Lanes {
    /// A number for each lane.
    fn from_array(numbers: [f32; LANES]) -> Self;

    /// The number of each lane.
    fn to_array(self) -> [f32; LANES];

    /// Of a row of numbers for each lane: what stands first in all rows, and so on.
    #[inline(always)]
    fn columns(rows: [[f32; 8]; LANES]) -> [Self; 8] {
        from_fn(|column| Self::from_array(from_fn(|lane| rows[lane][column])))
    }

    /// The largest power of two that is no larger, of normal numbers above 0.
    #[must_use]
    fn power_below(self) -> Self;

    /// A bit for each lane, the first lane's lowest.
    fn bits(mask: Self::Mask) -> u32;
}

/// Eight numbers, in two registers of four.
#[derive(Clone, Copy, Debug)]
pub struct Eight(Vec4, Vec4);

/// Eight times yes or no.
#[derive(Clone, Copy, Debug)]
pub struct EightMask(BVec4A, BVec4A);

impl Eight {
    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(Vec4, Vec4) -> Vec4) -> Self {
        Self(of(self.0, other.0), of(self.1, other.1))
    }
}

impl Add for Eight {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.each(other, Vec4::add)
    }
}

impl Sub for Eight {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.each(other, Vec4::sub)
    }
}

impl Mul for Eight {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.each(other, Vec4::mul)
    }
}

impl Div for Eight {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.each(other, Vec4::div)
    }
}

impl Neg for Eight {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl BitAnd for EightMask {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0, self.1 & other.1)
    }
}

impl BitOr for EightMask {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0, self.1 | other.1)
    }
}

impl Not for EightMask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0, !self.1)
    }
}

impl Lanes for Eight {
    const ZERO: Self = Self(Vec4::ZERO, Vec4::ZERO);

    type Mask = EightMask;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self(Vec4::splat(x), Vec4::splat(x))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.each(other, Vec4::min)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.each(other, Vec4::max)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> EightMask {
        EightMask(self.0.cmple(other.0), self.1.cmple(other.1))
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> EightMask {
        EightMask(self.0.cmpge(other.0), self.1.cmpge(other.1))
    }

    #[inline(always)]
    fn select(mask: EightMask, yes: Self, no: Self) -> Self {
        Self(
            Vec4::select(mask.0, yes.0, no.0),
            Vec4::select(mask.1, yes.1, no.1),
        )
    }

    #[inline(always)]
    fn any(mask: EightMask) -> bool {
        (mask.0 | mask.1).any()
    }
}

impl Wide<8> for Eight {
    #[inline(always)]
    fn from_array([a, b, c, d, e, f, g, h]: [f32; 8]) -> Self {
        Self(Vec4::new(a, b, c, d), Vec4::new(e, f, g, h))
    }

    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        let ([a, b, c, d], [e, f, g, h]) = (self.0.to_array(), self.1.to_array());
        [a, b, c, d, e, f, g, h]
    }

    #[inline(always)]
    fn power_below(self) -> Self {
        let below = |x: f32| f32::from_bits(x.to_bits() & float::INFINITY_BITS);
        Self::from_array(self.to_array().map(below))
    }

    #[inline(always)]
    fn bits(mask: EightMask) -> u32 {
        mask.0.bitmask() | mask.1.bitmask() << 4
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::float::{max, min};
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = f32> {
        const SPECIAL: [f32; 7] = [
            0.0,
            -0.0,
            1.0,
            f32::MAX,
            f32::MIN,
            f32::INFINITY,
            f32::NEG_INFINITY,
        ];
        prop_oneof![
            2 => proptest::sample::select(&SPECIAL[..]),
            3 => any::<u32>().prop_map(f32::from_bits).prop_filter("a number", |x| !x.is_nan()),
        ]
    }

    proptest! {
        #[test]
        fn each_lane_computes_as_one_number(a in proptest::array::uniform8(number()), b in proptest::array::uniform8(number())) {
            let (x, y) = (Eight::from_array(a), Eight::from_array(b));
            let lane = |wide: Eight, i: usize| wide.to_array()[i];
            for i in 0..8 {
                let (a, b) = (a[i], b[i]);
                for (found, expected) in [(x + y, a + b), (x - y, a - b), (x * y, a * b), (x / y, a / b), (-x, -a), (x.abs(), a.abs())] {
                    let found = lane(found, i);
                    prop_assert!(found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan()));
                }
                prop_assert_eq!(lane(x.min(y), i), min(a, b));
                prop_assert_eq!(lane(x.max(y), i), max(a, b));
                prop_assert_eq!(lane(Eight::splat(a), i), a);
                let says = |mask: EightMask| Eight::bits(mask) >> i & 1 == 1;
                let (at_most, at_least) = (x.at_most(y), x.at_least(y));
                prop_assert_eq!(says(at_most), a <= b);
                prop_assert_eq!(says(at_least), a >= b);
                prop_assert_eq!(says(!at_most), a > b);
                prop_assert_eq!(says(at_most & at_least), a == b);
                prop_assert!(says(at_most | at_least));
                prop_assert_eq!(lane(Eight::select(at_most, x, y), i).to_bits(), if a <= b { a } else { b }.to_bits());
                prop_assert_eq!(Eight::any(at_most), Eight::bits(at_most) != 0);
            }
        }
    }
}
