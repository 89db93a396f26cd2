//! A plain node on a lattice: what the lattice codec reads.

use crate::build::node::{Node, NodeRef};
use crate::geometry::lattice::{LatticeBox, lattice_floors};
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// A node whose children's boxes are the smallest on a lattice that hold the plain ones. 64 bytes, laid out as [`Node`], but
/// planes are whole numbers of steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct RoundedNode {
    /// Bytes 0–47: for x, y and z the planes `[left min, right min, left max, right max]`.
    pub planes: [[i32; 4]; 3],
    /// Bytes 48–51: left child.
    pub left: NodeRef,
    /// Bytes 52–55: right child.
    pub right: NodeRef,
    /// Bytes 56–59: first triangle below this node, in leaf order.
    pub first: u32,
    /// Bytes 60–63: last triangle below this node.
    pub last: u32,
}

const _: () = assert!(size_of::<RoundedNode>() == 64);

impl RoundedNode {
    /// A node without triangles.
    pub const EMPTY: Self = Self {
        planes: [[0; 4]; 3],
        left: NodeRef::EMPTY_LEAF,
        right: NodeRef::EMPTY_LEAF,
        first: 0,
        last: 0,
    };

    /// One thread per node. Reads it. Returns it on the lattice whose step is two to this power, which all its coordinates are
    /// below `2^30` steps of.
    #[inline(always)]
    #[must_use]
    pub fn new(node: &Node, step_exponent: i32) -> Self {
        let boxes = node.child_boxes();
        let ([a, b], [c, d]) = (
            [boxes.left.min, boxes.right.min],
            [boxes.left.max, boxes.right.max],
        );
        // What is above a number is not below its negative: four of one kind at once.
        let row = |a: f32, b: f32, c: f32, d: f32| {
            let [a, b, c, d] = lattice_floors(Vec4::new(a, b, -c, -d), step_exponent);
            [a, b, -c, -d]
        };
        Self {
            planes: [
                row(a.x, b.x, c.x, d.x),
                row(a.y, b.y, c.y, d.y),
                row(a.z, b.z, c.z, d.z),
            ],
            left: node.left,
            right: node.right,
            first: node.first,
            last: node.last,
        }
    }

    /// The left child's box and the right one's.
    #[inline(always)]
    #[must_use]
    pub const fn boxes(&self) -> [LatticeBox; 2] {
        boxes(self.planes)
    }
}

/// Both children's boxes, from their planes on each axis.
#[inline(always)]
pub(super) const fn boxes([x, y, z]: [[i32; 4]; 3]) -> [LatticeBox; 2] {
    [
        LatticeBox {
            min: [x[0], y[0], z[0]],
            max: [x[2], y[2], z[2]],
        },
        LatticeBox {
            min: [x[1], y[1], z[1]],
            max: [x[3], y[3], z[3]],
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::aabb::Aabb;
    use glam::Vec3;

    #[test]
    fn boxes_are_the_smallest_that_hold_the_plain_ones() {
        let left = Aabb {
            min: Vec3::new(0.3, -0.3, 0.0),
            max: Vec3::new(0.5, 0.3, 0.125),
        };
        let right = Aabb {
            min: Vec3::new(-0.26, 0.25, 0.7),
            max: Vec3::new(0.0, 0.26, 0.75),
        };
        let node = Node {
            left: NodeRef::inner(1),
            right: NodeRef::leaf(8, 2),
            first: 3,
            last: 9,
            ..Node::EMPTY
        }
        .with_boxes(left, right);
        let rounded = RoundedNode::new(&node, -2);
        let expected = [left, right].map(|bounds| LatticeBox::around(&bounds, -2));
        assert_eq!(rounded.boxes(), expected);
        assert_eq!(expected[0].min, [1, -2, 0]);
        assert_eq!(expected[1].max, [0, 2, 3]);
        let links = (rounded.left, rounded.right, rounded.first, rounded.last);
        assert_eq!(links, (node.left, node.right, node.first, node.last));
        assert_eq!(RoundedNode::new(&Node::EMPTY, -24), RoundedNode::EMPTY);
    }
}
