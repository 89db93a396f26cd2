//! The lattice codec's node of four children, with a frame of its own: decoded from its own 64 bytes alone.
//!
//! ```text
//!  0  x: origin, four lower planes, four upper planes, shift and extent
//! 16  y
//! 32  z
//! 48  four children
//! ```
//!
//! Both sides of the node are exact on each axis of at most 2^24 steps: its lower one is the origin, its upper one the last cell's
//! end, which is cut off by the extent ([`Frame`](super::frame::Frame)). On a longer axis the upper one is exact to a step.

use super::leaf_width::LeafWidth;
use super::rounded_children::RoundedChildren;
use super::wide_axis::{WideAxis, box_above, wide_axes};
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use crate::geometry::lattice::LatticeBox;
use bytemuck::{Pod, Zeroable};

/// A node of up to four children. 64 bytes, a cache line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct WideNode {
    /// Bytes 0–47: x, y and z.
    pub axes: [WideAxis; 3],
    /// Bytes 48–63: the children, those that are not there last: leaves without triangles.
    pub children: [NodeRef; WIDTH],
}

const _: () = assert!(size_of::<WideNode>() == 64);

impl WideNode {
    /// One thread per wide node. Takes its children; inner ones lie side by side from a place on, leaves name triangles in full.
    #[inline]
    #[must_use]
    pub fn new(from: &RoundedChildren, first_child: u32) -> Self {
        Self {
            axes: wide_axes::<false>(from),
            children: from.placed(first_child),
        }
    }

    /// The width of a leaf's triangles on the lattice: as its decoded box needs.
    #[inline(always)]
    #[must_use]
    pub fn leaf_width(&self, child: u32, step_exponent: i32) -> LeafWidth {
        LeafWidth::of(&self.child_box(child, step_exponent))
    }

    /// The node whose leaves begin at words instead of triangles, one after the other from word 0 on, and how many words these are.
    #[inline(always)]
    #[must_use]
    pub fn over_words(self, from: &RoundedChildren) -> (Self, u32) {
        let words = |i: u32| {
            let child = self.children[i as usize];
            if i < from.count && child.is_leaf() {
                child.count() * self.leaf_width(i, from.step_exponent).words()
            } else {
                0
            }
        };
        let named = |i: u32, first: u32| {
            let child = self.children[i as usize];
            if i < from.count && child.is_leaf() {
                NodeRef::leaf(first, child.count())
            } else {
                child
            }
        };
        let b = words(0);
        let c = b + words(1);
        let d = c + words(2);
        let node = Self {
            children: [named(0, 0), named(1, b), named(2, c), named(3, d)],
            ..self
        };
        (node, d + words(3))
    }

    /// The node whose inner children and whose leaves' words begin so much further on. Its children are the first `count`.
    #[inline(always)]
    #[must_use]
    pub fn moved(self, count: u32, first_child: u32, first_word: u32) -> Self {
        let moved = |i: u32| {
            let child = self.children[i as usize];
            if i >= count {
                child
            } else if child.is_leaf() {
                NodeRef::leaf(child.first().wrapping_add(first_word), child.count())
            } else {
                NodeRef::inner(child.index().wrapping_add(first_child))
            }
        };
        Self {
            children: [moved(0), moved(1), moved(2), moved(3)],
            ..self
        }
    }

