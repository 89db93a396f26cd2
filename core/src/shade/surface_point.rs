//! A hit point in the caller's unit, and the rays that leave it.

use crate::geometry::ends::{LOST_BITS, RayEnd, SurfaceRay};
use crate::geometry::float::{abs, gamma, next_up, scale_by_power_of_two};
use crate::shade::surface::{Surface, beside};
use glam::Vec3;

/// The point of a surface that a ray hits, in the caller's unit.
///
/// The exact point lies in the triangle that was hit, at the hit's weights, divided by their sum.
///
/// ```
/// use slimbvh_core::surface::Surface;
/// use slimbvh_core::{Hit, Ray, SurfacePoint, Triangle, Vec3};
///
/// let triangle = Triangle { v0: Vec3::ZERO, v1: Vec3::X, v2: Vec3::Y };
/// let hit = Hit { t: 3.0, u: 0.5, v: 0.25, primitive: 7 };
/// let surface = Surface::new(triangle, &hit, -Vec3::Z, [Vec3::ZERO; 3]);
/// // The scene is 8 times as large as at its magnitude.
/// let point = SurfacePoint::new(&surface, hit.primitive, -3);
/// assert_eq!((point.position, point.normal), ([4.0, 2.0, 0.0], [0.0, 0.0, 1.0]));
/// let mirrored = point.ray([0.0, 0.0, 1.0]);
/// let to_lamp = Ray::between(&point, [4.0, 2.0, 9.0]);
/// assert_eq!((mirrored.ends.skip[0], to_lamp.ends.skip[0]), (7, 7));
/// // For a plain ray.
/// assert!(point.leave()[2] > 0.0 && point.enter()[2] < 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The position, rounded.
    pub position: [f32; 3],
    /// Bound on the distance between the position and the exact point, by axis.
    pub error: [f32; 3],
    /// Unit normal of the triangle, on the side that the ray came from. Zero for a triangle whose normal underflows.
    pub normal: [f32; 3],
    /// Unit normal for shading, on the same side.
    pub shading_normal: [f32; 3],
    /// 1 where the ray came from the front, −1 where from the back.
    pub side: f32,
    /// The triangle that was hit.
    pub primitive: u32,
}

impl SurfacePoint {
    /// A hit point in the unit of a mesh whose coordinates were multiplied by `2^scene_exponent`.
    ///
    /// Multiplying by a power of two is exact in the normal range. Below it, the error grows by what the position loses.
    ///
    /// ```
    /// # use slimbvh_core::surface::Surface;
    /// # use slimbvh_core::{Hit, SurfacePoint, Triangle, Vec3};
    /// # let triangle = Triangle { v0: Vec3::ZERO, v1: Vec3::X, v2: Vec3::Y };
    /// # let hit = Hit { t: 1.0, u: 0.5, v: 0.25, primitive: 7 };
    /// let surface = Surface::new(triangle, &hit, -Vec3::Z, [Vec3::ZERO; 3]);
    /// let point = SurfacePoint::new(&surface, hit.primitive, -3);
    /// // The mesh is 2^3 times as large as at the scene's magnitude.
    /// assert_eq!(Vec3::from(point.position), 8.0 * surface.position);
    /// ```
    #[must_use]
    pub fn new(surface: &Surface, primitive: u32, scene_exponent: i32) -> Self {
        // A loop: written out, it would be most of the text that users' WGSL contains.
        let (mut position, mut error) = (surface.position.to_array(), surface.error.to_array());
        for axis in 0..3 {
            let restored = Restored::new(position[axis], error[axis], scene_exponent);
            position[axis] = restored.position;
            error[axis] = restored.error;
        }
        Self {
            position,
            error,
            normal: surface.normal.to_array(),
            shading_normal: surface.shading_normal.to_array(),
            side: surface.side,
            primitive,
        }
    }

    /// The point as an end of a ray, for [`crate::Ray::between`].
    ///
    /// ```
    /// # use slimbvh_core::{Ray, SurfacePoint};
    /// # let (z, error) = ([0.0, 0.0, 1.0], [f32::EPSILON; 3]);
    /// # let point = SurfacePoint {
    /// #     position: [4.0, 2.0, 0.0], error, normal: z, shading_normal: z, side: 1.0, primitive: 7,
    /// # };
    /// let end = point.end();
    /// assert_eq!(Ray::between(end, [4.0, 2.0, 9.0]), Ray::between(&point, [4.0, 2.0, 9.0]));
    /// assert_eq!(end.primitive, 7);
    /// ```
    #[inline]
    #[must_use]
    pub fn end(&self) -> RayEnd {
        let [x, y, z] = self.error;
        RayEnd {
            position: self.position,
            error: (x + y + z) * (1.0 + gamma(4)),
            primitive: self.primitive,
        }
    }

