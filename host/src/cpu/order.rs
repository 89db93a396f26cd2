//! Stages `bounds` to `snap` on the CPU: triangles in the order of the curve.

use super::BLOCK;
use super::sort::Sorter;
use crate::Stages;
use rayon::prelude::*;
use slimbvh_core::bounds::run_bounds;
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

/// Stages `morton` and `sort`.
pub fn order<const W: usize>(
    stages: &mut Stages,
    sorter: &mut Sorter<W>,
    key_bits: [u32; W],
    triangles: &IndexedTriangles,
    code: impl Fn(&Aabb) -> [u32; W] + Sync,
) {
    stages.time("morton", || {
        sorter.resize(triangles.indices.len());
        let blocks = sorter.items().par_chunks(BLOCK).enumerate();
        blocks.for_each(|(block, items)| {
            for (item, i) in items.iter().zip((block * BLOCK) as u32..) {
                item.set(code(&triangles.triangle(i).bounds()), i);
            }
        });
    });
    stages.time("sort", || sorter.sort(key_bits));
}

/// Stage `snap`: triangles in leaf order, and the sorted codes as the topology reads them.
pub fn gather<const W: usize>(
    sorter: &mut Sorter<W>,
    triangles: &IndexedTriangles,
    scale: &PowerOfTwo,
    leaves: &mut Vec<LeafTriangle>,
    codes: &mut Vec<[u32; W]>,
) {
    let items = sorter.items();
    leaves.resize(items.len(), LeafTriangle::default());
    codes.resize(items.len(), [0; W]);
    let blocks = leaves
        .par_chunks_mut(BLOCK)
        .zip(codes.par_chunks_mut(BLOCK))
        .zip(items.par_chunks(BLOCK));
    blocks.for_each(|((leaves, codes), items)| {
        for ((leaf, code), item) in leaves.iter_mut().zip(codes).zip(items) {
            *leaf = leaf_triangle(item.index(), triangles, scale);
            *code = item.key();
        }
    });
}

/// Stage `snap`, for triangles that are in leaf order already and have moved.
pub fn gather_again(triangles: &IndexedTriangles, scale: &PowerOfTwo, leaves: &mut [LeafTriangle]) {
    leaves.par_chunks_mut(BLOCK).for_each(|leaves| {
        for leaf in leaves {
            *leaf = leaf_triangle(leaf.primitive, triangles, scale);
        }
    });
}
