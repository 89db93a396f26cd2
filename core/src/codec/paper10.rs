//! The paper10 codec: 10 bits a plane between the decoded parent's planes, 10 bits a coordinate in the leaf's box.
//!
//! Floats decide here, so that every product is shielded from being fused with a sum, and the encoder asks the decoder.

use crate::build::node::{Node, NodeRef};
use crate::geometry::aabb::Aabb;
use crate::geometry::float::{abs, min, whole_number};
use crate::geometry::orientation::product;
use crate::geometry::planes::PlanePair;
use crate::geometry::ray::NO_PRIMITIVE;
use crate::geometry::triangle::LeafTriangle;
use crate::trace::{BoxCursor, Children, LeafRun, LeafSlot, NodeSource, Order, TriangleSource};
use bytemuck::{Pod, Zeroable};

/// The largest number of 10 bits.
const LAST: u32 = 1023;

/// A box as the codec decodes it. 24 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Paper10Box {
    /// Bytes 0–11: smallest coordinates.
    pub min: [f32; 3],
    /// Bytes 12–23: largest coordinates.
    pub max: [f32; 3],
}

impl Paper10Box {
    /// Nothing but the origin; all bits zero.
    pub const ZERO: Self = Self {
        min: [0.0; 3],
        max: [0.0; 3],
    };

    /// The same box.
    #[inline(always)]
    #[must_use]
    pub fn of(bounds: &Aabb) -> Self {
        Self {
            min: bounds.min.to_array(),
            max: bounds.max.to_array(),
        }
    }
}

/// A node: 24 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Paper10Node {
    /// Bytes 0–7: the left child's box, min then max: z, y and x, 10 bits each from bit 29 down.
    pub left_box: [u32; 2],
    /// Bytes 8–15: the right child's box.
    pub right_box: [u32; 2],
    /// Bytes 16–19: left child.
    pub left: NodeRef,
    /// Bytes 20–23: right child.
    pub right: NodeRef,
}

const _: () = assert!(size_of::<Paper10Node>() == 24);

impl Paper10Node {
    const EMPTY: Self = Self {
        left_box: [0; 2],
        right_box: [0; 2],
        left: NodeRef::EMPTY_LEAF,
        right: NodeRef::EMPTY_LEAF,
    };
}

/// The length of a cell between two planes.
#[inline(always)]
fn cell(low: f32, high: f32, opaque_zero: u32) -> f32 {
    product(high - low, 1.0 / LAST as f32, opaque_zero)
}

/// A number's place between two planes. Monotone; 0 is the lower plane and 1023 the upper one.
#[inline(always)]
fn decode(number: u32, low: f32, high: f32, opaque_zero: u32) -> f32 {
    let way = product(
        whole_number(number),
        cell(low, high, opaque_zero),
        opaque_zero,
    );
    let inner = min(low + way, high);
    if number == LAST { high } else { inner }
}

/// The largest number that is not above a coordinate, which lies between the planes, or one near it where the planes are so close
/// that several numbers come to lie in one place: the same on every device, where cells are a normal number long.
#[inline(always)]
fn number_below(x: f32, low: f32, high: f32, opaque_zero: u32) -> u32 {
    let (way, cell) = (x - low, cell(low, high, opaque_zero));
    let guess = if cell > 0.0 { way / cell } else { 0.0 };
    // Off by one at most: a few roundings, or the units that a GPU's division may have, are far less than a number.
    let mut number = min(guess, LAST as f32) as i32 as u32;
    if number > 0 && product(whole_number(number), cell, opaque_zero) > way {
        number -= 1;
    } else if number < LAST && product(whole_number(number + 1), cell, opaque_zero) <= way {
        number += 1;
    }
    // Now it is the same for every guess. The sum with a large plane may be rounded by more than a cell.
    if number > 0 && decode(number, low, high, opaque_zero) > x {
        number -= 1;
    } else if number < LAST && decode(number + 1, low, high, opaque_zero) <= x {
        number += 1;
    }
    // Whatever was rounded how: never inside.
    if decode(number, low, high, opaque_zero) > x {
        0
    } else {
        number
    }
}

