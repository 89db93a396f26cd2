//! A wide node on the lattice in 48 bytes: three axes, and links in the bits that they leave free.
//!
//! It holds the planes of [`WideNode`](super::WideNode) but no extents: a child's upper plane lies where its cell ends, at the last
//! cell up to a cell beyond the node. Triangles lie on the lattice, too: links name words ([`WideLinks`]).

use super::leaf_width::LeafWidth;
use super::rounded_children::RoundedChildren;
use super::wide_axis::{SHIFT_BITS, WideAxis, box_above, wide_axes};
use super::wide_links::WideLinks;
use crate::geometry::lattice::LatticeBox;
use bytemuck::{Pod, Zeroable};

/// A node of up to four children. 48 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct PackedWideNode {
    /// Bytes 0–47: x, y and z.
    pub axes: [WideAxis; 3],
}

const _: () = assert!(size_of::<PackedWideNode>() == 48);

impl PackedWideNode {
    /// One thread per wide node. Takes its children. Returns it with all links, whose runs begin at 0. A leaf's triangles are as
    /// wide as they may need, counted from its decoded box's smallest corner.
    #[inline]
    #[must_use]
    pub fn new(from: &RoundedChildren) -> Self {
        let node = Self {
            axes: wide_axes::<true>(from),
        };
        let width = |child: u32| {
            LeafWidth::of(&LatticeBox {
                min: node.child_box(child, from.step_exponent).min,
                max: from.boxes[child as usize & 3].max,
            })
        };
        let widths = [width(0), width(1), width(2), width(3)];
        node.linked(WideLinks::new(from.nodes, widths, from.count))
    }

    /// What its children are.
    #[inline(always)]
    #[must_use]
    pub const fn links(&self) -> WideLinks {
        let [x, y, z] = &self.axes;
        WideLinks::from_words([x.scale, y.scale, z.scale])
    }

    /// The node with these links.
    #[inline(always)]
    #[must_use]
    pub const fn linked(self, links: WideLinks) -> Self {
        let ([x, y, z], [a, b, c]) = (self.axes, links.words());
        Self {
            axes: [with_link(x, a), with_link(y, b), with_link(z, c)],
        }
    }

    /// A child's box, decoded, in steps. It holds the box that was encoded, and lies in the node's but for a cell.
    #[inline(always)]
    #[must_use]
    pub fn child_box(&self, child: u32, step_exponent: i32) -> LatticeBox {
        let [x, y, z] = &self.axes;
        let planes = [
            x.cell_planes(child),
            y.cell_planes(child),
            z.cell_planes(child),
        ];
        box_above(&self.axes, planes, step_exponent)
    }
}

/// The axis with a word of links.
#[inline(always)]
const fn with_link(axis: WideAxis, word: u32) -> WideAxis {
    WideAxis {
        scale: axis.scale & ((1 << SHIFT_BITS) - 1) | word,
        ..axis
    }
}

#[cfg(test)]
mod tests {
    use super::super::wide_node::WideNode;
    use super::super::wide_node::tests::{CHILDREN, case, whole};
    use super::*;
    use crate::geometry::float::power_of_two;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn decoded_boxes_hold_the_children_and_leave_the_node_by_less_than_a_cell(from in case()) {
            let exponent = from.step_exponent;
            let node = PackedWideNode::new(&from);
            let (there, exact) = (&from.boxes[..from.count as usize], WideNode::new(&from, 7));
            let whole = whole(there);
            for (i, bounds) in there.iter().enumerate() {
                let decoded = node.child_box(i as u32, exponent);
                prop_assert!(decoded.contains(bounds), "{:?} {:?}", decoded, bounds);
                let inside = exact.child_box(i as u32, exponent);
                prop_assert_eq!(decoded.min, inside.min);
                for (axis, stored) in node.axes.iter().enumerate() {
                    let cell = 1i32 << stored.shift();
                    let beyond = decoded.max[axis] - whole.max[axis];
                    let is_flat = i32::from(whole.min[axis] == whole.max[axis]);
                    prop_assert!(beyond < cell + is_flat);
                    let is_flat = i32::from(bounds.min[axis] == bounds.max[axis]);
                    prop_assert!(decoded.max[axis] - bounds.max[axis] < cell + is_flat);
                }
            }
            for child in from.count..4 {
                for axis in &node.axes {
                    prop_assert!(axis.is_absent(child, true));
                    let [lower, upper] = axis.cell_planes(child);
                    prop_assert!(lower > upper, "an absent child's box is inverted");
                }
            }
        }

        #[test]
        fn planes_hold_the_children_as_floats(from in case()) {
            // A plane beyond the node may be beyond 2^24 steps, too, and be rounded; never to below a plane that it holds.
            let step = power_of_two(from.step_exponent);
            let node = PackedWideNode::new(&from);
            for i in 0..from.count {
                let bounds = &from.boxes[i as usize];
                for (axis, stored) in node.axes.iter().enumerate() {
                    let [low, high] = stored.cell_planes(i).map(|steps| stored.origin + steps as f32 * step);
                    prop_assert!(low <= bounds.min[axis] as f32 * step);
                    prop_assert!(high >= bounds.max[axis] as f32 * step);
                }
            }
        }

        #[test]
        fn links_are_those_of_the_children_and_hold_their_triangles(from in case(), first_child in 0..1u32 << 28, first_word in 0..1u32 << 27) {
            let node = PackedWideNode::new(&from);
            let links = node.links().at(first_child, first_word);
            prop_assert!(links.are_canonical(from.count));
            let linked = node.linked(links);
            prop_assert_eq!(linked.links(), links);
            let exact = WideNode::new(&from, first_child);
            let wider = exact.links(&from).at(first_child, first_word);
            prop_assert_eq!(links.kinds, wider.kinds);
            for i in 0..from.count {
                prop_assert_eq!(linked.child_box(i, from.step_exponent), node.child_box(i, from.step_exponent));
                prop_assert!(links.width_bits(i) <= wider.width_bits(i));
                if !CHILDREN[i as usize].is_leaf() {
                    prop_assert_eq!(links.child(i), exact.children[i as usize]);
                    prop_assert_eq!(links.width_bits(i), 0);
                    continue;
                }
                // Every corner of the exact box is within reach.
                let min = node.child_box(i, from.step_exponent).min;
                let bits = [10, 21, 32][links.width_bits(i) as usize];
                for axis in 0..3 {
                    let reach = i64::from(from.boxes[i as usize].max[axis]) - i64::from(min[axis]);
                    prop_assert!(reach < 1 << bits);
                }
            }
        }
    }

    /// The negative control: a plane that is moved inward by a cell loses its child, and a bit of its links names another.
    #[test]
    fn a_bit_that_is_flipped_is_found() {
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
        let node = PackedWideNode::new(&from);
        for child in 0..4 {
            let mut spoilt = node;
            spoilt.axes[1].upper -= 1 << (8 * child);
            let held = &boxes[child as usize];
            assert!(node.child_box(child, -10).contains(held));
            assert!(!spoilt.child_box(child, -10).contains(held));
        }
        for (axis, bit) in [(0, 5), (1, 31), (2, 5), (2, 21), (2, 25)] {
            let mut spoilt = node;
            spoilt.axes[axis].scale ^= 1 << bit;
            assert_ne!(
                spoilt.links().children(),
                node.links().children(),
                "{axis} {bit}"
            );
        }
    }
}
