//! Which of the triangles that a ray meets are hits.

use crate::geometry::ray::NO_PRIMITIVE;

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