/// The smallest number that is not below a coordinate, which lies between the planes.
#[inline(always)]
fn number_above(x: f32, low: f32, high: f32, opaque_zero: u32) -> u32 {
    let below = number_below(x, low, high, opaque_zero);
    let number = if below < LAST && decode(below, low, high, opaque_zero) < x {
        below + 1
    } else {
        below
    };
    // Cells may underflow to nothing.
    if decode(number, low, high, opaque_zero) < x {
        LAST
    } else {
        number
    }
}

/// A node, and its children's boxes as they come out of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EncodedPaper10 {
    /// What is stored.
    pub node: Paper10Node,
    /// The left child's box, decoded.
    pub left: Paper10Box,
    /// The right child's box, decoded.
    pub right: Paper10Box,
}

/// One thread per node. Reads its box, decoded, its children's boxes, which lie in it, and the plain node's links; `zero` is 0,
/// but only at run time. Returns the node.
#[inline]
#[must_use]
pub fn encode_paper10_node(
    parent: &Paper10Box,
    left: &Paper10Box,
    right: &Paper10Box,
    plain: &Node,
    opaque_zero: u32,
) -> EncodedPaper10 {
    let node = Paper10Node {
        left_box: encode_box(parent, left, opaque_zero),
        right_box: encode_box(parent, right, opaque_zero),
        left: plain.left,
        right: plain.right,
    };
    let [left, right] = decode_paper10_node(&node, parent, opaque_zero);
    EncodedPaper10 { node, left, right }
}

/// A child's box as it comes out of its parent, which has this box.
#[inline]
#[must_use]
pub fn paper10_child(parent: &Paper10Box, child: &Paper10Box, opaque_zero: u32) -> Paper10Box {
    decode_box(
        encode_box(parent, child, opaque_zero),
        parent,
        [0, 1, 2],
        opaque_zero,
    )
}

/// Both children's boxes, from a node and its own box, decoded.
#[inline]
#[must_use]
pub fn decode_paper10_node(
    node: &Paper10Node,
    parent: &Paper10Box,
    opaque_zero: u32,
) -> [Paper10Box; 2] {
    let axes = [0, 1, 2];
    [
        decode_box(node.left_box, parent, axes, opaque_zero),
        decode_box(node.right_box, parent, axes, opaque_zero),
    ]
}

#[inline(always)]
fn encode_box(parent: &Paper10Box, child: &Paper10Box, opaque_zero: u32) -> [u32; 2] {
    let ([a, b, c], [d, e, f]) = (parent.min, parent.max);
    let ([u, v, w], [x, y, z]) = (child.min, child.max);
    [
        number_below(u, a, d, opaque_zero)
            | number_below(v, b, e, opaque_zero) << 10
            | number_below(w, c, f, opaque_zero) << 20,
        number_above(x, a, d, opaque_zero)
            | number_above(y, b, e, opaque_zero) << 10
            | number_above(z, c, f, opaque_zero) << 20,
    ]
}

/// A child's box from its words, coordinates in the order of the axes, as the parent's are.
#[inline(always)]
fn decode_box(
    words: [u32; 2],
    parent: &Paper10Box,
    axes: [u32; 3],
    opaque_zero: u32,
) -> Paper10Box {
    let [min, max] = words;
    Paper10Box {
        min: decode_point(min, parent, axes, opaque_zero),
        max: decode_point(max, parent, axes, opaque_zero),
    }
}

/// A point in a box from its word, coordinates in the order of the axes, as the box's are.
#[inline(always)]
fn decode_point(word: u32, bounds: &Paper10Box, axes: [u32; 3], opaque_zero: u32) -> [f32; 3] {
    let number = |axis: u32| (word >> (10 * axis)) & LAST;
    let ([a, b, c], [d, e, f]) = (bounds.min, bounds.max);
    [
        decode(number(axes[0]), a, d, opaque_zero),
        decode(number(axes[1]), b, e, opaque_zero),
        decode(number(axes[2]), c, f, opaque_zero),
    ]
}

