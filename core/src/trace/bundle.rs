//! Packets of rays that walk a wide tree together, on a CPU: a node is read and decoded once for all of them.
//!
//! An interval over all rays tests a node's children at once ([`RayInterval`]). A child that it meets is tested by the packets
//! one after the other, until one enters it; the rest go along untested (Wald, Ize and Parker 2008, "Fast, Parallel, and
//! Asynchronous Construction of BVHs for Ray Tracing Animated Scenes"; Overbeck, Ramamoorthi and Mark 2008, "Large Ray Packets
//! for Real-time Whitted Ray Tracing"). A leaf is tested by all packets, and its triangles by those that enter it.
//!
//! Each ray's answer is the one that it would find alone, bit for bit: triangles have the last word, whichever nodes are opened.

use super::interval::{RayExtremes, RayInterval};
use super::packet::{PacketStacks, box_entries, each_of, limits, test_corners, trace_others};
use super::prepare::PreparedRays;
use super::query::{ChildList, NOT_MET, key};
use super::wide::{WideFork, WideRef};
use super::{
    Collector, Fork, HitFilter, Lane, LeafSlot, NodeSource, Order, STACK_SIZE, TriangleSource,
    trace_packet,
};
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use crate::geometry::lanes::Wide;
use crate::geometry::slab::FourPlanes;
use core::array::from_fn;

/// Packets in a bundle.
pub const PACKETS: usize = 8;

/// One for each packet of a bundle.
pub type Bundle<T> = [T; PACKETS];

/// Children that may wait: all but one of each node on a path.
const ROWS: usize = (WIDTH - 1) * STACK_SIZE;

/// A child that waits.
#[derive(Clone, Copy, Debug)]
struct Child {
    name: WideRef,
    /// No ray enters it earlier.
    enter: f32,
    /// A bit for each packet that may enter it.
    packets: u32,
    /// Its box, in the order of the rays' axes.
    low: [f32; 3],
    high: [f32; 3],
}

impl Child {
    const NONE: Self = Self {
        name: WideRef(0),
        enter: 0.0,
        packets: 0,
        low: [0.0; 3],
        high: [0.0; 3],
    };
}

/// Memory for children that wait. It need not be cleared in between.
#[derive(Clone, Copy, Debug)]
pub struct BundleStack([Child; ROWS]);

impl BundleStack {
    /// Nothing waits.
    pub const EMPTY: Self = Self([Child::NONE; ROWS]);
}

/// [`trace_packet`] of all packets: together, as far as the order of their axes is the same and they begin and go side by side.
#[inline(always)]
pub fn trace_bundle<N, P, T, F, C, W, const LANES: usize>(
    (stack, stacks): (&mut BundleStack, &mut PacketStacks<N::Node, W>),
    nodes: &N,
    triangles: &T,
    rays: &mut Bundle<PreparedRays<W, LANES>>,
    (packets, count): (&mut Bundle<[Lane<F, C>; LANES]>, usize),
) where
    N: NodeSource<Node = WideFork<P>, Cursor = NodeRef>,
    P: FourPlanes,
    T: TriangleSource<N::Bounds>,
    F: HitFilter,
    C: Collector,
    W: Wide<LANES>,
{
    let joined = PreparedRays::side_by_side(rays, count);
    let all = rays.iter_mut().zip(packets.iter_mut()).take(count);
    for (k, (rays, packet)) in all.enumerate() {
        if joined >> k & 1 == 0 {
            trace_packet(stacks, nodes, triangles, rays, packet);
        } else {
            let who = rays.members;
            trace_others(&mut stacks.alone, nodes, triangles, rays, (packet, who));
        }
    }
    if joined == 0 {
        return;
    }
    let first = joined.trailing_zeros() as usize % PACKETS;
    let mut walk = Walk {
        axes: rays[first].axes.map(|axis| axis & 3),
        goes_farther_first: (packets[first].first())
            .is_some_and(|lane| lane.collector.goes_farther_first()),
        limits: packets.each_ref().map(|packet| limits(packet)),
        rays,
        packets,
        ends: [f32::MIN; PACKETS],
        active: joined,
        stack: &mut stack.0,
        waiting: 0,
    };
    walk.run(nodes, triangles);
}

