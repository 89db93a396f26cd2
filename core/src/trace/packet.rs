//! Several rays that walk a tree together, on a CPU: what is read of it, and what is decided about it, is shared.
//!
//! Each ray's answer is the one that it would find alone, bit for bit: boxes and triangles are tested by the same arithmetic
//! ([`crate::geometry::lanes`]), and no answer depends on which other nodes are opened.

use super::prepare::PreparedRays;
use super::query::{Opened, Query};
use super::stack::Enter;
use super::{
    Collector, Cursor, HitFilter, LeafSlot, NodeSource, Stack, TriangleSource, traverse_with, walk,
};
use crate::geometry::lanes::{Lanes, Wide};
use crate::geometry::planes::{BoxSpan, PlanePair, Planes};
use crate::geometry::ray::{Hit, PreparedRay};
use crate::geometry::slab::crossings;
use crate::geometry::watertight::{Meeting, meet};
use core::array::from_fn;

/// What a ray of a packet asks.
#[derive(Clone, Copy, Debug)]
pub struct Lane<F, C> {
    /// Which triangles count.
    pub filter: F,
    /// What is asked.
    pub collector: C,
}

/// The limits of all lanes.
#[inline(always)]
fn limits<W: Wide<LANES>, F, C: Collector, const LANES: usize>(packet: &[Lane<F, C>; LANES]) -> W {
    W::from_array(from_fn(|i| packet[i].collector.limit()))
}

/// Memory for a packet, and for rays that walk alone. It need not be cleared in between.
#[derive(Clone, Copy)]
pub struct PacketStacks<C: Cursor, W: Lanes> {
    together: Stack<C, Entries<W>>,
    /// For one ray.
    pub alone: Stack<C>,
}

impl<C: Cursor, W: Lanes> PacketStacks<C, W> {
    /// Nothing waits.
    pub const EMPTY: Self = Self {
        together: Stack::EMPTY,
        alone: Stack::EMPTY,
    };
}

/// [`super::traverse_with`] of all rays of a packet: together, as far as the order of their axes is the same and they begin and go
/// side by side. One that is left over walks alone.
#[inline(always)]
pub fn trace_packet<N, T, F, C, W, const LANES: usize>(
    stacks: &mut PacketStacks<N::Cursor, W>,
    nodes: &N,
    triangles: &T,
    rays: &mut PreparedRays<W, LANES>,
    packet: &mut [Lane<F, C>; LANES],
) where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    F: HitFilter,
    C: Collector,
    W: Wide<LANES>,
{
    let who = if rays.members.count_ones() > 1 {
        rays.members
    } else {
        0
    };
    for (i, lane) in packet.iter_mut().enumerate() {
        if who >> i & 1 == 0 {
            trace_alone(&mut stacks.alone, nodes, triangles, rays.alone(i), lane);
        }
    }
    if who == 0 {
        return;
    }
    let query = Together {
        limit: limits(packet),
        // All of a packet ask the same, as a rule; which is asked decides nothing but the time.
        goes_farther_first: packet
            .first()
            .is_some_and(|lane| lane.collector.goes_farther_first()),
        rays,
        packet,
        members: who,
        who,
    };
    walk(&mut stacks.together, nodes, triangles, query);
}

/// [`super::traverse_with`] of one ray, never part of its caller.
#[inline(never)]
pub fn trace_alone<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter, C: Collector>(
    stack: &mut Stack<N::Cursor>,
    nodes: &N,
    triangles: &T,
    ray: &PreparedRay,
    lane: &mut Lane<F, C>,
) {
    traverse_with(
        stack,
        nodes,
        triangles,
        ray,
        &lane.filter,
        &mut lane.collector,
    );
}

/// Offers a hit, if it counts: never part of the walk.
#[inline(never)]
fn offer<F: HitFilter, C: Collector>(
    lane: &mut Lane<F, C>,
    (corners, axes): (&[[f32; 3]; 3], [u32; 3]),
    hit: Hit,
) {
    if lane.filter.accepts(hit.primitive, corners, axes) {
        lane.collector.offer(hit);
    }
}