/// A node or a leaf, and its box, coordinates in the order of the ray's axes. 28 bytes.
#[derive(Clone, Copy, Debug)]
pub struct Paper10Cursor {
    /// Which.
    pub node: NodeRef,
    /// Its box, decoded.
    pub bounds: Paper10Box,
}

impl BoxCursor for Paper10Cursor {
    #[inline(always)]
    fn new(node: NodeRef, min: [f32; 3], max: [f32; 3]) -> Self {
        Self {
            node,
            bounds: Paper10Box { min, max },
        }
    }

    #[inline(always)]
    fn node(&self) -> NodeRef {
        self.node
    }

    #[inline(always)]
    fn corners(&self) -> [[f32; 3]; 2] {
        [self.bounds.min, self.bounds.max]
    }
}

/// Nodes of the paper10 codec, the root first.
#[derive(Clone, Copy)]
pub struct Paper10Nodes<'a> {
    /// The nodes.
    pub nodes: &'a [Paper10Node],
    /// The root's box.
    pub root: Paper10Box,
    /// Always 0, hidden from the compiler so that it cannot fuse a product with a sum.
    pub opaque_zero: u32,
}

impl NodeSource for Paper10Nodes<'_> {
    type Cursor = Paper10Cursor;
    type Node = Children<Paper10Cursor>;
    type Bounds = Paper10Box;

    const NOTHING: Paper10Cursor = Paper10Cursor {
        node: NodeRef::EMPTY_LEAF,
        bounds: Paper10Box::ZERO,
    };

    #[inline(always)]
    fn root(&self, axes: [u32; 3]) -> Paper10Cursor {
        let ordered = |v: [f32; 3]| {
            [
                v[axes[0] as usize % 3],
                v[axes[1] as usize % 3],
                v[axes[2] as usize % 3],
            ]
        };
        Paper10Cursor {
            node: if self.nodes.is_empty() {
                NodeRef::EMPTY_LEAF
            } else {
                NodeRef::inner(0)
            },
            bounds: Paper10Box {
                min: ordered(self.root.min),
                max: ordered(self.root.max),
            },
        }
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: Paper10Cursor) -> bool {
        cursor.node.is_leaf()
    }

    #[inline(always)]
    fn leaf(&self, cursor: Paper10Cursor, _axes: [u32; 3]) -> LeafRun<Paper10Box> {
        LeafRun::of(cursor.node, cursor.bounds)
    }

    #[inline(always)]
    fn resume(&self, waited: Paper10Cursor) -> Paper10Cursor {
        waited
    }

    #[inline(always)]
    fn children(
        &self,
        cursor: Paper10Cursor,
        Order { axes, .. }: Order,
    ) -> Children<Paper10Cursor> {
        let node = crate::load(self.nodes, cursor.node.index(), Paper10Node::EMPTY);
        let a = decode_box(node.left_box, &cursor.bounds, axes, self.opaque_zero);
        let b = decode_box(node.right_box, &cursor.bounds, axes, self.opaque_zero);
        let planes = |i: usize| PlanePair::new(a.min[i], b.min[i], a.max[i], b.max[i]);
        Children {
            planes: [planes(0), planes(1), planes(2)],
            left: Paper10Cursor {
                node: node.left,
                bounds: a,
            },
            right: Paper10Cursor {
                node: node.right,
                bounds: b,
            },
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.nodes.len() as u32 + 1
    }
}

/// A triangle in its leaf's box. 16 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Paper10Triangle {
    /// Bytes 0–11: v0, v1 and v2: z, y and x, 10 bits each from bit 29 down.
    pub vertices: [u32; 3],
    /// Bytes 12–15: the caller's index.
    pub primitive: u32,
}

const _: () = assert!(size_of::<Paper10Triangle>() == 16);