    /// The ray from the point in a direction, on either side of the surface: a mirrored ray, an occlusion ray or a refracted one. No
    /// triangle whose plane contains the point is a hit.
    ///
    /// ```
    /// # use slimbvh_core::{Ray, SurfacePoint, Vec3};
    /// # let (z, error) = ([0.0, 0.0, 1.0], [f32::EPSILON; 3]);
    /// # let point = SurfacePoint {
    /// #     position: [4.0, 2.0, 0.0], error, normal: z, shading_normal: z, side: 1.0, primitive: 7,
    /// # };
    /// let (came, normal) = (Vec3::new(1.0, 0.0, -1.0), Vec3::from(point.normal));
    /// let mirrored = point.ray((came - 2.0 * came.dot(normal) * normal).to_array());
    /// assert_eq!(mirrored.ray.direction, [1.0, 0.0, 1.0]);
    /// // It does not hit the triangle that it leaves.
    /// assert!(mirrored.ends.skips(7));
    /// ```
    #[inline]
    #[must_use]
    pub fn ray(&self, direction: [f32; 3]) -> SurfaceRay {
        self.end().ray(direction)
    }

    /// A position off the surface, on the side that the ray came from, for a plain [`crate::Ray`]: far enough along the normal that the
    /// exact triangle's plane is behind it.
    ///
    /// ```
    /// # use slimbvh_core::{Ray, SurfacePoint};
    /// # let (z, error) = ([0.0, 0.0, 1.0], [f32::EPSILON; 3]);
    /// # let point = SurfacePoint {
    /// #     position: [4.0, 2.0, 0.0], error, normal: z, shading_normal: z, side: 1.0, primitive: 7,
    /// # };
    /// let plain = Ray::new(point.leave(), point.normal);
    /// assert!(plain.origin[2] > 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn leave(&self) -> [f32; 3] {
        self.beside(1.0)
    }

    /// A position off the surface on the other side: [`Self::leave`] against the normal.
    ///
    /// ```
    /// # use slimbvh_core::{Ray, SurfacePoint};
    /// # let (z, error) = ([0.0, 0.0, 1.0], [f32::EPSILON; 3]);
    /// # let point = SurfacePoint {
    /// #     position: [4.0, 2.0, 0.0], error, normal: z, shading_normal: z, side: 1.0, primitive: 7,
    /// # };
    /// // On into the glass.
    /// let refracted = Ray::new(point.enter(), [0.25, 0.0, -1.0]);
    /// assert!(refracted.origin[2] < 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn enter(&self) -> [f32; 3] {
        self.beside(-1.0)
    }

    #[inline]
    fn beside(&self, side: f32) -> [f32; 3] {
        let position = Vec3::from_array(self.position);
        let error = Vec3::from_array(self.error);
        beside(position, error, Vec3::from_array(self.normal) * side).to_array()
    }
}

impl From<&SurfacePoint> for RayEnd {
    #[inline]
    fn from(point: &SurfacePoint) -> Self {
        point.end()
    }
}

impl From<SurfacePoint> for RayEnd {
    #[inline]
    fn from(point: SurfacePoint) -> Self {
        point.end()
    }
}

/// A coordinate in the caller's unit, and its error.
struct Restored {
    position: f32,
    error: f32,
}

impl Restored {
    #[inline]
    fn new(position: f32, error: f32, scene_exponent: i32) -> Self {
        let error = error + LOST_BITS;
        let restored = finite(scale_by_power_of_two(position, -scene_exponent));
        let bound = finite(scale_by_power_of_two(error, -scene_exponent));
        let is_exact = scale_by_power_of_two(restored, scene_exponent) == position
            && scale_by_power_of_two(bound, scene_exponent) == error;
        Self {
            position: restored,
            // Each was rounded by at most half a step of the smallest numbers.
            error: if is_exact { bound } else { next_up(bound) },
        }
    }
}

