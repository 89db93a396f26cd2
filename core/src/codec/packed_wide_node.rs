//! A wide node on the lattice in 48 bytes: three axes, and links in the bits that they leave free.
//!
//! It holds the planes of [`WideNode`](super::WideNode) but no extents: a child's upper plane lies where its cell ends, at the last
//! cell up to a cell beyond the node. Triangles lie on the lattice, too: links name words ([`PackedLinks`]).

use super::leaf_width::LeafWidth;
use super::packed_links::PackedLinks;
use super::rounded_children::RoundedChildren;
use super::wide_axis::{SHIFT_BITS, WideAxis, box_above, wide_axes};
use crate::build::wide::WIDTH;
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
    /// One thread per wide node. Takes its children, and how many corners each of them has that is a leaf. Returns it with all links,
    /// whose runs begin at 0. The corners of all leaves are as wide as the widest needs, counted from its decoded box's smallest
    /// corner.
    #[inline]
    #[must_use]
    pub fn new(from: &RoundedChildren, corner_counts: [u32; WIDTH]) -> Self {
        let node = Self {
            axes: wide_axes::<true>(from),
        };
        // Their bits together are as long as the longest.
        let reach = |child: u32| {
            if child < from.count && from.nodes[child as usize & 3].is_leaf() {
                let [a, b, c] = node.child_box(child, from.step_exponent).min;
                let [x, y, z] = from.boxes[child as usize & 3].max;
                x.wrapping_sub(a) as u32 | y.wrapping_sub(b) as u32 | z.wrapping_sub(c) as u32
            } else {
                0
            }
        };
        let any = reach(0) | reach(1) | reach(2) | reach(3);
        let width = LeafWidth::of_extents([any; 3]);
        let links = PackedLinks::new(from.nodes, corner_counts, width, from.count);
        node.linked(links)
    }

    /// What its children are.
    #[inline(always)]
    #[must_use]
    pub const fn links(&self) -> PackedLinks {
        let [x, y, z] = &self.axes;
        PackedLinks::from_words([x.scale, y.scale, z.scale])
    }

    /// The node with these links.
    #[inline(always)]
    #[must_use]
    pub const fn linked(self, links: PackedLinks) -> Self {
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

    /// Of the leaves of [`CHILDREN`].
    const CORNERS: [u32; 4] = [0, 5, 0, 18];

    proptest! {
        #[test]
        fn decoded_boxes_hold_the_children_and_leave_the_node_by_less_than_a_cell(from in case()) {
            let exponent = from.step_exponent;
            let node = PackedWideNode::new(&from, CORNERS);
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
            let node = PackedWideNode::new(&from, CORNERS);
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
        fn links_are_those_of_the_children_and_hold_their_triangles(from in case(), first_child in 0..(1u32 << 23) - 4, first_word in 0..1u32 << 27) {
            let node = PackedWideNode::new(&from, CORNERS);
            let links = node.links().at(first_child, first_word);
            prop_assert!(links.are_canonical(from.count));
            let linked = node.linked(links);
            prop_assert_eq!(linked.links(), links);
            let exact = WideNode::new(&from, first_child);
            let mut widest = LeafWidth::Narrow as u32;
            for i in 0..from.count {
                prop_assert_eq!(linked.child_box(i, from.step_exponent), node.child_box(i, from.step_exponent));
                let (child, named) = (CHILDREN[i as usize], links.child(i));
                if !child.is_leaf() {
                    prop_assert_eq!(named, exact.children[i as usize]);
                    continue;
                }
                prop_assert_eq!([named.is_leaf() as u32, named.count()], [1, child.count()]);
                prop_assert_eq!(links.corner_count(i), CORNERS[i as usize]);
                // Every corner of the exact box is within reach.
                let min = node.child_box(i, from.step_exponent).min;
                let bits = [10, 21, 32][links.width as usize];
                for axis in 0..3 {
                    let reach = i64::from(from.boxes[i as usize].max[axis]) - i64::from(min[axis]);
                    prop_assert!(reach < 1 << bits);
                    widest = widest.max(u32::from(reach >= 1 << 10) + u32::from(reach >= 1 << 21));
                }
            }
            prop_assert_eq!(links.width, widest, "no wider than a leaf needs");
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
        let node = PackedWideNode::new(&from, CORNERS);
        for child in 0..4 {
            let mut spoilt = node;
            spoilt.axes[1].upper -= 1 << (8 * child);
            let held = &boxes[child as usize];
            assert!(node.child_box(child, -10).contains(held));
            assert!(!spoilt.child_box(child, -10).contains(held));
        }
        for (axis, bit) in [(0, 5), (1, 5), (1, 28), (2, 11), (2, 12), (2, 23)] {
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