/// One thread per triangle. Reads it and its leaf's box, decoded, in which it lies; `opaque_zero` is 0. Returns
/// it with every coordinate moved to the nearest of those that there are in the box.
#[inline]
#[must_use]
pub fn encode_paper10_triangle(
    triangle: &LeafTriangle,
    bounds: &Paper10Box,
    opaque_zero: u32,
) -> Paper10Triangle {
    let v = &triangle.vertices;
    Paper10Triangle {
        vertices: [
            encode_vertex([v[0], v[1], v[2]], bounds, opaque_zero),
            encode_vertex([v[3], v[4], v[5]], bounds, opaque_zero),
            encode_vertex([v[6], v[7], v[8]], bounds, opaque_zero),
        ],
        primitive: triangle.primitive,
    }
}

#[inline(always)]
fn encode_vertex([x, y, z]: [f32; 3], bounds: &Paper10Box, opaque_zero: u32) -> u32 {
    let ([a, b, c], [d, e, f]) = (bounds.min, bounds.max);
    nearest(x, a, d, opaque_zero)
        | nearest(y, b, e, opaque_zero) << 10
        | nearest(z, c, f, opaque_zero) << 20
}

/// The number of the nearest of those coordinates that there are between two planes.
#[inline(always)]
fn nearest(x: f32, low: f32, high: f32, opaque_zero: u32) -> u32 {
    let below = number_below(x, low, high, opaque_zero);
    let above = if below < LAST { below + 1 } else { below };
    let to_below = abs(x - decode(below, low, high, opaque_zero));
    let to_above = abs(decode(above, low, high, opaque_zero) - x);
    if to_above < to_below { above } else { below }
}

/// Triangles of the paper10 codec.
#[derive(Clone, Copy)]
pub struct Paper10Triangles<'a> {
    /// The triangles, in leaf order.
    pub triangles: &'a [Paper10Triangle],
    /// Always 0, hidden from the compiler so that it cannot fuse a product with a sum.
    pub opaque_zero: u32,
}

