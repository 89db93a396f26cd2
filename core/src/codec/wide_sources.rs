//! The traversal's source of wide nodes on the lattice. They are decoded in floats, exactly: planes are whole numbers of steps.
//!
//! ```text
//! lower = origin + number·cell                   cell = step·2^shift
//! upper = origin + extent·step − number·cell     in nodes of 64 bytes
//! upper = origin + cell + number·cell            in nodes of 48 bytes
//! ```
//!
//! Where no more than 24 bits are needed, no operation is rounded, fused or not. An upper plane beyond 2^24 steps may be, but
//! rounding is monotone and children's planes have 24 bits: it still lies beyond what it must hold.

use super::leaf_width::{LeafFrame, LeafWidth};
use super::packed_wide_node::PackedWideNode;
use super::wide_axis::{SHIFT_BITS, WideAxis};
use super::wide_links::WideLinks;
use super::wide_node::WideNode;
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use crate::geometry::lattice::LatticeBox;
use crate::geometry::planes::PlanePair;
use crate::geometry::slab::CodedPlanes;
use crate::trace::{LeafRun, NodeSource, Order, WideFork, WideRef, child_count, in_order};
use bytemuck::{Pod, Zeroable};
use glam::{UVec4, Vec4};

/// A [`super::WideNode`] as rows. 64 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct WideRow {
    /// Its axes.
    pub axes: [UVec4; 3],
    /// Its children.
    pub children: [u32; WIDTH],
}

const _: () = assert!(size_of::<WideRow>() == size_of::<WideNode>());
const _: () = assert!(size_of::<PackedWideRow>() == size_of::<PackedWideNode>());

/// A [`super::PackedWideNode`] as rows: its axes.
pub type PackedWideRow = [UVec4; 3];

/// The planes of one axis' children: those that a ray meets first, and the others. `IS_EXACT` in nodes of 64 bytes.
#[inline(always)]
fn planes<const IS_EXACT: bool>(axis: UVec4, reversed: u32, step: f32) -> [CodedPlanes; 2] {
    let shift = axis.w & ((1 << SHIFT_BITS) - 1);
    // A step is a power of two: its bits are those of its exponent.
    let cell = step.to_bits().wrapping_add(shift << 23);
    let origin = f32::from_bits(axis.x);
    let end = if IS_EXACT {
        origin + (axis.w >> SHIFT_BITS) as f32 * step
    } else {
        origin + f32::from_bits(cell)
    };
    let (first, second) = if reversed == 0 {
        ((axis.y, origin), (axis.z, end))
    } else {
        ((axis.z, end), (axis.y, origin))
    };
    // Where upper planes count down from the end, their cells are negative.
    let sign = if IS_EXACT { reversed << 31 } else { 0 };
    let cell = f32::from_bits(cell ^ sign);
    let coded = |(numbers, base), cell: f32| CodedPlanes {
        numbers: numbers_of(numbers),
        base,
        cell,
    };
    let second_cell = if IS_EXACT { -cell } else { cell };
    [coded(first, cell), coded(second, second_cell)]
}

/// The numbers of all children.
#[inline(always)]
fn numbers_of(bytes: u32) -> Vec4 {
    let number = |child: u32| (bytes >> (8 * child) & 0xff) as f32;
    Vec4::new(number(0), number(1), number(2), number(3))
}

/// All axes' planes, in the rays' order.
#[inline(always)]
fn all_planes<const IS_EXACT: bool>(
    [a, b, c]: [UVec4; 3],
    reversed: [u32; 3],
    step: f32,
) -> ([CodedPlanes; 3], [CodedPlanes; 3]) {
    let [a, d] = planes::<IS_EXACT>(a, reversed[0], step);
    let [b, e] = planes::<IS_EXACT>(b, reversed[1], step);
    let [c, f] = planes::<IS_EXACT>(c, reversed[2], step);
    ([a, b, c], [d, e, f])
}

/// An axis of a node, from its row.
#[inline(always)]
const fn axis_of(row: UVec4) -> WideAxis {
    WideAxis {
        origin: f32::from_bits(row.x),
        lower: row.y,
        upper: row.z,
        scale: row.w,
    }
}

/// A child's smallest coordinate.
#[inline(always)]
fn smallest(axis: &WideAxis, child: u32, step: f32) -> f32 {
    let [lower, _] = axis.numbers(child);
    axis.origin + (lower << axis.shift()) as f32 * step
}

