//! The laboratory's lattice codec: a child's planes are integer distances of 4 to 21 bits to its parent's, so that a node is
//! decoded from the root down. Tables compare its widths; the library has nodes of up to four children ([`super::wide`]) instead.

use super::codec::{MeshCodec, NodeCodec};
use super::error::TreeError;
use super::lanes::Numbers;
use super::lattice::{LatticeMesh, aabb, check_root};
use super::sources::{LeafPlace, Opened, StoredNodes, StoredTriangles, triangle_in};
use super::stored::{List, ListReader, Lists, Stacks, StoredTree};
use super::visitor::TreeVisitor;
use slimbvh_core::encode::{
    LatticeBounds, LatticeNodes, LatticeTriangles, LeafFrame, LeafWidth, RootWords, decode_node,
    links_of, node_words,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{LeafSlot, LeafTriangles, PacketStacks};
use slimbvh_core::{Aabb, LeafTriangle};

/// Bits of a plane of [`NodeCodec::Lattice`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LatticeBits {
    /// 4 bits, 12 bytes a node.
    Q4,
    /// 6 bits, 16 bytes a node.
    Q6,
    /// 8 bits, 16 bytes a node.
    Q8,
    /// 10 bits, 16 bytes a node.
    Q10,
    /// 12 bits, 20 bytes a node.
    Q12,
    /// 16 bits, 28 bytes a node.
    Q16,
    /// 21 bits, 28 bytes a node.
    Q21,
}

/// Calls a function that is generic over the bits of a plane, the words of a node, and optionally a type.
macro_rules! by_bits {
    ($bits:expr, $function:ident $(::<$type:ty>)? ($($argument:expr),* $(,)?)) => {
        match $bits {
            $crate::LatticeBits::Q4 => $function::<4, 3 $(, $type)?>($($argument),*),
            $crate::LatticeBits::Q6 => $function::<6, 4 $(, $type)?>($($argument),*),
            $crate::LatticeBits::Q8 => $function::<8, 4 $(, $type)?>($($argument),*),
            $crate::LatticeBits::Q10 => $function::<10, 4 $(, $type)?>($($argument),*),
            $crate::LatticeBits::Q12 => $function::<12, 5 $(, $type)?>($($argument),*),
            $crate::LatticeBits::Q16 => $function::<16, 7 $(, $type)?>($($argument),*),
            $crate::LatticeBits::Q21 => $function::<21, 7 $(, $type)?>($($argument),*),
        }
    };
}
pub(crate) use by_bits;

impl LatticeBits {
    /// All widths.
    pub const ALL: [Self; 7] = [
        Self::Q4,
        Self::Q6,
        Self::Q8,
        Self::Q10,
        Self::Q12,
        Self::Q16,
        Self::Q21,
    ];

    /// The number of bits.
    #[must_use]
    pub const fn count(self) -> u32 {
        match self {
            Self::Q4 => 4,
            Self::Q6 => 6,
            Self::Q8 => 8,
            Self::Q10 => 10,
            Self::Q12 => 12,
            Self::Q16 => 16,
            Self::Q21 => 21,
        }
    }

    /// The name in options and reports.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Q4 => "q4",
            Self::Q6 => "q6",
            Self::Q8 => "q8",
            Self::Q10 => "q10",
            Self::Q12 => "q12",
            Self::Q16 => "q16",
            Self::Q21 => "q21",
        }
    }

    /// Words of a node.
    pub(crate) const fn words(self) -> usize {
        node_words(self.count())
    }
}

/// Nodes of the codec, the root's box, and triangles.
#[derive(Clone, Debug)]
pub struct LatticeTree {
    pub bits: LatticeBits,
    pub root: LatticeBox,
    /// The step is 2 to this power, at the scene's magnitude.
    pub step_exponent: i32,
    /// The nodes.
    pub words: Vec<u32>,
    pub triangles: LatticeMesh,
}

impl LatticeTree {
    /// The buffers of a tree to be replaced, if it uses this codec.
    pub fn reuse(tree: StoredTree) -> Self {
        match tree {
            StoredTree::Lattice(tree) => tree,
            _ => Self {
                bits: LatticeBits::Q10,
                root: LatticeBox {
                    min: [0; 3],
                    max: [0; 3],
                },
                step_exponent: 0,
                words: Vec::new(),
                triangles: LatticeMesh::Full(Vec::new()),
            },
        }
    }

    /// Calls a visitor with the sources.
    #[inline(always)]
    pub fn visit<V: TreeVisitor>(&self, visitor: V) -> V::Output {
        by_bits!(self.bits, visit::<V>(self, visitor))
    }

