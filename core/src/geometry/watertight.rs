//! Ray against triangle, watertight (after Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection").
//!
//! Each vertex is carried into the ray's space by one function (`shear`) that knows nothing of the triangle, so a
//! shared vertex has the same bits in all its triangles. On which side of an edge the ray passes is decided by comparing
//! two rounded products: rounding is monotone, so the answer is right or "on the edge", the same for both triangles of
//! the edge, and on the edge is inside.

use crate::geometry::float::{UNIT_ROUNDOFF, least, max, min, most};
use crate::geometry::lanes::Lanes;
use crate::geometry::planes::Planes;
use crate::geometry::ray::{Hit, PreparedRay, RayLanes};
use crate::geometry::slab::crossings;
use glam::Vec3;

/// A vertex seen along the ray: x and y across, scaled by the direction's last component.
#[derive(Clone, Copy)]
struct Sheared<L> {
    x: L,
    y: L,
}

/// Without a division: `x·dz − z·dx` has the sign of the exact one or is zero, as both products round monotonically.
#[inline(always)]
fn shear<L: Lanes>(origin: [L; 3], direction: [L; 3], corner: [L; 3]) -> Sheared<L> {
    let [dx, dy, dz] = direction;
    let x = corner[0] - origin[0];
    let y = corner[1] - origin[1];
    let z = corner[2] - origin[2];
    Sheared {
        x: x * dz - z * dx,
        y: y * dz - z * dy,
    }
}

/// A vector for all lanes.
#[inline(always)]
fn spread<L: Lanes>([x, y, z]: [f32; 3]) -> [L; 3] {
    [L::splat(x), L::splat(y), L::splat(z)]
}

/// How rays pass a triangle's edges.
struct Passage<L: Lanes> {
    /// The corners, seen along the rays.
    corners: [Sheared<L>; 3],
    /// Twice the signed areas that the ray's point spans with each edge, as two rounded products.
    products: [[L; 2]; 3],
    /// Inside or on all edges, of a triangle that turns its front to the ray.
    front: L::Mask,
    /// Inside or on all edges, of one that turns its back.
    back: L::Mask,
}

#[inline(always)]
fn pass<L: Lanes>(origin: [L; 3], direction: [L; 3], corners: [[L; 3]; 3]) -> Passage<L> {
    let a = shear(origin, direction, corners[0]);
    let b = shear(origin, direction, corners[1]);
    let c = shear(origin, direction, corners[2]);
    let (p0, q0) = (c.x * b.y, c.y * b.x);
    let (p1, q1) = (a.x * c.y, a.y * c.x);
    let (p2, q2) = (b.x * a.y, b.y * a.x);
    Passage {
        corners: [a, b, c],
        products: [[p0, q0], [p1, q1], [p2, q2]],
        front: p0.at_least(q0) & p1.at_least(q1) & p2.at_least(q2),
        back: p0.at_most(q0) & p1.at_most(q1) & p2.at_most(q2),
    }
}

/// Where rays meet a triangle: `P = (1-u-v)·v0 + u·v1 + v·v2`.
pub(crate) struct Meeting<L: Lanes> {
    /// In prepared t. Means nothing for rays that miss, as all the rest.
    pub t: L,
    pub u: L,
    pub v: L,
    /// Which rays meet it.
    pub met: L::Mask,
}

impl<L: Lanes> Meeting<L> {
    /// Where no ray does.
    #[inline(always)]
    fn nowhere(none: L::Mask) -> Self {
        Self {
            t: L::ZERO,
            u: L::ZERO,
            v: L::ZERO,
            met: none,
        }
    }
}

/// Where the ray meets the triangle, its corners in the order of the ray's axes, within `t_min..=limit`, in prepared t;
/// [`Hit::MISS`] otherwise. Both sides count.
#[inline(always)]
#[must_use]
pub fn intersect(ray: &PreparedRay, corners: [[f32; 3]; 3], limit: f32, primitive: u32) -> Hit {
    let Meeting { t, u, v, met } = meet(&ray.lanes(), &corners, limit);
    if met {
        Hit { t, u, v, primitive }
    } else {
        Hit::MISS
    }
}

