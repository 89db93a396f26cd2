//! A built hierarchy and its ray queries.

use super::codec::{MeshCodec, NodeCodec};
use super::meter::{Meter, Reads};
use super::packets::filter_of;
use super::sah_cost;
use super::stored::{Stacks, StoredTree, with_stacks};
use super::visitor::{Alone, Shared, Watched};
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::Sides;
use slimbvh_core::encode::RootWords;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, NO_PRIMITIVE, PreparedRay, Ray};
use slimbvh_core::trace::{
    self, AnyHit, ClosestHit, ClosestOrAny, Collector, Lane, LeafTriangles, NearestHits,
    PlainNodes, Skip, SkipAnd, traverse,
};
use slimbvh_core::{LeafTriangle, Node};

/// A bounding volume hierarchy over a mesh. A [`crate::Builder`] fills it, and can fill it again without allocating.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    pub(crate) stored: StoredTree,
    pub(crate) mesh_triangle_count: usize,
    pub(crate) bounds: Option<Aabb>,
    pub(crate) scene_exponent: i32,
    pub(crate) depth_bound: u32,
}

impl Bvh {
    /// The hit with the smallest t; among equals, the smallest primitive index. [`Hit::MISS`] if there is no hit.
    ///
    /// Rays are in the mesh's unit. A ray with a zero direction, or with a NaN or infinite component (except an infinite
    /// `t_max`), hits nothing.
    #[must_use]
    pub fn closest_hit(&self, ray: &Ray) -> Hit {
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        // Plain trees use a specialised collector, which is the fastest.
        let Some(plain) = self.stored.as_plain() else {
            let hit = self.trace_alone(&prepared, ClosestOrAny::closest(prepared.t_max));
            return prepared.restore(hit);
        };
        let mut collector = ClosestHit::new(prepared.t_max);
        plain.trace(&prepared, &mut collector);
        prepared.restore(collector.hit)
    }

    /// Whether the ray hits any triangle; stops at the first hit found.
    #[doc(alias = "occluded")]
    #[must_use]
    pub fn any_hit(&self, ray: &Ray) -> bool {
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        let Some(plain) = self.stored.as_plain() else {
            let collector = ClosestOrAny::any(prepared.t_max);
            return self.trace_alone(&prepared, collector).is_hit();
        };
        let mut collector = AnyHit::new(prepared.t_max);
        plain.trace(&prepared, &mut collector);
        collector.found
    }

    /// The K hits with the smallest `(t, primitive)`, in order, padded with [`Hit::MISS`].
    #[must_use]
    pub fn nearest_hits<const K: usize>(&self, ray: &Ray) -> [Hit; K] {
        if let Some(plain) = self.stored.as_plain() {
            let (nodes, triangles) = (plain.node_source(), plain.triangle_source());
            let filter = &Skip::NONE;
            return trace::nearest_hits(&nodes, &triangles, ray, self.scene_exponent, filter);
        }
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        let mut collector = NearestHits::<K>::new(prepared.t_max);
        with_stacks(|stacks| self.watch(stacks, &prepared, NO_PRIMITIVE, &mut collector));
        collector.hits.map(|hit| prepared.restore(hit))
    }

    #[inline(never)]
    fn trace_alone(&self, ray: &PreparedRay, collector: ClosestOrAny) -> Hit {
        let all = filter_of(None);
        let mut lane = Lane {
            filter: SkipAnd::new(&all, NO_PRIMITIVE),
            collector,
        };
        self.stored.visit(Alone {
            ray,
            lane: &mut lane,
        });
        lane.collector.closest.hit
    }

    fn watch(
        &self,
        stacks: &mut Stacks,
        ray: &PreparedRay,
        skip: u32,
        collector: &mut dyn Collector,
    ) {
        let all = filter_of(None);
        self.stored.visit(Watched {
            stacks,
            ray,
            filter: SkipAnd::new(&all, skip),
            collector,
        });
    }

    /// Traces one ray with any collector, for example one that counts nodes and triangles. Slower than the other queries.
    pub fn collect(&self, ray: &PreparedRay, skip: u32, collector: &mut dyn Collector) {
        // The collector may use this thread's stacks itself.
        if let Some(plain) = self.stored.as_plain() {
            let (nodes, triangles) = (plain.node_source(), plain.triangle_source());
            let collector = &mut Shared(collector);
            traverse(&nodes, &triangles, ray, &Skip(skip), collector);
        } else {
            self.watch(&mut { Stacks::EMPTY }, ray, skip, collector);
        }
    }

