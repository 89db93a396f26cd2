//! A built hierarchy, and the questions it answers.

use rayon::prelude::*;
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::Except;
use slimbvh_core::ray::{Hit, Ray};
use slimbvh_core::trace::{self, LeafTriangles, PlainNodes};
use slimbvh_core::{LeafTriangle, Node};

/// A bounding volume hierarchy over a mesh. Filled by a [`crate::Builder`], which can fill it again without allocating.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    pub(crate) nodes: Vec<Node>,
    pub(crate) triangles: Vec<LeafTriangle>,
    pub(crate) mesh_triangle_count: usize,
    pub(crate) bounds: Option<Aabb>,
    pub(crate) scene_exponent: i32,
    pub(crate) depth_bound: u32,
}

impl Bvh {
    /// The hit with the smallest t, and among equals with the smallest primitive index; [`Hit::MISS`] where there is none.
    ///
    /// Rays are in the mesh's unit. A ray with a zero direction, or with a NaN or infinite number in it (an
    /// infinite `t_max` aside), hits nothing.
    #[must_use]
    pub fn closest_hit(&self, ray: &Ray) -> Hit {
        trace::closest_hit(
            &self.node_source(),
            &self.triangle_source(),
            ray,
            self.scene_exponent,
            &Except::NOTHING,
        )
    }

    /// Whether the ray meets anything; stops at the first triangle found.
    #[doc(alias = "occluded")]
    #[must_use]
    pub fn any_hit(&self, ray: &Ray) -> bool {
        trace::any_hit(
            &self.node_source(),
            &self.triangle_source(),
            ray,
            self.scene_exponent,
            &Except::NOTHING,
        )
    }

    /// The K hits with the smallest `(t, primitive)`, in order; [`Hit::MISS`] fills what is left.
    #[must_use]
    pub fn nearest_hits<const K: usize>(&self, ray: &Ray) -> [Hit; K] {
        trace::nearest_hits(
            &self.node_source(),
            &self.triangle_source(),
            ray,
            self.scene_exponent,
        )
    }

    /// [`Self::closest_hit`] of many rays, in parallel. `hits` gets as many entries as there are rays.
    pub fn closest_hits(&self, rays: &[Ray], hits: &mut Vec<Hit>) {
        const BLOCK: usize = 512;
        hits.resize(rays.len(), Hit::MISS);
        let blocks = hits.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
        blocks.for_each(|(hits, rays)| {
            for (hit, ray) in hits.iter_mut().zip(rays) {
                *hit = self.closest_hit(ray);
            }
        });
    }

    /// Takes the bounds of the mesh, and the scale that goes with them.
    pub(crate) fn set_bounds(&mut self, bounds: Aabb) {
        self.bounds = (!bounds.is_empty()).then_some(bounds);
        self.scene_exponent = scene_exponent(&bounds);
    }

    /// The box around all triangles, in the mesh's unit; `None` for an empty mesh.
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        self.bounds
    }

    /// How many triangles there are in it.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// How many triangles the mesh has that it was built over. A reduced hierarchy leaves out some.
    #[must_use]
    pub fn mesh_triangle_count(&self) -> usize {
        self.mesh_triangle_count
    }

    /// How many inner nodes there are.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// Bytes of the nodes.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice())
    }

    /// Bytes of the triangles in the leaves.
    #[must_use]
    pub fn triangle_bytes(&self) -> usize {
        size_of_val(self.triangles.as_slice())
    }

    /// Bytes of the memory that is held for both, which a larger hierarchy may have left.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>()
            + self.triangles.capacity() * size_of::<LeafTriangle>()
    }

    /// No path from the root is longer than this.
    #[must_use]
    pub fn depth_bound(&self) -> u32 {
        self.depth_bound
    }

    /// All coordinates inside are the mesh's times two to this power.
    #[must_use]
    pub fn scene_exponent(&self) -> i32 {
        self.scene_exponent
    }

    /// The nodes, the root first.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The triangles in leaf order, carried to magnitude 1.
    #[must_use]
    pub fn leaf_triangles(&self) -> &[LeafTriangle] {
        &self.triangles
    }

    /// The nodes, as the tracer reads them.
    #[must_use]
    pub fn node_source(&self) -> PlainNodes<'_> {
        PlainNodes(&self.nodes)
    }

    /// The triangles, as the tracer reads them.
    #[must_use]
    pub fn triangle_source(&self) -> LeafTriangles<'_> {
        LeafTriangles(&self.triangles)
    }
}