    /// A tree with this root, its lists read by a reader.
    pub fn read<R: ListReader>(
        (bits, mesh): (LatticeBits, MeshCodec),
        root: &RootWords,
        triangle_count: usize,
        reader: &mut R,
    ) -> Result<Self, R::Error> {
        Ok(Self {
            bits,
            root: root.lattice(),
            step_exponent: root.step_exponent(),
            words: reader.nodes(bits.words())?,
            triangles: LatticeMesh::read(mesh, triangle_count, reader)?,
        })
    }
}

// Separate functions: one for all widths would be too large to optimise well.
#[inline(never)]
fn visit<const BITS: u32, const WORDS: usize, V: TreeVisitor>(
    tree: &LatticeTree,
    visitor: V,
) -> V::Output {
    let (root, step) = (tree.root, power_of_two(tree.step_exponent));
    let nodes: &[[u32; WORDS]] = bytemuck::cast_slice(&tree.words);
    match &tree.triangles {
        LatticeMesh::Full(triangles) => {
            let nodes = LatticeNodes::<BITS, WORDS, false> { nodes, root, step };
            visitor.visit(&nodes, &LeafTriangles(triangles))
        }
        LatticeMesh::Lattice { words, .. } => {
            let nodes = LatticeNodes::<BITS, WORDS, true> { nodes, root, step };
            visitor.visit(&nodes, &LatticeTriangles { words, step })
        }
    }
}

impl Lists for LatticeTree {
    fn codecs(&self, scene_exponent: i32) -> (NodeCodec, MeshCodec) {
        let mesh = self.triangles.codec(self.step_exponent, scene_exponent);
        (NodeCodec::Lattice(self.bits), mesh)
    }

    fn triangle_count(&self) -> usize {
        self.triangles.count()
    }

    fn lists(&self) -> [List<'_>; 2] {
        let nodes = List {
            item_bytes: self.bits.words() * size_of::<u32>(),
            ..List::of(&self.words)
        };
        [nodes, self.triangles.list()]
    }

    fn held_bytes(&self) -> usize {
        self.words.capacity() * size_of::<u32>() + self.triangles.held_bytes()
    }

    fn root_words(&self) -> Option<RootWords> {
        Some(RootWords::of_lattice(&self.root, self.step_exponent))
    }

    fn check_root(&self) -> Result<(), TreeError> {
        check_root(&self.root, self.step_exponent)
    }

    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>> {
        self.triangles.as_full()
    }

    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        self.triangles.as_full_mut()
    }
}

impl<const BITS: u32, const WORDS: usize, const MIXED: bool> StoredNodes
    for LatticeNodes<'_, BITS, WORDS, MIXED>
{
    type Box = LatticeBox;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.lattice
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> LatticeBox {
        self.root
    }

    fn open(&self, node: u32, bounds: &LatticeBox) -> Opened<LatticeBox> {
        let words = &self.nodes[node as usize];
        let boxes = decode_node::<BITS, WORDS>(words, bounds);
        let stride = if MIXED {
            LeafWidth::of(&boxes[0]).words()
        } else {
            1
        };
        Opened::pair(links_of::<BITS, WORDS>(words).children(stride), boxes)
    }

    fn aabb(&self, bounds: &LatticeBox) -> Aabb {
        aabb(bounds, self.step)
    }
}

impl<const BITS: u32, const WORDS: usize> StoredTriangles<LatticeNodes<'_, BITS, WORDS, true>>
    for LatticeTriangles<'_>
{
    fn place_count(&self) -> usize {
        self.words.len()
    }

    fn places(&self, count: u32, bounds: &LatticeBox) -> u32 {
        count * LeafWidth::of(bounds).words()
    }

    fn place(&self, at: LeafPlace, bounds: &LatticeBox) -> u32 {
        at.leaf.first() + at.number * LeafWidth::of(bounds).words()
    }

    fn bytes(&self, slot: &LeafSlot<LeafFrame>) -> usize {
        size_of::<u32>() * slot.bounds.width.words() as usize
    }

    fn triangle(&self, at: LeafPlace, bounds: &LatticeBox) -> LeafTriangle {
        triangle_in(
            self,
            at,
            LeafFrame::of(&LatticeBounds::new(bounds, self.step, [0, 1, 2]), self.step),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_those_of_the_nodes() {
        fn sizes<const BITS: u32, const WORDS: usize>() -> (u32, usize) {
            assert_eq!(WORDS, node_words(BITS));
            (BITS, WORDS)
        }
        for bits in LatticeBits::ALL {
            let (count, _) = by_bits!(bits, sizes());
            assert_eq!(count, bits.count());
        }
    }
}
