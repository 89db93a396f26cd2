//! Rays in a buffer of the caller's, and what is a hit for them.

use super::scaled_target;
use glam::UVec4;
use slimbvh_core::classify::{FacingFilter, PackedSides};
use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay};
use slimbvh_core::trace::{EndsFilter, EndsSource, HitFilter};
use slimbvh_core::{Ray, RayEnds};

/// The rays of a dispatch.
#[derive(Clone, Copy)]
pub struct Rays<'a> {
    /// All that there is room for.
    pub rays: &'a [Ray],
    /// What the ends of each lie on. Rays beyond the last have no such end.
    pub ends: &'a [RayEnds],
    /// How many of the rays there are.
    pub count: u32,
    /// The scene's exponent.
    pub exponent: u32,
    /// The packed sides of the primitives: what is not on the side that faces the target is no hit. Sides of 0 accept all triangles.
    pub sides: &'a [u32],
    /// The target's words, in the caller's unit.
    pub target: &'a [UVec4; 2],
}

/// Whether a tree's rule accepts a triangle that a ray meets. All is read here, for each such triangle: nothing of it is held while
/// the ray walks the tree.
#[inline(always)]
fn accepts(
    sides: &[u32],
    (target, exponent): (&[UVec4; 2], u32),
    skip: u32,
    (primitive, corners): (u32, &[[f32; 3]; 3]),
    axes: [u32; 3],
) -> bool {
    let filter = FacingFilter {
        skip,
        sides: PackedSides(sides),
        target: scaled_target(target, exponent),
    };
    filter.accepts(primitive, corners, axes)
}

impl Rays<'_> {
    /// Whether there is a ray of this number.
    #[inline(always)]
    pub const fn has(&self, i: u32) -> bool {
        i < self.count && (i as usize) < self.rays.len()
    }

    /// Room in the list of rays whose stack was full.
    #[inline(always)]
    pub const fn room(&self) -> u32 {
        self.rays.len() as u32
    }
}

/// Accepts what the tree's rule accepts and the ray's ends do not lie on.
///
/// The fields are slices and not [`Rays`]: a struct of structs of slices does not compile to SPIR-V.
#[derive(Clone, Copy)]
pub struct RayFilter<'a> {
    i: u32,
    exponent: u32,
    ray: PreparedRay,
    ends: &'a [RayEnds],
    sides: &'a [u32],
    target: &'a [UVec4; 2],
}

impl<'a> RayFilter<'a> {
    /// Of the ray of this number, which is prepared.
    #[inline(always)]
    pub const fn new(rays: Rays<'a>, i: u32, ray: PreparedRay) -> Self {
        Self {
            i,
            exponent: rays.exponent,
            ray,
            ends: rays.ends,
            sides: rays.sides,
            target: rays.target,
        }
    }
}

/// The ends of a ray that meets a triangle.
struct EndsThere {
    ends: RayEnds,
    ray: PreparedRay,
    exponent: u32,
    opaque_zero: u32,
}

impl EndsSource for EndsThere {
    #[inline(always)]
    fn ends(&self) -> RayEnds {
        self.ends
    }

    #[inline(always)]
    fn ray(&self) -> PreparedRay {
        self.ray
    }

    #[inline(always)]
    fn scene_exponent(&self) -> i32 {
        self.exponent as i32
    }

    #[inline(always)]
    fn opaque_zero(&self) -> u32 {
        self.opaque_zero
    }
}

impl HitFilter for RayFilter<'_> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool {
        let i = self.i as usize;
        let mut ends = RayEnds::NONE;
        if i < self.ends.len() {
            ends = self.ends[i];
        }
        let there = EndsThere {
            ends,
            ray: self.ray,
            exponent: self.exponent,
            // A target's padding.
            opaque_zero: self.target[1].y,
        };
        let (target, met) = ((self.target, self.exponent), (primitive, corners));
        EndsFilter(there).accepts(primitive, corners, axes)
            && accepts(self.sides, target, NO_PRIMITIVE, met, axes)
    }
}

/// Accepts what the tree's rule accepts, but for one triangle.
#[cfg(feature = "wide")]
#[derive(Clone, Copy)]
pub struct SkipFilter<'a> {
    pub skip: u32,
    pub exponent: u32,
    pub sides: &'a [u32],
    pub target: &'a [UVec4; 2],
}

#[cfg(feature = "wide")]
impl HitFilter for SkipFilter<'_> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool {
        let (target, met) = ((self.target, self.exponent), (primitive, corners));
        accepts(self.sides, target, self.skip, met, axes)
    }
}