/// Where rays meet a triangle within `t_min..=limit`.
///
/// A hit needs three things: the ray passes inside or on all edges; it passes the slab test of the triangle's own tight
/// box; and t, brought between the box's entry and exit where rounding left it outside, lies in range. As an ancestor's
/// box is entered no later than the triangle's own, no tree can lose the hit or find another.
#[inline(always)]
pub(crate) fn meet<P: Planes<Numbers = L>, L: Lanes>(
    rays: &RayLanes<P>,
    corners: &[[f32; 3]; 3],
    limit: L,
) -> Meeting<L> {
    let [v0, v1, v2] = *corners;
    let passage = pass(
        rays.origin,
        rays.direction,
        [spread(v0), spread(v1), spread(v2)],
    );
    let inside = passage.front | passage.back;
    if !L::any(inside) {
        return Meeting::nowhere(inside);
    }
    let [a, b, c] = passage.corners;
    let [[p0, q0], [p1, q1], [p2, q2]] = passage.products;

    // A fused difference may have the other sign: clamp it to the side that the comparison chose.
    let sign = L::select(passage.front, L::splat(1.0), L::splat(-1.0));
    let e0 = ((p0 - q0) * sign).max(L::ZERO);
    let e1 = ((p1 - q1) * sign).max(L::ZERO);
    let e2 = ((p2 - q2) * sign).max(L::ZERO);
    let area = e0 + e1 + e2;

    // The triangle's own box has the last word.
    let planes = [
        span(v0[0], v1[0], v2[0]),
        span(v0[1], v1[1], v2[1]),
        span(v0[2], v1[2], v2[2]),
    ];
    let own_box = crossings::<P>(planes, rays.plane_origins, rays.inverse);
    let (enter, exit) = (own_box.enter.low(), own_box.exit.low());
    let first = enter.most(rays.t_min);
    let candidates = inside
        & area.at_least(L::splat(f32::MIN_POSITIVE))
        & reaches(a.x, b.x, c.x)
        & reaches(a.y, b.y, c.y)
        & first.at_most(own_box.padded_exit.low())
        & first.at_most(limit);
    if !L::any(candidates) {
        return Meeting::nowhere(candidates);
    }
    let t = plane_t(rays, corners, ([a, b, c], [e0, e1, e2]), candidates);
    // Either zero may have come of the comparisons: the answer has no sign there.
    let t = t.min(exit).max(enter).positive_zero();
    let scale = L::splat(1.0) / area;
    Meeting {
        t,
        u: e1 * scale,
        v: e2 * scale,
        met: candidates & t.at_least(rays.t_min) & t.at_most(limit),
    }
}

/// Whether the ray passes between the corners or on one, on one axis across: exactly, as they are seen along the ray.
///
/// Edges alone do not tell where the ray runs in the triangle's plane: all three then pass through it, but for rounding.
/// Of surfaces that hang together one triangle holds the ray exactly, and is never beside it.
#[inline(always)]
fn reaches<L: Lanes>(a: L, b: L, c: L) -> L::Mask {
    a.least(b).least(c).at_most(L::ZERO) & a.most(b).most(c).at_least(L::ZERO)
}

/// Where the ray's line meets the triangle's plane: `n·p / n·d`. `sheared` are the corners as they are seen along the ray,
/// `weights` those of the point that the ray meets. Right for the rays that are asked.
///
/// The normal comes from the two shortest edges (as in Embree's `stable_triangle_normal`), and p is the corner of the
/// largest weight, so that t is about as good as the corners are. To weight the corners' own t would be off by the
/// weights' rounding times the corners' distance: on a wall 100,000 times as long as wide, that puts the hit behind
/// the eye.
///
/// On a triangle that is almost a line the normal is hardly known, nor is the plane that far from p. So it must pass the
/// point on the longest side beside the ray. Else, and where the ray runs in the plane as far as rounding can tell, t is
/// where the ray passes this point, and the rest of the way is with that normal, where it is no longer than the triangle.
#[inline(always)]
fn plane_t<P: Planes<Numbers = L>, L: Lanes>(
    rays: &RayLanes<P>,
    corners: &[[f32; 3]; 3],
    (sheared, weights): ([Sheared<L>; 3], [L; 3]),
    asked: L::Mask,
) -> L {
    let [a, b, c] = [
        Vec3::from_array(corners[0]),
        Vec3::from_array(corners[1]),
        Vec3::from_array(corners[2]),
    ];
    let [at_a, at_b, at_c] = sheared;
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let size = |v: Vec3| largest(v.to_array());
    let (size_ab, size_bc, size_ca) = (size(ab), size(bc), size(ca));
    let longest = most(most(size_ab, size_bc), size_ca);
    let (e, f, from, side, at, end) = if size_ab == longest {
        (bc, ca, a, ab, at_a, at_b)
    } else if size_bc == longest {
        (ca, ab, b, bc, at_b, at_c)
    } else {
        (ab, bc, c, ca, at_c, at_a)
    };
    let n = e.cross(f);
    let [origin, direction] = [rays.origin, rays.direction];
    let [weight_a, weight_b, weight_c] = weights;
    let is_a = weight_a.at_least(weight_b) & weight_a.at_least(weight_c);
    let is_b = weight_b.at_least(weight_c);
    let nearest = |a: f32, b: f32, c: f32| {
        L::select(is_a, L::splat(a), L::select(is_b, L::splat(b), L::splat(c)))
    };
    let p = [
        nearest(a.x, b.x, c.x) - origin[0],
        nearest(a.y, b.y, c.y) - origin[1],
        nearest(a.z, b.z, c.z) - origin[2],
    ];
    let normal = spread(n.to_array());
    let (height, slope) = (dot(normal, p), dot(normal, direction));

    // The point on the longest side that the ray passes at a right angle, as seen along it.
    let (x, y) = (end.x - at.x, end.y - at.y);
    // Squares of very small numbers are 0.
    let square = (x * x + y * y).max(L::splat(f32::MIN_POSITIVE));
    let share = -(at.x * x + at.y * y) / square;
    let share = share.min(L::splat(1.0)).max(L::ZERO);
    let (from, side) = (spread::<L>(from.to_array()), spread::<L>(side.to_array()));
    let p = [
        from[0] + side[0] * share - origin[0],
        from[1] + side[1] * share - origin[1],
        from[2] + side[2] * share - origin[2],
    ];
    let slack = L::splat(PLANE_SLACK) * largest(p).most(L::splat(longest)) * L::splat(size(n));
    let is_on_plane = (dot(normal, p) - height).abs().at_most(slack);
    let is_edge_on = slope.abs().at_most(L::splat(EDGE_ON * size(e) * size(f)));
    let is_sure = is_on_plane & !is_edge_on;
    let t = height / slope;
    if !L::any(asked & !is_sure) {
        return t;
    }
    // Along the direction's longest axis nothing is left. (Compilers of shaders take `z · (x / z)` for x: none is written here.)
    let beside = p[2] / direction[2];
    let (x, y) = (p[0] - direction[0] * beside, p[1] - direction[1] * beside);
    let rest = (normal[0] * x + normal[1] * y) / slope;
    let is_near = rest.abs().at_most(L::splat(longest));
    L::select(is_sure, t, L::select(is_near, beside + rest, beside))
}

