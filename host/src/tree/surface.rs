//! The point that a ray hits.

use super::query::Query;
use super::sources::{StoredNodes, StoredTriangles};
use super::visitor::TreeVisitor;
use crate::Mesh;
use glam::Vec3;
use slimbvh_core::float::{PowerOfTwo, exponent};
use slimbvh_core::ray::{Hit, PreparedRay};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::trace::{AnyHit, HitFilter, traverse};
use slimbvh_core::{SurfacePoint, SurfaceRay, Triangle};
use std::cell::Cell;

/// The point that a ray with this direction hits, with the mesh's shading normals. Everything is at the scene's magnitude.
pub fn surface_at(mesh: &Mesh, triangle: Triangle, hit: &Hit, direction: Vec3) -> Surface {
    let corners = mesh.indices.get(hit.primitive as usize);
    let corners = corners.copied().unwrap_or_default();
    let normals = corners.map(|corner| {
        let normal = mesh.normals.get(corner as usize);
        normal.map_or(Vec3::ZERO, |&normal| Vec3::from_array(normal))
    });
    Surface::new(triangle, hit, direction, normals)
}

impl Query<'_> {
    pub fn surface(&self, mesh: &Mesh, ray: &SurfaceRay, hit: &Hit) -> Option<SurfacePoint> {
        let is_over = mesh.indices.len() == self.bvh.mesh_triangle_count();
        if !hit.is_hit() || !is_over || hit.primitive as usize >= mesh.indices.len() {
            return None;
        }
        let scene_exponent = self.bvh.scene_exponent();
        let triangle = if self.bvh.codecs().1.moves_vertices() {
            self.traced_triangle(ray, hit.primitive)?
        } else {
            let scale = PowerOfTwo::new(scene_exponent);
            leaf_triangle(hit.primitive, &mesh.triangles(), &scale).triangle()
        };
        let longest = ray.ray.direction.iter().fold(0.0f32, |a, b| a.max(b.abs()));
        // Of magnitude 1, so that no product with it leaves the range of numbers.
        let to_one = PowerOfTwo::new(-exponent(longest));
        let direction = Vec3::from_array(to_one.times_each(ray.ray.direction));
        let surface = surface_at(mesh, triangle, hit, direction);
        Some(SurfacePoint::new(&surface, hit.primitive, scene_exponent))
    }

    /// A triangle that the ray meets, as its leaf stores it: in 10 bits it differs from the mesh's.
    fn traced_triangle(&self, ray: &SurfaceRay, primitive: u32) -> Option<Triangle> {
        let ray = PreparedRay::new(&ray.ray, self.bvh.scene_exponent());
        let wanted = Wanted {
            primitive,
            corners: Cell::new(None),
        };
        self.bvh.stored.visit(Search {
            ray: &ray,
            wanted: &wanted,
        });
        let corners = wanted.corners.get()?;
        let [v0, v1, v2] = corners.map(|corner| {
            let mut vertex = [0.0; 3];
            for (axis, x) in ray.axes.into_iter().zip(corner) {
                vertex[axis as usize % 3] = x;
            }
            Vec3::from_array(vertex)
        });
        Some(Triangle { v0, v1, v2 })
    }
}

/// Walks a tree along a ray, and accepts no triangle.
struct Search<'a> {
    ray: &'a PreparedRay,
    wanted: &'a Wanted,
}

impl TreeVisitor for Search<'_> {
    type Output = ();

    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) {
        let collector = &mut AnyHit::new(self.ray.t_max);
        traverse(nodes, triangles, self.ray, self.wanted, collector);
    }
}

/// Accepts no triangle, and remembers the corners of one.
struct Wanted {
    primitive: u32,
    /// Coordinates in the order of the ray's axes.
    corners: Cell<Option<[[f32; 3]; 3]>>,
}

impl HitFilter for Wanted {
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], _: [u32; 3]) -> bool {
        if primitive == self.primitive {
            self.corners.set(Some(*corners));
        }
        false
    }
}
