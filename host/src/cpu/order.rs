//! Stages `bounds` to `snap` on the CPU: triangles in the order of the curve.

use super::BLOCK;
use super::select::Selection;
use super::sort::Sorter;
use crate::Stages;
use rayon::prelude::*;
use slimbvh_core::bounds::run_bounds;
use slimbvh_core::classify::{VisibleSet, word_of_set};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::{Aabb, IndexedTriangles, LeafTriangle};

/// Stage `bounds`.
pub fn scene_bounds(triangles: &IndexedTriangles) -> Aabb {
    let count = triangles.indices.len();
    (0..count.div_ceil(BLOCK))
        .into_par_iter()
        .map(|block| {
            let first = block * BLOCK;
            run_bounds(first as u32, BLOCK.min(count - first) as u32, triangles)
        })
        .reduce(|| Aabb::EMPTY, Aabb::union)
}

/// Triangles in the order of their codes of W words, all or a subset. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Order<const W: usize> {
    sorter: Sorter<W>,
    /// By triangle: which are in the set.
    members: Selection,
    /// By place in the order: the same.
    selection: Selection,
    /// The codes of the triangles that were gathered last.
    pub codes: Vec<[u32; W]>,
}

impl<const W: usize> Order<W> {
    /// Stages `morton` and `sort`, of all triangles.
    pub fn sort(
        &mut self,
        stages: &mut Stages,
        key_bits: [u32; W],
        triangles: &IndexedTriangles,
        code: impl Fn(&Aabb) -> [u32; W] + Sync,
    ) {
        stages.time("morton", || {
            self.sorter.resize(triangles.indices.len());
            let blocks = self.sorter.items().par_chunks(BLOCK).enumerate();
            blocks.for_each(|(block, items)| {
                for (item, i) in items.iter().zip((block * BLOCK) as u32..) {
                    item.set(code(&triangles.triangle(i).bounds()), i);
                }
            });
        });
        stages.time("sort", || self.sorter.sort(key_bits));
    }

    /// Stages `classify`, `morton` and `sort`: only what is in the set is sorted.
    pub fn sort_set(
        &mut self,
        stages: &mut Stages,
        key_bits: [u32; W],
        triangles: &IndexedTriangles,
        (scale, reach): (&PowerOfTwo, &VisibleSet),
        code: impl Fn(&Aabb) -> [u32; W] + Sync,
    ) {
        let count = stages.time("classify", || self.classify(triangles, scale, reach));
        stages.time("morton", || {
            self.sorter.resize(count);
            let items = self.sorter.items();
            self.members
                .for_each(items, &mut vec![(); count], |i, item, ()| {
                    item.set(code(&triangles.triangle(i as u32).bounds()), i as u32);
                });
        });
        stages.time("sort", || self.sorter.sort(key_bits));
    }

    /// Stage `snap`: triangles in leaf order, and the sorted codes as the topology reads them.
    pub fn gather(
        &mut self,
        stages: &mut Stages,
        triangles: &IndexedTriangles,
        scale: &PowerOfTwo,
        leaves: &mut Vec<LeafTriangle>,
    ) {
        let items = self.sorter.items();
        stages.time("snap", || {
            leaves.resize(items.len(), LeafTriangle::default());
            self.codes.resize(items.len(), [0; W]);
            let blocks = leaves
                .par_chunks_mut(BLOCK)
                .zip(self.codes.par_chunks_mut(BLOCK))
                .zip(items.par_chunks(BLOCK));
            blocks.for_each(|((leaves, codes), items)| {
                for ((leaf, code), item) in leaves.iter_mut().zip(codes).zip(items) {
                    *leaf = leaf_triangle(item.index(), triangles, scale);
                    *code = item.key();
                }
            });
        });
    }

    /// Stages `classify` and `snap`: as [`Self::gather`], of what is in the set.
    pub fn gather_set(
        &mut self,
        stages: &mut Stages,
        triangles: &IndexedTriangles,
        (scale, reach): (&PowerOfTwo, &VisibleSet),
        leaves: &mut Vec<LeafTriangle>,
    ) {
        let count = stages.time("classify", || {
            self.classify(triangles, scale, reach);
            let (items, members) = (self.sorter.items(), &self.members);
            let is_member = |i: usize| members.is_taken(items[i].index());
            self.selection.select(items.len(), is_member)
        });
        let items = self.sorter.items();
        stages.time("snap", || {
            leaves.resize(count, LeafTriangle::default());
            self.codes.resize(count, [0; W]);
            let codes = self.codes.as_mut_slice();
            self.selection.for_each(leaves, codes, |i, leaf, code| {
                *leaf = leaf_triangle(items[i].index(), triangles, scale);
                *code = items[i].key();
            });
        });
    }

    /// Stage `classify` proper, in the mesh's order, as memory likes it. Returns how many are in the set.
    fn classify(
        &mut self,
        triangles: &IndexedTriangles,
        scale: &PowerOfTwo,
        reach: &VisibleSet,
    ) -> usize {
        let reach = reach.scaled(scale);
        let word = |word| word_of_set(word, triangles, scale, &reach);
        self.members
            .fill(triangles.indices.len().div_ceil(32), word)
    }

    /// How many triangles were sorted last.
    pub fn len(&self) -> usize {
        self.sorter.len()
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        self.sorter.bytes()
            + self.members.bytes()
            + self.selection.bytes()
            + size_of_val(self.codes.as_slice())
    }
}

/// Stage `snap`, for triangles that are in leaf order already and have moved.
pub fn gather_again(triangles: &IndexedTriangles, scale: &PowerOfTwo, leaves: &mut [LeafTriangle]) {
    leaves.par_chunks_mut(BLOCK).for_each(|leaves| {
        for leaf in leaves {
            *leaf = leaf_triangle(leaf.primitive, triangles, scale);
        }
    });
}