    /// A child's box, decoded, in steps. It holds the box that was encoded, and lies in the node's.
    #[inline(always)]
    #[must_use]
    pub fn child_box(&self, child: u32, step_exponent: i32) -> LatticeBox {
        let [x, y, z] = &self.axes;
        let planes = [x.planes(child), y.planes(child), z.planes(child)];
        box_above(&self.axes, planes, step_exponent)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::geometry::float::power_of_two;
    use proptest::array::{uniform3, uniform4};
    use proptest::prelude::*;

    /// A box around some size, near others.
    fn lattice_box() -> impl Strategy<Value = LatticeBox> {
        let size = prop_oneof![Just(0i32), 0..3i32, 0..300i32, 0..1 << 20, 0..1 << 25];
        let near = prop_oneof![
            -4..4i32,
            -1000..1000i32,
            -(1 << 23)..(1 << 23),
            Just(-(1i32 << 24))
        ];
        let corner = uniform3(near);
        (corner, uniform3(size)).prop_map(|(min, size)| LatticeBox {
            min,
            max: core::array::from_fn(|axis| (min[axis] + size[axis]).min(1 << 24)),
        })
    }

    pub(in super::super) fn case() -> impl Strategy<Value = RoundedChildren> {
        (uniform4(lattice_box()), 0..=4u32, -24..=0i32).prop_map(|(boxes, count, step_exponent)| {
            RoundedChildren {
                nodes: CHILDREN,
                boxes,
                count,
                step_exponent,
            }
        })
    }

    pub(in super::super) const CHILDREN: [NodeRef; 4] = [
        NodeRef::inner(7),
        NodeRef::leaf(3, 2),
        NodeRef::inner(8),
        NodeRef::leaf(90, 6),
    ];

    /// The node's box, its upper sides exact to a step where it has more than 2^24.
    pub(in super::super) fn whole(there: &[LatticeBox]) -> LatticeBox {
        let whole = there.iter().copied().reduce(|a, b| a.union(&b));
        let mut whole = whole.unwrap_or(LatticeBox::ZERO);
        for (min, max) in whole.min.iter().zip(&mut whole.max) {
            let extent = *max - min;
            *max += i32::from(extent > 1 << 24) & (extent & 1);
        }
        whole
    }

    proptest! {
        #[test]
        fn decoded_boxes_hold_the_children_and_stay_in_the_node(from in case()) {
            let exponent = from.step_exponent;
            let node = WideNode::new(&from, 7);
            let there = &from.boxes[..from.count as usize];
            let whole = whole(there);
            for (i, bounds) in there.iter().enumerate() {
                let decoded = node.child_box(i as u32, exponent);
                prop_assert!(decoded.contains(bounds), "{:?} {:?}", decoded, bounds);
                prop_assert!(whole.contains(&decoded), "{:?} {:?}", whole, decoded);
                // No plane moves by a whole cell, but for one of a child that is flat there.
                for (axis, stored) in node.axes.iter().enumerate() {
                    let (cell, is_flat) = (1i32 << stored.shift(), i32::from(bounds.min[axis] == bounds.max[axis]));
                    prop_assert!(bounds.min[axis] - decoded.min[axis] < cell + is_flat);
                    let is_long = i32::from(stored.extent() > 1 << 24);
                    prop_assert!(decoded.max[axis] - bounds.max[axis] < cell + is_flat + is_long);
                }
                prop_assert_eq!(node.children[i], CHILDREN[i]);
            }
            for child in from.count..4 {
                prop_assert_eq!(node.children[child as usize], NodeRef::EMPTY_LEAF);
                for axis in &node.axes {
                    prop_assert!(axis.is_absent(child, false));
                    let [lower, upper] = axis.planes(child);
                    prop_assert!(lower as i32 > upper as i32, "an absent child's box is inverted");
                }
            }
            // The node's own sides are exact: a child has them.
            for (axis, stored) in node.axes.iter().enumerate() {
                let step = power_of_two(exponent);
                prop_assert_eq!(stored.origin, whole.min[axis] as f32 * step);
                let end = i64::from(whole.min[axis]) + i64::from(stored.extent());
                prop_assert_eq!(end, i64::from(whole.max[axis]));
                if from.count > 0 {
                    let nearest = |side: usize| (0..from.count).map(move |child| stored.numbers(child)[side]).min();
                    prop_assert_eq!([nearest(0), nearest(1)], [Some(0); 2]);
                }
                let cell = 1u32 << stored.shift();
                prop_assert!(cell * 256 >= stored.extent() && (cell == 1 || cell * 128 < stored.extent()));
            }
        }

        #[test]
        fn planes_are_exact_as_floats(from in case()) {
            let (exponent, step) = (from.step_exponent, power_of_two(from.step_exponent));
            let node = WideNode::new(&from, 7);
            for i in 0..from.count {
                let decoded = node.child_box(i, exponent);
                for (axis, stored) in node.axes.iter().enumerate() {
                    for (steps, plane) in stored.planes(i).into_iter().zip([decoded.min[axis], decoded.max[axis]]) {
                        prop_assert_eq!(f64::from(steps as f32), f64::from(steps));
                        let single = stored.origin + steps as f32 * step;
                        if plane <= 1 << 24 {
                            prop_assert_eq!(f64::from(single), f64::from(plane) * f64::from(step));
                        } else {
                            // The step by which a long axis may be too long: rounded, not to below the plane it holds.
                            prop_assert!(single >= from.boxes[i as usize].max[axis] as f32 * step);
                        }
                    }
                }
            }
        }

        #[test]
        fn leaves_are_as_wide_as_their_decoded_boxes_need(from in case()) {
            let (node, count) = WideNode::new(&from, 0).over_words(&from);
            let moved = node.moved(from.count, 70, 500);
            let (mut inner, mut word) = (0, 0);
            for i in 0..from.count {
                let [at_first, child] = [node, moved].map(|node| node.children[i as usize]);
                prop_assert_eq!(child.is_leaf(), CHILDREN[i as usize].is_leaf());
                if child.is_leaf() {
                    prop_assert_eq!(at_first, NodeRef::leaf(word, CHILDREN[i as usize].count()));
                    prop_assert_eq!(child, NodeRef::leaf(500 + word, at_first.count()));
                    let width = LeafWidth::of(&node.child_box(i, from.step_exponent));
                    prop_assert_eq!(node.leaf_width(i, from.step_exponent), width);
                    word += child.count() * width.words();
                } else {
                    prop_assert_eq!([at_first, child], [NodeRef::inner(inner), NodeRef::inner(70 + inner)]);
                    inner += 1;
                }
            }
            prop_assert_eq!(count, word);
            for i in from.count..4 {
                prop_assert_eq!(moved.children[i as usize], NodeRef::EMPTY_LEAF);
            }
        }
    }

    /// The negative control: a plane that is moved inward by a cell loses its child.
    #[test]
    fn a_plane_moved_inward_is_found() {
        let boxes = [0, 1000, 2000, 3000].map(|at| LatticeBox {
            min: [at; 3],
            max: [at + 500; 3],
        });
        let from = RoundedChildren {
            nodes: CHILDREN,
            boxes,
            count: 4,
            step_exponent: -10,
        };
        let node = WideNode::new(&from, 7);
        for child in 0..4 {
            let spoilt = |from: fn(&mut WideNode, u32)| {
                let mut node = node;
                from(&mut node, 1 << (8 * child));
                !node.child_box(child, -10).contains(&boxes[child as usize])
            };
            assert!(spoilt(|node, by| node.axes[0].lower += by), "{child}");
            assert!(spoilt(|node, by| node.axes[2].upper += by), "{child}");
        }
    }
}
