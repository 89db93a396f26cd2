//! The builder's buffers between stages.

use super::super::buffer::Slot;
use super::super::encode::Encoder;
use super::super::scan::Scan;
use super::super::sort::Sort;
use slimbvh_core::refit::{PyramidBox, pyramid_size};
use wgpu::BufferUsages;

/// Buffers between the stages.
#[derive(Debug)]
pub struct Scratch {
    pub blocks: Slot,
    pub grid: Slot,
    pub exponent: Slot,
    pub bounds: Slot,
    pub items: Slot,
    pub sort: Sort,
    pub members: Slot,
    pub in_set: Slot,
    pub in_set_before: Slot,
    pub set: Slot,
    pub codes: Slot,
    pub kept: Slot,
    pub kept_before: Slot,
    pub scan: Scan,
    pub splits: Slot,
    pub pyramid: Slot,
    pub node_groups: Slot,
    pub item_groups: Slot,
    pub encoder: Encoder,
}

impl Scratch {
    pub const fn new() -> Self {
        let state = BufferUsages::INDIRECT.union(BufferUsages::COPY_DST);
        Self {
            blocks: Slot::storage("slimbvh block bounds"),
            grid: Slot::storage("slimbvh morton grid"),
            exponent: Slot::storage("slimbvh bounds' exponent"),
            bounds: Slot::storage("slimbvh bounds"),
            items: Slot::storage("slimbvh items"),
            sort: Sort::new(),
            members: Slot::storage("slimbvh members"),
            in_set: Slot::storage("slimbvh set bits"),
            in_set_before: Slot::storage("slimbvh set counts"),
            set: Slot::storage("slimbvh set items"),
            codes: Slot::storage("slimbvh codes"),
            kept: Slot::storage("slimbvh kept nodes"),
            kept_before: Slot::storage("slimbvh kept counts"),
            scan: Scan::new(),
            splits: Slot::storage("slimbvh splits"),
            pyramid: Slot::storage("slimbvh pyramid"),
            node_groups: Slot::new("slimbvh node dispatch", state),
            item_groups: Slot::new("slimbvh item dispatch", state),
            encoder: Encoder::new(),
        }
    }

    pub fn bytes(&self) -> u64 {
        let slots = [
            &self.blocks,
            &self.grid,
            &self.items,
            &self.codes,
            &self.kept,
            &self.kept_before,
            &self.splits,
            &self.pyramid,
            &self.node_groups,
            &self.item_groups,
            &self.exponent,
            &self.bounds,
            &self.members,
            &self.in_set,
            &self.in_set_before,
            &self.set,
        ];
        let slots = slots.iter().map(|slot| slot.bytes()).sum::<u64>();
        slots + self.sort.bytes() + self.scan.bytes() + self.encoder.bytes()
    }
}

/// Bytes of all levels of the pyramid, and at least one entry.
pub fn pyramid_bytes(triangle_count: u32) -> u64 {
    u64::from(pyramid_size(triangle_count).max(1)) * size_of::<PyramidBox>() as u64
}
