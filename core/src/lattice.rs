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
    let fraction = bits & 0x007f_ffff;
    let (significand, scale) = if biased == 0 {
        (fraction, -149)
    } else {
        (fraction | 0x0080_0000, biased as i32 - 150)
    };
    let shift = step_exponent - scale;
    let magnitude = if shift <= 0 {
        significand.wrapping_shl((-shift) as u32)
    } else if shift <= 24 {
        (significand + (1 << (shift - 1))) >> shift
    } else {
        0
    };
    if bits >> 31 == 0 {
        magnitude as i32
    } else {
        -(magnitude as i32)
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
