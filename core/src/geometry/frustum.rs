//! What a camera's rays can reach: a cone of four planes, or for parallel rays a shaft.

use crate::geometry::float::{PowerOfTwo, abs, gamma};
use crate::geometry::triangle::Triangle;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// The sides of a picture, as planes. 80 bytes.
///
/// Who makes one sets the planes apart from the outermost rays, by more than rounding moves these
/// (`slimbvh::scene::frustum` does).
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frustum {
    /// Bytes 0–11: the eye, or the middle of a parallel camera's picture.
    pub eye: [f32; 3],
    /// Bytes 12–15: 1 where the planes bound anything, 0 where rays may go anywhere.
    pub is_bounded: u32,
    /// Bytes 16–79: a unit normal that points inward, and how far the eye is from the plane. A normal of zero bounds
    /// nothing.
    pub planes: [[f32; 4]; 4],
}

const _: () = assert!(size_of::<Frustum>() == 80);

impl Frustum {
    /// Rays may go anywhere.
    pub const EVERYWHERE: Self = Self {
        eye: [0.0; 3],
        is_bounded: 0,
        planes: [[0.0; 4]; 4],
    };

    /// The same in a scene that is multiplied by a power of two.
    #[inline]
    #[must_use]
    pub fn scaled(&self, scale: &PowerOfTwo) -> Self {
        let mut frustum = *self;
        frustum.eye = scale.times_each(self.eye);
        for i in 0..4 {
            frustum.planes[i][3] = scale.times(self.planes[i][3]);
        }
        frustum
    }

    /// Whether no ray from inside all planes can hit the triangle: all of it is certainly beyond one of them.
    ///
    /// The tracer moves a corner by a few roundings of its distance from the eye, and an edge no farther than its ends; the
    /// sum below adds five roundings more. `gamma(64)` of the distance, in the sum norm, covers all of that many times over.
    #[inline]
    #[must_use]
    pub fn is_certainly_outside(&self, triangle: &Triangle) -> bool {
        let eye = Vec3::from_array(self.eye);
        let corners = [triangle.v0 - eye, triangle.v1 - eye, triangle.v2 - eye];
        let mut is_outside = false;
        for i in 0..4 {
            is_outside |= is_beyond(corners[0], self.planes[i])
                && is_beyond(corners[1], self.planes[i])
                && is_beyond(corners[2], self.planes[i]);
        }
        self.is_bounded == 1 && is_outside
    }
}

/// Whether a corner, seen from the eye, is certainly beyond a plane.
#[inline]
fn is_beyond(v: Vec3, [x, y, z, offset]: [f32; 4]) -> bool {
    let distance = x * v.x + y * v.y + z * v.z + offset;
    let reach = abs(v.x) + abs(v.y) + abs(v.z) + abs(offset);
    distance < -(gamma(64) * reach + 16.0 * f32::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Looks along −z from (1, 2, 3), half as high as wide, to 45° on both sides.
    fn frustum() -> Frustum {
        let (s, h) = (0.5f32.sqrt(), 1.0 / 5.0f32.sqrt());
        Frustum {
            eye: [1.0, 2.0, 3.0],
            is_bounded: 1,
            planes: [
                [-s, 0.0, -s, 0.0],
                [s, 0.0, -s, 0.0],
                [0.0, -2.0 * h, -h, 0.0],
                [0.0, 2.0 * h, -h, 0.0],
            ],
        }
    }

    fn triangle(x: f32, y: f32, z: f32) -> Triangle {
        let v0 = Vec3::new(1.0 + x, 2.0 + y, 3.0 + z);
        Triangle {
            v0,
            v1: v0 + Vec3::new(0.25, 0.0, 0.0),
            v2: v0 + Vec3::new(0.0, 0.25, 0.0),
        }
    }

    #[test]
    fn only_what_is_wholly_beyond_one_side_is_outside() {
        for (x, y, z, is_outside) in [
            (0.0, 0.0, -4.0, false),
            (3.9, 0.0, -4.0, false),
            (4.1, 0.0, -4.0, true),
            (-4.1, 0.0, -4.0, false),
            (-4.3, 0.0, -4.0, true),
            (0.0, 2.1, -4.0, true),
            (0.0, -2.1, -4.0, false),
            (0.0, -2.3, -4.0, true),
            // Behind the eye.
            (-0.1, -0.1, 4.0, true),
        ] {
            let triangle = triangle(x, y, z);
            assert_eq!(
                frustum().is_certainly_outside(&triangle),
                is_outside,
                "{x} {y} {z}"
            );
            assert!(!Frustum::EVERYWHERE.is_certainly_outside(&triangle));
        }
        // One that spans the picture, with all corners out of it.
        let wide = Triangle {
            v0: Vec3::new(-9.0, 2.0, -1.0),
            v1: Vec3::new(11.0, 2.0, -1.0),
            v2: Vec3::new(1.0, 9.0, -1.0),
        };
        assert!(!frustum().is_certainly_outside(&wide));
    }

    #[test]
    fn scaling_changes_no_answer() {
        let parallel = Frustum {
            planes: [
                [-1.0, 0.0, 0.0, 2.0],
                [1.0, 0.0, 0.0, 2.0],
                [0.0, -1.0, 0.0, 1.0],
                [0.0; 4],
            ],
            ..frustum()
        };
        for scale in [-20, 0, 3, 60] {
            let scale = PowerOfTwo::new(scale);
            for (x, is_outside) in [(1.9, false), (2.1, true), (-2.1, false), (-2.3, true)] {
                let large = triangle(x, 0.0, 7.0);
                let [v0, v1, v2] = [large.v0, large.v1, large.v2]
                    .map(|v| Vec3::from_array(scale.times_each(v.to_array())));
                let scaled = parallel.scaled(&scale);
                assert_eq!(
                    scaled.is_certainly_outside(&Triangle { v0, v1, v2 }),
                    is_outside
                );
            }
        }
    }
}
