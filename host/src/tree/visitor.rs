//! Visitors of a stored tree: code compiled once for each way to store nodes and triangles.

use super::lanes::{LANES, Numbers};
use super::packets::Packet;
use super::sources::{StoredNodes, StoredTriangles};
use super::stored::with_stacks;
use slimbvh_core::Hit;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    Bundle, ClosestOrAny, Collector, HitFilter, Lane, PreparedRays, trace_alone, traverse,
};

/// Called with the concrete sources of nodes and triangles: [`StoredTree::visit`](super::StoredTree::visit).
pub trait TreeVisitor {
    /// What a visit returns.
    type Output;

    /// Visits a tree with these nodes and triangles.
    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T)
    -> Self::Output;
}

// At most two references: they are passed in registers, and the compiler knows that they do not alias.

/// Traces one ray with the thread's own stack, for the closest hit or any, as its collector asks.
pub struct Alone<'a, F> {
    pub ray: &'a PreparedRay,
    pub lane: &'a mut Lane<F, ClosestOrAny>,
}

impl<F: HitFilter> TreeVisitor for Alone<'_, F> {
    type Output = ();

    #[inline(always)]
    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) {
        with_stacks(|stacks| {
            let stack = &mut N::stacks(stacks).alone;
            trace_alone(stack, nodes, triangles, self.ray, self.lane);
        });
    }
}

/// Traces packets of rays with the thread's own stacks, for the closest hit or any, as their collectors ask.
pub struct Together<'a, 'b> {
    pub rays: &'a mut Bundle<PreparedRays<Numbers, LANES>>,
    /// Packets, and how many of them count.
    pub packets: (&'a mut Bundle<Packet<'b>>, usize),
}

impl TreeVisitor for Together<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) {
        with_stacks(|stacks| {
            nodes.trace_packets(triangles, stacks, self.rays, self.packets);
        });
    }
}

/// Traces one ray for any collector, at the cost of a virtual call for each node. The stack is its own: the collector may use this
/// thread's.
pub struct Watched<'a, F> {
    pub ray: &'a PreparedRay,
    pub filter: &'a F,
    pub collector: &'a mut dyn Collector,
}

impl<F: HitFilter> TreeVisitor for Watched<'_, F> {
    type Output = ();

    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) {
        let collector = &mut Shared(self.collector);
        traverse(nodes, triangles, self.ray, self.filter, collector);
    }
}

/// A collector behind a reference.
pub struct Shared<'a>(pub &'a mut dyn Collector);

impl Collector for Shared<'_> {
    fn limit(&self) -> f32 {
        self.0.limit()
    }

    fn offer(&mut self, hit: Hit) {
        self.0.offer(hit);
    }

    fn goes_farther_first(&self) -> bool {
        self.0.goes_farther_first()
    }

    fn count_node(&mut self, children: u32) {
        self.0.count_node(children);
    }

    fn count_triangle(&mut self) {
        self.0.count_triangle();
    }
}
