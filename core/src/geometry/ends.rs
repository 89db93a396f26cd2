//! Rays that leave surfaces or lead to surfaces: which triangles the ends of a ray lie on, and so are no hits.
//!
//! A triangle whose plane contains an end of a segment does not separate the two ends, so it does not block it. That holds for the
//! face that an end lies on, for the faces at its edge or corner, and for coplanar neighbours: no distance has to be guessed.

use crate::geometry::float::{UNIT_ROUNDOFF, abs, gamma, magnitude_bits, scale_by_power_of_two};
use crate::geometry::orientation::{Orientation, Target, product};
use crate::geometry::ray::{NO_PRIMITIVE, PreparedRay, Ray};
use crate::geometry::triangle::Triangle;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// What is no hit for a ray because an end of the ray lies on it. 16 bytes.
///
/// Index 0 is the ray's origin, index 1 its end, `origin + t_max · direction`. A triangle is no hit
/// - if its primitive is in `skip`;
/// - if an error is given, unless the ball of that radius around that end is certainly on one side of the triangle's plane;
/// - if both errors are given, unless the two balls are on different sides.
///
/// ```
/// # use slimbvh_core::{Ray, RayEnd};
/// let (a, b) = ([0.0, 0.0, 1.0], [2.0, 0.0, 1.0]);
/// let on_face = |position, primitive| RayEnd { primitive, ..RayEnd::from(position) };
/// let ends = Ray::between(on_face(a, 3), on_face(b, 8)).ends;
/// assert_eq!(ends.skip, [3, 8]);
/// // Faces 3 and 8 do not block the line of sight, nor do others through a or b.
/// assert!(ends.skips(3) && ends.skips(8) && ends.have_errors());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct RayEnds {
    /// Bytes 0–7: the primitives that the ends lie on, or [`NO_PRIMITIVE`].
    pub skip: [u32; 2],
    /// Bytes 8–15: bounds on the distances between the ends and the points that they stand for, in the unit of the ray's origin.
    /// Negative: none is given. An error of the end needs a finite `t_max`.
    pub error: [f32; 2],
}

const _: () = assert!(size_of::<RayEnds>() == 16);

/// More than a point loses where coordinates leave the normal range, on its way to the scene's magnitude and in computations there.
pub(crate) const LOST_BITS: f32 = 4.0 * f32::MIN_POSITIVE;

impl RayEnds {
    /// All triangles that the ray meets are hits.
    ///
    /// ```
    /// # use slimbvh_core::{Ray, RayEnds, SurfaceRay};
    /// let ray = Ray::new([0.0, 1.0, 2.0], [0.0, 0.0, -1.0]);
    /// assert_eq!(SurfaceRay { ray, ends: RayEnds::NONE }, SurfaceRay::from(ray));
    /// ```
    pub const NONE: Self = Self::skipping(NO_PRIMITIVE);

    /// All triangles that the ray meets are hits, except one primitive.
    ///
    /// ```
    /// # use slimbvh_core::{Ray, RayEnds, SurfaceRay};
    /// // The next hit after one of triangle 7, however near it is.
    /// let ray = Ray::new([0.0, 1.0, 2.0], [0.0, 0.0, -1.0]);
    /// let next = SurfaceRay { ray, ends: RayEnds::skipping(7) };
    /// assert_eq!(next.ends.skip[0], 7);
    /// ```
    #[inline(always)]
    #[must_use]
    pub const fn skipping(primitive: u32) -> Self {
        Self {
            skip: [primitive, NO_PRIMITIVE],
            error: [-1.0; 2],
        }
    }

