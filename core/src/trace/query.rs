//! The walkers of a tree: one ray, or a packet of rays.

use super::{Collector, HitFilter, LeafSlot, NodeSource, TriangleSource};
use crate::geometry::planes::PlanePair;
use crate::geometry::ray::PreparedRay;
use crate::geometry::slab::slab;
use crate::geometry::watertight::intersect;

/// What rays that walk a tree decide on their way.
///
/// `E` is what the stack keeps of where they enter a node.
pub(super) trait Query<N: NodeSource, T: TriangleSource<N::Bounds>, E> {
    /// The order of their axes.
    fn axes(&self) -> [u32; 3];

    /// Whether any of them may hit anything.
    fn begin(&mut self) -> bool;

    /// Whether any of them enters a node no later than its limit.
    fn is_due(&mut self, enter: E) -> bool;

    /// Tests both boxes of an inner node.
    fn open(&mut self, planes: [PlanePair; 3]) -> Opened<E>;

    /// Goes to a child that is met.
    #[inline(always)]
    fn follow(&mut self, _: E) {}

    /// Tests a triangle.
    fn test(&mut self, triangles: &T, slot: &LeafSlot<N::Bounds>);

    /// Whether all answers are final.
    fn is_done(&self) -> bool;
}

/// An inner node's boxes, tested.
pub(super) struct Opened<E> {
    pub enter_left: E,
    pub enter_right: E,
    pub meets_left: bool,
    pub meets_right: bool,
    /// Which to walk first, if both are met.
    pub left_first: bool,
}

/// What the stack of a single ray keeps of where it enters a node.
pub trait Distance: Copy {
    /// The ray enters at this t.
    fn at(t: f32) -> Self;

    /// Whether that may be within a limit.
    fn is_within(self, limit: f32) -> bool;
}

impl Distance for f32 {
    #[inline(always)]
    fn at(t: f32) -> Self {
        t
    }

    #[inline(always)]
    fn is_within(self, limit: f32) -> bool {
        self <= limit
    }
}

/// It is not kept: a node may always be within the limit.
impl Distance for () {
    #[inline(always)]
    fn at(_: f32) {}

    #[inline(always)]
    fn is_within(self, _: f32) -> bool {
        true
    }
}

/// One ray.
pub(super) struct Single<'a, F, C> {
    pub ray: &'a PreparedRay,
    pub filter: &'a F,
    /// What its collector says ([`Collector::goes_farther_first`]).
    pub goes_farther_first: bool,
    pub collector: &'a mut C,
}

impl<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter, C: Collector, D: Distance>
    Query<N, T, D> for Single<'_, F, C>
{
    #[inline(always)]
    fn axes(&self) -> [u32; 3] {
        self.ray.axes
    }

    #[inline(always)]
    fn begin(&mut self) -> bool {
        self.ray.t_min <= self.ray.t_max
    }

    #[inline(always)]
    fn is_due(&mut self, enter: D) -> bool {
        enter.is_within(self.collector.limit())
    }

    #[inline(always)]
    fn open(&mut self, planes: [PlanePair; 3]) -> Opened<D> {
        self.collector.count_node();
        let boxes = slab(self.ray, planes, self.collector.limit());
        Opened {
            enter_left: D::at(boxes.enter_a),
            enter_right: D::at(boxes.enter_b),
            meets_left: boxes.meets_a,
            meets_right: boxes.meets_b,
            left_first: (boxes.enter_a <= boxes.enter_b) ^ self.goes_farther_first,
        }
    }

    #[inline(always)]
    fn test(&mut self, triangles: &T, slot: &LeafSlot<N::Bounds>) {
        self.collector.count_triangle();
        let primitive = triangles.primitive(slot);
        let corners = triangles.corners(slot, self.ray.axes);
        let hit = intersect(self.ray, corners, self.collector.limit(), primitive);
        if hit.is_hit() && self.filter.accepts(primitive, &corners, self.ray.axes) {
            self.collector.offer(hit);
        }
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.ray.t_min > self.collector.limit()
    }
}
