//! The walkers of a tree: one ray, or a packet of rays.

use super::stack::Enter;
use super::wide::WideFork;
use super::{Collector, HitFilter, LeafSlot, NodeSource, TriangleSource};
use crate::build::wide::WIDTH;
use crate::geometry::planes::PlanePair;
use crate::geometry::ray::PreparedRay;
use crate::geometry::slab::{FourPlanes, slab, slab_of_four};
use crate::geometry::watertight::intersect;
use glam::Vec4;

/// What rays that walk a tree decide about boxes.
///
/// `E` is what the stack keeps of where they enter a node.
pub trait Rays<E: Enter> {
    /// The order of their axes.
    fn axes(&self) -> [u32; 3];

    /// For each axis in that order 1 where they go backwards, so that they meet the upper plane of a box first. 0 on all axes of
    /// several rays: these look at both planes.
    fn reversed(&self) -> [u32; 3];

    /// Whether any of them may hit anything.
    fn begin(&mut self) -> bool;

    /// Whether any of them enters a node no later than its limit.
    fn is_due(&mut self, enter: E) -> bool;

    /// An inner node with this many children is opened.
    #[inline(always)]
    fn count_node(&mut self, _: u32) {}

    /// Tests two boxes, as a rule both of an inner node.
    fn open(&mut self, planes: [PlanePair; 3]) -> Opened<E>;

    /// Tests the boxes of a wide node, and goes to the first child that is met. Where several are met, sets where they are entered.
    fn open_wide<P: FourPlanes>(&mut self, node: &WideFork<P>, enters: &mut E::Four) -> ChildList;

    /// Goes to a child that is met.
    #[inline(always)]
    fn follow(&mut self, _: E) {}

    /// Whether all answers are final.
    fn is_done(&self) -> bool;
}

/// What rays that walk a tree decide about triangles, too.
pub trait Query<N: NodeSource, T: TriangleSource<N::Bounds>, E: Enter>: Rays<E> {
    /// Tests a triangle.
    fn test(&mut self, triangles: &T, slot: &LeafSlot<N::Bounds>);
}

/// An inner node's boxes, tested.
pub struct Opened<E> {
    pub enter_left: E,
    pub enter_right: E,
    pub meets_left: bool,
    pub meets_right: bool,
    /// Which to walk first, if both are met.
    pub left_first: bool,
}

/// Up to four children of a wide node in the order in which they are walked to: three bits each, the first child's lowest, its
/// number below a bit that is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChildList(pub u32);

impl ChildList {
    /// Bits of all.
    pub const BITS: u32 = WIDTH as u32 * KEY_BITS;

    /// No child.
    pub const NONE: Self = Self(0);

    /// One child.
    #[inline(always)]
    pub const fn one(child: u32) -> Self {
        Self(1 << (KEY_BITS - 1) | child)
    }

    /// The children that are met, a bit each, if they are fewer than two.
    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    pub const fn of_few(met: u32) -> Option<Self> {
        if met & met.wrapping_sub(1) != 0 {
            None
        } else if met == 0 {
            Some(Self::NONE)
        } else {
            Some(Self::one(met.trailing_zeros()))
        }
    }

    /// The children that are met, by the keys of all: the smallest first.
    #[inline(always)]
    pub fn sorted([a, b, c, d]: [u32; WIDTH]) -> Self {
        let pair = |a: u32, b: u32| if a < b { (a, b) } else { (b, a) };
        let (a, b) = pair(a, b);
        let (c, d) = pair(c, d);
        let (a, c) = pair(a, c);
        let (b, d) = pair(b, d);
        let (b, c) = pair(b, c);
        let named = |key: u32| key & ((1 << KEY_BITS) - 1);
        let (low, high) = (
            named(a) | named(b) << KEY_BITS,
            named(c) | named(d) << KEY_BITS,
        );
        Self(low | high << (2 * KEY_BITS))
    }

    /// The same after another child.
    #[inline(always)]
    pub const fn after(self, child: u32) -> Self {
        Self(self.0 << KEY_BITS | Self::one(child).0)
    }

    /// The first child's number.
    #[inline(always)]
    pub const fn first(self) -> u32 {
        self.0 & 3
    }

    /// The others.
    #[inline(always)]
    pub const fn rest(self) -> Self {
        Self(self.0 >> KEY_BITS)
    }
}

/// Bits of a key that name a child.
const KEY_BITS: u32 = 3;

/// The key of a child that is not met: its last bits name none.
pub const NOT_MET: u32 = u32::MAX << KEY_BITS;

