//! Several rays that walk a tree together, on a CPU: what is read of it, and what is decided about it, is shared.
//!
//! Each ray's answer is the one that it would find alone, bit for bit: boxes and triangles are tested by the same arithmetic
//! ([`crate::lanes`]), and no answer depends on which other nodes are opened.

use super::query::{Opened, Query, Single};
use super::stack::Enter;
use super::{Collector, Cursor, NodeSource, Place, Rule, Stack, TriangleSource, walk};
use crate::lanes::Wide;
use crate::ray::{Hit, PreparedRay, RayLanes};
use crate::slab::{BoxSpan, PlanePair, Planes, crossings};
use crate::watertight::{Meeting, meet};
use core::array::from_fn;

/// With no more rays than this below a node, each goes on alone. Measured against 2: ARCHITECTURE.md.
const FEW: u32 = 1;

/// Rays whose origins or directions are farther from the first one's, on any axis, walk alone. In the scene's magnitude, whose largest
/// coordinate is at most 1, and in that of directions, whose largest component is at most 2.
const APART: f32 = 1.0 / 16.0;

/// A ray of a packet.
#[derive(Clone, Copy, Debug)]
pub struct Lane<R, C> {
    /// In the scene's magnitude.
    pub ray: PreparedRay,
    /// Which triangles count.
    pub rule: R,
    /// What is asked.
    pub collector: C,
}

impl<R, C: Collector> Lane<R, C> {
    /// The limit, below everything where nothing is left to ask.
    #[inline(always)]
    fn limit(&self) -> f32 {
        if self.collector.is_done() {
            f32::NEG_INFINITY
        } else {
            self.collector.limit()
        }
    }
}

/// The limits of all lanes.
#[inline(always)]
fn limits<W: From<[f32; LANES]>, R, C: Collector, const LANES: usize>(
    packet: &[Lane<R, C>; LANES],
) -> W {
    from_fn(|i| packet[i].limit()).into()
}

/// Memory for a packet, and for rays that leave it. It need not be cleared in between.
#[derive(Clone, Copy)]
pub struct PacketStacks<C: Cursor, W: Wide> {
    together: Stack<C, Entries<W>>,
    /// For one ray.
    pub alone: Stack<C>,
}

impl<C: Cursor, W: Wide> PacketStacks<C, W> {
    /// Nothing waits.
    pub const EMPTY: Self = Self {
        together: Stack::EMPTY,
        alone: Stack::EMPTY,
    };
}

/// [`super::traverse_with`] of all rays of a packet: together, as far as the order of their axes is the same and while they pass the same nodes.
#[inline(always)]
pub fn trace_packet<N, T, R, C, W, const LANES: usize>(
    stacks: &mut PacketStacks<N::Cursor, W>,
    nodes: &N,
    triangles: &T,
    packet: &mut [Lane<R, C>; LANES],
) where
    N: NodeSource,
    T: TriangleSource<N::Frame>,
    R: Rule,
    C: Collector,
    W: Wide + From<[f32; LANES]> + Into<[f32; LANES]>,
{
    const { assert!(LANES <= 32, "a mask has 32 bits") };
    let mut first = None;
    for lane in packet.iter() {
        if first.is_none() && lane.ray.t_min <= lane.ray.t_max {
            first = Some(lane.ray);
        }
    }
    let Some(first) = first else {
        return;
    };
    let of_each = |numbers: fn(&PreparedRay) -> &[f32; 3]| {
        from_fn(|axis| from_fn(|i| numbers(&packet[i].ray)[axis]).into())
    };
    let rays = RayLanes {
        origin: of_each(|ray| &ray.origin),
        direction: of_each(|ray| &ray.direction),
        plane_origins: from_fn(|axis| BoxSpan {
            low: from_fn(|i| packet[i].ray.plane_origins[axis].x).into(),
            high: from_fn(|i| packet[i].ray.plane_origins[axis].z).into(),
        }),
        inverse: of_each(|ray| &ray.inverse),
        t_min: from_fn(|i| packet[i].ray.t_min).into(),
    };
    let mut who = near(&first.origin, &rays.origin) & near(&first.direction, &rays.direction);
    for (i, lane) in packet.iter().enumerate() {
        if lane.ray.axes != first.axes || lane.ray.t_min > lane.ray.t_max {
            who &= !(1 << i);
        }
    }
    if who.count_ones() <= FEW {
        who = 0;
    }
    for (i, lane) in packet.iter_mut().enumerate() {
        if who >> i & 1 == 0 {
            trace_alone(&mut stacks.alone, nodes, triangles, lane);
        }
    }
    if who == 0 {
        return;
    }
    let limit = limits(packet);
    let mut steps = nodes.step_limit();
    let mut query = Together {
        packet,
        // In a sound tree each passes every node once at most.
        steps_alone: steps.saturating_mul(LANES as u32),
        alone: &mut stacks.alone,
        axes: first.axes,
        rays,
        limit,
        members: who,
        who,
    };
    walk(
        &mut stacks.together,
        nodes,
        triangles,
        nodes.root(first.axes),
        &mut query,
        &mut steps,
    );
}

/// Which lanes are so near to a vector, on all axes, that they are expected to pass the same nodes.
#[inline(always)]
fn near<W: Wide>(vector: &[f32; 3], lanes: &[W; 3]) -> u32 {
    let mut who = u32::MAX;
    for axis in 0..3 {
        let off = lanes[axis] - W::splat(vector[axis]);
        who &= W::bits(off.abs().at_most(W::splat(APART)));
    }
    who
}

