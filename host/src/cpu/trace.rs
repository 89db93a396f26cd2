//! Stage `trace` on the CPU: the hits of a wave's rays.

use super::render::{BLOCK, Prepared, Renderer};
use super::trees::{Tree, skipping};
use crate::picture::RenderReport;
use crate::tree::Question;
use rayon::prelude::*;
use slimbvh_core::RayEnds;
use slimbvh_core::ray::{Hit, PreparedRay};
use slimbvh_core::trace::{ClosestHit, Counted};

impl Renderer {
    /// Traces the camera's rays.
    pub(super) fn trace_primary(&mut self, stage: &Prepared, report: &mut RenderReport) {
        report
            .stages
            .time("trace primary", || self.trace_paths(&stage.trees.primary));
        let hits = self.hits.par_iter().filter(|hit| hit.is_hit()).count();
        report.primary_hit_count += hits as u64;
    }

    /// Traces the rays of all living paths.
    pub(super) fn trace_paths(&mut self, tree: &Tree) {
        let blocks = self
            .hits
            .par_chunks_mut(BLOCK)
            .zip(self.paths.par_chunks(BLOCK));
        blocks.for_each(|(hits, paths)| {
            hits.fill(Hit::MISS);
            let alive = paths.iter().enumerate().filter(|(_, path)| path.is_alive());
            let rays = alive.map(|(i, path)| (i, skipping(path.ray, path.skip)));
            tree.ask(Question::Closest, rays, |i, hit| hits[i] = hit);
        });
    }

    /// Counts the nodes that each sample visits.
    pub(super) fn count_nodes(&mut self, stage: &Prepared, report: &mut RenderReport) {
        let bvh = stage.trees.primary.bvh;
        let begin = self.heat.len();
        self.heat.resize(begin + self.paths.len(), 0);
        let blocks = self.heat[begin..]
            .par_chunks_mut(BLOCK)
            .zip(self.paths.par_chunks(BLOCK));
        let hits = report.stages.time("trace primary", || {
            blocks
                .map(|(heat, paths)| {
                    let mut hits = 0;
                    for (count, path) in heat.iter_mut().zip(paths) {
                        let ray = PreparedRay::new(&path.ray, 0);
                        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
                        bvh.collect(&ray, &RayEnds::skipping(path.skip), &mut collector);
                        *count = collector.node_count;
                        hits += u64::from(collector.inner.hit.is_hit());
                    }
                    hits
                })
                .sum::<u64>()
        });
        report.primary_hit_count += hits;
    }
}
