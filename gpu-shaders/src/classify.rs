//! Stage `classify`: which items of the sorted list are in a target's set, and the list of these, between a scan.

use crate::trace::scaled_target;
use crate::{LANES, thread_index};
use glam::{UVec3, UVec4};
use slimbvh_core::IndexedTriangles;
use slimbvh_core::classify::{Sides, is_in_set};
use slimbvh_core::compact::{is_set, pack_lanes, rank};
use slimbvh_core::float::PowerOfTwo;
use spirv_std::arch::workgroup_memory_barrier_with_group_sync as barrier;
use spirv_std::spirv;

/// One thread per item. Reads the scene's exponent, the target, the sorted items, the mesh, the components of its
/// primitives and their outer sides. Stores a bit for each item whose triangle is in the set, and how many each word has.
#[spirv(compute(threads(64)))]
pub fn classify_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] bits: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] counts: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let i = thread_index(id) as usize;
    let mut flag = 0;
    if i < items.len() {
        let target = scaled_target(target, exponent.x);
        flag = is_in_set(
            items[i][1],
            &IndexedTriangles { vertices, indices },
            &PowerOfTwo::new(exponent.x as i32),
            &Sides { components, sides },
            &target,
        ) as u32;
    }
    store_bits(id, lane, flag, flags, bits, counts);
}

/// As [`classify_30`], of codes of two words.
#[spirv(compute(threads(64)))]
pub fn classify_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] bits: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] counts: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let i = thread_index(id) as usize;
    let mut flag = 0;
    if i < items.len() {
        let target = scaled_target(target, exponent.x);
        flag = is_in_set(
            items[i][2],
            &IndexedTriangles { vertices, indices },
            &PowerOfTwo::new(exponent.x as i32),
            &Sides { components, sides },
            &target,
        ) as u32;
    }
    store_bits(id, lane, flag, flags, bits, counts);
}

/// One thread per item. Reads the items, the bits and the prefix sums of their counts. Stores the items whose bit is set,
/// in order.
#[spirv(compute(threads(64)))]
pub fn classify_compact_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] set: &mut [[u32; 2]],
) {
    store_item(thread_index(id), items, bits, before, set);
}

/// As [`classify_compact_30`], of codes of two words.
#[spirv(compute(threads(64)))]
pub fn classify_compact_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] before: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] set: &mut [[u32; 3]],
) {
    store_item(thread_index(id), items, bits, before, set);
}

/// Lanes 0 and 32 store the words of their 32 lanes.
#[inline(always)]
fn store_bits(
    id: UVec3,
    lane: u32,
    flag: u32,
    flags: &mut [u32; LANES],
    bits: &mut [u32],
    counts: &mut [u32],
) {
    flags[lane as usize % LANES] = flag;
    barrier();
    let word = (thread_index(id) / 32) as usize;
    if lane & 31 == 0 && word < bits.len() && word < counts.len() {
        let packed = pack_lanes(lane, flags);
        bits[word] = packed;
        counts[word] = packed.count_ones();
    }
}

#[inline(always)]
fn store_item<I: Copy>(i: u32, items: &[I], bits: &[u32], before: &[u32], set: &mut [I]) {
    if (i as usize) < items.len() && is_set(i, bits) {
        let to = rank(i, bits, before) as usize;
        if to < set.len() {
            set[to] = items[i as usize];
        }
    }
}