    /// Whether the ends lie on this primitive.
    ///
    /// ```
    /// # use slimbvh_core::RayEnds;
    /// let ends = RayEnds { skip: [3, 8], ..RayEnds::NONE };
    /// assert_eq!([3, 5, 8].map(|primitive| ends.skips(primitive)), [true, false, true]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub const fn skips(&self, primitive: u32) -> bool {
        (primitive == self.skip[0]) | (primitive == self.skip[1])
    }

    /// Whether an error is given: then [`Self::are_separated`] is asked.
    ///
    /// ```
    /// # use slimbvh_core::{Ray, RayEnds};
    /// assert!(!RayEnds::skipping(7).have_errors());
    /// // Segments end at points that are exact or known within an error.
    /// assert!(Ray::between([0.0; 3], [0.0, 0.0, 1.0]).ends.have_errors());
    /// ```
    #[inline(always)]
    #[must_use]
    pub const fn have_errors(&self) -> bool {
        is_given(self.error[0]) | is_given(self.error[1])
    }

    /// Whether a triangle's plane certainly separates the ends of the ray: each end whose error is given is certainly on one side, and
    /// two of them are on different sides.
    ///
    /// `corners` are at the scene's magnitude, coordinates in the order of the ray's axes. The errors are multiplied by
    /// `2^scene_exponent`. `opaque_zero` is always 0; a kernel hides that from the compiler, so that it cannot fuse products and sums.
    ///
    /// ```
    /// # use slimbvh_core::Ray;
    /// # use slimbvh_core::ray::PreparedRay;
    /// let segment = Ray::between([0.25, 0.25, 0.75], [0.25, 0.25, 0.0]);
    /// let prepared = PreparedRay::new(&segment.ray, 0);
    /// let at = |z| [[0.0, 0.0, z], [0.75, 0.0, z], [0.0, 0.75, z]];
    /// let blocks = |z| segment.ends.are_separated(&prepared, 0, &at(z), 0);
    /// // A triangle between the ends blocks; the floor that the segment leads to does not.
    /// assert_eq!((blocks(0.5), blocks(0.0)), (true, false));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn are_separated(
        &self,
        ray: &PreparedRay,
        scene_exponent: i32,
        corners: &[[f32; 3]; 3],
        opaque_zero: u32,
    ) -> bool {
        let triangle = Triangle {
            v0: Vec3::from_array(corners[0]),
            v1: Vec3::from_array(corners[1]),
            v2: Vec3::from_array(corners[2]),
        };
        // The two shortest sides give the best normal.
        let triangle = triangle.from_widest_corner();
        let side = |point: [f32; 3], error: f32, rounding: f32| {
            let error = scale_by_power_of_two(error, scene_exponent);
            let target = Target {
                padding: [opaque_zero; 3],
                ..Target::ball(point, error + rounding + LOST_BITS)
            };
            Orientation::new(&triangle, &target).certain_side()
        };

        // Ends without an error are on no side that the other end could be on.
        let (mut start_side, mut end_side) = (2, 3);
        if is_given(self.error[0]) {
            start_side = side(ray.origin, self.error[0], 0.0);
        }
        if is_given(self.error[1]) {
            let (end, rounding) = end_of(ray, opaque_zero);
            end_side = side(end, self.error[1], rounding);
        }
        (start_side != 0) & (end_side != 0) & (start_side != end_side)
    }
}

impl Default for RayEnds {
    /// [`Self::NONE`].
    fn default() -> Self {
        Self::NONE
    }
}

/// Whether an error is given, by its sign.
#[inline(always)]
const fn is_given(error: f32) -> bool {
    error.to_bits() >> 31 == 0
}

/// A prepared ray's point at `t_max`, and a bound on its rounding: one product and one sum on each axis, and what
/// [`PreparedRay::new`] takes from a direction that is almost parallel to a plane of the axes.
#[inline(always)]
fn end_of(ray: &PreparedRay, opaque_zero: u32) -> ([f32; 3], f32) {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
    let way = |d: f32| product(d, ray.t_max, opaque_zero);
    let (wx, wy, wz) = (way(dx), way(dy), way(dz));
    let end = [ox + wx, oy + wy, oz + wz];
    let ways = abs(wx) + abs(wy) + abs(wz);
    let sums = abs(end[0]) + abs(end[1]) + abs(end[2]);
    (end, product(gamma(2), ways + sums, opaque_zero))
}

/// A ray, and what is no hit for it because its ends lie on it. 48 bytes.
///
/// A [`Ray`] alone becomes one without such triangles.
///
/// ```
/// # use slimbvh_core::{Ray, RayEnds, SurfaceRay};
/// let ray = Ray::new([0.0, 1.0, 2.0], [0.0, 0.0, -1.0]);
/// let plain = SurfaceRay::from(&ray);
/// assert_eq!(plain.ends, RayEnds::NONE);
/// let skips_face_7 = SurfaceRay { ends: RayEnds::skipping(7), ..plain };
/// assert!(skips_face_7.ends.skips(7));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct SurfaceRay {
    /// Bytes 0–31: the ray.
    pub ray: Ray,
    /// Bytes 32–47: what its ends lie on.
    pub ends: RayEnds,
}

const _: () = assert!(size_of::<SurfaceRay>() == 48);

impl From<Ray> for SurfaceRay {
    #[inline(always)]
    fn from(ray: Ray) -> Self {
        Self {
            ray,
            ends: RayEnds::NONE,
        }
    }
}

impl From<&Ray> for SurfaceRay {
    #[inline(always)]
    fn from(ray: &Ray) -> Self {
        Self::from(*ray)
    }
}

