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

/// The smaller of two numbers; the second where they are equal or unordered. One instruction on a CPU, two on a GPU: [`least`] is
/// one there, too.
#[inline(always)]
#[must_use]
pub const fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger of two numbers; the second where they are equal or unordered. See [`most`].
#[inline(always)]
#[must_use]
pub const fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller of two numbers, neither of them NaN, in one instruction. Of two zeros it may be either: what comes out may be compared,
/// but not stored.
#[inline(always)]
#[must_use]
pub fn least(a: f32, b: f32) -> f32 {
    #[cfg(target_arch = "spirv")]
    return libm::fminf(a, b);
    #[cfg(not(target_arch = "spirv"))]
    return min(a, b);
}

/// The larger of two numbers, as [`least`].
#[inline(always)]
#[must_use]
pub fn most(a: f32, b: f32) -> f32 {
    #[cfg(target_arch = "spirv")]
    return libm::fmaxf(a, b);
    #[cfg(not(target_arch = "spirv"))]
    return max(a, b);
}

/// The number, or 0 where it is −0: by its bits, as compilers may take a comparison with either zero for nothing.
#[inline(always)]
#[must_use]
pub const fn positive_zero(x: f32) -> f32 {
    if x.to_bits() == 0x8000_0000 { 0.0 } else { x }
}

/// A whole number below 2^23 as a float: on a GPU by a sum, as it does many of them while it does one conversion.
#[inline(always)]
#[must_use]
pub const fn whole_number(n: u32) -> f32 {
    if cfg!(target_arch = "spirv") {
        by_a_sum(n)
    } else {
        n as i32 as f32
    }
}

/// [`whole_number`], as the last bits of a sum with 2^23.
#[inline(always)]
const fn by_a_sum(n: u32) -> f32 {
    f32::from_bits(0x4b00_0000 | n) - 8_388_608.0
}

/// An integer that compares as the number does, with −0 below 0: also where a device takes what is no normal number for zero.
#[inline(always)]
#[must_use]
pub const fn order_key(x: f32) -> i32 {
    let bits = x.to_bits() as i32;
    bits ^ (bits >> 31 & 0x7fff_ffff)
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
        // Denormal: the exponent follows from the highest set bit. Zero has 32 leading zeros.
        -118 - bits.leading_zeros() as i32
    }
}

/// `2^e`, for e from −126 to 127.
#[inline(always)]
#[must_use]
pub const fn power_of_two(e: i32) -> f32 {
    f32::from_bits(((e + 127) as u32) << 23)
}

/// `x · 2^e` for e from −300 to 300, rounded once, to nearest; beyond the range infinite. By integers alone: a device may take what
/// is no normal number for zero wherever floats are computed with.
#[inline]
#[must_use]
pub const fn scale_by_power_of_two(x: f32, e: i32) -> f32 {
    let bits = x.to_bits();
    let biased = (bits >> 23) as i32 & 0xff;
    let scaled = biased + e;
    if biased == 0xff {
        x
    } else if biased > 0 && scaled > 0 && scaled < 0xff {
        f32::from_bits(bits.wrapping_add((e << 23) as u32))
    } else {
        from_significand(
            bits & 0x8000_0000,
            significand(bits),
            scaled + (biased == 0) as i32,
        )
    }
}

/// [`scale_by_power_of_two`], but 0 where the result is no normal number, and the largest number beyond the range.
#[inline(always)]
#[must_use]
pub const fn scale_to_normal(x: f32, e: i32) -> f32 {
    let bits = magnitude_bits(x);
    let (significand, biased) = (significand(bits), (bits >> 23) as i32);
    // Nothing but zero has no bit at all, and comes out below the range.
    let left = significand.leading_zeros() as i32 - 8;
    let to = if biased == 0xff {
        0xff
    } else {
        biased + (biased == 0) as i32 - left + e
    };
    normal_or_end(x, significand << (left & 31), to)
}

/// [`scale_to_normal`] of a number that is not denormal.
#[inline(always)]
#[must_use]
pub const fn normal_scaled_to_normal(x: f32, e: i32) -> f32 {
    let bits = magnitude_bits(x);
    let to = if bits >= INFINITY_BITS {
        0xff
    } else {
        (bits >> 23) as i32 + e
    };
    normal_or_end(x, if bits == 0 { 0 } else { bits | 0x0080_0000 }, to)
}

/// The number with this sign, this significand, whose lowest 24 bits count, and this biased exponent; 0 below the normal range or
/// where there is no significand, the largest number beyond.
#[inline(always)]
const fn normal_or_end(sign: f32, significand: u32, biased: i32) -> f32 {
    let inner = (biased as u32) << 23 | significand & 0x007f_ffff;
    let magnitude = if biased <= 0 || significand == 0 {
        0
    } else if biased >= 0xff {
        f32::MAX.to_bits()
    } else {
        inner
    };
    f32::from_bits((sign.to_bits() & 0x8000_0000) | magnitude)
}

