//! Stage `snap`: triangles on their way into the tree, carried to the scene's magnitude. Everything after it sees only
//! these.

use crate::float::power_of_two;
use crate::triangle::{IndexedTriangles, LeafTriangle, Triangle};
use glam::Vec3;

/// Multiplication by a power of two that may itself be out of range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    first: f32,
    second: f32,
}

impl Scale {
    /// Multiplication by `2^exponent`, for exponents from −252 to 252.
    #[inline]
    #[must_use]
    pub const fn new(exponent: i32) -> Self {
        let half = exponent / 2;
        Self {
            first: power_of_two(half),
            second: power_of_two(exponent - half),
        }
    }

    /// Exact, unless the result is denormal. Never −0, so that the smaller of two numbers does not depend on their order.
    #[inline(always)]
    #[must_use]
    pub fn snap(&self, x: f32) -> f32 {
        let scaled = x * self.first * self.second;
        if scaled == 0.0 { 0.0 } else { scaled }
    }
}

/// One thread per triangle, in leaf order. Reads the caller's triangle. Returns it as leaves store it.
#[inline(always)]
#[must_use]
pub fn leaf_triangle(primitive: u32, triangles: &IndexedTriangles, scale: &Scale) -> LeafTriangle {
    let Triangle { v0, v1, v2 } = triangles.triangle(primitive);
    let snap = |v: Vec3| [scale.snap(v.x), scale.snap(v.y), scale.snap(v.z)];
    let ([a, b, c], [d, e, f], [g, h, i]) = (snap(v0), snap(v1), snap(v2));
    LeafTriangle {
        vertices: [a, b, c, d, e, f, g, h, i],
        primitive,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn zero_is_positive() {
        assert_eq!(Scale::new(3).snap(-0.0).to_bits(), 0);
        assert_eq!(Scale::new(-126).snap(-1e-30).to_bits(), 0);
    }

    proptest! {
        #[test]
        fn the_largest_scenes_and_the_smallest_come_to_one(x in 0.5f32..1.0, e in -125i32..128) {
            let far = x * 2f32.powi(e / 2) * 2f32.powi(e - e / 2);
            prop_assert_eq!(Scale::new(-e).snap(far), x);
        }
    }
}
