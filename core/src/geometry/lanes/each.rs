//! Several numbers, one by one.

use super::{Lanes, Wide};
use crate::geometry::float::INFINITY_BITS;
use core::array::from_fn;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A number for each lane, computed with one by one.
#[derive(Clone, Copy, Debug)]
pub struct Each<const LANES: usize>(pub [f32; LANES]);

/// Yes or no for each lane.
#[derive(Clone, Copy, Debug)]
pub struct EachMask<const LANES: usize>([bool; LANES]);

impl<const LANES: usize> Each<LANES> {
    #[inline(always)]
    fn with(self, other: Self, of: impl Fn(f32, f32) -> f32) -> Self {
        Self(from_fn(|i| of(self.0[i], other.0[i])))
    }

    #[inline(always)]
    fn mask(self, other: Self, of: impl Fn(f32, f32) -> bool) -> EachMask<LANES> {
        EachMask(from_fn(|i| of(self.0[i], other.0[i])))
    }
}

impl<const LANES: usize> Add for Each<LANES> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, f32::add)
    }
}

impl<const LANES: usize> Sub for Each<LANES> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, f32::sub)
    }
}

impl<const LANES: usize> Mul for Each<LANES> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, f32::mul)
    }
}

impl<const LANES: usize> Div for Each<LANES> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, f32::div)
    }
}

impl<const LANES: usize> Neg for Each<LANES> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(f32::neg))
    }
}

impl<const LANES: usize> BitAnd for EachMask<LANES> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] & other.0[i]))
    }
}

impl<const LANES: usize> BitOr for EachMask<LANES> {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] | other.0[i]))
    }
}

impl<const LANES: usize> Not for EachMask<LANES> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(bool::not))
    }
}

impl<const LANES: usize> Lanes for Each<LANES> {
    const ZERO: Self = Self([0.0; LANES]);

    type Mask = EachMask<LANES>;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self([x; LANES])
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.with(other, Lanes::min)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.with(other, Lanes::max)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(Lanes::abs))
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> EachMask<LANES> {
        self.mask(other, Lanes::at_most)
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> EachMask<LANES> {
        self.mask(other, Lanes::at_least)
    }

    #[inline(always)]
    fn select(mask: EachMask<LANES>, yes: Self, no: Self) -> Self {
        Self(from_fn(|i| Lanes::select(mask.0[i], yes.0[i], no.0[i])))
    }

    #[inline(always)]
    fn any(mask: EachMask<LANES>) -> bool {
        Self::bits(mask) != 0
    }
}

impl<const LANES: usize> Wide<LANES> for Each<LANES> {
    #[inline(always)]
    fn from_array(numbers: [f32; LANES]) -> Self {
        Self(numbers)
    }

    #[inline(always)]
    fn to_array(self) -> [f32; LANES] {
        self.0
    }

    #[inline(always)]
    fn power_below(self) -> Self {
        Self(self.0.map(|x| f32::from_bits(x.to_bits() & INFINITY_BITS)))
    }

    #[inline(always)]
    fn bits(mask: EachMask<LANES>) -> u32 {
        let mut bits = 0;
        for (i, &yes) in mask.0.iter().enumerate() {
            bits |= u32::from(yes) << i;
        }
        bits
    }
}