impl From<&SurfaceRay> for SurfaceRay {
    #[inline(always)]
    fn from(ray: &SurfaceRay) -> Self {
        *ray
    }
}

// What closures of iterators over references get.
impl From<&&Ray> for SurfaceRay {
    #[inline(always)]
    fn from(ray: &&Ray) -> Self {
        Self::from(**ray)
    }
}

impl From<&&SurfaceRay> for SurfaceRay {
    #[inline(always)]
    fn from(ray: &&SurfaceRay) -> Self {
        **ray
    }
}

/// A point that a ray leaves or leads to: on a surface, or anywhere.
///
/// ```
/// # use slimbvh_core::{NO_PRIMITIVE, Ray, RayEnd};
/// // A point of one's own, known within a thousandth, on face 3.
/// let point = RayEnd { position: [1.0, 2.0, 0.0], error: 1e-3, primitive: 3 };
/// let ray = point.ray([0.0, 0.0, 1.0]);
/// assert_eq!((ray.ray.origin, ray.ends.skip), ([1.0, 2.0, 0.0], [3, NO_PRIMITIVE]));
/// let to_lamp = Ray::between(point, [1.0, 2.0, 5.0]);
/// assert_eq!((to_lamp.ray.direction, to_lamp.ray.t_max), ([0.0, 0.0, 5.0], 1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayEnd {
    /// The position, rounded.
    pub position: [f32; 3],
    /// Bound on the distance between the position and the point that it stands for.
    pub error: f32,
    /// The primitive that the point lies on, [`NO_PRIMITIVE`] for none.
    pub primitive: u32,
}

impl From<[f32; 3]> for RayEnd {
    /// The point at exactly this position.
    #[inline]
    fn from(position: [f32; 3]) -> Self {
        Self {
            position,
            error: 0.0,
            primitive: NO_PRIMITIVE,
        }
    }
}

impl RayEnd {
    /// The ray from here in a direction, on either side of the surface here: no triangle whose plane contains the point is a hit.
    ///
    /// ```
    /// # use slimbvh_core::RayEnd;
    /// // A position of one's own that is exact, on face 3.
    /// let corner = RayEnd { primitive: 3, ..RayEnd::from([1.0, 2.0, 0.0]) };
    /// let occlusion = corner.ray([0.0, 0.6, 0.8]);
    /// assert_eq!((occlusion.ends.skip[0], occlusion.ends.error[0]), (3, 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn ray(&self, direction: [f32; 3]) -> SurfaceRay {
        SurfaceRay {
            ray: Ray::new(self.position, direction),
            ends: RayEnds {
                skip: [self.primitive, NO_PRIMITIVE],
                error: [self.error, -1.0],
            },
        }
    }
}

impl Ray {
    /// The segment between two points, t from 0 to 1: any hit on it blocks the line of sight. Surfaces that an end lies on do not: the
    /// primitives of the ends are skipped, and a triangle is a hit only if its plane certainly separates the ends
    /// ([`RayEnds`]). Plain positions count as exact.
    ///
    /// Where the difference of the points overflows, t is from 0 to 2.
    ///
    /// ```
    /// # use slimbvh_core::Ray;
    /// let segment = Ray::between([0.0, 0.0, 1.0], [2.0, 0.0, 1.0]);
    /// assert_eq!((segment.ray.direction, segment.ray.t_max), ([2.0, 0.0, 0.0], 1.0));
    /// ```
    #[must_use]
    pub fn between(a: impl Into<RayEnd>, b: impl Into<RayEnd>) -> SurfaceRay {
        let (a, b) = (a.into(), b.into());
        let [mut dx, mut dy, mut dz] = difference(b.position, a.position, 1.0);
        let mut t_max = 1.0;
        if magnitude_bits(dx)
            .max(magnitude_bits(dy))
            .max(magnitude_bits(dz))
            > f32::MAX.to_bits()
        {
            [dx, dy, dz] = difference(b.position, a.position, 0.5);
            t_max = 2.0;
        }
        // On each axis one rounding: half a unit in the last place of the difference, and where it was halved, two of the halves.
        let step = 4.0 * UNIT_ROUNDOFF * t_max;
        let rounding = step * abs(dx) + step * abs(dy) + step * abs(dz);
        SurfaceRay {
            ray: Ray {
                t_max,
                ..Ray::new(a.position, [dx, dy, dz])
            },
            ends: RayEnds {
                skip: [a.primitive, b.primitive],
                error: [a.error, b.error + rounding],
            },
        }
    }
}