impl TriangleSource<Paper10Box> for Paper10Triangles<'_> {
    #[inline(always)]
    fn corners(&self, slot: &LeafSlot<Paper10Box>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let at = slot.first.wrapping_add(slot.number);
        let Paper10Triangle { vertices, .. } = crate::load(
            self.triangles,
            at,
            Paper10Triangle {
                vertices: [0; 3],
                primitive: NO_PRIMITIVE,
            },
        );
        let vertex = |word: u32| decode_point(word, &slot.bounds, axes, self.opaque_zero);
        [
            vertex(vertices[0]),
            vertex(vertices[1]),
            vertex(vertices[2]),
        ]
    }

    #[inline(always)]
    fn primitive(&self, slot: &LeafSlot<Paper10Box>) -> u32 {
        let at = slot.first.wrapping_add(slot.number) as usize;
        if at < self.triangles.len() {
            self.triangles[at].primitive
        } else {
            NO_PRIMITIVE
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Coordinates as scenes have them at magnitude 1, tiny ones among them.
    fn coordinate() -> impl Strategy<Value = f32> {
        prop_oneof![
            -1.0f32..1.0,
            -1e-6f32..1e-6,
            Just(0.0),
            (-1.0f32..1.0).prop_map(|x| 0.75 + x * 1e-6),
            (-126i32..0, -16i32..=16).prop_map(|(e, ulps)| f32::from_bits(
                (2f32.powi(e).to_bits() as i32 + ulps) as u32
            )),
        ]
    }

    fn any_box() -> impl Strategy<Value = Paper10Box> {
        proptest::array::uniform3((coordinate(), coordinate())).prop_map(|axes| Paper10Box {
            min: axes.map(|(a, b)| a.min(b)),
            max: axes.map(|(a, b)| a.max(b)),
        })
    }

    /// The smaller of both planes at each side, and the boxes themselves.
    fn family() -> impl Strategy<Value = [Paper10Box; 3]> {
        (any_box(), any_box(), any_box()).prop_map(|(a, b, slack)| {
            let mut parent = a;
            for axis in 0..3 {
                for other in [b, slack] {
                    parent.min[axis] = parent.min[axis].min(other.min[axis]);
                    parent.max[axis] = parent.max[axis].max(other.max[axis]);
                }
            }
            [parent, a, b]
        })
    }

    fn contains(a: &Paper10Box, b: &Paper10Box) -> bool {
        (0..3).all(|axis| a.min[axis] <= b.min[axis] && a.max[axis] >= b.max[axis])
    }

    proptest! {
        #[test]
        fn decoded_boxes_hold_the_children_and_stay_in_the_parent([parent, left, right] in family()) {
            let plain = Node { left: NodeRef::leaf(3, 2), right: NodeRef::inner(9), ..Node::EMPTY };
            let coded = encode_paper10_node(&parent, &left, &right, &plain, 0);
            prop_assert_eq!((coded.node.left, coded.node.right), (plain.left, plain.right));
            for (decoded, exact) in [coded.left, coded.right].iter().zip([left, right]) {
                prop_assert_eq!(&paper10_child(&parent, &exact, 0), decoded);
                prop_assert!(contains(decoded, &exact), "{decoded:?} {exact:?}");
                prop_assert!(contains(&parent, decoded));
                for axis in 0..3 {
                    // Within a cell and the roundings of its ends.
                    let extent = f64::from(parent.max[axis]) - f64::from(parent.min[axis]);
                    let largest = parent.min[axis].abs().max(parent.max[axis].abs());
                    let cell = extent / 1023.0 * 1.001 + 4.0 * f64::from(largest) * 2f64.powi(-24) + 1e-37;
                    prop_assert!(f64::from(exact.min[axis]) - f64::from(decoded.min[axis]) <= cell);
                    prop_assert!(f64::from(decoded.max[axis]) - f64::from(exact.max[axis]) <= cell);
                }
            }
        }

        #[test]
        fn cells_that_underflow_are_outside_too(ends in proptest::array::uniform4(-3000i32..3000)) {
            let [a, b, c, d] = ends.map(|steps| steps as f32 * f32::from_bits(1));
            let bounds = |a: f32, b: f32| Paper10Box { min: [a.min(b); 3], max: [a.max(b); 3] };
            let child = bounds(a, b);
            let parent = bounds(c.min(child.min[0]), d.max(child.max[0]));
            let decoded = paper10_child(&parent, &child, 0);
            prop_assert!(contains(&decoded, &child) && contains(&parent, &decoded), "{decoded:?} {child:?} {parent:?}");
        }

        #[test]
        fn triangles_stay_in_their_box_and_move_half_a_cell(bounds in any_box(), weights in proptest::array::uniform9(0.0f32..=1.0), primitive: u32) {
            let mut triangle = LeafTriangle { primitive, ..LeafTriangle::default() };
            for (i, (to, weight)) in triangle.vertices.iter_mut().zip(weights).enumerate() {
                let (low, high) = (bounds.min[i % 3], bounds.max[i % 3]);
                *to = (low + (high - low) * weight).clamp(low, high);
            }
            let own = [encode_paper10_triangle(&triangle, &bounds, 0)];
            let source = Paper10Triangles { triangles: &own, opaque_zero: 0 };
            let slot = LeafSlot { first: 0, number: 0, count: 1, bounds };
            prop_assert_eq!(source.primitive(&slot), primitive);
            let corners = source.corners(&slot, [0, 1, 2]);
            for i in 0..9 {
                let (low, high) = (bounds.min[i % 3], bounds.max[i % 3]);
                let x = corners[i / 3][i % 3];
                prop_assert!((low..=high).contains(&x));
                let largest = f64::from(low.abs().max(high.abs()));
                let half = (f64::from(high) - f64::from(low)) / 2046.0 * 1.001 + 4.0 * largest * 2f64.powi(-24) + 1e-37;
                prop_assert!((f64::from(x) - f64::from(triangle.vertices[i])).abs() <= half);
            }
        }

        #[test]
        fn numbers_are_monotone(a in coordinate(), b in coordinate(), number in 0..LAST) {
            let (low, high) = (a.min(b), a.max(b));
            prop_assert!(decode(number, low, high, 0) <= decode(number + 1, low, high, 0));
            prop_assert_eq!([decode(0, low, high, 0), decode(LAST, low, high, 0)], [low, high]);
        }
    }
}
