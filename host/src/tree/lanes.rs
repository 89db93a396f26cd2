//! The numbers of a packet's rays, in as few registers as the target has.
//!
//! Two registers of four numbers anywhere; one of eight with AVX (`-C target-cpu=native`).

use slimbvh_core::lanes::{Lanes, Wide};
use std::ops::{Add, Div, Mul, Neg, Sub};
use wide::f32x8;

/// Rays in a packet. Measured against 16: docs/measured.md.
pub const LANES: usize = 8;

/// Eight numbers. Minimum and maximum return the second operand if both are equal, as x86 does in one instruction, so that
/// the choice between −0 and +0 is the same on every processor.
#[derive(Clone, Copy, Debug)]
pub struct Numbers(f32x8);

impl Add for Numbers {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Numbers {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Numbers {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Numbers {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Numbers {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Lanes for Numbers {
    const ZERO: Self = Self(f32x8::ZERO);

    type Mask = f32x8;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self(f32x8::splat(x))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
            Self(self.0.fast_min(other.0))
        } else {
            Self(self.0.simd_lt(other.0).select(self.0, other.0))
        }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
            Self(self.0.fast_max(other.0))
        } else {
            Self(self.0.simd_gt(other.0).select(self.0, other.0))
        }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> f32x8 {
        self.0.simd_le(other.0)
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> f32x8 {
        self.0.simd_ge(other.0)
    }

    #[inline(always)]
    fn select(mask: f32x8, yes: Self, no: Self) -> Self {
        Self(mask.select(yes.0, no.0))
    }

    #[inline(always)]
    fn any(mask: f32x8) -> bool {
        mask.any()
    }
}

impl Wide<8> for Numbers {
    #[inline(always)]
    fn from_array(numbers: [f32; 8]) -> Self {
        Self(f32x8::new(numbers))
    }

    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        self.0.to_array()
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> f32 {
        self.0.as_array()[i % LANES]
    }

    #[inline(always)]
    fn columns(rows: [[f32; 8]; 8]) -> [Self; 8] {
        // One by one: `map` is not always inlined.
        let [a, b, c, d, e, f, g, h] = rows;
        let rows = [
            f32x8::new(a),
            f32x8::new(b),
            f32x8::new(c),
            f32x8::new(d),
            f32x8::new(e),
            f32x8::new(f),
            f32x8::new(g),
            f32x8::new(h),
        ];
        let [a, b, c, d, e, f, g, h] = f32x8::transpose(rows);
        [
            Self(a),
            Self(b),
            Self(c),
            Self(d),
            Self(e),
            Self(f),
            Self(g),
            Self(h),
        ]
    }

    #[inline(always)]
    fn power_below(self) -> Self {
        Self(self.0 & f32x8::splat(f32::INFINITY))
    }

    #[inline(always)]
    fn bits(mask: f32x8) -> u32 {
        mask.to_bitmask()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::array::uniform8;
    use proptest::prelude::*;
    use slimbvh_core::lanes::Each;

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

    fn bits<W: Wide<8>>(numbers: W) -> [u32; 8] {
        let bits = |x: f32| if x.is_nan() { f32::NAN } else { x }.to_bits();
        numbers.to_array().map(bits)
    }

    /// All operations on two numbers and a third.
    fn all<W: Wide<8>>(a: [f32; 8], b: [f32; 8], c: f32) -> (Vec<[u32; 8]>, Vec<u32>) {
        let (x, y) = (W::from_array(a), W::from_array(b));
        let (at_most, at_least) = (x.at_most(y), x.at_least(y));
        let numbers = [
            x + y,
            x - y,
            x * y,
            x / y,
            -x,
            x.abs(),
            x.min(y),
            x.max(y),
            x.power_below(),
            W::ZERO,
            W::splat(c),
            W::select(at_most, x, y),
        ];
        let columns =
            W::columns([0, 1, 2, 3, 4, 5, 6, 7].map(|row| if row % 3 == 0 { a } else { b }));
        let masks = [
            at_most,
            at_least,
            !at_most,
            at_most & at_least,
            at_most | at_least,
        ];
        let any = masks.map(|mask| u32::from(W::any(mask)));
        let masks = masks.map(W::bits);
        (
            numbers.into_iter().chain(columns).map(bits).collect(),
            masks.into_iter().chain(any).collect(),
        )
    }

    proptest! {
        #[test]
        fn all_lanes_compute_as_each_alone(a in uniform8(number()), b in uniform8(number()), c in number()) {
            prop_assert_eq!(all::<Numbers>(a, b, c), all::<Each<8>>(a, b, c));
        }
    }
}
