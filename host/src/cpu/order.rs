//! Stages `bounds` to `snap` on the CPU: triangles in the order of the curve.

use super::BLOCK;
use super::build::Subset;
use super::select::Selection;
use super::sort::{Item, Sorter};
use crate::Stages;
use rayon::prelude::*;
use slimbvh_core::bounds::run_bounds;
use slimbvh_core::classify::is_in_set;
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

/// Triangles in the order of their codes of W words, and a subset of them. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Order<const W: usize> {
    sorter: Sorter<W>,
    selection: Selection,
    /// The codes of the triangles that were gathered last.
    pub codes: Vec<[u32; W]>,
}

impl<const W: usize> Order<W> {
    /// Stages `morton` and `sort`.
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

    /// Stages `classify` and `snap`: triangles in leaf order, and the sorted codes as the topology reads them.
    pub fn gather(
        &mut self,
        stages: &mut Stages,
        triangles: &IndexedTriangles,
        scale: &PowerOfTwo,
        subset: Subset,
        leaves: &mut Vec<LeafTriangle>,
    ) {
        let items = self.sorter.items();
        let store = |leaf: &mut LeafTriangle, code: &mut [u32; W], item: &Item<W>| {
            *leaf = leaf_triangle(item.index(), triangles, scale);
            *code = item.key();
        };
        let Subset::Facing { sides, target } = subset else {
            stages.time("snap", || {
                leaves.resize(items.len(), LeafTriangle::default());
                self.codes.resize(items.len(), [0; W]);
                let blocks = leaves
                    .par_chunks_mut(BLOCK)
                    .zip(self.codes.par_chunks_mut(BLOCK))
                    .zip(items.par_chunks(BLOCK));
                blocks.for_each(|((leaves, codes), items)| {
                    for ((leaf, code), item) in leaves.iter_mut().zip(codes).zip(items) {
                        store(leaf, code, item);
                    }
                });
            });
            return;
        };
        let target = target.scaled(scale);
        let count = stages.time("classify", || {
            self.selection.select(items.len(), |i| {
                is_in_set(items[i].index(), triangles, scale, &sides, &target)
            })
        });
        stages.time("snap", || {
            leaves.resize(count, LeafTriangle::default());
            self.codes.resize(count, [0; W]);
            let codes = self.codes.as_mut_slice();
            self.selection.for_each(leaves, codes, |i, leaf, code| {
                store(leaf, code, &items[i]);
            });
        });
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        self.sorter.bytes() + self.selection.bytes() + size_of_val(self.codes.as_slice())
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
