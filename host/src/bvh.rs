//! A built hierarchy, and the questions it answers.

mod error;
mod validate;
pub(crate) mod view;

pub use error::TreeError;

use crate::animate::sah_cost;
use crate::codec::{MeshCodec, NodeCodec};
use crate::coded::{Alone, Coded, Shared, Stacks, Watched, with_stacks};
use crate::cpu::decode;
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::encode::RootWords;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, NO_PRIMITIVE, PreparedRay, Ray};
use slimbvh_core::trace::{
    self, AnyHit, ClosestHit, ClosestOrAny, Collector, Lane, LeafTriangles, NearestHits,
    PlainNodes, Skip, SkipAnd, traverse, traverse_with,
};
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
    /// What is stored in a codec, in place of nodes and perhaps triangles.
    pub(crate) coded: Option<Coded>,
}

impl Bvh {
    /// The hit with the smallest t, and among equals with the smallest primitive index; [`Hit::MISS`] where there is none.
    ///
    /// Rays are in the mesh's unit. A ray with a zero direction, or with a NaN or infinite number in it (an
    /// infinite `t_max` aside), hits nothing.
    #[must_use]
    pub fn closest_hit(&self, ray: &Ray) -> Hit {
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        if let Some(coded) = &self.coded {
            let hit = self.trace_coded(coded, &prepared, ClosestOrAny::closest(prepared.t_max));
            return prepared.restore(hit);
        }
        let mut collector = ClosestHit::new(prepared.t_max);
        self.trace_plain(&prepared, &mut collector);
        prepared.restore(collector.hit)
    }

    /// Whether the ray meets anything; stops at the first triangle found.
    #[doc(alias = "occluded")]
    #[must_use]
    pub fn any_hit(&self, ray: &Ray) -> bool {
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        if let Some(coded) = &self.coded {
            let collector = ClosestOrAny::any(prepared.t_max);
            return self.trace_coded(coded, &prepared, collector).is_hit();
        }
        let mut collector = AnyHit::new(prepared.t_max);
        self.trace_plain(&prepared, &mut collector);
        collector.found
    }

    /// The K hits with the smallest `(t, primitive)`, in order; [`Hit::MISS`] fills what is left.
    #[must_use]
    pub fn nearest_hits<const K: usize>(&self, ray: &Ray) -> [Hit; K] {
        let Some(coded) = &self.coded else {
            let (nodes, triangles) = (self.node_source(), self.triangle_source());
            return trace::nearest_hits(&nodes, &triangles, ray, self.scene_exponent);
        };
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        let mut collector = NearestHits::<K>::new(prepared.t_max);
        let all = facing(None);
        let errand = Watched {
            ray: &prepared,
            filter: SkipAnd::new(&all, NO_PRIMITIVE),
            collector: &mut collector,
        };
        with_stacks(|stacks| coded.walk(&self.triangles, errand, stacks));
        collector.hits.map(|hit| prepared.restore(hit))
    }

    fn trace_coded(&self, coded: &Coded, ray: &PreparedRay, collector: ClosestOrAny) -> Hit {
        let all = facing(None);
        let mut lane = Lane {
            filter: SkipAnd::new(&all, NO_PRIMITIVE),
            collector,
        };
        with_stacks(|stacks| coded.walk(&self.triangles, Alone(ray, &mut lane), stacks));
        lane.collector.closest.hit
    }

    #[inline(always)]
    fn trace_plain<C: Collector>(&self, ray: &PreparedRay, collector: &mut C) {
        let (nodes, triangles) = (self.node_source(), self.triangle_source());
        with_stacks(|Stacks { plain, .. }| {
            let (stack, rule) = (&mut plain.alone, &Skip::NONE);
            traverse_with(stack, &nodes, &triangles, ray, rule, collector);
        });
    }

    /// Traces one ray with whatever is asked, and counts what is touched on the way. Slower than the other questions.
    pub fn collect(&self, ray: &PreparedRay, skip: u32, collector: &mut dyn Collector) {
        if let Some(coded) = &self.coded {
            let all = facing(None);
            let errand = Watched {
                ray,
                filter: SkipAnd::new(&all, skip),
                collector,
            };
            // The collector may ask this thread's stacks.
            let mut stacks = Stacks::NEW;
            coded.walk(&self.triangles, errand, &mut stacks);
        } else {
            let (nodes, triangles) = (self.node_source(), self.triangle_source());
            traverse(&nodes, &triangles, ray, &Skip(skip), &mut Shared(collector));
        }
    }