/// [`super::traverse_with`] of one ray, never part of its caller.
#[inline(always)]
pub fn trace_alone<N: NodeSource, T: TriangleSource<N::Frame>, R: Rule, C: Collector>(
    stack: &mut Stack<N::Cursor>,
    nodes: &N,
    triangles: &T,
    lane: &mut Lane<R, C>,
) {
    let root = nodes.root(lane.ray.axes);
    go_alone(stack, nodes, triangles, root, lane, &mut nodes.step_limit());
}

/// Walks the tree below a node with one ray.
#[inline(never)]
fn go_alone<N: NodeSource, T: TriangleSource<N::Frame>, R: Rule, C: Collector>(
    stack: &mut Stack<N::Cursor>,
    nodes: &N,
    triangles: &T,
    root: N::Cursor,
    lane: &mut Lane<R, C>,
    steps: &mut u32,
) {
    let mut query = Single {
        ray: &lane.ray,
        rule: &lane.rule,
        collector: &mut lane.collector,
    };
    walk(stack, nodes, triangles, root, &mut query, steps);
}

/// Offers a hit, if it counts: never part of the walk.
#[inline(never)]
fn offer<R: Rule, C: Collector>(lane: &mut Lane<R, C>, corners: &[[f32; 3]; 3], hit: Hit) {
    if lane.rule.counts(hit.primitive, corners, lane.ray.axes) {
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

impl<W: Wide> Enter for Entries<W> {
    const ZERO: Self = Self {
        enter: W::ZERO,
        who: 0,
    };
}

/// Rays whose axes have the same order.
struct Together<'a, R, C, U: Cursor, W: Wide, const LANES: usize> {
    packet: &'a mut [Lane<R, C>; LANES],
    alone: &'a mut Stack<U>,
    /// What is left of the steps of all rays that go on alone.
    steps_alone: u32,
    axes: [u32; 3],
    rays: RayLanes<BoxSpan<W>>,
    /// Below everything for rays that want nothing more.
    limit: W,
    /// A bit for each ray that walks along.
    members: u32,
    /// Those that meet the node that is walked to.
    who: u32,
}

impl<R, C, U, W, const LANES: usize> Together<'_, R, C, U, W, LANES>
where
    C: Collector,
    U: Cursor,
    W: Wide + From<[f32; LANES]> + Into<[f32; LANES]>,
{
    #[inline(always)]
    fn meet(&self, low: [f32; 3], high: [f32; 3]) -> Entries<W> {
        let [x, y, z] = from_fn(|axis| BoxSpan::of_box(low[axis], high[axis]));
        let crossing = crossings([x, y, z], self.rays.plane_origins, self.rays.inverse);
        let enter = crossing.enter.low.max(self.rays.t_min);
        let meets = enter.at_most(crossing.padded_exit.low.min(self.limit));
        let who = self.who & W::bits(meets);
        Entries { enter, who }
    }

    /// Calls for each of these rays.
    #[inline(always)]
    fn for_each(
        &mut self,
        who: u32,
        mut call: impl FnMut(usize, &mut Lane<R, C>, &mut Stack<U>, &mut u32),
    ) {
        let mut left = who;
        while left != 0 {
            let next = left.trailing_zeros() as usize;
            left &= left - 1;
            if let Some(lane) = self.packet.get_mut(next) {
                call(next, lane, self.alone, &mut self.steps_alone);
            }
        }
        self.limit = limits(self.packet);
    }
}

impl<N, T, R, C, W, const LANES: usize> Query<N, T> for Together<'_, R, C, N::Cursor, W, LANES>
where
    N: NodeSource,
    T: TriangleSource<N::Frame>,
    R: Rule,
    C: Collector,
    W: Wide + From<[f32; LANES]> + Into<[f32; LANES]>,
{
    type Enter = Entries<W>;

    #[inline(always)]
    fn axes(&self) -> [u32; 3] {
        self.axes
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
            left_first: W::bits(left.enter.at_most(right.enter)) & first == first,
            enter_left: left,
            enter_right: right,
        }
    }

    #[inline(always)]
    fn follow(&mut self, entries: Entries<W>) {
        self.who = entries.who;
    }

    #[inline(always)]
    fn test(&mut self, triangles: &T, place: &Place<N::Frame>) {
        let corners = triangles.corners(place, self.axes);
        let Meeting { t, u, v, met } = meet(&self.rays, &corners, self.limit);
        let who = self.who & W::bits(met);
        if who != 0 {
            let primitive = triangles.primitive(place);
            let (t, u, v): ([f32; LANES], [f32; LANES], [f32; LANES]) =
                (t.into(), u.into(), v.into());
            self.for_each(who, |i, lane, _, _| {
                let (t, u, v) = (t[i], u[i], v[i]);
                offer(lane, &corners, Hit { t, u, v, primitive });
            });
        }
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.members & W::bits(self.rays.t_min.at_most(self.limit)) == 0
    }

    #[inline(always)]
    fn divide(&mut self, nodes: &N, triangles: &T, cursor: N::Cursor) -> bool {
        let is_few = self.who.count_ones() <= FEW;
        if is_few {
            let who = self.who;
            self.for_each(who, |_, lane, stack, steps| {
                go_alone(stack, nodes, triangles, cursor, lane, steps);
            });
        }
        is_few
    }
}
