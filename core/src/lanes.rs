//! Numbers of one ray, or of several at once: the same arithmetic either way.

use core::ops::{Add, BitAnd, BitOr, Mul, Neg, Sub};
use glam::{BVec4A, Vec4};

/// A number for each lane: `f32` for one, [`Wide`] for several.
pub trait Lanes: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A yes or no for each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask>;

    /// Where it is smaller or equal.
    fn at_most(self, other: Self) -> Self::Mask;

    /// Where it is larger or equal.
    fn at_least(self, other: Self) -> Self::Mask;
}

impl Lanes for f32 {
    type Mask = bool;

    #[inline(always)]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> bool {
        self >= other
    }
}

/// Numbers of several rays, 32 at most. Masks hold a bit a lane, the first lane lowest.
///
/// Each lane computes what `f32` does, to the bit. [`Eight`] does so everywhere; hosts have types of their own where a
/// processor has wider registers.
pub trait Wide: Lanes<Mask = u32> + Neg<Output = Self> {
    /// Zero in all lanes.
    const ZERO: Self;

    /// The same in all lanes.
    fn splat(x: f32) -> Self;

    /// The smaller in each lane.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The larger in each lane.
    #[must_use]
    fn max(self, other: Self) -> Self;
}

/// Eight numbers, in two registers of four.
#[derive(Clone, Copy, Debug)]
pub struct Eight(Vec4, Vec4);

impl Eight {
    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(Vec4, Vec4) -> Vec4) -> Self {
        Self(of(self.0, other.0), of(self.1, other.1))
    }

    #[inline(always)]
    fn mask(self, other: Self, of: impl Fn(Vec4, Vec4) -> BVec4A) -> u32 {
        of(self.0, other.0).bitmask() | of(self.1, other.1).bitmask() << 4
    }
}

impl From<[f32; 8]> for Eight {
    #[inline(always)]
    fn from([a, b, c, d, e, f, g, h]: [f32; 8]) -> Self {
        Self(Vec4::new(a, b, c, d), Vec4::new(e, f, g, h))
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

impl Neg for Eight {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Lanes for Eight {
    type Mask = u32;

    #[inline(always)]
    fn at_most(self, other: Self) -> u32 {
        self.mask(other, Vec4::cmple)
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> u32 {
        self.mask(other, Vec4::cmpge)
    }
}

impl Wide for Eight {
    const ZERO: Self = Self(Vec4::ZERO, Vec4::ZERO);

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
            let (x, y) = (Eight::from(a), Eight::from(b));
            let lane = |wide: Eight, i: usize| [wide.0, wide.1][i / 4][i % 4];
            for i in 0..8 {
                let (a, b) = (a[i], b[i]);
                for (found, expected) in [(x + y, a + b), (x - y, a - b), (x * y, a * b), (-x, -a)] {
                    let found = lane(found, i);
                    prop_assert!(found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan()));
                }
                prop_assert_eq!(lane(x.min(y), i), min(a, b));
                prop_assert_eq!(lane(x.max(y), i), max(a, b));
                prop_assert_eq!(lane(Eight::splat(a), i), a);
                prop_assert_eq!(x.at_most(y) >> i & 1 == 1, a.at_most(b));
                prop_assert_eq!(x.at_least(y) >> i & 1 == 1, a.at_least(b));
            }
        }
    }
}
