//! Stage `snap`: triangles on their way into the tree, carried to the scene's magnitude. Everything after it sees only
//! these.

use crate::geometry::float::{PowerOfTwo, abs};
use crate::geometry::triangle::{IndexedTriangles, LeafTriangle, Triangle};
use glam::Vec3;

/// A coordinate at the scene's magnitude. Never −0, so that the smaller of two numbers does not depend on their order, and 0 where
/// it is no normal number: to some devices that is zero anyway.
#[inline(always)]
#[must_use]
pub const fn snap(x: f32, scale: &PowerOfTwo) -> f32 {
    let scaled = scale.times(x);
    if abs(scaled) < f32::MIN_POSITIVE {
        0.0
    } else {
        scaled
    }
}

/// A triangle's corners at the scene's magnitude.
#[inline(always)]
#[must_use]
pub fn snap_triangle(triangle: &Triangle, scale: &PowerOfTwo) -> Triangle {
    let snap = |v: Vec3| Vec3::new(snap(v.x, scale), snap(v.y, scale), snap(v.z, scale));
    Triangle {
        v0: snap(triangle.v0),
        v1: snap(triangle.v1),
        v2: snap(triangle.v2),
    }
}

/// One thread per triangle, in leaf order. Reads the caller's triangle. Returns it as leaves store it.
#[inline(always)]
#[must_use]
pub fn leaf_triangle(
    primitive: u32,
    triangles: &IndexedTriangles,
    scale: &PowerOfTwo,
) -> LeafTriangle {
    let Triangle { v0, v1, v2 } = snap_triangle(&triangles.triangle(primitive), scale);
    LeafTriangle {
        vertices: [v0.x, v0.y, v0.z, v1.x, v1.y, v1.z, v2.x, v2.y, v2.z],
        primitive,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn zero_is_positive() {
        assert_eq!(snap(-0.0, &PowerOfTwo::new(3)).to_bits(), 0);
        assert_eq!(snap(-1e-30, &PowerOfTwo::new(-126)).to_bits(), 0);
    }

    #[test]
    fn what_is_no_normal_number_is_zero() {
        let half = PowerOfTwo::new(-1);
        assert_eq!(snap(f32::MIN_POSITIVE, &half).to_bits(), 0);
        assert_eq!(snap(2.0 * f32::MIN_POSITIVE, &half), f32::MIN_POSITIVE);
        let twice = PowerOfTwo::new(1);
        assert_eq!(snap(f32::MIN_POSITIVE / 2.0, &twice), f32::MIN_POSITIVE);
    }

    proptest! {
        #[test]
        fn the_largest_scenes_and_the_smallest_come_to_one(x in 0.5f32..1.0, e in -125i32..128) {
            let far = x * 2f32.powi(e / 2) * 2f32.powi(e - e / 2);
            prop_assert_eq!(snap(far, &PowerOfTwo::new(-e)), x);
        }
    }
}