/// Where rays of a packet enter a node, and which of them do.
#[derive(Clone, Copy, Debug)]
pub struct Entries<W> {
    enter: W,
    /// A bit a ray.
    who: u32,
}

impl<W: Lanes> Enter for Entries<W> {
    const ZERO: Self = Self {
        enter: W::ZERO,
        who: 0,
    };
}

/// Rays that walk together.
struct Together<'a, F, C, W: Wide<LANES>, const LANES: usize> {
    rays: &'a PreparedRays<W, LANES>,
    packet: &'a mut [Lane<F, C>; LANES],
    /// Below everything for rays that want nothing more.
    limit: W,
    /// Whether the first of them goes to the farther of two children first.
    goes_farther_first: bool,
    /// A bit for each ray that walks along.
    members: u32,
    /// Those that meet the node that is walked to.
    who: u32,
}

/// The numbers of the bits in a mask.
#[inline(always)]
fn each_of(mut who: u32) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let next = (who != 0).then(|| who.trailing_zeros() as usize);
        who &= who.wrapping_sub(1);
        next
    })
}

impl<F, C, W: Wide<LANES>, const LANES: usize> Together<'_, F, C, W, LANES> {
    #[inline(always)]
    fn meet(&self, low: [f32; 3], high: [f32; 3]) -> Entries<W> {
        let rays = &self.rays.lanes;
        let planes = from_fn(|i| BoxSpan::new(W::splat(low[i]), W::splat(high[i])));
        let crossing = crossings(planes, rays.plane_origins, rays.inverse);
        let enter = crossing.enter.low.most(rays.t_min);
        let meets = enter.at_most(crossing.padded_exit.low.least(self.limit));
        let who = self.who & W::bits(meets);
        Entries { enter, who }
    }
}

impl<N, T, F, C, W, const LANES: usize> Query<N, T, Entries<W>> for Together<'_, F, C, W, LANES>
where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    F: HitFilter,
    C: Collector,
    W: Wide<LANES>,
{
    #[inline(always)]
    fn axes(&self) -> [u32; 3] {
        self.rays.axes
    }

    #[inline(always)]
    fn begin(&mut self) -> bool {
        self.who = self.members;
        self.who != 0
    }

    #[inline(always)]
    fn is_due(&mut self, entries: Entries<W>) -> bool {
        self.who = entries.who & W::bits(entries.enter.at_most(self.limit));
        self.who != 0
    }

    #[inline(always)]
    fn open(&mut self, planes: [PlanePair; 3]) -> Opened<Entries<W>> {
        let [p, q, r] = planes;
        let left = self.meet([p.x, q.x, r.x], [p.z, q.z, r.z]);
        let right = self.meet([p.y, q.y, r.y], [p.w, q.w, r.w]);
        // The first ray that meets both decides; where none does, left goes first.
        let both = left.who & right.who;
        let first = both & both.wrapping_neg();
        Opened {
            meets_left: left.who != 0,
            meets_right: right.who != 0,
            left_first: (W::bits(left.enter.at_most(right.enter)) & first == first)
                ^ self.goes_farther_first,
            enter_left: left,
            enter_right: right,
        }
    }

    #[inline(always)]
    fn follow(&mut self, entries: Entries<W>) {
        self.who = entries.who;
    }

    #[inline(always)]
    fn test(&mut self, triangles: &T, slot: &LeafSlot<N::Bounds>) {
        let axes = self.rays.axes;
        let corners = triangles.corners(slot, axes);
        let Meeting { t, u, v, met } = meet(&self.rays.lanes, &corners, self.limit);
        let who = self.who & W::bits(met);
        if who != 0 {
            let primitive = triangles.primitive(slot);
            let (t, u, v) = (t.to_array(), u.to_array(), v.to_array());
            for i in each_of(who) {
                let i = i % LANES;
                let (t, u, v) = (t[i], u[i], v[i]);
                offer(
                    &mut self.packet[i],
                    (&corners, axes),
                    Hit { t, u, v, primitive },
                );
            }
            self.limit = limits(self.packet);
        }
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.members & W::bits(self.rays.lanes.t_min.at_most(self.limit)) == 0
    }
}