/// The 24 bits of a number's significand: the highest is 0 where it is no normal number.
#[inline(always)]
const fn significand(bits: u32) -> u32 {
    (bits & 0x007f_ffff) | (((bits & 0x7f80_0000 != 0) as u32) << 23)
}

/// The number `± significand · 2^(biased - 150)`, rounded to nearest, ties to even.
const fn from_significand(sign: u32, significand: u32, biased: i32) -> f32 {
    if significand == 0 {
        return f32::from_bits(sign);
    }
    let left = significand.leading_zeros() - 8;
    let (normal, biased) = (significand << left, biased - left as i32);
    if biased >= 0xff {
        return f32::from_bits(sign | INFINITY_BITS);
    }
    if biased > 0 {
        return f32::from_bits(sign | (biased as u32) << 23 | (normal & 0x007f_ffff));
    }
    // What is below a quarter of the smallest number is nothing.
    let right = if biased < -24 {
        26
    } else {
        (1 - biased) as u32
    };
    let (kept, rest) = (normal >> right, normal & ((1 << right) - 1));
    let half = 1 << (right - 1);
    let is_up = rest > half || (rest == half && kept & 1 == 1);
    f32::from_bits(sign | (kept + is_up as u32))
}

/// The bits of infinity: magnitudes of numbers have less, of what is none have more.
pub const INFINITY_BITS: u32 = 0x7f80_0000;

/// The bits of a number's magnitude: they compare as it does, with infinity above all numbers and NaN above that.
#[inline(always)]
#[must_use]
pub const fn magnitude_bits(x: f32) -> u32 {
    x.to_bits() & 0x7fff_ffff
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
        if cfg!(target_arch = "spirv") {
            self.times_steps(x)
        } else {
            x * self.first * self.second
        }
    }

    /// [`Self::times`] where a device may take what is no normal number for zero: such a number is counted in steps of the smallest.
    #[inline(always)]
    const fn times_steps(&self, x: f32) -> f32 {
        let bits = x.to_bits();
        let is_normal = bits & INFINITY_BITS != 0;
        let steps = whole_number(bits & 0x007f_ffff) * power_of_two(-126);
        let steps = f32::from_bits(steps.to_bits() | (bits & 0x8000_0000));
        let from = if is_normal { x } else { steps };
        let step = if is_normal { 1.0 } else { power_of_two(-23) };
        from * self.first * step * self.second
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
        fn scaling_rounds_once(bits: u32, e in -300i32..=300) {
            let x = f32::from_bits(bits);
            prop_assume!(x.is_finite());
            let expected = (f64::from(x) * 2f64.powi(e)) as f32;
            prop_assert_eq!(scale_by_power_of_two(x, e).to_bits(), expected.to_bits());
        }

        #[test]
        fn scaling_to_normal_numbers_leaves_none_else(bits: u32, e in -300i32..=300) {
            let x = f32::from_bits(bits);
            prop_assume!(!x.is_nan());
            let scaled = scale_by_power_of_two(x, e);
            let expected = if scaled.is_subnormal() { 0.0f32.copysign(x) } else { scaled.clamp(-f32::MAX, f32::MAX) };
            // What is rounded up to the smallest normal number may be either.
            let found = scale_to_normal(x, e);
            let is_least = abs(expected) == f32::MIN_POSITIVE && abs(found) == 0.0;
            prop_assert!(found.to_bits() == expected.to_bits() || is_least, "{found:e} {expected:e}");
        }

        #[test]
        fn denormals_are_multiplied_as_whole_steps(bits in prop_oneof![0u32..0x0080_0000, 0u32..INFINITY_BITS], is_negative: bool, e in -126i32..=254) {
            let x = f32::from_bits(bits | u32::from(is_negative) << 31);
            let scale = PowerOfTwo::new(e);
            let (expected, found) = (scale.times(x), scale.times_steps(x));
            // Below the normal range either may round as it likes.
            if expected.is_normal() || found.is_normal() || e >= 0 {
                prop_assert_eq!(found.to_bits(), expected.to_bits());
            }
        }

        #[test]
        fn whole_numbers_are_what_conversion_makes_of_them(n in 0u32..1 << 23) {
            prop_assert_eq!(by_a_sum(n), n as f32);
            prop_assert_eq!(whole_number(n), n as f32);
        }

        #[test]
        fn keys_are_in_the_order_of_their_numbers(a: u32, b: u32) {
            let (a, b) = (f32::from_bits(a), f32::from_bits(b));
            prop_assume!(!a.is_nan() && !b.is_nan());
            prop_assert_eq!(order_key(a).cmp(&order_key(b)), a.total_cmp(&b));
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