/// The number, or the largest one of its sign where it is infinite: no vertex is beyond that.
#[inline]
fn finite(x: f32) -> f32 {
    if abs(x) > f32::MAX {
        f32::from_bits((x.to_bits() & 0x8000_0000) | f32::MAX.to_bits())
    } else {
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::snap::snap;
    use crate::geometry::float::PowerOfTwo;
    use crate::geometry::ray::Hit;
    use crate::geometry::triangle::Triangle;
    use crate::shade::surface::tests::height;
    use proptest::array::uniform3;
    use proptest::prelude::*;

    /// A coordinate at the scene's magnitude: some are small, some zero.
    fn coordinate() -> impl Strategy<Value = f32> {
        let small = (-1.0f32..1.0, -126..0i32).prop_map(|(x, e)| scale_by_power_of_two(x, e));
        prop_oneof![4 => -1.0f32..1.0, 1 => small, 1 => Just(0.0)]
    }

    /// How far the exact point is from the position, by axis, in units of the error there.
    fn shares(vertices: &[[f32; 3]; 3], weights: Vec3, point: &SurfacePoint) -> [f64; 3] {
        let weights = weights.to_array().map(f64::from);
        let sum: f64 = weights.iter().sum();
        core::array::from_fn(|axis| {
            let corner = |i: usize| f64::from(vertices[i][axis]) * weights[i] / sum;
            let exact = corner(0) + corner(1) + corner(2);
            (exact - f64::from(point.position[axis])).abs() / f64::from(point.error[axis])
        })
    }

    proptest! {
        /// At all scales.
        #[test]
        fn the_error_bounds_the_position(t in uniform3(uniform3(coordinate())), u in 0.0f32..1.0, v in 0.0f32..1.0, exponent in -127..=149i32) {
            // The caller's mesh, and what the tree makes of it.
            let vertices = t.map(|v| v.map(|x| finite(scale_by_power_of_two(x, -exponent))));
            let scaled = vertices.map(|v| Vec3::from_array(v.map(|x| snap(x, &PowerOfTwo::new(exponent)))));
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let hit = Hit { t: 1.0, u, v, primitive: 3 };
            let triangle = Triangle { v0: scaled[0], v1: scaled[1], v2: scaled[2] };
            let surface = Surface::new(triangle, &hit, Vec3::X, [Vec3::ZERO; 3]);
            let point = SurfacePoint::new(&surface, 3, exponent);
            let weights = crate::geometry::watertight::weights(u, v);
            for share in shares(&vertices, weights, &point) {
                prop_assert!(share <= 1.0, "{share}");
            }
        }

        /// The plain positions are off the exact plane, at all scales.
        #[test]
        fn plain_rays_start_off_the_surface(t in uniform3(uniform3(-1.0f32..1.0)), d in uniform3(-1.0f32..1.0), u in 0.0f32..1.0, exponent in -120..=140i32) {
            let vertices = t.map(|v| v.map(|x| scale_by_power_of_two(x, -exponent)));
            let scaled = vertices.map(|v| Vec3::from_array(v.map(|x| snap(x, &PowerOfTwo::new(exponent)))));
            let triangle = Triangle { v0: scaled[0], v1: scaled[1], v2: scaled[2] };
            prop_assume!(triangle.normal().length() > 1e-2);
            let hit = Hit { t: 1.0, u, v: (1.0 - u) * 0.5, primitive: 3 };
            let surface = Surface::new(triangle, &hit, Vec3::from_array(d), [Vec3::ZERO; 3]);
            let point = SurfacePoint::new(&surface, 3, exponent);
            let scale = 2f64.powi(exponent);
            let corners = vertices.map(|v| v.map(|x| f64::from(x) * scale));
            let height = |p: [f32; 3]| height(&corners, p.map(|x| f64::from(x) * scale)) * f64::from(point.side);
            let (left, entered) = (height(point.leave()), height(point.enter()));
            prop_assert!(left > 0.0 && entered < 0.0, "{left:e} {entered:e}");
        }
    }

    /// The bound is needed: a few roundings, not none.
    #[test]
    fn positions_are_off_by_more_than_a_rounding() {
        let mut largest = 0.0f64;
        for i in 0..1000 {
            let x = i as f32 / 1000.0;
            let vertices = [[0.3, x, 0.7], [x, 0.9, 0.1], [0.6, 0.5, x]];
            let [v0, v1, v2] = vertices.map(Vec3::from_array);
            let (u, v) = (x / 3.0, (1.0 - x) / 7.0);
            let hit = Hit {
                t: 1.0,
                u,
                v,
                primitive: 0,
            };
            let surface = Surface::new(Triangle { v0, v1, v2 }, &hit, Vec3::X, [Vec3::ZERO; 3]);
            let point = SurfacePoint::new(&surface, 0, 0);
            let weights = crate::geometry::watertight::weights(u, v);
            largest = shares(&vertices, weights, &point)
                .into_iter()
                .fold(largest, f64::max);
        }
        assert!(largest > 1.0 / 12.0 && largest <= 1.0, "{largest}");
    }
}
