//! Stage `classify`: which triangles rays of one origin may hit (after Wong, Cheng and Lii 2012, "Reduced BVHs").
//!
//! On a closed surface that is seen from outside, the first triangle that a ray meets faces its origin, and a ray to a light
//! outside that meets anything meets a triangle that faces the light. Others need not be in the tree at all. The rule is
//! one function, [`faces`]: a reduced tree leaves out only what it rejects, and a whole tree's hits are asked the same.
//!
//! A ray to a light that starts outside, too, meets as many triangles that face the light as triangles that face away: then
//! either half answers, and with sides negated the same function keeps the other one.

use crate::float::PowerOfTwo;
use crate::frustum::Frustum;
use crate::orientation::{Orientation, Target};
use crate::ray::NO_PRIMITIVE;
use crate::snap::leaf_triangle;
use crate::trace::{Rule, TriangleSource};
use crate::triangle::{IndexedTriangles, Triangle};
use glam::Vec3;

/// Whether rays from or to a target may hit a triangle of a component whose outer side is this: 1 for the front, −1 for the
/// back, and 0 where all of it must stay. False only where the triangle certainly faces away from all of the target.
#[inline]
#[must_use]
pub fn faces(triangle: &Triangle, side: i32, target: &Target) -> bool {
    side == 0 || !Orientation::new(triangle, target).is_certainly_on(-side as f32)
}

/// Which sides of which components face out, for one target.
#[derive(Clone, Copy, Debug)]
pub struct Sides<'a> {
    /// The component of each primitive.
    pub components: &'a [u32],
    /// The outer side of each component, 0 where it stays whole. Components beyond the last stay whole.
    pub sides: &'a [i32],
}

impl Sides<'_> {
    /// The outer side of a primitive's component.
    #[inline(always)]
    #[must_use]
    pub fn side(&self, primitive: u32) -> i32 {
        let component = crate::load(self.components, primitive, u32::MAX);
        crate::load(self.sides, component, 0)
    }
}

/// What rays of one kind may hit.
#[derive(Clone, Copy, Debug)]
pub struct Reach<'a> {
    /// Which sides of which components face out.
    pub sides: Sides<'a>,
    /// Where the rays come from, or lead to.
    pub target: Target,
    /// Where they go.
    pub frustum: Frustum,
}

impl Reach<'_> {
    /// The same in a scene that is multiplied by a power of two.
    #[inline]
    #[must_use]
    pub fn scaled(&self, scale: &PowerOfTwo) -> Self {
        Self {
            target: self.target.scaled(scale),
            frustum: self.frustum.scaled(scale),
            ..*self
        }
    }
}

/// One thread per triangle, in any order. Reads the mesh, its component and that one's side. Returns whether it is in the
/// set of what rays may hit, which is in the scene's magnitude.
#[inline]
#[must_use]
pub fn is_in_set(
    primitive: u32,
    mesh: &IndexedTriangles,
    scale: &PowerOfTwo,
    reach: &Reach,
) -> bool {
    let side = reach.sides.side(primitive);
    if side == 0 && reach.frustum.is_bounded == 0 {
        return true;
    }
    let triangle = leaf_triangle(primitive, mesh, scale).triangle();
    faces(&triangle, side, &reach.target) && !reach.frustum.is_certainly_outside(&triangle)
}

/// The rule for rays from or to a target, traced through a whole tree: what [`faces`] rejects does not count.
#[derive(Clone, Copy, Debug)]
pub struct Facing<'a> {
    /// A primitive that does not count, [`NO_PRIMITIVE`] for none.
    pub skip: u32,
    /// Components and their sides.
    pub sides: Sides<'a>,
    /// The rays' origin, or where they go, in the scene's magnitude.
    pub target: Target,
}

impl Rule for Facing<'_> {
    #[inline(always)]
    fn counts<T: TriangleSource>(&self, place: u32, primitive: u32, triangles: &T) -> bool {
        if primitive == self.skip {
            return false;
        }
        let side = self.sides.side(primitive);
        if side == 0 {
            return true;
        }
        let corners = triangles.corners(place, [0, 1, 2]);
        let triangle = Triangle {
            v0: Vec3::from_array(corners[0]),
            v1: Vec3::from_array(corners[1]),
            v2: Vec3::from_array(corners[2]),
        };
        faces(&triangle, side, &self.target)
    }
}

/// The rule that all triangles count but one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Except(pub u32);

impl Except {
    /// All triangles count.
    pub const NOTHING: Self = Self(NO_PRIMITIVE);
}

impl Rule for Except {
    #[inline(always)]
    fn counts<T: TriangleSource>(&self, _: u32, primitive: u32, _: &T) -> bool {
        primitive != self.0
    }
}
