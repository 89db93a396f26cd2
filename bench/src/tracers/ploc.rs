//! obvhs: its binary tree, built by locally ordered clustering.

use super::{Answer, Bytes, Question, Tracer, Visits, answer_all};
use anyhow::{Result, ensure};
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use obvhs::ploc::PlocBuilder;
use obvhs::ray::{Ray as PeerRay, RayHit};
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use slimbvh::Stages;
use slimbvh_core::Ray;
use std::ops::Add;

/// obvhs' `Bvh2` over triangles in leaf order, as its documentation advises.
///
/// The build is `build_bvh2_from_tris` step by step, as that one offers no way to keep its buffers.
pub struct Ploc<'a> {
    name: &'static str,
    params: BvhBuildParams,
    triangles: &'a [Triangle],
    builder: PlocBuilder,
    optimizer: ReinsertionOptimizer,
    bvh: Bvh2,
    leaf_triangles: Vec<Triangle>,
}

impl<'a> Ploc<'a> {
    /// Nothing is built yet.
    #[must_use]
    pub fn new(name: &'static str, params: BvhBuildParams, triangles: &'a [Triangle]) -> Self {
        Self {
            name,
            params,
            triangles,
            builder: PlocBuilder::new(),
            optimizer: ReinsertionOptimizer::default(),
            bvh: Bvh2::default(),
            leaf_triangles: Vec::new(),
        }
    }

    /// Walks the tree as obvhs' `ray_traverse_dynamic` does, and counts.
    fn count(&self, ray: &Ray, question: Question) -> Visits {
        let mut visits = Visits::default();
        let mut ray = peer_ray(ray);
        let nodes = &self.bvh.nodes;
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
            // The far child's box is held against what the near child's triangles left of the ray.
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

/// A ray as obvhs takes it. Its reciprocals are part of the time, as slimbvh's preparation is.
#[inline(always)]
fn peer_ray(ray: &Ray) -> PeerRay {
    PeerRay::new(
        Vec3A::from_array(ray.origin),
        Vec3A::from_array(ray.direction),
        ray.t_min,
        ray.t_max,
    )
}

impl Tracer for Ploc<'_> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn build(&mut self) -> Result<Stages> {
        let params = &self.params;
        ensure!(
            !params.pre_split,
            "presets that split triangles are not handled"
        );

        // The first build gets zeroed pages from the system, as in obvhs' own function.
        if self.bvh.nodes.is_empty() {
            self.builder = PlocBuilder::with_capacity(self.triangles.len());
            self.bvh = Bvh2::zeroed(self.triangles.len());
        }
        let mut indices = std::mem::take(&mut self.bvh.primitive_indices);
        indices.clear();
        indices.extend(0..self.triangles.len() as u32);
        self.builder.build_with_bvh(
            &mut self.bvh,
            params.ploc_search_distance,
            self.triangles,
            indices,
            params.sort_precision,
            params.search_depth_threshold,
        );
        let ratio = params.reinsertion_batch_ratio;
        self.optimizer.run(&mut self.bvh, ratio, None);
        let most = params.max_prims_per_leaf.clamp(1, 255);
        collapse(&mut self.bvh, most, params.collapse_traversal_cost);
        let ratio = ratio * params.post_collapse_reinsertion_batch_ratio_multiplier;
        self.optimizer.run(&mut self.bvh, ratio, None);

        let order = self.bvh.primitive_indices.par_iter();
        order
            .map(|&primitive| self.triangles[primitive as usize])
            .collect_into_vec(&mut self.leaf_triangles);
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        *self = Self::new(self.name, self.params, self.triangles);
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        answer_all(rays, answers, |ray| {
            let mut hit = RayHit::none();
            self.bvh
                .ray_traverse(peer_ray(ray), &mut hit, |ray, place| {
                    self.leaf_triangles[place].intersect(ray)
                });
            match self.bvh.primitive_indices.get(hit.primitive_id as usize) {
                Some(&primitive) => Answer {
                    t: hit.t,
                    primitive,
                },
                None => Answer::MISS,
            }
        });
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        answer_all(rays, answers, |ray| {
            !self.bvh.ray_traverse_miss(peer_ray(ray), |ray, place| {
                self.leaf_triangles[place].intersect(ray)
            })
        });
    }

    fn bytes(&self) -> Bytes {
        Bytes {
            nodes: self.bvh.nodes.len() * size_of::<Bvh2Node>(),
            triangles: size_of_val(self.leaf_triangles.as_slice())
                + size_of_val(self.bvh.primitive_indices.as_slice()),
        }
    }

    fn visits(&self, rays: &[Ray], question: Question) -> Visits {
        rays.par_iter()
            .map(|ray| self.count(ray, question))
            .reduce(Visits::default, Visits::add)
    }
}
