//! Stage `snap` on the CPU: triangles in leaf order, scaled to magnitude 1.

use super::BLOCK;
use super::compact::Selection;
use super::sort::Item;
use crate::parallel::prelude::*;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::{IndexedTriangles, LeafTriangle};

/// Leaf triangles, and the sorted codes in the form that stage `topology` reads.
pub struct Leaves<'a, const W: usize> {
    pub triangles: &'a mut Vec<LeafTriangle>,
    pub codes: &'a mut Vec<[u32; W]>,
}

impl<const W: usize> Leaves<'_, W> {
    fn resize(&mut self, count: usize) {
        self.triangles.resize(count, LeafTriangle::default());
        self.codes.resize(count, [0; W]);
    }

    /// Gathers all sorted triangles.
    pub fn gather(mut self, items: &[Item<W>], triangles: &IndexedTriangles, scale: &PowerOfTwo) {
        self.resize(items.len());
        let blocks = self
            .triangles
            .par_chunks_mut(BLOCK)
            .zip(self.codes.par_chunks_mut(BLOCK))
            .zip(items.par_chunks(BLOCK));
        blocks.for_each(|((leaves, codes), items)| {
            for ((leaf, code), item) in leaves.iter_mut().zip(codes).zip(items) {
                *leaf = leaf_triangle(item.index(), triangles, scale);
                *code = item.key();
            }
        });
    }

    /// Gathers the selected sorted triangles.
    pub fn gather_selected(
        mut self,
        items: &[Item<W>],
        selection: &Selection,
        triangles: &IndexedTriangles,
        scale: &PowerOfTwo,
    ) {
        self.resize(selection.len());
        let codes = self.codes.as_mut_slice();
        selection.for_each(self.triangles, codes, |i, leaf, code| {
            *leaf = leaf_triangle(items[i].index(), triangles, scale);
            *code = items[i].key();
        });
    }
}

/// Updates triangles that are already in leaf order.
pub fn gather_again(triangles: &IndexedTriangles, scale: &PowerOfTwo, leaves: &mut [LeafTriangle]) {
    leaves.par_chunks_mut(BLOCK).for_each(|leaves| {
        for leaf in leaves {
            *leaf = leaf_triangle(leaf.primitive, triangles, scale);
        }
    });
}
