//! Stage `morton` on the CPU: a code for each triangle, as items for the sort.

use super::BLOCK;
use super::compact::Selection;
use super::sort::Sorter;
use crate::parallel::prelude::*;
use slimbvh_core::{Aabb, IndexedTriangles};

/// Computes the codes of all triangles.
pub fn fill_codes<const W: usize>(
    sorter: &mut Sorter<W>,
    triangles: &IndexedTriangles,
    code: impl Fn(&Aabb) -> [u32; W] + Sync,
) {
    sorter.resize(triangles.indices.len());
    let blocks = sorter.items().par_chunks(BLOCK).enumerate();
    blocks.for_each(|(block, items)| {
        for (item, i) in items.iter().zip((block * BLOCK) as u32..) {
            item.set(code(&triangles.triangle(i).bounds()), i);
        }
    });
}

/// Computes the codes of the triangles in a set.
pub fn fill_codes_of_set<const W: usize>(
    sorter: &mut Sorter<W>,
    members: &Selection,
    triangles: &IndexedTriangles,
    code: impl Fn(&Aabb) -> [u32; W] + Sync,
) {
    let count = members.len();
    sorter.resize(count);
    let items = sorter.items();
    members.for_each(items, &mut vec![(); count], |i, item, ()| {
        item.set(code(&triangles.triangle(i as u32).bounds()), i as u32);
    });
}
