//! Plain nodes and triangles as rows of 16 bytes, which a GPU reads with one load each.

use super::{Children, LeafRun, LeafSlot, NodeSource, Order, TriangleSource};
use crate::build::node::{Node, NodeRef};
use crate::geometry::triangle::LeafTriangle;
use glam::Vec4;

/// A [`Node`] as rows: its planes an axis, then both children and the triangles below it, as bits.
pub type NodeRow = [Vec4; 4];

/// Two [`LeafTriangle`]s as rows. Where the last has none beside it, its row is padded.
pub type TrianglePair = [Vec4; 5];

const _: () = assert!(size_of::<NodeRow>() == size_of::<Node>());
const _: () = assert!(size_of::<TrianglePair>() == 2 * size_of::<LeafTriangle>());

/// Uncompressed nodes in rows, the root first.
#[derive(Clone, Copy)]
pub struct NodeRows<'a>(pub &'a [NodeRow]);

impl NodeSource for NodeRows<'_> {
    type Cursor = NodeRef;
    type Node = Children<NodeRef>;
    type Bounds = ();

    const NOTHING: NodeRef = NodeRef::EMPTY_LEAF;

    #[inline(always)]
    fn root(&self, _axes: [u32; 3]) -> NodeRef {
        NodeRef::inner(0)
    }

    #[inline(always)]
    fn is_leaf(&self, cursor: NodeRef) -> bool {
        // Leaves have the highest bit. The same comparison answers for an index out of range, which is opened by no walk.
        cursor.index() as usize >= self.0.len()
    }

    #[inline(always)]
    fn leaf(&self, cursor: NodeRef, _axes: [u32; 3]) -> LeafRun<()> {
        LeafRun::of(cursor, ())
    }

    #[inline(always)]
    fn resume(&self, waited: NodeRef) -> NodeRef {
        waited
    }

    #[inline(always)]
    fn children(&self, cursor: NodeRef, Order { axes, .. }: Order) -> Children<NodeRef> {
        // In range, as `is_leaf` has said no: the compiler sees it, and checks nothing.
        let index = cursor.index() as usize;
        // Rows are read where they lie: rows in registers could not be indexed by axis.
        let links = self.0[index][3];
        Children {
            planes: [
                self.0[index][axes[0] as usize % 4],
                self.0[index][axes[1] as usize % 4],
                self.0[index][axes[2] as usize % 4],
            ],
            left: NodeRef(links.x.to_bits()),
            right: NodeRef(links.y.to_bits()),
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.0.len() as u32 + 1
    }
}

/// Triangles in leaf order, in rows.
#[derive(Clone, Copy)]
pub struct TriangleRows<'a>(pub &'a [TrianglePair]);

impl TriangleRows<'_> {
    /// The ten words of a triangle, and two that are not its own.
    #[inline(always)]
    fn words(&self, index: u32) -> [Vec4; 3] {
        let (pair, second) = (index as usize / 2, index as usize % 2);
        if pair >= self.0.len() {
            return [Vec4::ZERO; 3];
        }
        let (a, b, c) = (
            self.0[pair][2 * second],
            self.0[pair][2 * second + 1],
            self.0[pair][2 * second + 2],
        );
        // The second triangle begins in the middle of the row where the first one ends.
        if second == 0 {
            [a, b, c]
        } else {
            [
                Vec4::new(a.z, a.w, b.x, b.y),
                Vec4::new(b.z, b.w, c.x, c.y),
                Vec4::new(c.z, c.w, 0.0, 0.0),
            ]
        }
    }
}

impl<B: Copy> TriangleSource<B> for TriangleRows<'_> {
    #[inline(always)]
    fn corners(&self, slot: &LeafSlot<B>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let [a, b, c] = self.words(slot.first + slot.number);
        [
            in_order([a.x, a.y, a.z], axes),
            in_order([a.w, b.x, b.y], axes),
            in_order([b.z, b.w, c.x], axes),
        ]
    }

    #[inline(always)]
    fn primitive(&self, slot: &LeafSlot<B>) -> u32 {
        let [_, _, c] = self.words(slot.first + slot.number);
        c.y.to_bits()
    }
}

/// Coordinates in the order of a ray's axes, each the next after the last: by selection, as registers have no index.
#[inline(always)]
pub(crate) const fn in_order([x, y, z]: [f32; 3], axes: [u32; 3]) -> [f32; 3] {
    if axes[0] == 0 {
        [x, y, z]
    } else if axes[0] == 1 {
        [y, z, x]
    } else {
        [z, x, y]
    }
}