    /// The same with plain nodes and triangles: as they come out of the codec.
    #[must_use]
    pub fn decoded(&self) -> Self {
        let Some(coded) = &self.coded else {
            return self.clone();
        };
        let (nodes, triangles) = decode(coded, &self.triangles);
        Self {
            nodes,
            triangles,
            coded: None,
            ..*self
        }
    }

    /// What tracing it costs: [`crate::animate::sah_cost`] of its nodes, as they are decoded.
    #[must_use]
    pub fn sah_cost(&self) -> f64 {
        match &self.coded {
            None => sah_cost(&self.nodes),
            Some(coded) => sah_cost(&decode(coded, &self.triangles).0),
        }
    }

    /// What is stored, byte for byte: nodes, and triangles in leaf order. The same tree has the same bytes on every backend.
    #[must_use]
    pub fn stored(&self) -> [&[u8]; 2] {
        let plain = bytemuck::cast_slice(&self.triangles);
        match &self.coded {
            None => [bytemuck::cast_slice(&self.nodes), plain],
            Some(coded) => [coded.nodes.stored(), coded.triangles.stored(plain)],
        }
    }

    /// The root's box, where nodes are stored in a codec, and the exponent of its step, where it has one, as words.
    #[must_use]
    pub fn root_words(&self) -> Option<RootWords> {
        self.coded.as_ref().map(|coded| coded.nodes.root_words())
    }

    /// How nodes and triangles are stored.
    #[must_use]
    pub fn codecs(&self) -> (NodeCodec, MeshCodec) {
        self.coded
            .as_ref()
            .map_or_else(Default::default, |coded| coded.codecs(self.scene_exponent))
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
        let coded = self.coded.as_ref();
        coded.map_or(self.triangles.len(), |coded| coded.triangle_count)
    }

    /// How many triangles the mesh has that it was built over. A reduced hierarchy leaves out some.
    #[must_use]
    pub fn mesh_triangle_count(&self) -> usize {
        self.mesh_triangle_count
    }

    /// How many inner nodes there are.
    #[must_use]
    pub fn node_count(&self) -> usize {
        let coded = self.coded.as_ref();
        coded.map_or(self.nodes.len(), |coded| coded.nodes.count())
    }

    /// Bytes of the nodes.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        let coded = self.coded.as_ref().map_or(0, |coded| coded.nodes.bytes());
        size_of_val(self.nodes.as_slice()) + coded
    }

    /// Bytes of the triangles in the leaves.
    #[must_use]
    pub fn triangle_bytes(&self) -> usize {
        let coded = self
            .coded
            .as_ref()
            .map_or(0, |coded| coded.triangles.bytes());
        size_of_val(self.triangles.as_slice()) + coded
    }

    /// Bytes of the memory that is held for both, which a larger hierarchy may have left.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>()
            + self.triangles.capacity() * size_of::<LeafTriangle>()
            + self.coded.as_ref().map_or(0, Coded::held_bytes)
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

    /// The nodes, the root first; none where they are stored in a codec.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The triangles in leaf order, carried to magnitude 1; none where they are stored in a codec.
    #[must_use]
    pub fn leaf_triangles(&self) -> &[LeafTriangle] {
        &self.triangles
    }

    /// [`Self::nodes`], as the tracer reads them.
    #[must_use]
    pub fn node_source(&self) -> PlainNodes<'_> {
        PlainNodes(&self.nodes)
    }

    /// [`Self::leaf_triangles`], as the tracer reads them.
    #[must_use]
    pub fn triangle_source(&self) -> LeafTriangles<'_> {
        LeafTriangles(&self.triangles)
    }
}

/// The rule for many rays, and of all trees in codecs: where there is no target, no triangle faces away.
pub(crate) fn facing(target: Option<(Sides, Target)>) -> FacingFilter {
    let everything = Sides {
        components: &[],
        sides: &[],
    };
    let (sides, target) = target.unwrap_or((everything, Target::position([0.0; 3])));
    FacingFilter {
        skip: NO_PRIMITIVE,
        sides,
        target,
    }
}
