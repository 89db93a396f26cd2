//! The plain node: both children's boxes in their parent.

use crate::geometry::aabb::Aabb;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// Triangles that a leaf holds at most. Measured against others: ARCHITECTURE.md.
pub const LEAF_SIZE: u32 = 6;

/// Names a child: an inner node by its index, or a leaf by its run of triangles.
///
/// ```text
/// inner  0 iiiiiii iiiiiiii iiiiiiii iiiiiiii   index, 31 bits
/// leaf   1 cccffff ffffffff ffffffff ffffffff   count 0–7, first triangle, 28 bits
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct NodeRef(pub u32);

impl NodeRef {
    /// A leaf without triangles.
    pub const EMPTY_LEAF: Self = Self(LEAF_BIT);

    /// An inner node.
    #[inline(always)]
    #[must_use]
    pub const fn inner(index: u32) -> Self {
        Self(index)
    }

    /// A run of `count <= 7` triangles.
    #[inline(always)]
    #[must_use]
    pub const fn leaf(first: u32, count: u32) -> Self {
        Self(LEAF_BIT | (count << FIRST_BITS) | first)
    }

    /// Whether it is a leaf.
    #[inline(always)]
    #[must_use]
    pub const fn is_leaf(self) -> bool {
        self.0 & LEAF_BIT != 0
    }

    /// An inner node's index.
    #[inline(always)]
    #[must_use]
    pub const fn index(self) -> u32 {
        self.0
    }

    /// A leaf's first triangle, in leaf order.
    #[inline(always)]
    #[must_use]
    pub const fn first(self) -> u32 {
        self.0 & (crate::MAX_TRIANGLES - 1)
    }

    /// How many triangles a leaf has.
    #[inline(always)]
    #[must_use]
    pub const fn count(self) -> u32 {
        (self.0 >> FIRST_BITS) & 7
    }
}

const LEAF_BIT: u32 = 1 << 31;
const FIRST_BITS: u32 = 28;
const _: () = assert!(1 << FIRST_BITS == crate::MAX_TRIANGLES);
const _: () = assert!(LEAF_SIZE <= 7);

/// An inner node: its children and their boxes, side by side. 64 bytes, one cache line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Node {
    /// Bytes 0–47: for x, y and z the planes `[left min, right min, left max, right max]`.
    pub planes: [[f32; 4]; 3],
    /// Bytes 48–51: left child, the first part of the node's triangles.
    pub left: NodeRef,
    /// Bytes 52–55: right child, the rest.
    pub right: NodeRef,
    /// Bytes 56–59: first triangle below this node, in leaf order.
    pub first: u32,
    /// Bytes 60–63: last triangle below this node.
    pub last: u32,
}

const _: () = assert!(size_of::<Node>() == 64);

/// A node without boxes. 16 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Connection {
    /// Bytes 0–3: left child.
    pub left: NodeRef,
    /// Bytes 4–7: right child.
    pub right: NodeRef,
    /// Bytes 8–11: first triangle below this node, in leaf order.
    pub first: u32,
    /// Bytes 12–15: last triangle below this node.
    pub last: u32,
}

const _: () = assert!(size_of::<Connection>() == 16);

impl From<&Node> for Connection {
    fn from(node: &Node) -> Self {
        Self {
            left: node.left,
            right: node.right,
            first: node.first,
            last: node.last,
        }
    }
}

impl From<&Connection> for Node {
    fn from(connection: &Connection) -> Self {
        Self {
            left: connection.left,
            right: connection.right,
            first: connection.first,
            last: connection.last,
            ..Self::EMPTY
        }
    }
}

impl Node {
    /// A node without triangles.
    pub const EMPTY: Self = Self {
        planes: [[0.0; 4]; 3],
        left: NodeRef::EMPTY_LEAF,
        right: NodeRef::EMPTY_LEAF,
        first: 0,
        last: 0,
    };

    /// Puts both children's boxes in place.
    #[inline]
    #[must_use]
    pub fn with_boxes(self, left: Aabb, right: Aabb) -> Self {
        Self {
            planes: [
                [left.min.x, right.min.x, left.max.x, right.max.x],
                [left.min.y, right.min.y, left.max.y, right.max.y],
                [left.min.z, right.min.z, left.max.z, right.max.z],
            ],
            ..self
        }
    }

    /// The left child's box.
    #[inline]
    #[must_use]
    pub fn left_box(&self) -> Aabb {
        let [x, y, z] = self.planes;
        Aabb {
            min: Vec3::new(x[0], y[0], z[0]),
            max: Vec3::new(x[2], y[2], z[2]),
        }
    }

    /// The right child's box.
    #[inline]
    #[must_use]
    pub fn right_box(&self) -> Aabb {
        let [x, y, z] = self.planes;
        Aabb {
            min: Vec3::new(x[1], y[1], z[1]),
            max: Vec3::new(x[3], y[3], z[3]),
        }
    }

    /// Both children's boxes, with a box also for one that is not there: the other's, or the origin where neither is.
    #[inline]
    #[must_use]
    pub fn child_boxes(&self) -> ChildBoxes {
        const ORIGIN: Aabb = Aabb {
            min: Vec3::ZERO,
            max: Vec3::ZERO,
        };
        let left = if self.left.0 == NodeRef::EMPTY_LEAF.0 {
            ORIGIN
        } else {
            self.left_box()
        };
        let right = if self.right.0 == NodeRef::EMPTY_LEAF.0 {
            left
        } else {
            self.right_box()
        };
        ChildBoxes { left, right }
    }
}

/// Both children's boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChildBoxes {
    /// The left child's.
    pub left: Aabb,
    /// The right child's.
    pub right: Aabb,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_give_back_what_they_were_made_from() {
        let leaf = NodeRef::leaf(crate::MAX_TRIANGLES - 1, 7);
        assert!(leaf.is_leaf());
        assert_eq!((leaf.first(), leaf.count()), (crate::MAX_TRIANGLES - 1, 7));
        let inner = NodeRef::inner(123);
        assert!(!inner.is_leaf());
        assert_eq!(inner.index(), 123);
        assert_eq!(NodeRef::EMPTY_LEAF.count(), 0);
    }

    #[test]
    fn boxes_come_back_as_they_went_in() {
        let left = Aabb {
            min: Vec3::new(1.0, 2.0, 3.0),
            max: Vec3::new(4.0, 6.0, 8.0),
        };
        let right = Aabb {
            min: Vec3::new(-1.0, -2.0, -3.0),
            max: Vec3::new(0.5, 0.25, 0.125),
        };
        let node = Node::EMPTY.with_boxes(left, right);
        assert_eq!((node.left_box(), node.right_box()), (left, right));
    }
}
