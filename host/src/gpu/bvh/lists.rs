//! The sizes of the lists of nodes and triangles.

use super::{most_nodes, paired, triangle_bytes};
use crate::gpu::coding::Coding;
use slimbvh_core::wide::most_wide_nodes;
use slimbvh_core::{LeafTriangle, Node};

/// Trees begin at multiples of this many elements, so that ranges of them are aligned and pairs of triangles stay together.
const STEP: u64 = 512;

/// The lists of nodes and triangles in a codec, or in full. Elements are nodes, and what leaves' links count: triangles in full, or
/// words.
pub struct Lists {
    pub coding: Option<Coding>,
}

impl Lists {
    /// The most elements of a tree over so many triangles.
    pub fn counts(&self, triangle_count: u32) -> [u64; 2] {
        let nodes = match self.coding {
            Some(coding) if coding.is_wide() => most_wide_nodes(triangle_count).into(),
            _ => most_nodes(triangle_count),
        };
        let coded = |coding: Coding| coding.most_triangle_bytes(triangle_count.max(1).into());
        let bytes = self.coding.and_then(coded);
        let bytes = bytes.unwrap_or_else(|| paired(triangle_bytes(triangle_count)));
        [nodes, bytes / self.element_bytes()[1]]
    }

    /// Bytes of so many elements.
    pub fn bytes(&self, counts: [u64; 2]) -> [u64; 2] {
        let [node, triangle] = self.element_bytes();
        [node * counts[0], triangle * counts[1]]
    }

    fn element_bytes(&self) -> [u64; 2] {
        let node = self
            .coding
            .map_or(size_of::<Node>() as u64, Coding::node_bytes);
        let is_full = self.coding.is_none_or(Coding::has_full_triangles);
        [
            node,
            if is_full {
                size_of::<LeafTriangle>() as u64
            } else {
                4
            },
        ]
    }

    /// Where a tree can begin that begins no sooner than here.
    pub const fn aligned(element: u64) -> u64 {
        element.next_multiple_of(STEP)
    }

    /// The end of a tree over so many triangles that begins here.
    pub fn behind(&self, first: [u64; 2], triangle_count: u32) -> [u64; 2] {
        let counts = self.counts(triangle_count);
        [first[0] + counts[0], first[1] + counts[1]]
    }

    /// The end of a tree, and of others behind it.
    pub fn ends(&self, triangle_count: u32, others: impl IntoIterator<Item = u32>) -> [u64; 2] {
        let first = self.counts(triangle_count);
        let behind = |end: [u64; 2], count| self.behind(end.map(Self::aligned), count);
        others.into_iter().fold(first, behind)
    }
}
