//! Numbers of the rays of a packet, in one register where processors have one so wide.
//!
//! Which one is settled when this is compiled: `-C target-cpu=native` is for the machine that it is built on.

/// Rays in a packet. Measured against 16: ARCHITECTURE.md.
pub const LANES: usize = 8;

#[cfg(not(target_feature = "avx"))]
pub use slimbvh_core::lanes::Eight as Numbers;

#[cfg(target_feature = "avx")]
pub use one_register::Numbers;

#[cfg(target_feature = "avx")]
mod one_register {
    use slimbvh_core::lanes::{Lanes, Wide};
    use std::ops::{Add, Div, Mul, Neg, Sub};
    use wide::f32x8;

    /// Eight numbers, in one register.
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
            Self(self.0.fast_min(other.0))
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Self(self.0.fast_max(other.0))
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
        fn columns(rows: [[f32; 8]; 8]) -> [Self; 8] {
            f32x8::transpose(rows.map(f32x8::new)).map(Self)
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
}
