//! Floating-point pieces whose bits are the same on every device: comparisons, powers of two, bit steps.

/// Half the distance from 1 to the next `f32`: the largest relative error of one rounded operation.
pub const UNIT_ROUNDOFF: f32 = 1.0 / 16_777_216.0;

/// Bound on the relative error of `n` rounded operations in a row, `nu / (1 - nu)` (Higham 2002, section 3.1).
#[inline]
#[must_use]
pub const fn gamma(n: u32) -> f32 {
    let nu = n as f32 * UNIT_ROUNDOFF;
    nu / (1.0 - nu)
}

/// The smaller of two numbers; the second where they are equal or unordered. One instruction everywhere.
#[inline(always)]
#[must_use]
pub const fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger of two numbers; the second where they are equal or unordered. One instruction everywhere.
#[inline(always)]
#[must_use]
pub const fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Magnitude, by the sign bit.
#[inline(always)]
#[must_use]
pub const fn abs(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7fff_ffff)
}

/// The exponent `e` of `|x|` in `[2^e, 2^(e+1))`, −149 to 127; −150 for zero. `x` must be finite.
#[inline]
#[must_use]
pub const fn exponent(x: f32) -> i32 {
    let bits = x.to_bits() & 0x7fff_ffff;
    if bits >= 0x0080_0000 {
        (bits >> 23) as i32 - 127
    } else {
        // Denormal: the highest set bit tells. Zero has 32 leading zeros.
        -118 - bits.leading_zeros() as i32
    }
}

/// `2^e`, for e from −126 to 127.
#[inline(always)]
#[must_use]
pub const fn power_of_two(e: i32) -> f32 {
    f32::from_bits(((e + 127) as u32) << 23)
}

/// `x · 2^e` for e from −300 to 300, exact unless the result leaves the normal range.
#[inline]
#[must_use]
pub const fn scale_by_power_of_two(x: f32, e: i32) -> f32 {
    // Three factors, each in range, applied from one side only, so that no intermediate result overflows early.
    let third = e / 3;
    let rest = e - 2 * third;
    x * power_of_two(third) * power_of_two(third) * power_of_two(rest)
}

/// Multiplication by a power of two that may itself be out of range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerOfTwo {
    first: f32,
    second: f32,
}

impl PowerOfTwo {
    /// Multiplication by `2^exponent`, for exponents from −252 to 254.
    #[inline(always)]
    #[must_use]
    pub const fn new(exponent: i32) -> Self {
        let first = if exponent < -126 {
            -126
        } else if exponent > 127 {
            127
        } else {
            exponent
        };
        Self {
            first: power_of_two(first),
            second: power_of_two(exponent - first),
        }
    }

    /// The one factor, where one does: from 2^-126 to 2^127.
    #[inline(always)]
    #[must_use]
    pub const fn single(&self) -> Option<f32> {
        if self.second == 1.0 {
            Some(self.first)
        } else {
            None
        }
    }

    /// Exact, unless the result leaves the normal range.
    #[inline(always)]
    #[must_use]
    pub const fn times(&self, x: f32) -> f32 {
        x * self.first * self.second
    }

    /// [`Self::times`], of each component.
    #[inline(always)]
    #[must_use]
    pub const fn times_each(&self, v: [f32; 3]) -> [f32; 3] {
        [self.times(v[0]), self.times(v[1]), self.times(v[2])]
    }
}

/// The next larger `f32`. `x` must be finite.
#[inline]
#[must_use]
pub const fn next_up(x: f32) -> f32 {
    let bits = x.to_bits();
    if bits & 0x7fff_ffff == 0 {
        f32::from_bits(1)
    } else if bits >> 31 == 0 {
        f32::from_bits(bits + 1)
    } else {
        f32::from_bits(bits - 1)
    }
}

/// The next smaller `f32`. `x` must be finite.
#[inline]
#[must_use]
pub const fn next_down(x: f32) -> f32 {
    -next_up(-x)
}

/// The upper 32 bits of the 64-bit product, from 16-bit halves: GPUs need no 64-bit integers for it.
#[inline(always)]
#[must_use]
pub const fn multiply_high(a: u32, b: u32) -> u32 {
    let (a_high, a_low) = (a >> 16, a & 0xffff);
    let (b_high, b_low) = (b >> 16, b & 0xffff);
    let low = a_low * b_low;
    let middle = (a_high * b_low).wrapping_add(low >> 16);
    let cross = (a_low * b_high).wrapping_add(middle & 0xffff);
    (a_high * b_high)
        .wrapping_add(middle >> 16)
        .wrapping_add(cross >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn exponents_of_known_numbers() {
        assert_eq!(exponent(1.0), 0);
        assert_eq!(exponent(-1.999), 0);
        assert_eq!(exponent(0.75), -1);
        assert_eq!(exponent(f32::MAX), 127);
        assert_eq!(exponent(f32::MIN_POSITIVE), -126);
        assert_eq!(exponent(f32::MIN_POSITIVE / 2.0), -127);
        assert_eq!(exponent(f32::from_bits(1)), -149);
        assert_eq!(exponent(0.0), -150);
    }

    proptest! {
        #[test]
        fn scaling_there_and_back_is_exact(x in -1e9f32..1e9, e in -60i32..60) {
            prop_assume!(x == 0.0 || abs(x) > 1e-9);
            let there = scale_by_power_of_two(x, e);
            prop_assert_eq!(there as f64, f64::from(x) * 2f64.powi(e));
            prop_assert_eq!(scale_by_power_of_two(there, -e), x);
        }

        #[test]
        fn multiply_high_is_the_upper_half(a: u32, b: u32) {
            prop_assert_eq!(u64::from(multiply_high(a, b)), (u64::from(a) * u64::from(b)) >> 32);
        }

        #[test]
        fn neighbours_are_adjacent(x in -1e30f32..1e30) {
            prop_assert!(next_up(x) > x && next_down(next_up(x)) == x);
        }
    }
}