/// The planes of a box, twice.
#[inline(always)]
fn twice(bounds: &LatticeBox, step: f32, axes: [u32; 3]) -> [PlanePair; 3] {
    let ([a, b, c], [x, y, z]) = (bounds.min, bounds.max);
    let min = in_order([a as f32 * step, b as f32 * step, c as f32 * step], axes);
    let max = in_order([x as f32 * step, y as f32 * step, z as f32 * step], axes);
    [
        PlanePair::new(min[0], min[0], max[0], max[0]),
        PlanePair::new(min[1], min[1], max[1], max[1]),
        PlanePair::new(min[2], min[2], max[2], max[2]),
    ]
}

/// Wide nodes of 64 bytes with triangles in full, the root first.
#[derive(Clone, Copy)]
pub struct WideNodes<'a> {
    /// Nodes.
    pub nodes: &'a [WideRow],
    /// The root's box.
    pub root: LatticeBox,
    /// The lattice's step, a power of two.
    pub step: f32,
}

impl NodeSource for WideNodes<'_> {
    type Cursor = NodeRef;
    type Node = WideFork<CodedPlanes>;
    type Bounds = ();

    const NOTHING: NodeRef = NodeRef::EMPTY_LEAF;
    const TESTS_ROOT: bool = true;

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) -> NodeRef {
        NodeRef::inner(0)
    }

    #[inline(always)]
    fn root_planes(&self, axes: [u32; 3]) -> [PlanePair; 3] {
        twice(&self.root, self.step, axes)
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: NodeRef) -> bool {
        // Leaves have the highest bit. The same comparison answers for an index out of range, which is opened by no walk.
        cursor.index() as usize >= self.nodes.len()
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef, _axes: [u32; 3]) -> LeafRun<()> {
        LeafRun::of(cursor, ())
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, order: Order) -> WideFork<CodedPlanes> {
        let (node, index) = (cursor.index(), cursor.index() as usize);
        let [a, b, c] = order.axes;
        let rows = [
            self.nodes[index].axes[a.min(2) as usize],
            self.nodes[index].axes[b.min(2) as usize],
            self.nodes[index].axes[c.min(2) as usize],
        ];
        let (first, second) = all_planes::<true>(rows, order.reversed, self.step);
        WideFork {
            first,
            second,
            node,
            count: child_count(self.nodes[index].children),
        }
    }

    #[inline(always)]
    fn resume(&self, waited: WideRef) -> NodeRef {
        reference(self.nodes, waited)
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.nodes.len() as u32 + 1
    }
}

/// A child's reference.
#[inline(always)]
fn reference(nodes: &[WideRow], child: WideRef) -> NodeRef {
    let index = child.node() as usize;
    if index < nodes.len() {
        NodeRef(nodes[index].children[child.child() as usize])
    } else {
        NodeRef::EMPTY_LEAF
    }
}

/// Wide nodes of 64 bytes with triangles on the lattice, the root first.
#[derive(Clone, Copy)]
pub struct WideMixedNodes<'a> {
    /// Nodes.
    pub nodes: &'a [WideRow],
    /// The root's box.
    pub root: LatticeBox,
    /// The lattice's step, a power of two.
    pub step: f32,
}

/// A child out of range: a leaf without triangles.
const NO_CHILD: NodeRef = NodeRef(u32::MAX);

/// The cursor of a child with this reference.
#[inline(always)]
const fn named(reference: NodeRef, child: WideRef) -> NodeRef {
    if reference.is_leaf() {
        child.leaf()
    } else {
        reference
    }
}

impl NodeSource for WideMixedNodes<'_> {
    type Cursor = NodeRef;
    type Node = WideFork<CodedPlanes>;
    type Bounds = LeafFrame;

    const NOTHING: NodeRef = NO_CHILD;
    const TESTS_ROOT: bool = true;

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) -> NodeRef {
        first_node(self.nodes)
    }

    #[inline(always)]
    fn root_planes(&self, axes: [u32; 3]) -> [PlanePair; 3] {
        twice(&self.root, self.step, axes)
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: NodeRef) -> bool {
        cursor.index() as usize >= self.nodes.len()
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef, axes: [u32; 3]) -> LeafRun<LeafFrame> {
        let child = WideRef::of_leaf(cursor);
        let index = child.node() as usize;
        if index >= self.nodes.len() {
            return NO_LEAF;
        }
        let axes = [
            axis_of(self.nodes[index].axes[axes[0].min(2) as usize]),
            axis_of(self.nodes[index].axes[axes[1].min(2) as usize]),
            axis_of(self.nodes[index].axes[axes[2].min(2) as usize]),
        ];
        let extent = |axis: &WideAxis| {
            let [low, high] = axis.planes(child.child());
            high.wrapping_sub(low)
        };
        let [a, b, c] = &axes;
        let width = LeafWidth::of_extents([extent(a), extent(b), extent(c)]);
        let bounds = frame(&axes, child, width, self.step);
        let reference = reference(self.nodes, child);
        LeafRun {
            // Children out of order name inner nodes as leaves.
            count: if reference.is_leaf() {
                reference.count()
            } else {
                0
            },
            ..LeafRun::of(reference, bounds)
        }
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, order: Order) -> WideFork<CodedPlanes> {
        let (node, index) = (cursor.index(), cursor.index() as usize);
        let [a, b, c] = order.axes;
        let rows = [
            self.nodes[index].axes[a.min(2) as usize],
            self.nodes[index].axes[b.min(2) as usize],
            self.nodes[index].axes[c.min(2) as usize],
        ];
        let (first, second) = all_planes::<true>(rows, order.reversed, self.step);
        WideFork {
            first,
            second,
            node,
            count: child_count(self.nodes[index].children),
        }
    }

    #[inline(always)]
    fn resume(&self, waited: WideRef) -> NodeRef {
        if waited.node() as usize >= self.nodes.len() {
            return NO_CHILD;
        }
        named(reference(self.nodes, waited), waited)
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.nodes.len() as u32 + 1
    }
}

