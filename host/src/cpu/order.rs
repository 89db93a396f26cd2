//! Triangles in the order of the curve: stages `classify`, `morton`, `sort` and `snap`, with their times.

use super::classify::classify;
use super::compact::Selection;
use super::morton::{fill_codes, fill_codes_of_set};
use super::snap::Leaves;
use super::sort::Sorter;
use crate::Stages;
use slimbvh_core::classify::VisibleSet;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::{Aabb, IndexedTriangles, LeafTriangle};

/// Triangles, all or a subset, in the order of their codes of W words. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Order<const W: usize> {
    sorter: Sorter<W>,
    /// The set, by triangle index.
    members: Selection,
    /// The set, by position in the order.
    selection: Selection,
    /// The codes of the triangles gathered last.
    pub codes: Vec<[u32; W]>,
}

impl<const W: usize> Order<W> {
    /// Stages `morton` and `sort` of all triangles.
    pub fn sort(
        &mut self,
        stages: &mut Stages,
        key_bits: [u32; W],
        triangles: &IndexedTriangles,
        code: impl Fn(&Aabb) -> [u32; W] + Sync,
    ) {
        stages.time("morton", || fill_codes(&mut self.sorter, triangles, code));
        stages.time("sort", || self.sorter.sort(key_bits));
    }

    /// Stages `classify`, `morton` and `sort` of the triangles in a set.
    pub fn sort_set(
        &mut self,
        stages: &mut Stages,
        key_bits: [u32; W],
        triangles: &IndexedTriangles,
        (scale, reach): (&PowerOfTwo, &VisibleSet),
        code: impl Fn(&Aabb) -> [u32; W] + Sync,
    ) {
        let (sorter, members) = (&mut self.sorter, &mut self.members);
        stages.time("classify", || classify(members, triangles, scale, reach));
        stages.time("morton", || {
            fill_codes_of_set(sorter, members, triangles, code);
        });
        stages.time("sort", || sorter.sort(key_bits));
    }

    /// Stage `snap`: triangles in leaf order.
    pub fn gather(
        &mut self,
        stages: &mut Stages,
        triangles: &IndexedTriangles,
        scale: &PowerOfTwo,
        leaves: &mut Vec<LeafTriangle>,
    ) {
        let leaves = Leaves {
            triangles: leaves,
            codes: &mut self.codes,
        };
        let items = self.sorter.items();
        stages.time("snap", || leaves.gather(items, triangles, scale));
    }

    /// Stages `classify` and `snap`: [`Self::gather`] for the triangles in a set.
    pub fn gather_set(
        &mut self,
        stages: &mut Stages,
        triangles: &IndexedTriangles,
        (scale, reach): (&PowerOfTwo, &VisibleSet),
        leaves: &mut Vec<LeafTriangle>,
    ) {
        let (members, selection) = (&mut self.members, &mut self.selection);
        let items = &*self.sorter.items();
        stages.time("classify", || {
            classify(members, triangles, scale, reach);
            let is_member = |i: usize| members.is_taken(items[i].index());
            selection.select(items.len(), is_member);
        });
        let leaves = Leaves {
            triangles: leaves,
            codes: &mut self.codes,
        };
        stages.time("snap", || {
            leaves.gather_selected(items, selection, triangles, scale);
        });
    }

    /// The number of triangles sorted last.
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
