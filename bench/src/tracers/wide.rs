//! obvhs: its compressed tree of eight children a node.

use super::clusters::{Clusters, answer, in_order, peer_ray};
use super::{Answer, Bytes, Tracer, answer_all};
use anyhow::Result;
use obvhs::BvhBuildParams;
use obvhs::cwbvh::bvh2_to_cwbvh::bvh2_to_cwbvh;
use obvhs::cwbvh::{CwBvh, node::CwBvhNode};
use obvhs::ray::RayHit;
use obvhs::triangle::Triangle;
use slimbvh::Stages;
use slimbvh_core::Ray;

/// obvhs' `CwBvh` over triangles in leaf order.
///
/// The build repeats `build_cwbvh_from_tris` step by step; the binary tree that it converts keeps its buffers.
pub struct Wide<'a> {
    name: &'static str,
    clusters: Clusters<'a>,
    bvh: CwBvh,
    leaf_triangles: Vec<Triangle>,
}

impl<'a> Wide<'a> {
    /// A tracer without a tree yet.
    #[must_use]
    pub fn new(name: &'static str, params: BvhBuildParams, triangles: &'a [Triangle]) -> Self {
        Self {
            name,
            clusters: Clusters::new(params, triangles),
            bvh: CwBvh::default(),
            leaf_triangles: Vec::new(),
        }
    }

    /// The tree, and the triangles in the order of its leaves.
    #[must_use]
    pub fn tree(&self) -> (&CwBvh, &[Triangle]) {
        (&self.bvh, &self.leaf_triangles)
    }
}

impl Tracer for Wide<'_> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn build(&mut self) -> Result<Stages> {
        self.clusters.build()?;
        let most = self.clusters.params.max_prims_per_leaf.clamp(1, 3);
        self.bvh = bvh2_to_cwbvh(&self.clusters.bvh, most, true, false);
        let order = &self.bvh.primitive_indices;
        in_order(self.clusters.triangles, order, &mut self.leaf_triangles);
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        self.clusters.forget();
        self.bvh = CwBvh::default();
        self.leaf_triangles = Vec::new();
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        answer_all(rays, answers, |ray| {
            let (peer_ray, shift) = peer_ray(ray);
            let mut hit = RayHit::none();
            self.bvh.ray_traverse(peer_ray, &mut hit, |ray, place| {
                self.leaf_triangles[place].intersect(ray)
            });
            answer(&hit, shift, &self.bvh.primitive_indices)
        });
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        answer_all(rays, answers, |ray| {
            !self.bvh.ray_traverse_miss(peer_ray(ray).0, |ray, place| {
                self.leaf_triangles[place].intersect(ray)
            })
        });
    }

    fn bytes(&self) -> Bytes {
        let nodes = self.bvh.nodes.len() * size_of::<CwBvhNode>();
        let triangles = size_of_val(self.leaf_triangles.as_slice());
        let indices = self.bvh.primitive_indices.as_slice();
        Bytes {
            nodes: Some(nodes),
            all: Some(nodes + triangles + size_of_val(indices)),
        }
    }
}
