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
        if !ends.have_errors() {
            return true;
        }
        let (exponent, opaque_zero) = (self.0.scene_exponent(), self.0.opaque_zero());
        ends.are_separated(&self.0.ray(), exponent, corners, opaque_zero)
    }
}

/// Accepts what a filter that several rays share accepts, but for one triangle of each ray.
#[cfg(not(target_arch = "spirv"))]
#[derive(Clone, Copy, Debug)]
pub struct SkipAnd<'a, F> {
    /// This ray's triangle.
    pub skip: Skip,
    /// All rays' filter.
    pub filter: &'a F,
}

#[cfg(not(target_arch = "spirv"))]
impl<'a, F: HitFilter> SkipAnd<'a, F> {
    /// Skips one primitive, [`NO_PRIMITIVE`] for none.
    #[inline(always)]
    #[must_use]
    pub const fn new(filter: &'a F, skip: u32) -> Self {
        Self {
            skip: Skip(skip),
            filter,
        }
    }
}

#[cfg(not(target_arch = "spirv"))]
impl<F: HitFilter> HitFilter for SkipAnd<'_, F> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool {
        self.skip.accepts(primitive, corners, axes) && self.filter.accepts(primitive, corners, axes)
    }
}
