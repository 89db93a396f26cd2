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

use crate::geometry::float::{abs, gamma, power_of_two};
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
    let near = |t: P| t.least(t.opposite());
    let far = |t: P| t.most(t.opposite());
    between(
        [near(t0), near(t1), near(t2)],
        [far(t0), far(t1), far(t2)],
        SLAB_PADDING,
    )
}

/// Where lines pass boxes, from where they pass the nearer and the farther plane of each axis.
#[inline(always)]
fn between<P: Planes>(near: [P; 3], far: [P; 3], padding: f32) -> Crossings<P> {
    let enter = near[0].most(near[1]).most(near[2]);
    let exit = far[0].least(far[1]).least(far[2]);
    let reach = far[2].most(-near[2]);
    Crossings {
        enter,
        exit,
        padded_exit: exit + reach.scaled(padding),
    }
}

/// Where a ray enters four boxes, and which of them it meets within its range.
#[derive(Clone, Copy, Debug)]
pub struct FourBoxesHit {
    /// At least the ray's `t_min`. Rounded, not padded.
    pub enter: Vec4,
    /// The same, padded as limits are: what a box holds is entered no earlier.
    pub earliest: Vec4,
    /// Whether it meets each before `limit`.
    pub meets: [bool; 4],
    /// The same, a bit each.
    #[cfg(not(target_arch = "spirv"))]
    pub met: u32,
}

/// Planes of four boxes on one axis, a lane a box, as nodes hold them.
pub trait FourPlanes: Copy {
    /// Padding of the interval's end, as [`SLAB_PADDING`].
    const PADDING: f32;

    /// By how much limits are padded, relative to them: 0 where a box is never entered later than what it holds.
    const LIMIT_PADDING: f32;

    /// The planes.
    fn planes(self) -> Vec4;

    /// Where a ray meets them that has this origin and this reciprocal of its direction there: where it enters boxes, not later than
    /// that but for the padding; or where it leaves them, not earlier.
    fn crossed(self, origin: f32, inverse: f32, is_entry: bool) -> Vec4;
}

/// Planes in full.
impl FourPlanes for Vec4 {
    const PADDING: f32 = SLAB_PADDING;
    const LIMIT_PADDING: f32 = 0.0;

    #[inline(always)]
    fn planes(self) -> Vec4 {
        self
    }

    #[inline(always)]
    fn crossed(self, origin: f32, inverse: f32, _: bool) -> Vec4 {
        (self - Vec4::splat(origin)) * inverse
    }
}

/// Planes that are `base + number·cell`, numbers from 0 to 255, cells powers of two of either sign.
///
/// A ray's t is computed as `number·(cell·inverse) + (base − origin)·inverse`, one fused operation a plane, or two. That is not
/// monotone: the ray may be far from the base and near to the plane. With u the unit of rounding, C the cell's length in t, A the second
/// summand and t the exact one, errors are at most `2u|A|` of A and, as `|A| ≤ |t| + 255|C|`, all in all
///
/// ```text
/// u|t| + 3u|A| + u·255|C| ≤ 4u|t| + 1020u|C|
/// ```
///
/// where A carries a margin, too, and the product is rounded, not fused. The margin, 2^-13·|C| = 2048u|C|, moves entries down
/// and exits up by more than the second part. The first is that of planes in full but for two units a plane: the end's
/// padding is larger by 8. A triangle's own box is entered at `t(1 ± 2u)`, so that limits are padded by 8 units.
#[derive(Clone, Copy, Debug)]
pub struct CodedPlanes {
    /// Whole numbers from 0 to 255.
    pub numbers: Vec4,
    /// A plane with the number 0.
    pub base: f32,
    /// From one number to the next.
    pub cell: f32,
}

/// Cells by which entries and exits are moved apart.
const MARGIN: f32 = power_of_two(-13);

impl FourPlanes for CodedPlanes {
    const PADDING: f32 = gamma(40);
    const LIMIT_PADDING: f32 = gamma(8);

    #[inline(always)]
    fn planes(self) -> Vec4 {
        self.numbers * self.cell + Vec4::splat(self.base)
    }

    #[inline(always)]
    fn crossed(self, origin: f32, inverse: f32, is_entry: bool) -> Vec4 {
        let scale = self.cell * inverse;
        let margin = abs(scale) * if is_entry { -MARGIN } else { MARGIN };
        let at = (self.base - origin) * inverse + margin;
        self.numbers * scale + Vec4::splat(at)
    }
}

/// [`slab`] of four boxes: by the planes that the ray meets first on each axis, and by the others. For planes in full to the bit, but
/// for the sign of zeros. A box whose planes are exchanged is met by no ray that does not begin very far away.
#[inline(always)]
#[must_use]
pub fn slab_of_four<P: FourPlanes>(
    ray: &PreparedRay,
    first: [P; 3],
    second: [P; 3],
    limit: f32,
) -> FourBoxesHit {
    let crossed = |axis: usize| {
        // They differ only where the direction is zero, and is taken for positive.
        let (a, b) = (ray.plane_origins[axis].x, ray.plane_origins[axis].z);
        let inverse = ray.inverse[axis];
        (
            first[axis].crossed(a, inverse, true),
            second[axis].crossed(b, inverse, false),
        )
    };
    let ((a, d), (b, e), (c, f)) = (crossed(0), crossed(1), crossed(2));
    let crossing = between([a, b, c], [d, e, f], P::PADDING);
    let enter = Planes::most(crossing.enter, Vec4::splat(ray.t_min));
    let limit = if P::LIMIT_PADDING == 0.0 {
        limit
    } else {
        limit + abs(limit) * P::LIMIT_PADDING
    };
    let meets = enter.cmple(Planes::least(crossing.padded_exit, Vec4::splat(limit)));
    let earliest = if P::LIMIT_PADDING == 0.0 {
        enter
    } else {
        let [a, b, c, d] = [enter.x, enter.y, enter.z, enter.w];
        let earlier = |x: f32| x - abs(x) * P::LIMIT_PADDING;
        Vec4::new(earlier(a), earlier(b), earlier(c), earlier(d))
    };
    FourBoxesHit {
        enter,
        earliest,
        meets: [meets.test(0), meets.test(1), meets.test(2), meets.test(3)],
        #[cfg(not(target_arch = "spirv"))]
        met: meets.bitmask(),
    }
}
