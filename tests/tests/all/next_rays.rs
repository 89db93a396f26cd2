//! Rays between points of surfaces, and rays that leave surfaces: no face, edge or corner that an end lies on blocks them.

mod coded;
mod rooms;
mod solids;

use glam::DVec3;
use slimbvh::{Bvh, Hit, Mesh, Ray, RayEnds, SurfacePoint, SurfaceRay};
use slimbvh_core::watertight::weights;

/// A hit point, and the exact point that it stands for, off by some units of `f64`.
#[derive(Clone, Copy, Debug)]
struct Found {
    point: SurfacePoint,
    exact: DVec3,
}

/// The corners of a triangle.
fn corners(mesh: &Mesh, primitive: u32) -> [DVec3; 3] {
    mesh.indices[primitive as usize].map(|v| DVec3::from(mesh.vertices[v as usize].map(f64::from)))
}

/// The point that a ray through a target hits.
fn found(bvh: &Bvh, mesh: &Mesh, eye: [f32; 3], target: [f32; 3]) -> Option<Found> {
    let ray = Ray::new(eye, [0, 1, 2].map(|axis| target[axis] - eye[axis]));
    let hit = bvh.closest_hit(ray);
    let point = bvh.surface(mesh, ray, &hit)?;
    let [a, b, c] = corners(mesh, hit.primitive);
    let [u, v, w] = weights(hit.u, hit.v).to_array().map(f64::from);
    let exact = (a * u + b * v + c * w) / (u + v + w);
    for axis in 0..3 {
        let off = (exact[axis] - f64::from(point.position[axis])).abs();
        assert!(off <= f64::from(point.error[axis]), "{point:?} {exact}");
    }
    Some(Found { point, exact })
}

/// How far a point is in front of a triangle's plane, times twice the triangle's area; 0 if `f64` is too coarse to tell the side.
fn height(corners: [DVec3; 3], point: DVec3) -> f64 {
    let [a, b, c] = corners;
    let (e, f, r) = (b - a, c - a, point - a);
    let height = e.cross(f).dot(r);
    let certain = height.abs() > 1e-14 * e.length() * f.length() * (r.length() + point.length());
    if certain { height } else { 0.0 }
}

/// Whether a triangle's plane separates the two exact points.
fn separates(mesh: &Mesh, primitive: u32, a: &Found, b: &Found) -> bool {
    let corners = corners(mesh, primitive);
    height(corners, a.exact) * height(corners, b.exact) < 0.0
}

/// Whether the exact point is in a triangle's plane.
fn is_on(mesh: &Mesh, primitive: u32, point: &Found) -> bool {
    height(corners(mesh, primitive), point.exact) == 0.0
}

/// What blocks two points.
fn blocker(bvh: &Bvh, a: &Found, b: &Found) -> Option<Hit> {
    let ray = Ray::between(a.point, b.point);
    let hit = bvh.closest_hit(ray);
    assert_eq!(bvh.any_hit(ray), hit.is_hit());
    hit.is_hit().then_some(hit)
}

/// The negative control: the same ray without errors, with the primitives at both ends skipped.
fn is_blocked_without_errors(bvh: &Bvh, a: &Found, b: &Found) -> bool {
    let ray = Ray::between(a.point, b.point);
    bvh.any_hit(SurfaceRay {
        ends: RayEnds {
            error: [-1.0; 2],
            ..ray.ends
        },
        ..ray
    })
}
