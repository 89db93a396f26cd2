//! Ray against triangle, watertight (after Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection").
//!
//! Each vertex is carried into the ray's space by one function (`shear`) that knows nothing of the triangle, so a
//! shared vertex has the same bits in all its triangles. On which side of an edge the ray passes is decided by comparing
//! two rounded products: rounding is monotone, so the answer is right or "on the edge", the same for both triangles of
//! the edge, and on the edge is inside.

use crate::float::{abs, max, min};
use crate::ray::{Hit, PreparedRay};
use crate::slab::{PlanePair, crossings};
use glam::Vec3;

/// A vertex seen along the ray: x and y across, scaled by the direction's last component.
#[derive(Clone, Copy)]
struct Sheared {
    x: f32,
    y: f32,
}

/// Without a division: `x·dz − z·dx` has the sign of the exact one or is zero, as both products round monotonically.
#[inline(always)]
fn shear(ray: &PreparedRay, corner: [f32; 3]) -> Sheared {
    let [dx, dy, dz] = ray.direction;
    let x = corner[0] - ray.origin[0];
    let y = corner[1] - ray.origin[1];
    let z = corner[2] - ray.origin[2];
    Sheared {
        x: x * dz - z * dx,
        y: y * dz - z * dy,
    }
}

/// Where the ray meets the triangle, its corners in the order of the ray's axes, within `t_min..=limit`, in prepared t;
/// [`Hit::MISS`] otherwise. Both sides count.
///
/// A hit needs three things: the ray passes inside or on all edges; it passes the slab test of the triangle's own tight
/// box; and t, brought between the box's entry and exit where rounding left it outside, lies in range. As an ancestor's
/// box is entered no later than the triangle's own, no tree can lose the hit or find another.
#[inline(always)]
#[must_use]
pub fn intersect(ray: &PreparedRay, corners: [[f32; 3]; 3], limit: f32, primitive: u32) -> Hit {
    let a = shear(ray, corners[0]);
    let b = shear(ray, corners[1]);
    let c = shear(ray, corners[2]);

    // Twice the signed areas that the ray's point spans with each edge, as two rounded products.
    let (p0, q0) = (c.x * b.y, c.y * b.x);
    let (p1, q1) = (a.x * c.y, a.y * c.x);
    let (p2, q2) = (b.x * a.y, b.y * a.x);
    let front = (p0 >= q0) & (p1 >= q1) & (p2 >= q2);
    let back = (p0 <= q0) & (p1 <= q1) & (p2 <= q2);
    if !(front | back) {
        return Hit::MISS;
    }

    // A fused difference may have the other sign: clamp it to the side that the comparison chose.
    let sign = if front { 1.0 } else { -1.0 };
    let e0 = max((p0 - q0) * sign, 0.0);
    let e1 = max((p1 - q1) * sign, 0.0);
    let e2 = max((p2 - q2) * sign, 0.0);
    let area = e0 + e1 + e2;
    if area < f32::MIN_POSITIVE {
        return Hit::MISS;
    }

    // The triangle's own box has the last word.
    let ([a, b, c], weights) = (corners, [e0, e1, e2]);
    let planes = [
        span(a[0], b[0], c[0]),
        span(a[1], b[1], c[1]),
        span(a[2], b[2], c[2]),
    ];
    let own_box = crossings(ray, planes);
    let (enter, exit) = (own_box.enter.x, own_box.exit.x);
    let first = max(enter, ray.t_min);
    if first > own_box.padded_exit.x || first > limit {
        return Hit::MISS;
    }
    let t = max(min(plane_t(ray, corners, weights), exit), enter);
    if t >= ray.t_min && t <= limit {
        let scale = 1.0 / area;
        Hit {
            t,
            u: e1 * scale,
            v: e2 * scale,
            primitive,
        }
    } else {
        Hit::MISS
    }
}

/// Where the ray's line meets the triangle's plane: `n·p / n·d`.
///
/// The normal comes from the two shortest edges (as in Embree's `stable_triangle_normal`), and p is the corner of the
/// largest weight, so that t is about as good as the corners are. To weight the corners' own t would be off by the
/// weights' rounding times the corners' distance: on a wall 100,000 times as long as wide, that puts the hit behind
/// the eye. NaN or infinite where the triangle is seen exactly from its edge.
#[inline(always)]
fn plane_t(ray: &PreparedRay, corners: [[f32; 3]; 3], weights: [f32; 3]) -> f32 {
    let [a, b, c] = corners;
    let (a, b, c) = (
        Vec3::from_array(a),
        Vec3::from_array(b),
        Vec3::from_array(c),
    );
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let (size_ab, size_bc, size_ca) = (size(ab), size(bc), size(ca));
    let longest = max(max(size_ab, size_bc), size_ca);
    let (e, f) = if size_ab == longest {
        (bc, ca)
    } else if size_bc == longest {
        (ca, ab)
    } else {
        (ab, bc)
    };
    let n = e.cross(f);
    let [weight_a, weight_b, weight_c] = weights;
    let p = if weight_a >= weight_b && weight_a >= weight_c {
        a
    } else if weight_b >= weight_c {
        b
    } else {
        c
    };
    n.dot(p - Vec3::from_array(ray.origin)) / n.dot(Vec3::from_array(ray.direction))
}

/// The magnitude of the largest component.
#[inline(always)]
fn size(v: Vec3) -> f32 {
    max(max(abs(v.x), abs(v.y)), abs(v.z))
}

/// The planes around three coordinates, twice.
#[inline(always)]
fn span(a: f32, b: f32, c: f32) -> PlanePair {
    let low = min(min(a, b), c);
    let high = max(max(a, b), c);
    PlanePair::new(low, low, high, high)
}

/// Keeps barycentric coordinates of a hit in range: rounding may leave u + v a little above 1.
#[inline]
#[must_use]
pub fn weights(u: f32, v: f32) -> Vec3 {
    Vec3::new(max(1.0 - u - v, 0.0), min(u, 1.0), min(v, 1.0))
}
