//! Whether two triangles meet beyond their shared corners and side, decided exactly.

use crate::analysis::{area_sign, volume_sign};
use glam::Vec3;
use slimbvh_core::Aabb;

/// A triangle of positive area.
#[derive(Clone, Copy)]
pub(super) struct Face {
    /// Positions.
    pub(super) corners: [[f32; 3]; 3],
    /// Equal exactly if positions are equal.
    pub(super) ids: [u32; 3],
}

/// Whether two triangles certainly meet in one shared corner alone, by boxes. So it is with all but a few pairs in a fan.
///
/// Else they have a segment in common that begins in the corner. It ends where it leaves one of them, through the side opposite
/// the corner; so one triangle's opposite side meets the other triangle.
pub(super) fn meet_in_corner_alone(t: &Face, u: &Face) -> bool {
    let shared = |face: &Face, other: &Face| {
        let mut corners = (0..3).filter(|&i| other.ids.contains(&face.ids[i]));
        match (corners.next(), corners.next()) {
            (Some(corner), None) => Some(corner),
            _ => None,
        }
    };
    let (Some(i), Some(j)) = (shared(t, u), shared(u, t)) else {
        return false;
    };
    let opposite = |face: &Face, corner: usize| {
        bounds(&[
            face.corners[(corner + 1) % 3],
            face.corners[(corner + 2) % 3],
        ])
    };
    !touch(&opposite(t, i), &bounds(&u.corners)) && !touch(&opposite(u, j), &bounds(&t.corners))
}

fn bounds(points: &[[f32; 3]]) -> Aabb {
    let points = points.iter().map(|&point| Vec3::from(point));
    points.fold(Aabb::EMPTY, Aabb::union_point)
}

/// Whether two boxes have a point in common.
pub(super) fn touch(a: &Aabb, b: &Aabb) -> bool {
    let gap = |a: Vec3, b: Vec3| a.x > b.x || a.y > b.y || a.z > b.z;
    !gap(a.min, b.max) && !gap(b.min, a.max)
}

/// Whether two triangles of positive area have a common point outside of their shared corners and side. Triangles that
/// share all corners do.
pub(super) fn collide(t: &Face, u: &Face) -> bool {
    let shared_t = t.ids.map(|id| u.ids.contains(&id));
    let shared_u = u.ids.map(|id| t.ids.contains(&id));
    if shared_t == [true; 3] {
        return true;
    }

    // The sides of the other's plane on which the corners lie. If a triangle, its shared corners aside, lies strictly on
    // one side, the triangles do not meet.
    let signs_t = signs(t, shared_t, u);
    if are_on_one_side(signs_t, shared_t) {
        return false;
    }
    let signs_u = signs(u, shared_u, t);
    if are_on_one_side(signs_u, shared_u) {
        return false;
    }

    let shared_count = shared_t.iter().filter(|&&shared| shared).count();
    if shared_count == 2 {
        // Coplanar, with a common side as hinge.
        return lie_on_one_side_of_hinge(t, shared_t, u);
    }
    // Each corner of the intersection lies on a side of one triangle that shares no corner with the other, or is a shared
    // corner.
    any_side_meets(t, shared_t, signs_t, u) || any_side_meets(u, shared_u, signs_u, t)
}

/// The side of `other`'s plane on which each corner lies; 0 for shared corners.
fn signs(face: &Face, shared: [bool; 3], other: &Face) -> [i32; 3] {
    [0, 1, 2].map(|i| {
        if shared[i] {
            0
        } else {
            volume_sign(other.corners, face.corners[i])
        }
    })
}

/// Whether all unshared corners lie strictly on the same side.
fn are_on_one_side(signs: [i32; 3], shared: [bool; 3]) -> bool {
    let all = |side| (0..3).all(|i| shared[i] || signs[i] == side);
    all(1) || all(-1)
}

/// For two coplanar triangles that share a side: whether they lie on the same side of it.
fn lie_on_one_side_of_hinge(t: &Face, shared_t: [bool; 3], u: &Face) -> bool {
    let (x, y) = shadow_axes(t.corners);
    let flat = |p: [f32; 3]| [f64::from(p[x]), f64::from(p[y])];
    let free_t = (0..3).find(|&i| !shared_t[i]).unwrap_or(0);
    let free_u = (0..3).find(|&i| !t.ids.contains(&u.ids[i])).unwrap_or(0);
    let (a, b) = (
        flat(t.corners[(free_t + 1) % 3]),
        flat(t.corners[(free_t + 2) % 3]),
    );
    area_sign(a, b, flat(t.corners[free_t])) == area_sign(a, b, flat(u.corners[free_u]))
}

/// Whether a side without shared corners meets the other triangle. `signs` are the corners' sides of its plane.
fn any_side_meets(face: &Face, shared: [bool; 3], signs: [i32; 3], other: &Face) -> bool {
    [(0, 1), (1, 2), (2, 0)].into_iter().any(|(i, j)| {
        if shared[i] || shared[j] || signs[i] * signs[j] > 0 {
            return false;
        }
        let segment = [face.corners[i], face.corners[j]];
        if signs[i] == 0 && signs[j] == 0 {
            meets_in_plane(segment, other.corners)
        } else {
            line_passes(segment, other.corners)
        }
    })
}

/// Whether a line that crosses a triangle's plane does so inside the triangle or on its border.
fn line_passes([p, q]: [[f32; 3]; 2], [a, b, c]: [[f32; 3]; 3]) -> bool {
    let first = volume_sign([p, q, a], b);
    let second = volume_sign([p, q, b], c);
    if first * second < 0 {
        return false;
    }
    let third = volume_sign([p, q, c], a);
    first * third >= 0 && second * third >= 0
}

/// Whether a segment in a triangle's plane meets the triangle.
fn meets_in_plane(segment: [[f32; 3]; 2], triangle: [[f32; 3]; 3]) -> bool {
    let (x, y) = shadow_axes(triangle);
    let flat = |p: [f32; 3]| [f64::from(p[x]), f64::from(p[y])];
    let ([p, q], corners) = (segment.map(flat), triangle.map(flat));
    let [a, b, c] = corners;
    let turn = area_sign(a, b, c);
    let sides = [[a, b], [b, c], [c, a]];
    // An end inside, or a crossed side.
    sides.iter().all(|&[a, b]| area_sign(a, b, p) * turn >= 0)
        || sides.iter().any(|&[a, b]| {
            let ends = [area_sign(a, b, p), area_sign(a, b, q)];
            let others = [area_sign(p, q, a), area_sign(p, q, b)];
            ends[0] * ends[1] <= 0 && others[0] * others[1] <= 0 && ends != [0, 0]
        })
}

/// Two axes whose plane a triangle of positive area projects to with positive area.
fn shadow_axes(corners: [[f32; 3]; 3]) -> (usize, usize) {
    let has_area = |&(x, y): &(usize, usize)| {
        let [a, b, c] = corners.map(|p| [f64::from(p[x]), f64::from(p[y])]);
        area_sign(a, b, c) != 0
    };
    let axes = [(0, 1), (1, 2), (2, 0)];
    axes.into_iter().find(has_area).unwrap_or(axes[0])
}
