//! Collectors: what a traversal looks for.

use crate::geometry::ray::Hit;

/// The limit where no hit can change the answer: no t is below it. A ray that has it is done, unless its
/// range begins there.
pub const FINAL: f32 = f32::MIN;

/// Gathers hits, and says how far away a hit still matters.
pub trait Collector {
    /// The largest t, in prepared units, at which a hit may still change the answer; [`FINAL`] where none can.
    fn limit(&self) -> f32;

    /// Takes a hit with `t <= limit`.
    fn offer(&mut self, hit: Hit);

    /// Whether rays go to the farther of two children first. Read once, before the walk; no closest hit depends on it. It pays where
    /// any hit ends the walk: a ray that leaves a surface passes many of its triangles narrowly, and hits what is farther away.
    #[inline(always)]
    fn goes_farther_first(&self) -> bool {
        false
    }

    /// Called for each inner node that is opened by a ray that walks alone, with the number of its children, whose boxes are tested.
    #[inline(always)]
    fn count_node(&mut self, _children: u32) {}

    /// Called for each triangle that is tested by a ray that walks alone.
    #[inline(always)]
    fn count_triangle(&mut self) {}
}

/// The hit with the smallest `(t, primitive)`.
#[derive(Clone, Copy, Debug)]
pub struct ClosestHit {
    /// The best so far.
    pub hit: Hit,
    limit: f32,
}

impl ClosestHit {
    /// Looks for hits up to `t_max`.
    #[inline(always)]
    #[must_use]
    pub fn new(t_max: f32) -> Self {
        Self {
            hit: Hit::MISS,
            limit: t_max,
        }
    }
}

impl Collector for ClosestHit {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline(always)]
    fn offer(&mut self, hit: Hit) {
        if precedes(&hit, &self.hit) {
            self.hit = hit;
            self.limit = hit.t;
        }
    }
}

/// The closest hit or any hit, chosen at run time.
#[derive(Clone, Copy, Debug)]
pub struct ClosestOrAny {
    /// The best so far.
    pub closest: ClosestHit,
    any_will_do: bool,
}

impl ClosestOrAny {
    /// Looks for hits up to `t_max`: the closest.
    #[inline(always)]
    #[must_use]
    pub fn closest(t_max: f32) -> Self {
        Self {
            closest: ClosestHit::new(t_max),
            any_will_do: false,
        }
    }

    /// Looks for hits up to `t_max`: any.
    #[inline(always)]
    #[must_use]
    pub fn any(t_max: f32) -> Self {
        Self {
            any_will_do: true,
            ..Self::closest(t_max)
        }
    }
}

impl Collector for ClosestOrAny {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.closest.limit()
    }

    #[inline(always)]
    fn offer(&mut self, hit: Hit) {
        self.closest.offer(hit);
        if self.any_will_do {
            self.closest.limit = FINAL;
        }
    }

    #[inline(always)]
    fn goes_farther_first(&self) -> bool {
        self.any_will_do
    }
}

/// Whether there is a hit at all.
#[derive(Clone, Copy, Debug)]
pub struct AnyHit {
    /// Whether one was found.
    pub found: bool,
    limit: f32,
}

impl AnyHit {
    /// Looks for hits up to `t_max`.
    #[inline(always)]
    #[must_use]
    pub fn new(t_max: f32) -> Self {
        Self {
            found: false,
            limit: t_max,
        }
    }
}

impl Collector for AnyHit {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline(always)]
    fn offer(&mut self, _hit: Hit) {
        self.found = true;
        self.limit = FINAL;
    }

    #[inline(always)]
    fn goes_farther_first(&self) -> bool {
        true
    }
}

/// The K hits with the smallest `(t, primitive)`, in order.
#[derive(Clone, Copy, Debug)]
pub struct NearestHits<const K: usize> {
    /// Misses at the end.
    pub hits: [Hit; K],
    limit: f32,
}

impl<const K: usize> NearestHits<K> {
    /// Looks for hits up to `t_max`.
    #[inline(always)]
    #[must_use]
    pub fn new(t_max: f32) -> Self {
        Self {
            hits: [Hit::MISS; K],
            limit: t_max,
        }
    }
}

impl<const K: usize> Collector for NearestHits<K> {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline(always)]
    fn offer(&mut self, hit: Hit) {
        insert(hit, &mut self.hits);
        if K > 0 && self.hits[K - 1].is_hit() {
            self.limit = self.hits[K - 1].t;
        }
    }
}

/// Up to K nearest hits, their number chosen at run time; none stands for any hit.
#[derive(Clone, Copy, Debug)]
pub struct UpTo<const K: usize> {
    /// The answer, misses at the end: the first `count`, or in `hits[0]` any.
    pub hits: [Hit; K],
    count: u32,
    limit: f32,
}

