//! Ray against box: the slab test, padded so that it never rejects a triangle that the ray meets.
//!
//! All operations are monotone (one subtraction, one product by a constant of the ray, min, max, one padding sum), so a
//! box that holds another enters no later and leaves no earlier, to the last bit. That is why the answer of a traversal
//! does not depend on the tree.
//!
//! The padding: the triangle test ([`crate::geometry::watertight`]) decides by comparing rounded products, each within a relative
//! `gamma(2)` of the exact one. Where it accepts a triangle, the exact intervals of any two axes overlap but for a few of
//! those errors, measured in t along the ray's longest axis, over which the triangle reaches no farther than its box.
//! The slab's own roundings (a subtraction, a reciprocal of 2.5 ULP as Vulkan allows, a product, on both planes) add to
//! them: 30 units in all. Ize (2013, "Robust BVH Ray Traversal") pads the far plane by a factor instead; that loses rays
//! that pass an edge of a box much longer than their way to it.

use crate::geometry::float::gamma;
use crate::geometry::planes::{PlanePair, Planes};
use crate::geometry::ray::PreparedRay;
use glam::Vec4;

/// Padding of the interval's end, relative to how far the box reaches along the ray's longest axis.
pub const SLAB_PADDING: f32 = gamma(32);

/// Where a ray enters two boxes, and which of them it meets within its range.
#[derive(Clone, Copy, Debug)]
pub struct BoxPairHit {
    /// At least the ray's `t_min`. Rounded, not padded.
    pub enter_a: f32,
    /// At least the ray's `t_min`. Rounded, not padded.
    pub enter_b: f32,
    /// Whether it meets the first box before `limit`.
    pub meets_a: bool,
    /// Whether it meets the second box before `limit`.
    pub meets_b: bool,
}

/// Tests two boxes at once, their planes in the order of the ray's axes.
#[inline(always)]
#[must_use]
pub fn slab(ray: &PreparedRay, planes: [PlanePair; 3], limit: f32) -> BoxPairHit {
    let crossing = crossings(planes, ray.plane_origins, ray.inverse);
    let enter = Planes::most(crossing.enter, Vec4::splat(ray.t_min));
    let meets = enter.cmple(Planes::least(crossing.padded_exit, Vec4::splat(limit)));
    BoxPairHit {
        enter_a: enter.x,
        enter_b: enter.y,
        meets_a: meets.test(0),
        meets_b: meets.test(1),
    }
}

/// Where rays' whole lines pass boxes, in the place of each plane. A number that is 0 may have either sign
/// ([`crate::geometry::float::least`]).
#[derive(Clone, Copy)]
pub(crate) struct Crossings<P> {
    /// Rounded.
    pub enter: P,
    /// Rounded; below `enter` where the box is missed, by rounding alone if barely.
    pub exit: P,
    /// `exit` with the padding.
    pub padded_exit: P,
}

/// The arithmetic of all slab tests.
#[inline(always)]
pub(crate) fn crossings<P: Planes>(
    planes: [P; 3],
    plane_origins: [P; 3],
    inverse: [P::Numbers; 3],
) -> Crossings<P> {
    let t0 = (planes[0] - plane_origins[0]).times(inverse[0]);
    let t1 = (planes[1] - plane_origins[1]).times(inverse[1]);
    let t2 = (planes[2] - plane_origins[2]).times(inverse[2]);
    let (near_2, far_2) = (t2.least(t2.opposite()), t2.most(t2.opposite()));
    let enter = t0
        .least(t0.opposite())
        .most(t1.least(t1.opposite()))
        .most(near_2);
    let exit = t0
        .most(t0.opposite())
        .least(t1.most(t1.opposite()))
        .least(far_2);
    let reach = far_2.most(-near_2);
    Crossings {
        enter,
        exit,
        padded_exit: exit + reach.scaled(SLAB_PADDING),
    }
}