/// Packets that walk together.
struct Walk<'a, F, C, W: Wide<LANES>, const LANES: usize> {
    rays: &'a Bundle<PreparedRays<W, LANES>>,
    packets: &'a mut Bundle<[Lane<F, C>; LANES]>,
    /// The limits of all lanes.
    limits: Bundle<W>,
    /// The largest limit of each packet's rays that are not done.
    ends: Bundle<f32>,
    /// A bit for each packet with rays that are not done.
    active: u32,
    axes: [u32; 3],
    goes_farther_first: bool,
    stack: &'a mut [Child; ROWS],
    waiting: usize,
}

impl<F: HitFilter, C: Collector, W: Wide<LANES>, const LANES: usize> Walk<'_, F, C, W, LANES> {
    #[inline(always)]
    fn run<N, P, T>(&mut self, nodes: &N, triangles: &T)
    where
        N: NodeSource<Node = WideFork<P>, Cursor = NodeRef>,
        P: FourPlanes,
        T: TriangleSource<N::Bounds>,
    {
        for k in each_of(self.active) {
            self.find_end(k);
        }
        let mut cursor = nodes.root(self.axes);
        if N::TESTS_ROOT {
            let [p, q, r] = nodes.root_planes(self.axes);
            let [low, high] = [[p.x, q.x, r.x], [p.z, q.z, r.z]];
            self.active = self.entering(self.active, low, high);
        }
        let order = Order::of(self.axes);
        let mut packets = self.active;
        if !nodes.is_leaf(cursor) {
            // Packets that miss the root's box or all of its children's go no further.
            let all = self.boxes(&nodes.children(cursor, order));
            let (low, high) = all.whole();
            let near = self.entering(self.active, low, high);
            let there = (0..WIDTH).filter(|child| all.is_there(*child));
            let active = there.fold(0, |packets, child| {
                let (low, high) = all.of(child);
                packets | self.entering(near & !packets, low, high)
            });
            (self.active, packets) = (active, active);
        }
        if self.active == 0 {
            return;
        }
        let interval = self.interval();
        let mut steps = nodes.step_limit();
        loop {
            if nodes.is_leaf(cursor) {
                self.test(nodes, triangles, cursor, packets);
            } else {
                let node = nodes.children(cursor, order);
                self.open(&node, &interval, packets);
                steps = steps.wrapping_sub(1);
            }
            let Some((next, entering)) = self.take(nodes) else {
                return;
            };
            (cursor, packets) = (next, entering);
            if steps == 0 {
                return;
            }
        }
    }

    fn interval(&self) -> RayInterval {
        let of = |k: usize| {
            let rays = &self.rays[k % PACKETS];
            RayExtremes::of(&rays.lanes, rays.members)
        };
        let mut packets = each_of(self.active);
        let first = of(packets.next().unwrap_or(0));
        packets.fold(first, |all, k| all.with(&of(k))).interval()
    }

    /// The boxes of a node's children.
    #[inline(always)]
    fn boxes<P: FourPlanes>(&self, node: &WideFork<P>) -> Boxes {
        Boxes {
            low: node.first.map(|planes| planes.planes().to_array()),
            high: node.second.map(|planes| planes.planes().to_array()),
        }
    }

    /// Whether a ray of a packet enters a box.
    #[inline(always)]
    fn enters(&self, k: usize, low: [f32; 3], high: [f32; 3]) -> bool {
        let k = k % PACKETS;
        let (rays, limit) = (&self.rays[k], self.limits[k]);
        let (_, met) = box_entries(&rays.lanes, limit, low, high);
        rays.members & met != 0
    }

    /// Which of some packets enter a box.
    #[inline(always)]
    fn entering(&self, packets: u32, low: [f32; 3], high: [f32; 3]) -> u32 {
        each_of(packets).fold(0, |found, k| {
            found | u32::from(self.enters(k, low, high)) << k
        })
    }

    /// Opens a node: its children that the interval meets wait.
    #[inline(always)]
    fn open<P: FourPlanes>(&mut self, node: &WideFork<P>, interval: &RayInterval, packets: u32) {
        let limit = self
            .ends
            .iter()
            .fold(f32::MIN, |a, &b| if a > b { a } else { b });
        let (met, enters) = interval.meet(node, limit);
        if met == 0 {
            return;
        }
        let enters = enters.to_array();
        let boxes = self.boxes(node);
        let mut list = ChildList::of_few(met).unwrap_or_else(|| {
            let keys = from_fn(|child| {
                let own = match self.goes_farther_first {
                    true => 1 << 2 | child as u32,
                    false => key(enters[child], child as u32, false),
                };
                if met >> child & 1 == 1 { own } else { NOT_MET }
            });
            ChildList::sorted(keys)
        });
        // The first child waits on top.
        let count = met.count_ones() as usize;
        for place in (0..count.min(WIDTH)).rev() {
            let child = list.first() as usize % WIDTH;
            list = list.rest();
            let (low, high) = boxes.of(child);
            self.stack[(self.waiting + place) % ROWS] = Child {
                name: WideRef::new(node.node, child as u32),
                enter: enters[child],
                packets,
                low,
                high,
            };
        }
        self.waiting += count;
    }

    /// The next child that packets enter, and which do: of an inner node all from the first on.
    #[inline(always)]
    fn take<N>(&mut self, nodes: &N) -> Option<(NodeRef, u32)>
    where
        N: NodeSource<Cursor = NodeRef>,
        N::Node: Fork<Waiting = WideRef>,
    {
        while self.waiting > 0 {
            self.waiting -= 1;
            let child = self.stack[self.waiting % ROWS];
            let mut due = 0;
            for (k, &end) in self.ends.iter().enumerate() {
                due |= u32::from(child.enter <= end) << k;
            }
            let packets = child.packets & self.active & due;
            if packets == 0 {
                continue;
            }
            let cursor = nodes.resume(child.name);
            let entering = if nodes.is_leaf(cursor) {
                self.entering(packets, child.low, child.high)
            } else {
                let first = each_of(packets).find(|k| self.enters(*k, child.low, child.high));
                first.map_or(0, |k| packets & u32::MAX << k)
            };
            if entering != 0 {
                return Some((cursor, entering));
            }
        }
        None
    }

    /// Tests a leaf's triangles.
    #[inline(always)]
    fn test<N, T>(&mut self, nodes: &N, triangles: &T, leaf: NodeRef, packets: u32)
    where
        N: NodeSource<Cursor = NodeRef>,
        T: TriangleSource<N::Bounds>,
    {
        let run = nodes.leaf(leaf, self.axes);
        let mut changed = 0;
        for number in 0..run.count {
            let slot = LeafSlot {
                first: run.first,
                number,
                count: run.count,
                bounds: run.bounds,
            };
            let corners = triangles.corners(&slot, self.axes);
            for k in each_of(packets) {
                let k = k % PACKETS;
                let (rays, packet) = (&self.rays[k], &mut self.packets[k]);
                let asked = (rays, rays.members, self.limits[k]);
                let primitive = || triangles.primitive(&slot);
                if test_corners(asked, packet, &corners, primitive) {
                    self.limits[k] = limits(packet);
                    changed |= 1 << k;
                }
            }
        }
        for k in each_of(changed) {
            self.find_end(k);
        }
    }

    /// Finds the largest limit of a packet's rays, and whether they are done.
    fn find_end(&mut self, k: usize) {
        let k = k % PACKETS;
        let rays = &self.rays[k];
        let open = rays.members & W::bits(rays.lanes.t_min.at_most(self.limits[k]));
        let limits = self.limits[k].to_array();
        self.ends[k] = each_of(open).fold(f32::MIN, |end, i| {
            let limit = limits[i % LANES];
            if limit > end { limit } else { end }
        });
        if open == 0 {
            self.active &= !(1 << k);
        }
    }
}

/// The planes of a wide node's boxes by axis and child.
struct Boxes {
    low: [[f32; WIDTH]; 3],
    high: [[f32; WIDTH]; 3],
}

impl Boxes {
    #[inline(always)]
    fn of(&self, child: usize) -> ([f32; 3], [f32; 3]) {
        let child = child % WIDTH;
        let ([a, b, c], [d, e, f]) = (self.low, self.high);
        (
            [a[child], b[child], c[child]],
            [d[child], e[child], f[child]],
        )
    }

    /// The box of all children.
    #[inline(always)]
    fn whole(&self) -> ([f32; 3], [f32; 3]) {
        let (mut low, mut high) = ([f32::MAX; 3], [f32::MIN; 3]);
        for child in (0..WIDTH).filter(|child| self.is_there(*child)) {
            let (a, b) = self.of(child);
            for axis in 0..3 {
                low[axis] = low[axis].min(a[axis]);
                high[axis] = high[axis].max(b[axis]);
            }
        }
        (low, high)
    }

    /// A lane without a child has its planes exchanged.
    #[inline(always)]
    fn is_there(&self, child: usize) -> bool {
        let child = child % WIDTH;
        self.low[0][child] <= self.high[0][child]
    }
}
