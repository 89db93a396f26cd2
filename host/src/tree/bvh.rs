//! A built hierarchy.

use super::codec::{MeshCodec, NodeCodec};
use super::meter::{Meter, Reads};
use super::sah_cost;
use super::stored::StoredTree;
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::Sides;
use slimbvh_core::encode::RootWords;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{Collector, LeafTriangles, PlainNodes};
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
