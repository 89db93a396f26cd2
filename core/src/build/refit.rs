//! Stage `refit`: every node's boxes from its triangles, in one dispatch over a pyramid of boxes.
//!
//! Level 0 of the pyramid holds the box of each [`GROUP_SIZE`] triangles in leaf order, each further level that of two
//! entries of the level below. A node covers a run of leaves, so its children's boxes are unions of few entries: no
//! order among the nodes, no atomics. `min` and `max` are exact, so any grouping gives the same bits.

use crate::build::node::{Node, NodeRef};
use crate::geometry::aabb::Aabb;
use crate::geometry::triangle::LeafTriangle;
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// Triangles in an entry of the pyramid's level 0.
pub const GROUP_SIZE: u32 = 8;

/// An entry of the pyramid. 32 bytes: min, unused, max, unused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(transparent)]
pub struct PyramidBox(pub [f32; 8]);

/// A box in vectors of four, the last lane unused.
#[derive(Clone, Copy)]
pub(crate) struct WideBox {
    pub(crate) min: Vec4,
    pub(crate) max: Vec4,
}

impl WideBox {
    pub(crate) const EMPTY: Self = Self {
        min: Vec4::splat(f32::MAX),
        max: Vec4::splat(-f32::MAX),
    };

    #[inline(always)]
    pub(crate) fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    #[inline(always)]
    pub(crate) fn of_triangle(i: u32, triangles: &[LeafTriangle]) -> Self {
        let LeafTriangle {
            vertices: v,
            primitive,
        } = crate::load(triangles, i, LeafTriangle::ABSENT);
        // Each vector reaches one number into what follows.
        let a = Vec4::new(v[0], v[1], v[2], v[3]);
        let b = Vec4::new(v[3], v[4], v[5], v[6]);
        let c = Vec4::new(v[6], v[7], v[8], f32::from_bits(primitive));
        Self {
            min: a.min(b).min(c),
            max: a.max(b).max(c),
        }
    }

    #[inline(always)]
    pub(crate) fn of_entry(i: u32, pyramid: &[PyramidBox]) -> Self {
        let PyramidBox(p) = crate::load(pyramid, i, PyramidBox([0.0; 8]));
        Self {
            min: Vec4::new(p[0], p[1], p[2], p[3]),
            max: Vec4::new(p[4], p[5], p[6], p[7]),
        }
    }

    #[inline(always)]
    pub(crate) fn entry(self) -> PyramidBox {
        let (a, b) = (self.min, self.max);
        PyramidBox([a.x, a.y, a.z, 0.0, b.x, b.y, b.z, 0.0])
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
pub fn group_bounds(group: u32, triangles: &[LeafTriangle]) -> PyramidBox {
    let first = group * GROUP_SIZE;
    let mut bounds = WideBox::EMPTY;
    for i in first..first + GROUP_SIZE {
        if i < triangles.len() as u32 {
            bounds = bounds.union(WideBox::of_triangle(i, triangles));
        }
    }
    bounds.entry()
}

/// One thread per entry of a further level. Reads two entries of the level below. Returns their union.
#[inline(always)]
#[must_use]
pub fn parent_bounds(entry: u32, below: &[PyramidBox]) -> PyramidBox {
    let left = 2 * entry;
    let right = if left + 1 < below.len() as u32 {
        left + 1
    } else {
        left
    };
    WideBox::of_entry(left, below)
        .union(WideBox::of_entry(right, below))
        .entry()
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
    let bounds = wide_range_bounds(first, last, triangles, pyramid);
    Aabb {
        min: bounds.min.truncate(),
        max: bounds.max.truncate(),
    }
}

#[inline(always)]
fn wide_range_bounds(
    first: u32,
    last: u32,
    triangles: &[LeafTriangle],
    pyramid: &[PyramidBox],
) -> WideBox {
    let mut bounds = WideBox::EMPTY;

    // Whole groups inside the range; what hangs over at both ends comes triangle by triangle.
    let mut low = first.div_ceil(GROUP_SIZE);
    let mut high = (last + 1) / GROUP_SIZE;
    if low >= high {
        for i in first..=last {
            bounds = bounds.union(WideBox::of_triangle(i, triangles));
        }
        return bounds;
    }
    for i in first..low * GROUP_SIZE {
        bounds = bounds.union(WideBox::of_triangle(i, triangles));
    }
    for i in high * GROUP_SIZE..=last {
        bounds = bounds.union(WideBox::of_triangle(i, triangles));
    }

    // Climb: an odd end is taken at its level, even ends are covered by their parents.
    let mut level_begin = 0;
    let mut level_count = group_count(triangles.len() as u32);
    for _ in 0..32u32 {
        if low >= high {
            break;
        }
        if low & 1 == 1 {
            bounds = bounds.union(WideBox::of_entry(level_begin + low, pyramid));
            low += 1;
        }
        if high & 1 == 1 {
            high -= 1;
            bounds = bounds.union(WideBox::of_entry(level_begin + high, pyramid));
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
/// last triangle of the left child. The node of a tree over nothing stays as it is.
#[inline]
#[must_use]
pub fn refit_node(
    node: Node,
    split: u32,
    triangles: &[LeafTriangle],
    pyramid: &[PyramidBox],
) -> Node {
    if node.left.0 == NodeRef::EMPTY_LEAF.0 {
        return node;
    }
    let left = range_bounds(node.first, split, triangles, pyramid);
    let right = range_bounds(split + 1, node.last, triangles, pyramid);
    node.with_boxes(left, right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::topology::{Codes30, internal_node, kept_nodes};

    #[test]
    fn a_node_over_nothing_stays_as_it_is() {
        let codes = Codes30 {
            codes: &[0; 4],
            count: 0,
        };
        let kept = kept_nodes(0, &codes);
        let (node, split) = internal_node(0, &codes, &[kept], &[0]);
        let stale = [LeafTriangle::ABSENT; 8];
        let pyramid = [PyramidBox::default(); 3];
        // A range up to `split` would have 2^32 triangles.
        assert_eq!(split, u32::MAX);
        assert_eq!(refit_node(node, split, &stale, &pyramid), node);
    }
}
