//! The second pass of a trace: rays whose stack in workgroup memory was full are traced again, with private stacks.

use crate::gpu::buffer::{Range, Slot, upload};
use crate::gpu::fit::PARTS_BYTES;
use crate::gpu::program::{Groups, Recorder, Uniform, groups};
use crate::gpu::{Gpu, Kernel};
use slimbvh_core::RayEnds;
use wgpu::BufferUsages;

/// Bytes of `[length, x, y, z]`.
const GROUPS_BYTES: u64 = 16;

/// Bytes of a list with room for this many rays: its length, then their numbers.
pub const fn list_bytes(ray_count: u64) -> u64 {
    4 * (ray_count + 1)
}

/// A slot for the dispatch of second passes.
pub const fn groups_slot() -> Slot {
    let usage = BufferUsages::STORAGE
        .union(BufferUsages::UNIFORM)
        .union(BufferUsages::INDIRECT);
    Slot::new("slimbvh overflow dispatch", usage)
}

/// What traces of rays in the caller's buffers share, one after the other: lists, and what stands in for what a caller leaves out.
#[derive(Debug)]
pub struct Lists {
    list: Slot,
    groups: Slot,
    ray_groups: Slot,
    no_ends: Option<wgpu::Buffer>,
}

impl Default for Lists {
    fn default() -> Self {
        Self {
            list: Slot::storage("slimbvh overflow list"),
            groups: groups_slot(),
            ray_groups: groups_slot(),
            no_ends: None,
        }
    }
}

impl Lists {
    /// A list with room for this many rays. Between traces its length is 0.
    pub fn overflow(&mut self, gpu: &Gpu, ray_count: u64) -> Overflow {
        Overflow {
            list: self.list.range(gpu, list_bytes(ray_count)),
            groups: groups_range(gpu, &mut self.groups),
        }
    }

    /// The range of numbers of rays that only the GPU knows, and of the dispatches with a thread for each.
    pub fn ray_groups(&mut self, gpu: &Gpu) -> Range {
        self.ray_groups.range(gpu, PARTS_BYTES)
    }

    /// Ends of one ray, which lie on nothing: bound for rays without ends.
    pub fn no_ends(&mut self, gpu: &Gpu) -> wgpu::Buffer {
        let made = || {
            upload(
                gpu,
                "slimbvh no ends",
                BufferUsages::STORAGE,
                &[RayEnds::NONE],
            )
        };
        self.no_ends.get_or_insert_with(made).clone()
    }
}

/// The range of the dispatch of second passes.
pub fn groups_range(gpu: &Gpu, slot: &mut Slot) -> Range {
    slot.range(gpu, GROUPS_BYTES)
}

/// What a first pass leaves for the second.
#[derive(Clone, Debug)]
pub struct Overflow {
    /// The rays to trace again.
    pub list: Range,
    /// The list's length, and the dispatch with a thread for each.
    pub groups: Range,
}

impl Overflow {
    /// Records that the length of the list becomes a dispatch, and the list empty. Returns that dispatch.
    pub fn record(&self, recorder: &mut Recorder) -> Groups {
        let list = &self.list.touching(4);
        recorder.read(list);
        let to = &[list, &self.groups];
        recorder.dispatch(Kernel::trace_groups, &[], &[], to, groups(1));
        Groups::Indirect(self.groups.part(4, 12))
    }

    /// The list's length, for the kernels of the second pass.
    pub const fn length(&self) -> Uniform<'_> {
        Uniform::Stored(&self.groups)
    }
}
