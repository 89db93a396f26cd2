//! Rays in a buffer of the caller's, and what is a hit for them.

use super::scaled_target;
use glam::UVec4;
use slimbvh_core::classify::{FacingFilter, PackedSides};
use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay};
use slimbvh_core::trace::{EndsFilter, EndsSource, HitFilter, Skip};
use slimbvh_core::{Ray, RayEnds};

/// The rays of a dispatch, and what is a hit for them.
pub trait RaySource: Copy {
    /// What is a hit for one of them.
    type Filter: HitFilter;

    /// Whether there is a ray of this number.
    fn has(&self, i: u32) -> bool;

    /// The ray of this number, which is there, in the scene's magnitude.
    fn prepared(&self, i: u32) -> PreparedRay;

    /// What is a hit for it.
    fn filter(&self, i: u32, ray: PreparedRay) -> Self::Filter;

    /// Room in the list of rays whose stack was full.
    fn room(&self) -> u32;
}

/// Rays for which all triangles are hits.
#[derive(Clone, Copy)]
pub struct PlainRays<'a> {
    /// All that there is room for.
    pub rays: &'a [Ray],
    /// How many of the rays there are.
    pub count: u32,
    /// The scene's exponent.
    pub exponent: u32,
}

impl RaySource for PlainRays<'_> {
    type Filter = Skip;

    #[inline(always)]
    fn has(&self, i: u32) -> bool {
        i < self.count && (i as usize) < self.rays.len()
    }

    #[inline(always)]
    fn prepared(&self, i: u32) -> PreparedRay {
        let mut ray = Ray::EMPTY;
        if (i as usize) < self.rays.len() {
            ray = self.rays[i as usize];
        }
        PreparedRay::new(&ray, self.exponent as i32)
    }

    #[inline(always)]
    fn filter(&self, _: u32, _: PreparedRay) -> Skip {
        Skip::NONE
    }

    #[inline(always)]
    fn room(&self) -> u32 {
        self.rays.len() as u32
    }
}

/// Rays whose ends may lie on surfaces, through a tree that may have a rule.
#[derive(Clone, Copy)]
pub struct FilteredRays<'a> {
    pub rays: PlainRays<'a>,
    /// What the ends of each lie on. Rays beyond the last have no such end.
    pub ends: &'a [RayEnds],
    /// The packed sides of the primitives: what is not on the side that faces the target is no hit. Sides of 0 accept all triangles.
    pub sides: &'a [u32],
    /// The target's words, in the caller's unit.
    pub target: &'a [UVec4; 2],
}

impl<'a> RaySource for FilteredRays<'a> {
    type Filter = RayFilter<'a>;

    #[inline(always)]
    fn has(&self, i: u32) -> bool {
        self.rays.has(i)
    }

    #[inline(always)]
    fn prepared(&self, i: u32) -> PreparedRay {
        self.rays.prepared(i)
    }

    #[inline(always)]
    fn filter(&self, i: u32, ray: PreparedRay) -> RayFilter<'a> {
        RayFilter {
            i,
            exponent: self.rays.exponent,
            ray,
            ends: self.ends,
            sides: self.sides,
            target: self.target,
        }
    }

    #[inline(always)]
    fn room(&self) -> u32 {
        self.rays.room()
    }
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

/// Accepts what the tree's rule accepts and the ray's ends do not lie on.
///
/// It has slices of its own: with [`FilteredRays`] in it, it would not compile to SPIR-V.
#[derive(Clone, Copy)]
pub struct RayFilter<'a> {
    i: u32,
    exponent: u32,
    ray: PreparedRay,
    ends: &'a [RayEnds],
    sides: &'a [u32],
    target: &'a [UVec4; 2],
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
