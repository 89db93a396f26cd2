//! Several rays that walk a tree together, on a CPU: what is read of it, and what is decided about it, is shared.
//!
//! Each ray's answer is the one that it would find alone, bit for bit: boxes and triangles are tested by the same arithmetic
//! ([`crate::geometry::lanes`]), and no answer depends on which other nodes are opened.

use super::prepare::PreparedRays;
use super::query::{ChildList, NOT_MET, Opened, Query, Rays, key};
use super::stack::{Empty, Enter};
use super::wide::WideFork;
use super::{
    Collector, Fork, HitFilter, LeafSlot, NodeSource, TriangleSource, traverse_with, walk,
};
use crate::build::wide::WIDTH;
use crate::geometry::lanes::{Lanes, Wide};
use crate::geometry::planes::{BoxSpan, PlanePair, Planes};
use crate::geometry::ray::{Hit, PreparedRay, RayLanes};
use crate::geometry::slab::{FourPlanes, crossings};
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
pub(super) fn limits<W: Wide<LANES>, F, C: Collector, const LANES: usize>(
    packet: &[Lane<F, C>; LANES],
) -> W {
    W::from_array(from_fn(|i| packet[i].collector.limit()))
}

/// Memory for a packet over nodes opened as `F`, and for rays that walk alone. It need not be cleared in between.
#[derive(Clone, Copy)]
pub struct PacketStacks<F: Fork, W: Lanes> {
    together: F::Stack<Entries<W>>,
    /// For one ray.
    pub alone: F::Stack<f32>,
}

impl<F: Fork, W: Lanes> PacketStacks<F, W> {
    /// Nothing waits.
    pub const EMPTY: Self = Self {
        together: Empty::EMPTY,
        alone: Empty::EMPTY,
    };
}

/// [`super::traverse_with`] of all rays of a packet: together, as far as the order of their axes is the same and they begin and go
/// side by side. One that is left over walks alone.
#[inline(always)]
pub fn trace_packet<N, T, F, C, W, const LANES: usize>(
    stacks: &mut PacketStacks<N::Node, W>,
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
    trace_others(&mut stacks.alone, nodes, triangles, rays, (packet, who));
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

/// [`trace_alone`] of all rays of a packet but these.
#[inline(always)]
pub(super) fn trace_others<N, T, F, C, W, const LANES: usize>(
    stack: &mut <N::Node as Fork>::Stack<f32>,
    nodes: &N,
    triangles: &T,
    rays: &mut PreparedRays<W, LANES>,
    (packet, who): (&mut [Lane<F, C>; LANES], u32),
) where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    F: HitFilter,
    C: Collector,
    W: Wide<LANES>,
{
    for (i, lane) in packet.iter_mut().enumerate() {
        if who >> i & 1 == 0 {
            trace_alone(stack, nodes, triangles, rays.alone(i), lane);
        }
    }
}

/// [`super::traverse_with`] of one ray, never part of its caller.
#[inline(never)]
pub fn trace_alone<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter, C: Collector>(
    stack: &mut <N::Node as Fork>::Stack<f32>,
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

    type Four = FourEntries<W>;
    const FOUR: FourEntries<W> = FourEntries {
        enter: [W::ZERO; WIDTH],
        who: [0; WIDTH],
    };

    #[inline(always)]
    fn of(four: &FourEntries<W>, child: u32) -> Self {
        let child = child as usize % WIDTH;
        Self {
            enter: four.enter[child],
            who: four.who[child],
        }
    }
}

/// [`Entries`] of a wide node's children.
#[derive(Clone, Copy, Debug)]
pub struct FourEntries<W> {
    enter: [W; WIDTH],
    who: [u32; WIDTH],
}

/// For each set of children, a bit each, the list of them as they are stored.
const LISTS: [ChildList; 1 << WIDTH] = {
    let mut lists = [ChildList::NONE; 1 << WIDTH];
    let mut set = 0;
    while set < lists.len() {
        let mut child = WIDTH as u32;
        while child > 0 {
            child -= 1;
            if set >> child & 1 == 1 {
                lists[set] = lists[set].after(child);
            }
        }
        set += 1;
    }
    lists
};

/// Where rays enter a box, and a bit for each that does no later than its limit.
#[inline(always)]
pub(super) fn box_entries<W: Wide<LANES>, const LANES: usize>(
    rays: &RayLanes<BoxSpan<W>>,
    limit: W,
    low: [f32; 3],
    high: [f32; 3],
) -> (W, u32) {
    let planes = from_fn(|i| BoxSpan::new(W::splat(low[i]), W::splat(high[i])));
    let crossing = crossings(planes, rays.plane_origins, rays.inverse);
    let enter = crossing.enter.low.most(rays.t_min);
    let meets = enter.at_most(crossing.padded_exit.low.least(limit));
    (enter, W::bits(meets))
}

/// Tests a triangle with those rays of a packet. Returns whether a hit was offered, after which limits may be others.
#[inline(always)]
pub(super) fn test_corners<F, C, W, const LANES: usize>(
    (rays, who, limit): (&PreparedRays<W, LANES>, u32, W),
    packet: &mut [Lane<F, C>; LANES],
    corners: &[[f32; 3]; 3],
    primitive: impl FnOnce() -> u32,
) -> bool
where
    F: HitFilter,
    C: Collector,
    W: Wide<LANES>,
{
    let Meeting { t, u, v, met } = meet(&rays.lanes, corners, limit);
    let who = who & W::bits(met);
    if who == 0 {
        return false;
    }
    let primitive = primitive();
    let (t, u, v) = (t.to_array(), u.to_array(), v.to_array());
    for i in each_of(who) {
        let i = i % LANES;
        let (t, u, v) = (t[i], u[i], v[i]);
        let hit = Hit { t, u, v, primitive };
        offer(&mut packet[i], (corners, rays.axes), hit);
    }
    true
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
pub(super) fn each_of(mut who: u32) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let next = (who != 0).then(|| who.trailing_zeros() as usize);
        who &= who.wrapping_sub(1);
        next
    })
}

