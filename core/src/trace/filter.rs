//! Which of the triangles that a ray meets are hits.

use crate::geometry::ends::RayEnds;
use crate::geometry::ray::{NO_PRIMITIVE, PreparedRay};

/// Which triangles count for a ray.
pub trait HitFilter {
    /// Whether a triangle that the ray meets is a hit, by its index in the caller's list and its corners, coordinates in the
    /// order of the axes.
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool;
}

/// Accepts all triangles but one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Skip(pub u32);

impl Skip {
    /// Accepts all triangles.
    pub const NONE: Self = Self(NO_PRIMITIVE);
}

impl HitFilter for Skip {
    #[inline(always)]
    fn accepts(&self, primitive: u32, _: &[[f32; 3]; 3], _: [u32; 3]) -> bool {
        primitive != self.0
    }
}

/// Where a filter finds a ray and its ends, asked for each triangle that the ray meets: nothing of them need be held while the ray
/// walks the tree.
pub trait EndsSource {
    /// What is no hit because the ray's ends lie on it.
    fn ends(&self) -> RayEnds;

    /// The ray, at the scene's magnitude. Asked only for ends with errors.
    fn ray(&self) -> PreparedRay;

    /// Coordinates at the scene's magnitude are the caller's, times two to this power.
    fn scene_exponent(&self) -> i32;

    /// Always 0. A kernel hides that from the compiler, so that it cannot fuse products and sums.
    #[inline(always)]
    fn opaque_zero(&self) -> u32 {
        0
    }
}

/// Accepts all triangles except those that the ray's ends lie on ([`RayEnds`]).
#[derive(Clone, Copy, Debug)]
pub struct EndsFilter<S>(pub S);

impl<S: EndsSource> HitFilter for EndsFilter<S> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], _: [u32; 3]) -> bool {
        let ends = self.0.ends();
        if ends.skips(primitive) {
            return false;
        }
        !ends.have_errors() || self.are_separated(corners)
    }
}

impl<S: EndsSource> EndsFilter<S> {
    /// [`RayEnds::are_separated`]. On a CPU a function of its own: within the walk it would take the walk's registers.
    #[cfg_attr(target_arch = "spirv", inline(always))]
    #[cfg_attr(not(target_arch = "spirv"), inline(never))]
    fn are_separated(&self, corners: &[[f32; 3]; 3]) -> bool {
        let (ray, exponent) = (self.0.ray(), self.0.scene_exponent());
        let ends = self.0.ends();
        ends.are_separated(&ray, exponent, corners, self.0.opaque_zero())
    }
}

/// A ray as the tracer uses it, and its ends.
#[derive(Clone, Copy, Debug)]
pub struct PreparedEnds<'a> {
    /// The ray.
    pub ray: &'a PreparedRay,
    /// Its ends.
    pub ends: &'a RayEnds,
    /// The exponent that the ray was prepared with.
    pub scene_exponent: i32,
}

impl EndsSource for PreparedEnds<'_> {
    #[inline(always)]
    fn ends(&self) -> RayEnds {
        *self.ends
    }

    #[inline(always)]
    fn ray(&self) -> PreparedRay {
        *self.ray
    }

    #[inline(always)]
    fn scene_exponent(&self) -> i32 {
        self.scene_exponent
    }
}

/// Accepts what a filter that several rays share accepts, except the triangles that this ray's ends lie on.
#[cfg(not(target_arch = "spirv"))]
#[derive(Clone, Copy, Debug)]
pub struct EndsAnd<'a, S, F> {
    /// This ray's ends.
    pub ends: EndsFilter<S>,
    /// All rays' filter.
    pub filter: &'a F,
}

#[cfg(not(target_arch = "spirv"))]
impl<S: EndsSource, F: HitFilter> HitFilter for EndsAnd<'_, S, F> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool {
        self.ends.accepts(primitive, corners, axes) && self.filter.accepts(primitive, corners, axes)
    }
}
