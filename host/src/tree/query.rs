//! Queries of single rays: of a tree, and of a tree with a rule.

use super::bvh::Bvh;
use super::packets::{Question, filter_of};
use super::ray_filter::{RayFilter, SharedFilter, are_more_than_skip};
use super::visitor::{Alone, Watched};
use slimbvh_core::classify::Sides;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, PreparedRay, Ray};
use slimbvh_core::trace::{
    self, AnyHit, ClosestHit, Collector, EndsAnd, EndsFilter, HitFilter, Lane, NearestHits,
    PreparedEnds, Skip,
};
use slimbvh_core::{RayEnds, SurfaceRay};

/// A tree, and which of its triangles count.
#[derive(Clone, Copy, Debug)]
pub struct Query<'a> {
    pub bvh: &'a Bvh,
    /// Triangles that face away from the target do not count. At the scene's magnitude. `None`: all count.
    pub rule: Option<(Sides<'a>, Target)>,
}

impl Query<'_> {
    #[inline]
    pub fn closest_hit(&self, ray: SurfaceRay) -> Hit {
        if self.is_plain(&ray) {
            self.bvh.closest_hit_of_all(&ray.ray)
        } else {
            self.ask(Question::Closest, &ray)
        }
    }

    #[inline]
    pub fn any_hit(&self, ray: SurfaceRay) -> bool {
        if self.is_plain(&ray) {
            self.bvh.has_hit_of_all(&ray.ray)
        } else {
            self.ask(Question::Any, &ray).is_hit()
        }
    }

    #[inline]
    pub fn nearest_hits<const K: usize>(&self, ray: SurfaceRay) -> [Hit; K] {
        let exponent = self.bvh.scene_exponent();
        if self.is_plain(&ray)
            && let Some(plain) = self.bvh.stored.as_plain()
        {
            let (nodes, triangles) = (plain.node_source(), plain.triangle_source());
            return trace::nearest_hits(&nodes, &triangles, &ray.ray, exponent, &Skip::NONE);
        }
        let prepared = PreparedRay::new(&ray.ray, exponent);
        let mut collector = NearestHits::<K>::new(prepared.t_max);
        self.collect(&prepared, &ray.ends, &mut collector);
        collector.hits.map(|hit| prepared.restore(hit))
    }

    pub fn all_hits(&self, ray: &SurfaceRay) -> Vec<Hit> {
        let prepared = PreparedRay::new(&ray.ray, self.bvh.scene_exponent());
        let mut collector = AllHits {
            hits: Vec::new(),
            t_max: prepared.t_max,
        };
        self.collect(&prepared, &ray.ends, &mut collector);
        let mut hits = collector.hits;
        hits.sort_unstable_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
        for hit in &mut hits {
            *hit = prepared.restore(*hit);
        }
        hits
    }

    pub fn closest_hit_where(
        &self,
        ray: &SurfaceRay,
        accepts: &mut dyn FnMut(&Hit) -> bool,
    ) -> Hit {
        let prepared = PreparedRay::new(&ray.ray, self.bvh.scene_exponent());
        let mut collector = Where {
            ray: &prepared,
            accepts,
            inner: ClosestHit::new(prepared.t_max),
        };
        self.collect(&prepared, &ray.ends, &mut collector);
        prepared.restore(collector.inner.hit)
    }

    pub fn any_hit_where(&self, ray: &SurfaceRay, accepts: &mut dyn FnMut(&Hit) -> bool) -> bool {
        let prepared = PreparedRay::new(&ray.ray, self.bvh.scene_exponent());
        let mut collector = Where {
            ray: &prepared,
            accepts,
            inner: AnyHit::new(prepared.t_max),
        };
        self.collect(&prepared, &ray.ends, &mut collector);
        collector.inner.found
    }

    pub fn collect(&self, ray: &PreparedRay, ends: &RayEnds, collector: &mut dyn Collector) {
        let rule = filter_of(self.rule);
        let ends = PreparedEnds {
            ray,
            ends,
            scene_exponent: self.bvh.scene_exponent(),
        };
        let filter = &EndsAnd {
            ends: EndsFilter(ends),
            filter: &rule,
        };
        self.bvh.stored.visit(Watched {
            ray,
            filter,
            collector,
        });
    }

    /// Whether all triangles that the ray meets are hits.
    #[inline]
    fn is_plain(&self, ray: &SurfaceRay) -> bool {
        self.rule.is_none() && ray.ends == RayEnds::NONE
    }

    #[inline(never)]
    fn ask(&self, question: Question, ray: &SurfaceRay) -> Hit {
        let shared = SharedFilter {
            facing: &filter_of(self.rule),
            rays: std::slice::from_ref(ray),
            with_ends: are_more_than_skip(&ray.ends).into(),
            scene_exponent: self.bvh.scene_exponent(),
        };
        let filter = RayFilter {
            skip: ray.ends.skip[0],
            number: 0,
            shared: &shared,
        };
        self.bvh.trace_alone(question, &ray.ray, filter)
    }
}

impl Bvh {
    /// All of its triangles count.
    #[inline]
    pub(super) fn query(&self) -> Query<'_> {
        Query {
            bvh: self,
            rule: None,
        }
    }

    fn closest_hit_of_all(&self, ray: &Ray) -> Hit {
        // Plain trees use a specialised collector, which is the fastest.
        let Some(plain) = self.stored.as_plain() else {
            return self.trace_alone(Question::Closest, ray, Skip::NONE);
        };
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        let mut collector = ClosestHit::new(prepared.t_max);
        plain.trace(&prepared, &mut collector);
        prepared.restore(collector.hit)
    }

    fn has_hit_of_all(&self, ray: &Ray) -> bool {
        let Some(plain) = self.stored.as_plain() else {
            return self.trace_alone(Question::Any, ray, Skip::NONE).is_hit();
        };
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        let mut collector = AnyHit::new(prepared.t_max);
        plain.trace(&prepared, &mut collector);
        collector.found
    }

    fn trace_alone<F: HitFilter>(&self, question: Question, ray: &Ray, filter: F) -> Hit {
        let prepared = PreparedRay::new(ray, self.scene_exponent);
        let collector = question.collector(prepared.t_max);
        let mut lane = Lane { filter, collector };
        self.stored.visit(Alone {
            ray: &prepared,
            lane: &mut lane,
        });
        prepared.restore(lane.collector.closest.hit)
    }
}

/// All hits, in no order.
struct AllHits {
    hits: Vec<Hit>,
    t_max: f32,
}

impl Collector for AllHits {
    fn limit(&self) -> f32 {
        self.t_max
    }

    fn offer(&mut self, hit: Hit) {
        self.hits.push(hit);
    }
}

/// The hits that a closure accepts.
struct Where<'a, C> {
    ray: &'a PreparedRay,
    accepts: &'a mut dyn FnMut(&Hit) -> bool,
    inner: C,
}

impl<C: Collector> Collector for Where<'_, C> {
    fn limit(&self) -> f32 {
        self.inner.limit()
    }

    fn offer(&mut self, hit: Hit) {
        if (self.accepts)(&self.ray.restore(hit)) {
            self.inner.offer(hit);
        }
    }

    fn goes_farther_first(&self) -> bool {
        self.inner.goes_farther_first()
    }
}
