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
use super::packed_links::PackedLinks;
use super::packed_wide_node::PackedWideNode;
use super::wide_axis::{SHIFT_BITS, WideAxis};
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

/// The same, whose leaves' triangles lie on the lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct MixedWideRow(pub WideRow);

/// A [`super::PackedWideNode`] as rows: its axes.
pub type PackedWideRow = [UVec4; 3];

/// The planes of one axis' children: those that a ray meets first, and the others.
#[inline(always)]
fn planes(is_exact: bool, axis: UVec4, reversed: u32, step: f32) -> (CodedPlanes, CodedPlanes) {
    let shift = axis.w & ((1 << SHIFT_BITS) - 1);
    // A step is a power of two: its bits are those of its exponent.
    let cell = step.to_bits().wrapping_add(shift << 23);
    let origin = f32::from_bits(axis.x);
    let end = if is_exact {
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
    let sign = if is_exact { reversed << 31 } else { 0 };
    let cell = f32::from_bits(cell ^ sign);
    let coded = |(numbers, base), cell: f32| CodedPlanes {
        numbers: numbers_of(numbers),
        base,
        cell,
    };
    let second_cell = if is_exact { -cell } else { cell };
    (coded(first, cell), coded(second, second_cell))
}

/// The numbers of all children.
#[inline(always)]
fn numbers_of(bytes: u32) -> Vec4 {
    let number = |child: u32| (bytes >> (8 * child) & 0xff) as f32;
    Vec4::new(number(0), number(1), number(2), number(3))
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

/// What wide nodes on the lattice differ in: how they name their children.
pub trait LatticeRow: Copy {
    /// What a leaf's triangles are decoded relative to.
    type Bounds: Copy;

    /// [`NodeSource::NOTHING`].
    const NOTHING: NodeRef;

    /// Whether the node's upper sides are exact, and its upper planes counted down from them.
    const IS_EXACT: bool;

    /// The row of an axis.
    fn axis(&self, axis: u32) -> UVec4;

    /// How many children there are.
    fn count(&self) -> u32;

    /// A child as it is walked to.
    fn child(&self, child: WideRef) -> NodeRef;

    /// [`NodeSource::leaf`].
    fn leaf(nodes: &[Self], cursor: NodeRef, axes: [u32; 3], step: f32) -> LeafRun<Self::Bounds>;
}

/// Wide nodes on the lattice, the root first.
#[derive(Clone, Copy)]
pub struct LatticeWideNodes<'a, R> {
    /// Nodes.
    pub nodes: &'a [R],
    /// The root's box.
    pub root: LatticeBox,
    /// The lattice's step, a power of two.
    pub step: f32,
}

/// Wide nodes of 64 bytes with triangles in full.
pub type WideNodes<'a> = LatticeWideNodes<'a, WideRow>;

/// Wide nodes of 64 bytes with triangles on the lattice.
pub type WideMixedNodes<'a> = LatticeWideNodes<'a, MixedWideRow>;

/// Wide nodes of 48 bytes, with triangles on the lattice whose corners are shared.
pub type PackedWideNodes<'a> = LatticeWideNodes<'a, PackedWideRow>;

impl<R: LatticeRow> NodeSource for LatticeWideNodes<'_, R> {
    type Cursor = NodeRef;
    type Node = WideFork<CodedPlanes>;
    type Bounds = R::Bounds;

    const NOTHING: NodeRef = R::NOTHING;
    const TESTS_ROOT: bool = true;

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) -> NodeRef {
        if self.nodes.is_empty() {
            R::NOTHING
        } else {
            NodeRef::inner(0)
        }
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
    fn leaf(&self, cursor: NodeRef, axes: [u32; 3]) -> LeafRun<R::Bounds> {
        R::leaf(self.nodes, cursor, axes, self.step)
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, order: Order) -> WideFork<CodedPlanes> {
        let (node, index) = (cursor.index(), cursor.index() as usize);
        let [a, b, c] = order.axes;
        let rows = [
            self.nodes[index].axis(a),
            self.nodes[index].axis(b),
            self.nodes[index].axis(c),
        ];
        let [(a, d), (b, e), (c, f)] = [
            planes(R::IS_EXACT, rows[0], order.reversed[0], self.step),
            planes(R::IS_EXACT, rows[1], order.reversed[1], self.step),
            planes(R::IS_EXACT, rows[2], order.reversed[2], self.step),
        ];
        WideFork {
            first: [a, b, c],
            second: [d, e, f],
            node,
            count: self.nodes[index].count(),
        }
    }

    #[inline(always)]
    fn resume(&self, waited: WideRef) -> NodeRef {
        let index = waited.node() as usize;
        if index < self.nodes.len() {
            self.nodes[index].child(waited)
        } else {
            R::NOTHING
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.nodes.len() as u32 + 1
    }
}

impl LatticeRow for WideRow {
    type Bounds = ();

    const NOTHING: NodeRef = NodeRef::EMPTY_LEAF;
    const IS_EXACT: bool = true;

    #[inline(always)]
    fn axis(&self, axis: u32) -> UVec4 {
        self.axes[axis.min(2) as usize]
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        child_count(self.children)
    }

    #[inline(always)]
    fn child(&self, child: WideRef) -> NodeRef {
        NodeRef(self.children[child.child() as usize])
    }

    #[inline(always)]
    fn leaf(_: &[Self], cursor: NodeRef, _: [u32; 3], _: f32) -> LeafRun<()> {
        LeafRun::of(cursor, ())
    }
}

/// A child out of range: a leaf without triangles.
const NO_CHILD: NodeRef = NodeRef(u32::MAX);

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

impl LatticeRow for MixedWideRow {
    type Bounds = LeafFrame;

    const NOTHING: NodeRef = NO_CHILD;
    const IS_EXACT: bool = true;

    #[inline(always)]
    fn axis(&self, axis: u32) -> UVec4 {
        self.0.axis(axis)
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        self.0.count()
    }

    #[inline(always)]
    fn child(&self, child: WideRef) -> NodeRef {
        let reference = self.0.child(child);
        if reference.is_leaf() {
            child.leaf()
        } else {
            reference
        }
    }

    #[inline(always)]
    fn leaf(nodes: &[Self], cursor: NodeRef, axes: [u32; 3], step: f32) -> LeafRun<LeafFrame> {
        let child = WideRef::of_leaf(cursor);
        let index = child.node() as usize;
        if index >= nodes.len() {
            return NO_LEAF;
        }
        let axes = [
            axis_of(nodes[index].axis(axes[0])),
            axis_of(nodes[index].axis(axes[1])),
            axis_of(nodes[index].axis(axes[2])),
        ];
        let extent = |axis: &WideAxis| {
            let [low, high] = axis.planes(child.child());
            high.wrapping_sub(low)
        };
        let [a, b, c] = &axes;
        let width = LeafWidth::of_extents([extent(a), extent(b), extent(c)]);
        let bounds = frame(&axes, child, width, step);
        let reference = nodes[index].0.child(child);
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
}

/// The links of a node of 48 bytes.
#[inline(always)]
const fn links(row: &PackedWideRow) -> PackedLinks {
    PackedLinks::from_words([row[0].w, row[1].w, row[2].w])
}

impl LatticeRow for PackedWideRow {
    type Bounds = LeafFrame;

    const NOTHING: NodeRef = NO_CHILD;
    const IS_EXACT: bool = false;

    #[inline(always)]
    fn axis(&self, axis: u32) -> UVec4 {
        self[axis.min(2) as usize]
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        links(self).count()
    }

    #[inline(always)]
    fn child(&self, child: WideRef) -> NodeRef {
        let links = links(self);
        if links.is_inner(child.child()) {
            NodeRef::inner(links.inner_child(child.child()))
        } else {
            child.leaf()
        }
    }

    #[inline(always)]
    fn leaf(nodes: &[Self], cursor: NodeRef, axes: [u32; 3], step: f32) -> LeafRun<LeafFrame> {
        let child = WideRef::of_leaf(cursor);
        let index = child.node() as usize;
        if index >= nodes.len() {
            return NO_LEAF;
        }
        let axes = [
            axis_of(nodes[index].axis(axes[0])),
            axis_of(nodes[index].axis(axes[1])),
            axis_of(nodes[index].axis(axes[2])),
        ];
        let links = links(&nodes[index]);
        LeafRun::of(
            links.child(child.child()),
            frame(&axes, child, links.width(), step),
        )
    }
}