/// The root, where there is one.
#[inline(always)]
const fn first_node<T>(nodes: &[T]) -> NodeRef {
    if nodes.is_empty() {
        NO_CHILD
    } else {
        NodeRef::inner(0)
    }
}

const NO_LEAF: LeafRun<LeafFrame> = LeafRun {
    first: 0,
    count: 0,
    bounds: LeafFrame {
        min: Vec4::ZERO,
        width: LeafWidth::Narrow,
    },
};

/// What a leaf's triangles are decoded relative to.
#[inline(always)]
fn frame([a, b, c]: &[WideAxis; 3], child: WideRef, width: LeafWidth, step: f32) -> LeafFrame {
    let smallest = |axis: &WideAxis| smallest(axis, child.child(), step);
    LeafFrame {
        min: Vec4::new(smallest(a), smallest(b), smallest(c), 0.0),
        width,
    }
}

/// Wide nodes of 48 bytes, the root first. Triangles lie on the lattice.
#[derive(Clone, Copy)]
pub struct PackedWideNodes<'a> {
    /// Nodes.
    pub nodes: &'a [PackedWideRow],
    /// The root's box.
    pub root: LatticeBox,
    /// The lattice's step, a power of two.
    pub step: f32,
}

impl PackedWideNodes<'_> {
    #[inline(always)]
    fn links(&self, index: usize) -> WideLinks {
        let rows = &self.nodes[index];
        WideLinks::from_words([rows[0].w, rows[1].w, rows[2].w])
    }
}

impl NodeSource for PackedWideNodes<'_> {
    type Cursor = NodeRef;
    type Node = WideFork<CodedPlanes>;
    type Bounds = LeafFrame;

    const NOTHING: NodeRef = NO_CHILD;
    const TESTS_ROOT: bool = true;

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) -> NodeRef {
        first_node(self.nodes)
    }

    #[inline(always)]
    fn root_planes(&self, axes: [u32; 3]) -> [PlanePair; 3] {
        twice(&self.root, self.step, axes)
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: NodeRef) -> bool {
        cursor.index() as usize >= self.nodes.len()
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef, axes: [u32; 3]) -> LeafRun<LeafFrame> {
        let child = WideRef::of_leaf(cursor);
        let index = child.node() as usize;
        if index >= self.nodes.len() {
            return NO_LEAF;
        }
        let axes = [
            axis_of(self.nodes[index][axes[0].min(2) as usize]),
            axis_of(self.nodes[index][axes[1].min(2) as usize]),
            axis_of(self.nodes[index][axes[2].min(2) as usize]),
        ];
        let links = self.links(index);
        let width = links.width(child.child());
        LeafRun::of(
            links.child(child.child()),
            frame(&axes, child, width, self.step),
        )
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, order: Order) -> WideFork<CodedPlanes> {
        let (node, index) = (cursor.index(), cursor.index() as usize);
        let [a, b, c] = order.axes;
        let rows = [
            self.nodes[index][a.min(2) as usize],
            self.nodes[index][b.min(2) as usize],
            self.nodes[index][c.min(2) as usize],
        ];
        let (first, second) = all_planes::<false>(rows, order.reversed, self.step);
        WideFork {
            first,
            second,
            node,
            count: self.links(index).count(),
        }
    }

    #[inline(always)]
    fn resume(&self, waited: WideRef) -> NodeRef {
        let index = waited.node() as usize;
        if index >= self.nodes.len() {
            return NO_CHILD;
        }
        let links = self.links(index);
        if links.is_inner(waited.child()) {
            NodeRef::inner(links.inner_child(waited.child()))
        } else {
            waited.leaf()
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.nodes.len() as u32 + 1
    }
}
