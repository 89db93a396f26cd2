//! slimbvh.

use super::{Answer, Bytes, Demand, Question, Tracer, Visits, answer_rows};
use crate::rays::BLOCK;
use anyhow::Result;
use rayon::prelude::*;
use slimbvh::{BuildConfig, Builder, Bvh, Mesh, Stages};
use slimbvh_core::ray::{Hit, PreparedRay, Ray};
use slimbvh_core::trace::{AnyHit, ClosestHit, Collector, Counted, Skip, traverse};
use std::ops::Add;

/// slimbvh's plain tree.
pub struct Slim<'a> {
    name: &'static str,
    config: BuildConfig,
    mesh: &'a Mesh,
    builder: Builder,
    bvh: Bvh,
}

impl<'a> Slim<'a> {
    /// A tracer without a tree yet.
    #[must_use]
    pub fn new(name: &'static str, config: BuildConfig, mesh: &'a Mesh) -> Self {
        Self {
            name,
            config,
            mesh,
            builder: Builder::new(config),
            bvh: Bvh::default(),
        }
    }

    /// Traces with a collector that counts.
    fn count<C: Collector>(&self, ray: &Ray, collector: impl Fn(f32) -> C) -> Visits {
        let ray = PreparedRay::new(ray, self.bvh.scene_exponent());
        let mut counted = Counted::new(collector(ray.t_max));
        traverse(
            &self.bvh.node_source(),
            &self.bvh.triangle_source(),
            &ray,
            &Skip::NONE,
            &mut counted,
        );
        Visits {
            nodes: counted.node_count.into(),
            triangles: counted.triangle_count.into(),
        }
    }
}

impl Tracer for Slim<'_> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn demand(&self) -> Demand {
        Demand::Exact
    }

    fn build(&mut self) -> Result<Stages> {
        Ok(self.builder.build_into(self.mesh, &mut self.bvh)?)
    }

    fn forget(&mut self) {
        self.builder = Builder::new(self.config);
        self.bvh = Bvh::default();
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        answer_rows(rays, answers, |rays, answers| {
            let mut hits = [Hit::MISS; BLOCK];
            self.bvh.closest_hits_of_block(rays, &mut hits);
            for (answer, hit) in answers.iter_mut().zip(hits) {
                *answer = Answer::from(&hit);
            }
        });
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        answer_rows(rays, answers, |rays, answers| {
            self.bvh.any_hits_of_block(rays, answers);
        });
    }

    fn bytes(&self) -> Bytes {
        Bytes {
            nodes: Some(self.bvh.node_bytes()),
            all: Some(self.bvh.node_bytes() + self.bvh.triangle_bytes()),
        }
    }

    fn visits(&self, rays: &[Ray], question: Question) -> Option<Visits> {
        let visits = rays.par_iter().map(|ray| match question {
            Question::Closest => self.count(ray, ClosestHit::new),
            Question::Any => self.count(ray, AnyHit::new),
        });
        Some(visits.reduce(Visits::default, Visits::add))
    }
}
