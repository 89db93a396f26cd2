//! Wide nodes with planes in full, as rows of 16 bytes, which a GPU reads with one load each.

use super::wide::{WideFork, WideRef, child_count};
use super::{LeafRun, NodeSource, Order};
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// A wide node as rows. 128 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct FullWideRow {
    /// On each axis the children's lower planes, then their upper planes.
    pub planes: [Vec4; 6],
    /// The children.
    pub children: [u32; WIDTH],
    /// The run of triangles below, and padding.
    pub run: [u32; 4],
}

const _: () = assert!(size_of::<FullWideRow>() == 128);

/// Wide nodes in full, the root first.
#[derive(Clone, Copy)]
pub struct FullWideNodes<'a>(pub &'a [FullWideRow]);

impl NodeSource for FullWideNodes<'_> {
    type Cursor = NodeRef;
    type Node = WideFork<Vec4>;
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
    fn children(&self, cursor: NodeRef, Order { axes, reversed }: Order) -> WideFork<Vec4> {
        let index = cursor.index() as usize;
        // Rows are read where they lie: rows in registers could not be indexed by axis.
        let (a, b, c) = (
            2 * axes[0] + reversed[0],
            2 * axes[1] + reversed[1],
            2 * axes[2] + reversed[2],
        );
        WideFork {
            first: [
                self.0[index].planes[a.min(5) as usize],
                self.0[index].planes[b.min(5) as usize],
                self.0[index].planes[c.min(5) as usize],
            ],
            second: [
                self.0[index].planes[(a ^ 1).min(5) as usize],
                self.0[index].planes[(b ^ 1).min(5) as usize],
                self.0[index].planes[(c ^ 1).min(5) as usize],
            ],
            node: cursor.index(),
            count: child_count(self.0[index].children),
        }
    }

    #[inline(always)]
    fn resume(&self, waited: WideRef) -> NodeRef {
        let index = waited.node() as usize;
        if index < self.0.len() {
            NodeRef(self.0[index].children[waited.child() as usize])
        } else {
            NodeRef::EMPTY_LEAF
        }
    }

    #[inline(always)]
    fn step_limit(&self) -> u32 {
        self.0.len() as u32 + 1
    }
}
