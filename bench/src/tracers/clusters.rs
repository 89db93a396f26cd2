//! The build that all of obvhs' trees start with, and obvhs' rays and hits.

use super::{Answer, not_behind};
use anyhow::{Result, ensure};
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;
use obvhs::ray::{Ray as PeerRay, RayHit};
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use slimbvh_core::Ray;

/// A binary tree over single triangles, by locally ordered clustering and, if the preset asks for it, reinsertion.
pub struct Clusters<'a> {
    pub params: BvhBuildParams,
    pub triangles: &'a [Triangle],
    pub optimizer: ReinsertionOptimizer,
    pub bvh: Bvh2,
    builder: PlocBuilder,
}

impl<'a> Clusters<'a> {
    /// No tree yet.
    pub fn new(params: BvhBuildParams, triangles: &'a [Triangle]) -> Self {
        Self {
            params,
            triangles,
            optimizer: ReinsertionOptimizer::default(),
            bvh: Bvh2::default(),
            builder: PlocBuilder::new(),
        }
    }

    /// Builds into the buffers of the build before.
    pub fn build(&mut self) -> Result<()> {
        let params = &self.params;
        ensure!(
            !params.pre_split,
            "presets that split triangles are not handled"
        );
        // The first build takes zeroed pages from the system, as obvhs' own function does.
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
        Ok(())
    }

    /// Frees all memory.
    pub fn forget(&mut self) {
        *self = Self::new(self.params, self.triangles);
    }
}

/// Triangles in the order of a tree's leaves.
pub fn in_order(triangles: &[Triangle], order: &[u32], to: &mut Vec<Triangle>) {
    let order = order.par_iter();
    order
        .map(|&primitive| triangles[primitive as usize])
        .collect_into_vec(to);
}

/// A ray in obvhs' form, and the shift to add to its t. Its reciprocals are part of the time, as slimbvh's preparation is.
#[inline(always)]
pub fn peer_ray(ray: &Ray) -> (PeerRay, f32) {
    let (ray, shift) = not_behind(ray);
    let [origin, direction] = [ray.origin, ray.direction].map(Vec3A::from_array);
    (PeerRay::new(origin, direction, ray.t_min, ray.t_max), shift)
}

/// The hit that obvhs found along a ray with the shift of [`peer_ray`], in a tree with triangles in this order.
#[inline(always)]
pub fn answer(hit: &RayHit, shift: f32, order: &[u32]) -> Answer {
    match order.get(hit.primitive_id as usize) {
        Some(&primitive) => Answer {
            t: hit.t + shift,
            primitive,
        },
        None => Answer::MISS,
    }
}
