//! Whether a target is certainly outside of a box.

use crate::geometry::float::{PowerOfTwo, exponent, gamma, max};
use crate::geometry::orientation::{Target, product};

/// Whether all of a target certainly lies outside of a box; on the border is not outside. Directions always do. Positions,
/// directions and radii that are not finite, and negative radii, never do.
///
/// A point is compared, exactly. A ball's distance from the box is rounded: a difference has one rounding and its square one
/// more, with two sums behind, `gamma(5)` in all, and the radius two. Both are covered twice over.
#[inline]
#[must_use]
pub fn is_clear_of_box(low: [f32; 3], high: [f32; 3], target: &Target) -> bool {
    let p = target.point;
    if !(is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2])) {
        return false;
    }
    if target.is_position == 0 {
        return true;
    }
    let (radius, opaque_zero) = (target.radius, target.padding[0]);
    if !is_finite(radius) || radius < 0.0 {
        return false;
    }
    if radius == 0.0 {
        return is_beyond(p[0], low[0], high[0])
            || is_beyond(p[1], low[1], high[1])
            || is_beyond(p[2], low[2], high[2]);
    }

    // Along one axis alone, in any unit.
    let gaps = [
        gap(p[0], low[0], high[0]),
        gap(p[1], low[1], high[1]),
        gap(p[2], low[2], high[2]),
    ];
    let reach = product(radius, 1.0 + gamma(8), opaque_zero);
    if gaps[0] > reach || gaps[1] > reach || gaps[2] > reach {
        return true;
    }

    // No gap is longer than the radius: both are brought to magnitude 1, and squares neither overflow nor vanish.
    let scale = PowerOfTwo::new(-(exponent(radius) + 1));
    let [x, y, z] = scale.times_each(gaps);
    let radius = scale.times(radius);
    let squared =
        product(x, x, opaque_zero) + product(y, y, opaque_zero) + product(z, z, opaque_zero);
    squared
        > product(
            product(radius, radius, opaque_zero),
            1.0 + gamma(16),
            opaque_zero,
        )
}

/// Whether a coordinate lies outside of a range.
#[inline(always)]
fn is_beyond(x: f32, low: f32, high: f32) -> bool {
    x < low || x > high
}

/// How far a coordinate lies outside of a range, 0 inside.
#[inline(always)]
fn gap(x: f32, low: f32, high: f32) -> f32 {
    max(max(low - x, x - high), 0.0)
}

/// By the bits: shaders know no infinity.
#[inline(always)]
const fn is_finite(x: f32) -> bool {
    x.to_bits() & 0x7f80_0000 != 0x7f80_0000
}