impl<const K: usize> UpTo<K> {
    /// Looks for this many hits up to `t_max`, at most K.
    #[inline(always)]
    #[must_use]
    pub fn new(count: u32, t_max: f32) -> Self {
        Self {
            hits: [Hit::MISS; K],
            count,
            limit: t_max,
        }
    }
}

impl<const K: usize> Collector for UpTo<K> {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline(always)]
    fn offer(&mut self, hit: Hit) {
        insert(hit, &mut self.hits);
        if self.count == 0 {
            self.limit = FINAL;
        } else {
            let last = (self.count - 1) as usize;
            if last < K && self.hits[last].is_hit() {
                self.limit = self.hits[last].t;
            }
        }
    }

    #[inline(always)]
    fn goes_farther_first(&self) -> bool {
        self.count == 0
    }
}

/// The new hit moves up, what it passes moves down, the last falls out.
#[inline(always)]
#[expect(
    clippy::needless_range_loop,
    reason = "iterators over local arrays do not compile to SPIR-V"
)]
fn insert<const K: usize>(hit: Hit, hits: &mut [Hit; K]) {
    let mut moving = hit;
    for i in 0..K {
        if precedes(&moving, &hits[i]) {
            moving = core::mem::replace(&mut hits[i], moving);
        }
    }
}

/// The order of hits: by t, then by the caller's index. A miss comes last.
#[inline(always)]
fn precedes(a: &Hit, b: &Hit) -> bool {
    a.t < b.t || (a.t == b.t && a.primitive < b.primitive)
}

/// A collector that also counts what the traversal touches.
#[derive(Clone, Copy, Debug)]
pub struct Counted<C> {
    /// The answer.
    pub inner: C,
    /// Inner nodes opened.
    pub node_count: u32,
    /// Boxes tested: the opened nodes' children.
    pub box_count: u32,
    /// Triangles tested.
    pub triangle_count: u32,
}

impl<C> Counted<C> {
    /// Counts from zero.
    #[inline(always)]
    #[must_use]
    pub fn new(inner: C) -> Self {
        Self {
            inner,
            node_count: 0,
            box_count: 0,
            triangle_count: 0,
        }
    }
}

impl<C: Collector> Collector for Counted<C> {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.inner.limit()
    }

    #[inline(always)]
    fn offer(&mut self, hit: Hit) {
        self.inner.offer(hit);
    }

    #[inline(always)]
    fn goes_farther_first(&self) -> bool {
        self.inner.goes_farther_first()
    }

    #[inline(always)]
    fn count_node(&mut self, children: u32) {
        self.node_count += 1;
        self.box_count += children;
    }

    #[inline(always)]
    fn count_triangle(&mut self) {
        self.triangle_count += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn offered<C: Collector>(collector: &mut C, hits: &[(f32, u32)]) {
        for &(t, primitive) in hits {
            if t <= collector.limit() {
                collector.offer(Hit {
                    t,
                    primitive,
                    ..Hit::MISS
                });
            }
        }
    }

    #[test]
    fn one_collector_asks_either_question() {
        let hits = [(5.0, 1), (3.0, 8), (3.0, 2), (4.0, 0), (9.0, 3)];
        let mut closest = ClosestOrAny::closest(7.0);
        offered(&mut closest, &hits);
        assert_eq!(
            (closest.closest.hit.t, closest.closest.hit.primitive),
            (3.0, 2)
        );
        let mut any = ClosestOrAny::any(7.0);
        offered(&mut any, &hits);
        assert_eq!(any.closest.hit.primitive, 1);
        let mut nearest = NearestHits::<3>::new(7.0);
        offered(&mut nearest, &hits);
        let answers: [(u32, &[u32]); 3] = [(0, &[1]), (1, &[2]), (3, &[2, 8, 0])];
        for (count, primitives) in answers {
            let mut up_to = UpTo::<3>::new(count, 7.0);
            offered(&mut up_to, &hits);
            let found = up_to.hits.map(|hit| hit.primitive);
            assert_eq!(found[..primitives.len()], *primitives, "{count}");
        }
        assert_eq!(nearest.hits.map(|hit| hit.primitive), [2, 8, 0]);
        let mut first = Counted::new(AnyHit::new(7.0));
        first.offer(any.closest.hit);
        assert_eq!([any.limit(), first.limit()], [FINAL; 2]);
        let mut none = ClosestOrAny::any(7.0);
        offered(&mut none, &hits[4..]);
        assert!(none.limit() == 7.0 && !none.closest.hit.is_hit());
    }
}
