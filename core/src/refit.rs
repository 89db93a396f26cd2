//! Stage `refit`: every node's boxes from its triangles, in one dispatch over a pyramid of boxes.
//!
//! Level 0 of the pyramid holds the box of each [`GROUP_SIZE`] triangles in leaf order, each further level that of two
//! entries of the level below. A node covers a run of leaves, so its children's boxes are unions of few entries: no
//! order among the nodes, no atomics. `min` and `max` are exact, so any grouping gives the same bits.

use crate::aabb::Aabb;
use crate::node::Node;
use crate::triangle::LeafTriangle;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// Triangles in an entry of the pyramid's level 0.
pub const GROUP_SIZE: u32 = 4;

/// An entry of the pyramid. 24 bytes: min, max.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(transparent)]
pub struct PyramidBox(pub [f32; 6]);

impl From<Aabb> for PyramidBox {
    #[inline(always)]
    fn from(b: Aabb) -> Self {
        Self([b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z])
    }
}

impl From<PyramidBox> for Aabb {
    #[inline(always)]
    fn from(PyramidBox(p): PyramidBox) -> Self {
        Self {
            min: Vec3::new(p[0], p[1], p[2]),
            max: Vec3::new(p[3], p[4], p[5]),
        }
    }
}

/// How many entries level 0 has.
#[inline(always)]
#[must_use]
pub const fn group_count(triangle_count: u32) -> u32 {
    triangle_count.div_ceil(GROUP_SIZE)
}

/// One thread per entry of level 0. Reads its triangles. Returns their box.
#[inline(always)]
#[must_use]
pub fn group_bounds(group: u32, triangles: &[LeafTriangle]) -> Aabb {
    let first = group * GROUP_SIZE;
    let mut bounds = Aabb::EMPTY;
    for i in first..first + GROUP_SIZE {
        if i < triangles.len() as u32 {
            bounds = bounds.union(triangle_bounds(i, triangles));
        }
    }
    bounds
}

/// One thread per entry of a further level. Reads two entries of the level below. Returns their union.
#[inline(always)]
#[must_use]
pub fn parent_bounds(entry: u32, below: &[PyramidBox]) -> Aabb {
    let left = crate::load(below, 2 * entry, Aabb::EMPTY.into());
    let right = crate::load(below, 2 * entry + 1, Aabb::EMPTY.into());
    Aabb::from(left).union(right.into())
}

/// The box of the triangles `first..=last`. `pyramid` holds all levels, one after the other.
#[inline]
#[must_use]
pub fn range_bounds(
    first: u32,
    last: u32,
    triangles: &[LeafTriangle],
    pyramid: &[PyramidBox],
) -> Aabb {
    let mut bounds = Aabb::EMPTY;

    // Whole groups inside the range; what hangs over at both ends comes triangle by triangle.
    let mut low = first.div_ceil(GROUP_SIZE);
    let mut high = (last + 1) / GROUP_SIZE;
    if low >= high {
        for i in first..=last {
            bounds = bounds.union(triangle_bounds(i, triangles));
        }
        return bounds;
    }
    for i in first..low * GROUP_SIZE {
        bounds = bounds.union(triangle_bounds(i, triangles));
    }
    for i in high * GROUP_SIZE..=last {
        bounds = bounds.union(triangle_bounds(i, triangles));
    }

    // Climb: an odd end is taken at its level, even ends are covered by their parents.
    let mut level_begin = 0;
    let mut level_count = group_count(triangles.len() as u32);
    for _ in 0..32 {
        if low >= high {
            break;
        }
        if low & 1 == 1 {
            bounds = bounds.union(entry(pyramid, level_begin + low));
            low += 1;
        }
        if high & 1 == 1 {
            high -= 1;
            bounds = bounds.union(entry(pyramid, level_begin + high));
        }
        low /= 2;
        high /= 2;
        level_begin += level_count;
        level_count = level_count.div_ceil(2);
    }
    bounds
}

/// The last triangle of a node's left child, which [`refit_node`] wants. `left_last` is the `last` of the left child
/// where that is an inner node.
#[inline(always)]
#[must_use]
pub fn split_of(node: &Node, left_last: u32) -> u32 {
    if node.left.is_leaf() {
        (node.left.first() + node.left.count()).wrapping_sub(1)
    } else {
        left_last
    }
}

/// One thread per node. Reads the triangles and the pyramid. Returns the node with its children's boxes. `split` is the
/// last triangle of the left child.
#[inline]
#[must_use]
pub fn refit_node(
    node: Node,
    split: u32,
    triangles: &[LeafTriangle],
    pyramid: &[PyramidBox],
) -> Node {
    let left = range_bounds(node.first, split, triangles, pyramid);
    let right = range_bounds(split + 1, node.last, triangles, pyramid);
    node.with_boxes(left, right)
}

#[inline(always)]
fn triangle_bounds(i: u32, triangles: &[LeafTriangle]) -> Aabb {
    crate::load(triangles, i, LeafTriangle::zeroed())
        .triangle()
        .bounds()
}

#[inline(always)]
fn entry(pyramid: &[PyramidBox], i: u32) -> Aabb {
    crate::load(pyramid, i, PyramidBox([0.0; 6])).into()
}