/// The difference of two positions times a factor, each multiplied first.
#[inline]
fn difference([ax, ay, az]: [f32; 3], [bx, by, bz]: [f32; 3], factor: f32) -> [f32; 3] {
    [
        ax * factor - bx * factor,
        ay * factor - by * factor,
        az * factor - bz * factor,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::float::power_of_two;
    use proptest::array::uniform3;
    use proptest::prelude::*;

    /// On a floor at height 1, in the order of a ray's axes.
    fn is_separating(ray: &SurfaceRay, corners: [[f32; 3]; 3], exponent: i32) -> bool {
        let prepared = PreparedRay::new(&ray.ray, exponent);
        let turned = corners.map(|v| prepared.axes.map(|axis| v[axis as usize % 3]));
        ray.ends.are_separated(&prepared, exponent, &turned, 0)
    }

    const FLOOR: [[f32; 3]; 3] = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 2.0, 1.0]];

    #[test]
    fn a_plane_separates_only_ends_on_both_sides() {
        let [above, on, below] = [3.0, 1.0, -2.0].map(|z| [0.5, 0.25, z]);
        for (a, b, expected) in [
            (above, below, true),
            (below, above, true),
            (above, on, false),
            (on, below, false),
            (above, above, false),
            (below, [9.0, -5.0, 0.5], false),
        ] {
            assert_eq!(
                is_separating(&Ray::between(a, b), FLOOR, 0),
                expected,
                "{a:?} {b:?}"
            );
        }
    }

    #[test]
    fn an_end_without_an_error_is_on_no_side() {
        let ray = Ray {
            t_max: 4.0,
            ..Ray::new([0.5, 0.25, 3.0], [0.0, 0.0, -1.0])
        };
        let with = |error| SurfaceRay {
            ray,
            ends: RayEnds {
                error,
                ..RayEnds::NONE
            },
        };
        // 2 above the floor, and 2 below.
        for (error, expected) in [
            ([1.9, -1.0], true),
            ([2.1, -1.0], false),
            ([-1.0, 1.9], true),
            ([-1.0, 2.1], false),
            ([1.9, 1.9], true),
            ([1.9, 2.1], false),
        ] {
            assert_eq!(is_separating(&with(error), FLOOR, 0), expected, "{error:?}");
        }
        assert!(!RayEnds::NONE.have_errors() && with([0.0, -1.0]).ends.have_errors());
    }

    #[test]
    fn a_segment_as_long_as_all_numbers_is_halved() {
        let (a, b) = ([-3e38, 0.0, 1e38], [3e38, 1.0, 0.0]);
        let segment = Ray::between(a, b);
        assert_eq!((segment.ray.t_max, segment.ray.direction[0]), (2.0, 3e38));
        assert!(segment.ends.error[1].is_finite());
    }

    proptest! {
        /// The exact end of a segment is within its error of the point that it leads to, at all scales.
        #[test]
        fn a_segment_ends_at_its_point(a in uniform3(-1.0f32..1.0), b in uniform3(-1.0f32..1.0), e in -140..120i32, apart in -30..=0i32) {
            let a = a.map(|x| scale_by_power_of_two(x, e));
            let b = b.map(|x| scale_by_power_of_two(x, e + apart));
            let segment = Ray::between(a, b);
            let squares: [f64; 3] = core::array::from_fn(|axis| {
                let end = f64::from(a[axis]) + f64::from(segment.ray.t_max) * f64::from(segment.ray.direction[axis]);
                (end - f64::from(b[axis])).powi(2)
            });
            let off = squares.into_iter().sum::<f64>().sqrt();
            prop_assert!(off <= f64::from(segment.ends.error[1]), "{off:e}");
        }

        /// Whatever the scale, the same plane separates the same ends.
        #[test]
        fn separation_does_not_depend_on_scale(a in uniform3(-1.0f32..1.0), b in uniform3(-1.0f32..1.0), t in uniform3(uniform3(-1.0f32..1.0)), e in -60..60i32) {
            let scaled = |v: [f32; 3]| v.map(|x| x * power_of_two(e));
            let here = is_separating(&Ray::between(a, b), t, 0);
            let there = is_separating(&Ray::between(scaled(a), scaled(b)), t, -e);
            prop_assert_eq!(here, there);
        }
    }

    /// The negative control of that: without an error the end is elsewhere.
    #[test]
    fn differences_are_rounded() {
        let segment = Ray::between([1.0, 0.0, 0.0], [power_of_two(-30) * 1.1, 0.0, 0.0]);
        let end = 1.0 + f64::from(segment.ray.direction[0]);
        assert!((end - f64::from(power_of_two(-30) * 1.1f32)).abs() > 0.0);
        assert!(segment.ends.error[1] > 0.0);
    }
}