#[inline(always)]
fn dot<L: Lanes>(a: [L; 3], b: [L; 3]) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// What rounding may leave of `n·d` where the ray runs in the triangle's plane, relative to the sides that n comes from.
const EDGE_ON: f32 = 64.0 * UNIT_ROUNDOFF;

/// How far off the point beside the ray the plane may pass, relative to the way there.
const PLANE_SLACK: f32 = 16.0 * UNIT_ROUNDOFF;

/// The magnitude of the largest component.
#[inline(always)]
fn largest<L: Lanes>([x, y, z]: [L; 3]) -> L {
    x.abs().most(y.abs()).most(z.abs())
}

/// The planes around three coordinates.
#[inline(always)]
fn span<P: Planes>(a: f32, b: f32, c: f32) -> P {
    let (low, high) = (least(least(a, b), c), most(most(a, b), c));
    P::new(P::Numbers::splat(low), P::Numbers::splat(high))
}

/// Keeps barycentric coordinates of a hit in range: rounding may leave u + v a little above 1.
#[inline]
#[must_use]
pub fn weights(u: f32, v: f32) -> Vec3 {
    Vec3::new(max(1.0 - u - v, 0.0), min(u, 1.0), min(v, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ray::Ray;

    fn hit(ray: &Ray, corners: [[f32; 3]; 3]) -> Hit {
        let ray = PreparedRay::new(ray, 0);
        let corners = corners.map(|corner| ray.axes.map(|axis| corner[axis as usize]));
        ray.restore(intersect(&ray, corners, ray.t_max, 7))
    }

    /// Such a ray passes all three edges' lines, but for rounding, and the box: it was a hit, 0.004 off.
    #[test]
    fn a_ray_in_a_triangles_plane_beside_it_misses() {
        let coplanar = [
            [1.095_703_1, 0.591_796_9, -0.635_742_2],
            [0.974_609_4, 0.742_187_5, -0.997_070_3],
            [1.09375, 0.689_453_1, -0.832_031_25],
        ];
        let ray = Ray::new(
            [1.121_951_1, 0.698_196_65, -0.835_417_75],
            [-2.496_044_6e-17, 7.943_045e-18, -2.836_631_3e-17],
        );
        assert_eq!(hit(&ray, coplanar), Hit::MISS);
    }

    /// It passes the triangle from t = 1 on, and was said to at 0.47, before its end.
    #[test]
    fn a_ray_in_a_triangles_plane_that_ends_before_it_misses() {
        let centred = [
            [0.634_890_56, -0.519_751_8, 0.905_436],
            [-0.634_890_56, 0.519_751_8, -0.905_436],
            [-0.231_798_02, -0.189_760_95, -0.330_573_98],
        ];
        let whole = Ray::new(
            [0.970_797_6, -0.417_675_94, 1.384_483],
            [-0.716_841_4, 0.209_775_24, -1.022_308_6],
        );
        let ray = Ray {
            t_max: 0.774,
            ..whole
        };
        assert_eq!(hit(&ray, centred), Hit::MISS);
        assert!((hit(&whole, centred).t - 1.0).abs() < 1e-6);
    }

    /// A triangle 100,000 times as long as high: its normal is hardly known, and t was off by 0.0003 of 1.
    #[test]
    fn t_is_exact_on_a_triangle_that_is_almost_a_line() {
        let flat = [
            [0.481_669_1, 0.708_729_9, 1.071_414_7],
            [1.409_17, 0.985_452_95, 0.820_085_35],
            [0.945_419_8, 0.847_089_65, 0.945_748_8],
        ];
        let ray = Ray::new(
            [1.129_308_8, 0.901_954_65, 0.895_920_2],
            [-1.135_536_8, -0.494_195_16, -0.764_926_7],
        );
        let found = hit(&ray, flat);
        assert!(found.is_hit() && found.t.abs() < 1e-6, "{found:?}");
    }
}
