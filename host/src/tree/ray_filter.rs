//! Which triangles are hits for one of several rays.

use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay};
use slimbvh_core::trace::{EndsFilter, EndsSource, HitFilter};
use slimbvh_core::{RayEnds, SurfaceRay};

/// What the filters of some rays share.
#[derive(Clone, Copy, Debug)]
pub struct SharedFilter<'a> {
    /// The filter of all rays.
    pub facing: &'a FacingFilter<Sides<'a>>,
    /// The rays as their caller gives them.
    pub rays: &'a [SurfaceRay],
    /// A bit for each ray with more than one primitive to skip or with errors: the others' ends are not read.
    pub with_ends: u64,
    /// The exponent that the rays are prepared with.
    pub scene_exponent: i32,
}

/// Accepts what the filter of all rays accepts, except the triangles that this ray's ends lie on.
#[derive(Clone, Copy, Debug)]
pub struct RayFilter<'a> {
    /// The first primitive that is skipped.
    pub skip: u32,
    /// The ray's number.
    pub number: u32,
    /// What all share.
    pub shared: &'a SharedFilter<'a>,
}

/// Whether a ray's ends are more than one primitive to skip.
#[inline(always)]
pub const fn are_more_than_skip(ends: &RayEnds) -> bool {
    (ends.skip[1] != NO_PRIMITIVE) | ends.have_errors()
}

impl HitFilter for RayFilter<'_> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool {
        let has_ends = self.shared.with_ends >> (self.number & 63) & 1 == 1;
        primitive != self.skip
            && (!has_ends || self.ends_accept(primitive, *corners, axes))
            && self.shared.facing.accepts(primitive, corners, axes)
    }
}

impl RayFilter<'_> {
    /// Never part of the walk, which keeps corners in registers: they are copied here.
    #[inline(never)]
    fn ends_accept(self, primitive: u32, corners: [[f32; 3]; 3], axes: [u32; 3]) -> bool {
        let ray = self.shared.rays.get(self.number as usize);
        ray.is_none_or(|ray| {
            let ends = GivenEnds {
                ray,
                scene_exponent: self.shared.scene_exponent,
            };
            EndsFilter(ends).accepts(primitive, &corners, axes)
        })
    }
}

/// A ray as its caller gives it: prepared again for each triangle that it meets.
#[derive(Clone, Copy, Debug)]
struct GivenEnds<'a> {
    ray: &'a SurfaceRay,
    scene_exponent: i32,
}

impl EndsSource for GivenEnds<'_> {
    fn ends(&self) -> RayEnds {
        self.ray.ends
    }

    fn ray(&self) -> PreparedRay {
        PreparedRay::new(&self.ray.ray, self.scene_exponent)
    }

    fn scene_exponent(&self) -> i32 {
        self.scene_exponent
    }
}