    /// As [`Self::collect`], for triangles that a rule accepts ([`crate::Tree::rule`], in the scene's magnitude) or for all. Returns
    /// what the ray tests and reads beside the nodes that it opens.
    pub fn meter(
        &self,
        ray: &PreparedRay,
        skip: u32,
        rule: Option<(Sides, Target)>,
        collector: &mut dyn Collector,
    ) -> Reads {
        self.stored.visit(Meter {
            ray,
            skip,
            rule,
            collector,
        })
    }

    /// The same tree, decoded: nodes and triangles in full.
    #[must_use]
    pub fn decoded(&self) -> Self {
        match self.stored.as_plain() {
            Some(_) => self.clone(),
            None => Self {
                stored: self.stored.decode().into(),
                ..*self
            },
        }
    }

    /// The expected cost of tracing: [`sah_cost`] of the decoded nodes.
    #[must_use]
    pub fn sah_cost(&self) -> f64 {
        match self.stored.as_plain() {
            Some(plain) => sah_cost(&plain.nodes),
            None => sah_cost(&self.stored.decode().nodes),
        }
    }

    /// The bytes of the nodes, and those of the triangles in leaf order. Every backend stores the same tree in the same
    /// bytes.
    #[must_use]
    pub fn stored(&self) -> [&[u8]; 2] {
        let lists = self.stored.lists().lists();
        lists.map(|list| bytemuck::cast_slice(list.words))
    }

    /// The root's box and, on a lattice, the exponent of its step, as words. `None` for plain nodes.
    #[must_use]
    pub fn root_words(&self) -> Option<RootWords> {
        self.stored.lists().root_words()
    }

    /// How nodes and triangles are stored.
    #[must_use]
    pub fn codecs(&self) -> (NodeCodec, MeshCodec) {
        self.stored.lists().codecs(self.scene_exponent)
    }

    /// Whether a refit in these codecs is of collapsed nodes and leaves all of them and all triangles where they lie.
    pub(crate) fn keeps_shape(&self, (nodes, mesh): (NodeCodec, MeshCodec)) -> bool {
        let (own_nodes, own_mesh) = self.codecs();
        let is_same = own_nodes == nodes && own_mesh.name() == mesh.name();
        nodes.is_collapsed() && is_same && self.node_count() > 0
    }

    /// Sets the mesh's bounds and the exponent that follows from them.
    pub(crate) fn set_bounds(&mut self, bounds: Aabb) {
        self.bounds = (!bounds.is_empty()).then_some(bounds);
        self.scene_exponent = scene_exponent(&bounds);
    }

    /// The box around all triangles, in the mesh's unit; `None` for an empty mesh.
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        self.bounds
    }

    /// The number of triangles in the hierarchy.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.stored.lists().triangle_count()
    }

    /// The number of triangles in the mesh it was built over. A reduced hierarchy holds fewer.
    #[must_use]
    pub fn mesh_triangle_count(&self) -> usize {
        self.mesh_triangle_count
    }

    /// The number of inner nodes.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.stored.lists().lists()[0].count()
    }

    /// Bytes of the nodes.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        self.stored()[0].len()
    }

    /// Bytes of the triangles in the leaves.
    #[must_use]
    pub fn triangle_bytes(&self) -> usize {
        self.stored()[1].len()
    }

    /// Bytes of the two buffers, which may be larger than the lists.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.stored.lists().held_bytes()
    }

    /// An upper bound on the nodes along a path from the root.
    #[must_use]
    pub fn depth_bound(&self) -> u32 {
        self.depth_bound
    }

    /// Stored coordinates are the mesh's, times two to this power.
    #[must_use]
    pub fn scene_exponent(&self) -> i32 {
        self.scene_exponent
    }

    /// The nodes, the root first; empty if a codec stores them.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        self.stored.as_plain().map_or(&[], |plain| &plain.nodes)
    }

    /// The triangles in leaf order, scaled to magnitude 1; empty if a codec stores them.
    #[must_use]
    pub fn leaf_triangles(&self) -> &[LeafTriangle] {
        let full = self.stored.lists().full_triangles();
        full.map_or(&[], Vec::as_slice)
    }

    /// [`Self::nodes`] as a source for the traversal.
    #[must_use]
    pub fn node_source(&self) -> PlainNodes<'_> {
        PlainNodes(self.nodes())
    }

    /// [`Self::leaf_triangles`] as a source for the traversal.
    #[must_use]
    pub fn triangle_source(&self) -> LeafTriangles<'_> {
        LeafTriangles(self.leaf_triangles())
    }
}