/// The key of a child that is met: children that are entered earlier come first, or last.
#[inline(always)]
pub fn key(enter: f32, child: u32, is_farther_first: bool) -> u32 {
    // Bits of numbers that are not negative compare as the numbers do. The sign is dropped, so that no key is as large as that of
    // a child that is not met: where a ray reaches behind its origin, the order is another one, which decides nothing but the time.
    let flip = if is_farther_first { NOT_MET } else { 0 };
    ((enter.to_bits() ^ flip) & (NOT_MET >> 1 & NOT_MET)) | 1 << (KEY_BITS - 1) | child
}

/// What the stack of a single ray keeps of where it enters a node.
pub trait Distance: Enter {
    /// The ray enters at this t.
    fn at(t: f32) -> Self;

    /// The ray enters four children at these.
    fn four(enters: Vec4) -> Self::Four;

    /// Whether that may be within a limit.
    fn is_within(self, limit: f32) -> bool;
}

impl Distance for f32 {
    #[inline(always)]
    fn at(t: f32) -> Self {
        t
    }

    #[inline(always)]
    fn four(enters: Vec4) -> Vec4 {
        enters
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
    fn four(_: Vec4) -> Vec4 {
        Vec4::ZERO
    }

    #[inline(always)]
    fn is_within(self, _: f32) -> bool {
        true
    }
}

/// One ray.
pub struct Single<'a, F, C> {
    pub ray: &'a PreparedRay,
    pub filter: &'a F,
    /// What its collector says ([`Collector::goes_farther_first`]).
    pub goes_farther_first: bool,
    pub collector: &'a mut C,
}

impl<F: HitFilter, C: Collector, D: Distance> Rays<D> for Single<'_, F, C> {
    #[inline(always)]
    fn axes(&self) -> [u32; 3] {
        self.ray.axes
    }

    #[inline(always)]
    fn reversed(&self) -> [u32; 3] {
        let [a, b, c] = self.ray.inverse;
        [a.to_bits() >> 31, b.to_bits() >> 31, c.to_bits() >> 31]
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
    fn count_node(&mut self, children: u32) {
        self.collector.count_node(children);
    }

    #[inline(always)]
    fn open(&mut self, planes: [PlanePair; 3]) -> Opened<D> {
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
    fn open_wide<P: FourPlanes>(&mut self, node: &WideFork<P>, enters: &mut D::Four) -> ChildList {
        let boxes = slab_of_four(self.ray, node.first, node.second, self.collector.limit());
        #[cfg(not(target_arch = "spirv"))]
        if let Some(list) = ChildList::of_few(boxes.met) {
            return list;
        }
        *enters = D::four(boxes.earliest);
        let key = |meets: bool, enter: f32, child: u32| {
            if meets {
                key(enter, child, self.goes_farther_first)
            } else {
                NOT_MET
            }
        };
        let (enter, [a, b, c, d]) = (boxes.enter, boxes.meets);
        ChildList::sorted([
            key(a, enter.x, 0),
            key(b, enter.y, 1),
            key(c, enter.z, 2),
            key(d, enter.w, 3),
        ])
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.ray.t_min > self.collector.limit()
    }
}

impl<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter, C: Collector, D: Distance>
    Query<N, T, D> for Single<'_, F, C>
{
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_child_that_is_met_comes_before_those_that_are_not(bits: [u32; 4], met: u8, is_farther_first: bool) {
            let enters = bits.map(f32::from_bits);
            let keys = core::array::from_fn(|i| if met >> i & 1 == 1 { key(enters[i], i as u32, is_farther_first) } else { NOT_MET });
            let mut list = ChildList::sorted(keys);
            prop_assert!(list.0 < 1 << ChildList::BITS);
            let (mut found, mut sorted) = (0, [0; 4]);
            let count = (met & 15).count_ones() as usize;
            for child in &mut sorted[..count] {
                prop_assert_ne!(list, ChildList::NONE);
                *child = list.first();
                found |= 1u8 << *child;
                list = list.rest();
            }
            prop_assert_eq!(found, met & 15);
            prop_assert_eq!(list, ChildList::NONE);
            for pair in sorted[..count].windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|child| enters[child as usize].abs());
                let (near, far) = if is_farther_first { (b, a) } else { (a, b) };
                // Keys hold all but a few bits.
                prop_assert!(near.is_nan() || far.is_nan() || near.to_bits() >> KEY_BITS <= far.to_bits() >> KEY_BITS);
            }
        }
    }

    #[test]
    fn a_box_that_is_entered_at_no_t_is_met() {
        for enter in [0.0, -0.0, -f32::from_bits(1), f32::MAX, f32::MIN] {
            for is_farther_first in [false, true] {
                assert!(key(enter, 3, is_farther_first) < NOT_MET, "{enter}");
            }
        }
    }
}
