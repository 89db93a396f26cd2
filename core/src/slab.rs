//! Ray against box: the slab test, padded so that it never rejects a triangle that the ray meets.
//!
//! All operations are monotone (one subtraction, one product by a constant of the ray, min, max, one padding sum), so a
//! box that holds another enters no later and leaves no earlier, to the last bit. That is why the answer of a traversal
//! does not depend on the tree.
//!
//! The padding: the triangle test ([`crate::watertight`]) decides by comparing rounded products, each within a relative
//! `gamma(2)` of the exact one. Where it accepts a triangle, the exact intervals of any two axes overlap but for a few of
//! those errors, measured in t along the ray's longest axis, over which the triangle reaches no farther than its box.
//! The slab's own roundings (a subtraction, a reciprocal of 2.5 ULP as Vulkan allows, a product, on both planes) add to
//! them: 30 units in all. Ize (2013, "Robust BVH Ray Traversal") pads the far plane by a factor instead; that loses rays
//! that pass an edge of a box much longer than their way to it.

use crate::float::{gamma, max, min};
use crate::ray::PreparedRay;

/// Padding of the interval's end, relative to how far the box reaches along the ray's longest axis.
pub const SLAB_PADDING: f32 = gamma(32);

/// Where a ray enters and leaves boxes, in prepared t, not yet clipped to the ray's range. Missed where
/// `enter > exit`.
#[derive(Clone, Copy, Debug)]
pub struct Intervals<const N: usize> {
    /// Rounded, not padded.
    pub enter: [f32; N],
    /// Padded.
    pub exit: [f32; N],
}

/// Tests N boxes at once. `low` and `high` hold their planes in the order of the ray's axes.
#[inline(always)]
#[must_use]
pub fn slab<const N: usize>(
    ray: &PreparedRay,
    low: [[f32; N]; 3],
    high: [[f32; N]; 3],
) -> Intervals<N> {
    let (near_0, far_0) = axis(ray, 0, low[0], high[0]);
    let (near_1, far_1) = axis(ray, 1, low[1], high[1]);
    let (near_2, far_2) = axis(ray, 2, low[2], high[2]);
    let mut enter = near_0;
    let mut exit = far_0;
    for i in 0..N {
        enter[i] = max(max(near_0[i], near_1[i]), near_2[i]);
        let reach = max(far_2[i], -near_2[i]);
        exit[i] = min(min(far_0[i], far_1[i]), far_2[i]) + SLAB_PADDING * reach;
    }
    Intervals { enter, exit }
}

/// One axis: where the ray passes the nearer and the farther plane.
#[inline(always)]
fn axis<const N: usize>(
    ray: &PreparedRay,
    axis: usize,
    low: [f32; N],
    high: [f32; N],
) -> ([f32; N], [f32; N]) {
    let mut near = low;
    let mut far = high;
    for i in 0..N {
        let a = (low[i] - ray.min_origin[axis]) * ray.inverse[axis];
        let b = (high[i] - ray.max_origin[axis]) * ray.inverse[axis];
        near[i] = min(a, b);
        far[i] = max(a, b);
    }
    (near, far)
}