impl<F, C, W: Wide<LANES>, const LANES: usize> Together<'_, F, C, W, LANES> {
    #[inline(always)]
    fn meet(&self, low: [f32; 3], high: [f32; 3]) -> Entries<W> {
        let (enter, met) = box_entries(&self.rays.lanes, self.limit, low, high);
        let who = self.who & met;
        Entries { enter, who }
    }
}

impl<F, C, W, const LANES: usize> Rays<Entries<W>> for Together<'_, F, C, W, LANES>
where
    F: HitFilter,
    C: Collector,
    W: Wide<LANES>,
{
    #[inline(always)]
    fn axes(&self) -> [u32; 3] {
        self.rays.axes
    }

    #[inline(always)]
    fn reversed(&self) -> [u32; 3] {
        [0; 3]
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
    fn open_wide<P: FourPlanes>(
        &mut self,
        node: &WideFork<P>,
        enters: &mut FourEntries<W>,
    ) -> ChildList {
        let [p, q, r] = node.first.map(FourPlanes::planes);
        let [u, v, w] = node.second.map(FourPlanes::planes);
        let met = [
            self.meet([p.x, q.x, r.x], [u.x, v.x, w.x]),
            self.meet([p.y, q.y, r.y], [u.y, v.y, w.y]),
            self.meet([p.z, q.z, r.z], [u.z, v.z, w.z]),
            self.meet([p.w, q.w, r.w], [u.w, v.w, w.w]),
        ];
        let there = p.cmple(u).bitmask();
        let who: [u32; WIDTH] = from_fn(|child| {
            if there >> child & 1 == 1 {
                met[child].who
            } else {
                0
            }
        });
        let any = who[0] | who[1] | who[2] | who[3];
        let mask = (who[0] != 0) as u32
            | ((who[1] != 0) as u32) << 1
            | ((who[2] != 0) as u32) << 2
            | ((who[3] != 0) as u32) << 3;
        if let Some(list) = ChildList::of_few(mask) {
            // No order is asked for.
            self.who = any;
            return list;
        }
        for (to, entries) in enters.enter.iter_mut().zip(&met) {
            *to = entries.enter;
        }
        enters.who = who;
        if self.goes_farther_first {
            let list = LISTS[mask as usize % LISTS.len()];
            self.who = enters.who[list.first() as usize % WIDTH];
            return list;
        }
        // The first ray that meets any of them decides about their order.
        let first = any.trailing_zeros() as usize % LANES;
        let mut keys = [NOT_MET; WIDTH];
        for (child, ((key_of, enter), who)) in
            (0..).zip(keys.iter_mut().zip(&enters.enter).zip(who))
        {
            let own = key(enter.lane(first), child, self.goes_farther_first);
            *key_of = if who != 0 { own } else { NOT_MET };
        }
        let list = ChildList::sorted(keys);
        self.who = enters.who[list.first() as usize % WIDTH];
        list
    }

    #[inline(always)]
    fn follow(&mut self, entries: Entries<W>) {
        self.who = entries.who;
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.members & W::bits(self.rays.lanes.t_min.at_most(self.limit)) == 0
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
    fn test(&mut self, triangles: &T, slot: &LeafSlot<N::Bounds>) {
        let corners = triangles.corners(slot, self.rays.axes);
        let asked = (self.rays, self.who, self.limit);
        let primitive = || triangles.primitive(slot);
        if test_corners(asked, self.packet, &corners, primitive) {
            self.limit = limits(self.packet);
        }
    }
}
