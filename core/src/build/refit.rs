//! Stage `refit`: every node's boxes from its triangles, each node on its own, over a pyramid of boxes.
//!
//! Level 0 of the pyramid holds the box of each [`GROUP_SIZE`] triangles in leaf order, each further level that of two
//! entries of the level below; the last entry of an odd level goes up alone. A node covers a run of leaves, so its children's
//! boxes are unions of few entries: no order among the nodes, no atomics. `min` and `max` are exact, so any grouping gives the
//! same bits.

use crate::build::node::{Node, NodeRef};
use crate::geometry::aabb::Aabb;
use crate::geometry::triangle::LeafTriangle;
use crate::launch::LANES;
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// Triangles in an entry of the pyramid's level 0.
pub const GROUP_SIZE: u32 = 8;

/// Levels of the pyramid that a workgroup makes: that of its lanes, and one for each time that these are halved.
pub const GROUP_LEVELS: u32 = 1 + LANES.ilog2();

/// An entry of the pyramid. 32 bytes: min, unused, max, unused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(transparent)]
pub struct PyramidBox(pub [f32; 8]);

impl PyramidBox {
    /// The box of no triangles.
    pub const EMPTY: Self = Self([
        f32::MAX,
        f32::MAX,
        f32::MAX,
        0.0,
        -f32::MAX,
        -f32::MAX,
        -f32::MAX,
        0.0,
    ]);
}

/// A level of the pyramid, whose levels lie one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Level {
    /// Its first entry in the pyramid.
    pub begin: u32,
    /// How many entries it has; 0 above the top.
    pub count: u32,
}

impl Level {
    /// Level 0 over this many triangles.
    #[inline(always)]
    #[must_use]
    pub const fn lowest(triangle_count: u32) -> Self {
        Self {
            begin: 0,
            count: triangle_count.div_ceil(GROUP_SIZE),
        }
    }

    /// The next level.
    #[inline(always)]
    #[must_use]
    pub const fn above(self) -> Self {
        Self {
            begin: self.begin + self.count,
            count: if self.count > 1 {
                self.count.div_ceil(2)
            } else {
                0
            },
        }
    }
}

/// How many entries all levels have together, over this many triangles.
#[must_use]
pub const fn pyramid_size(triangle_count: u32) -> u32 {
    let mut level = Level::lowest(triangle_count);
    while level.count > 0 {
        level = level.above();
    }
    level.begin
}

/// A box in vectors of four, the last lane unused.
#[derive(Clone, Copy, Debug)]
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
    pub(crate) fn around(bounds: Aabb) -> Self {
        Self {
            min: bounds.min.extend(0.0),
            max: bounds.max.extend(0.0),
        }
    }

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
        Self::of(crate::load(pyramid, i, PyramidBox([0.0; 8])))
    }

    #[inline(always)]
    fn of(PyramidBox(p): PyramidBox) -> Self {
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
pub fn parent_bounds(entry: u32, below: Level, pyramid: &[PyramidBox]) -> PyramidBox {
    let left = 2 * entry;
    let right = if left + 1 < below.count {
        left + 1
    } else {
        left
    };
    WideBox::of_entry(below.begin + left, pyramid)
        .union(WideBox::of_entry(below.begin + right, pyramid))
        .entry()
}

/// Workgroup step, where each lane begins with a box: at each step with `distance` = 1, 2, 4 … LANES/2 every lane below
/// LANES / 2 / `distance` stores this at `2 * distance * lane`. After it these places hold the boxes of the next level, in
/// order. Returns the union of two neighbours.
#[inline(always)]
#[must_use]
pub fn pair_step<const LANES: usize>(
    lane: u32,
    distance: u32,
    boxes: &[PyramidBox; LANES],
) -> PyramidBox {
    let left = pair_place(lane, distance);
    let right = left + distance;
    WideBox::of(boxes[left as usize % LANES])
        .union(WideBox::of(boxes[right as usize % LANES]))
        .entry()
}

/// Where a lane stores the result of [`pair_step`].
#[inline(always)]
#[must_use]
pub const fn pair_place(lane: u32, distance: u32) -> u32 {
    2 * distance * lane
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
    let mut level = Level::lowest(triangles.len() as u32);
    for _ in 0..32u32 {
        if low >= high {
            break;
        }
        if low & 1 == 1 {
            bounds = bounds.union(WideBox::of_entry(level.begin + low, pyramid));
            low += 1;
        }
        if high & 1 == 1 {
            high -= 1;
            bounds = bounds.union(WideBox::of_entry(level.begin + high, pyramid));
        }
        low /= 2;
        high /= 2;
        level = level.above();
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
    use proptest::prelude::*;
    use std::vec::Vec;

    #[test]
    fn odd_levels_go_up_alone_to_one_entry() {
        let mut level = Level::lowest(8 * 5 + 1);
        let mut levels = Vec::new();
        while level.count > 0 {
            levels.push((level.begin, level.count));
            level = level.above();
        }
        assert_eq!(levels, [(0, 6), (6, 3), (9, 2), (11, 1)]);
        assert_eq!([0, 1, 8, 9, 41].map(pyramid_size), [0, 1, 1, 3, 12]);
    }

    proptest! {
        #[test]
        fn the_steps_of_a_workgroup_make_the_levels_above(values in proptest::collection::vec(-1f32..1.0, 1..=64)) {
            let boxed = |x: f32| PyramidBox([x, -x, x / 2.0, 0.0, x, 1.0, 2.0 * x, 0.0]);
            let mut pyramid: Vec<PyramidBox> = values.iter().map(|&x| boxed(x)).collect();
            let mut level = Level { begin: 0, count: pyramid.len() as u32 };
            let mut boxes = [PyramidBox::EMPTY; 64];
            boxes[..pyramid.len()].copy_from_slice(&pyramid);
            for step in 0..6 {
                let (distance, lanes) = (1 << step, 32 >> step);
                for lane in 0..lanes {
                    boxes[pair_place(lane, distance) as usize] = pair_step(lane, distance, &boxes);
                }
                let next = level.above();
                for entry in 0..next.count {
                    pyramid.push(parent_bounds(entry, level, &pyramid));
                    prop_assert_eq!(boxes[pair_place(entry, distance) as usize], pyramid[pyramid.len() - 1]);
                }
                level = next;
            }
            prop_assert_eq!(level.count, u32::from(values.len() > 32));
        }
    }

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
