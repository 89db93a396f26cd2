//! Numbers of one ray, or of several at once: the same arithmetic either way.

use core::ops::{Add, BitAnd, BitOr, Mul, Neg, Sub};
use glam::Vec4;

/// A number for each lane: `f32` for one, [`Wide`] for several.
pub trait Lanes: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A yes or no for each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask>;

    /// The same in all lanes.
    fn splat(x: f32) -> Self;

    /// Where it is smaller or equal.
    fn at_most(self, other: Self) -> Self::Mask;

    /// Where it is larger or equal.
    fn at_least(self, other: Self) -> Self::Mask;
}

impl Lanes for f32 {
    type Mask = bool;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        x
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> bool {
        self >= other
    }
}

/// Four numbers a group, in at most eight groups. Masks hold a bit a lane, the first lane lowest.
#[derive(Clone, Copy, Debug)]
pub struct Wide<const GROUPS: usize>(pub [Vec4; GROUPS]);

impl<const GROUPS: usize> Wide<GROUPS> {
    /// Zero in all lanes.
    pub const ZERO: Self = Self([Vec4::ZERO; GROUPS]);

    /// Of each lane's number.
    #[inline(always)]
    #[must_use]
    pub fn from_lanes(lane: impl Fn(usize, usize) -> f32) -> Self {
        let mut wide = Self::ZERO;
        for group in 0..GROUPS {
            let lane = |i| lane(group, i);
            wide.0[group] = Vec4::new(lane(0), lane(1), lane(2), lane(3));
        }
        wide
    }

    /// The smaller in each lane.
    #[inline(always)]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        self.each(other, Vec4::min)
    }

    /// The larger in each lane.
    #[inline(always)]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        self.each(other, Vec4::max)
    }

    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(Vec4, Vec4) -> Vec4) -> Self {
        let mut wide = self;
        for group in 0..GROUPS {
            wide.0[group] = of(self.0[group], other.0[group]);
        }
        wide
    }

    #[inline(always)]
    fn mask(self, other: Self, of: impl Fn(Vec4, Vec4) -> u32) -> u32 {
        const { assert!(GROUPS <= 8, "a mask has 32 bits") };
        let mut mask = 0;
        for group in 0..GROUPS {
            mask |= of(self.0[group], other.0[group]) << (4 * group);
        }
        mask
    }
}

impl<const GROUPS: usize> Add for Wide<GROUPS> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.each(other, Vec4::add)
    }
}

impl<const GROUPS: usize> Sub for Wide<GROUPS> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.each(other, Vec4::sub)
    }
}

impl<const GROUPS: usize> Mul for Wide<GROUPS> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.each(other, Vec4::mul)
    }
}

impl<const GROUPS: usize> Neg for Wide<GROUPS> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.each(self, |x, _| -x)
    }
}

impl<const GROUPS: usize> Lanes for Wide<GROUPS> {
    type Mask = u32;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self([Vec4::splat(x); GROUPS])
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> u32 {
        self.mask(other, |a, b| a.cmple(b).bitmask())
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> u32 {
        self.mask(other, |a, b| a.cmpge(b).bitmask())
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

    fn wide(numbers: &[f32; 8]) -> Wide<2> {
        Wide::from_lanes(|group, i| numbers[4 * group + i])
    }

    proptest! {
        #[test]
        fn each_lane_computes_as_one_number(a in proptest::array::uniform8(number()), b in proptest::array::uniform8(number())) {
            let (x, y) = (wide(&a), wide(&b));
            let lane = |wide: Wide<2>, i: usize| wide.0[i / 4].to_array()[i % 4];
            for i in 0..8 {
                let (a, b) = (a[i], b[i]);
                for (found, expected) in [(x + y, a + b), (x - y, a - b), (x * y, a * b), (-x, -a)] {
                    let found = lane(found, i);
                    prop_assert!(found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan()));
                }
                prop_assert_eq!(lane(x.min(y), i), min(a, b));
                prop_assert_eq!(lane(x.max(y), i), max(a, b));
                prop_assert_eq!(lane(Wide::splat(a), i), a);
                prop_assert_eq!(x.at_most(y) >> i & 1 == 1, a.at_most(b));
                prop_assert_eq!(x.at_least(y) >> i & 1 == 1, a.at_least(b));
            }
        }
    }
}
