//! Floats to integers by their bits, so that every device finds the same integer.

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

    proptest! {
        #[test]
        fn nearest_step(x in -1.0f32..1.0, e in -24i32..0) {
            let exact = f64::from(x) * 2f64.powi(-e);
            prop_assert_eq!(f64::from(to_lattice(x, e)), exact.round());
        }

        #[test]
        fn monotone(a in -1.0f32..1.0, b in -1.0f32..1.0, e in -24i32..0) {
            prop_assert_eq!(a <= b, a <= b && to_lattice(a, e) <= to_lattice(b, e));
        }
    }
}
