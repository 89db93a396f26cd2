//! obvhs: its binary tree, built by locally ordered clustering.

use super::clusters::{Clusters, answer, in_order, peer_ray};
use super::{Answer, Bytes, Demand, Question, Tracer, Visits, answer_all};
use anyhow::Result;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::ray::RayHit;
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use slimbvh::Stages;
use slimbvh_core::Ray;
use std::ops::Add;

/// obvhs' `Bvh2` over triangles in leaf order, as its documentation advises.
///
/// The build repeats `build_bvh2_from_tris` step by step, as that function cannot keep its buffers.
pub struct Ploc<'a> {
    name: &'static str,
    clusters: Clusters<'a>,
    leaf_triangles: Vec<Triangle>,
}

impl<'a> Ploc<'a> {
    /// A tracer without a tree yet.
    #[must_use]
    pub fn new(name: &'static str, params: BvhBuildParams, triangles: &'a [Triangle]) -> Self {
        Self {
            name,
            clusters: Clusters::new(params, triangles),
            leaf_triangles: Vec::new(),
        }
    }

    /// The tree, and the triangles in the order of its leaves.
    #[must_use]
    pub fn tree(&self) -> (&Bvh2, &[Triangle]) {
        (&self.clusters.bvh, &self.leaf_triangles)
    }

    /// Walks the tree as obvhs' `ray_traverse_dynamic` does, and counts.
    fn count(&self, ray: &Ray, question: Question) -> Visits {
        let mut visits = Visits::default();
        let (mut ray, _) = peer_ray(ray);
        let nodes = &self.clusters.bvh.nodes;
        let mut stack = Vec::new();
        match nodes.first() {
            Some(root) if root.aabb().intersect_ray(&ray) < ray.tmax => {
                stack.push(root.first_index as usize);
            }
            _ => return visits,
        }
        while let Some(left) = stack.pop() {
            visits.nodes += 1;
            let mut pair = [&nodes[left], &nodes[left + 1]]
                .map(|node| (node, node.aabb().intersect_ray(&ray)));
            if pair[0].1 > pair[1].1 {
                pair.swap(0, 1);
            }
            // Compare the far child's box with the t that the near child's triangles left.
            let mut inner = [None; 2];
            for ((node, enter), inner) in pair.into_iter().zip(&mut inner) {
                if enter >= ray.tmax {
                    continue;
                }
                if !node.is_leaf() {
                    *inner = Some(node.first_index as usize);
                    continue;
                }
                for place in node.first_index..node.first_index + node.prim_count {
                    visits.triangles += 1;
                    let t = self.leaf_triangles[place as usize].intersect(&ray);
                    if t < ray.tmax {
                        ray.tmax = t;
                        if question == Question::Any {
                            return visits;
                        }
                    }
                }
            }
            stack.extend(inner.into_iter().rev().flatten());
        }
        visits
    }
}

impl Tracer for Ploc<'_> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn demand(&self) -> Demand {
        Demand::Close
    }

    fn build(&mut self) -> Result<Stages> {
        self.clusters.build()?;
        let Clusters {
            params,
            triangles,
            optimizer,
            bvh,
            ..
        } = &mut self.clusters;
        let most = params.max_prims_per_leaf.clamp(1, 255);
        collapse(bvh, most, params.collapse_traversal_cost);
        let again = params.post_collapse_reinsertion_batch_ratio_multiplier;
        optimizer.run(bvh, params.reinsertion_batch_ratio * again, None);
        in_order(triangles, &bvh.primitive_indices, &mut self.leaf_triangles);
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        self.clusters.forget();
        self.leaf_triangles = Vec::new();
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        answer_all(rays, answers, |ray| {
            let (peer_ray, shift) = peer_ray(ray);
            let mut hit = RayHit::none();
            self.clusters
                .bvh
                .ray_traverse(peer_ray, &mut hit, |ray, place| {
                    self.leaf_triangles[place].intersect(ray)
                });
            answer(&hit, shift, &self.clusters.bvh.primitive_indices)
        });
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        answer_all(rays, answers, |ray| {
            !self
                .clusters
                .bvh
                .ray_traverse_miss(peer_ray(ray).0, |ray, place| {
                    self.leaf_triangles[place].intersect(ray)
                })
        });
    }

    fn bytes(&self) -> Bytes {
        let nodes = self.clusters.bvh.nodes.len() * size_of::<Bvh2Node>();
        let triangles = size_of_val(self.leaf_triangles.as_slice());
        let indices = self.clusters.bvh.primitive_indices.as_slice();
        Bytes {
            nodes: Some(nodes),
            all: Some(nodes + triangles + size_of_val(indices)),
        }
    }

    fn visits(&self, rays: &[Ray], question: Question) -> Option<Visits> {
        let visits = rays.par_iter().map(|ray| self.count(ray, question));
        Some(visits.reduce(Visits::default, Visits::add))
    }
}
