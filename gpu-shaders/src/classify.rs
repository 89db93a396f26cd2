//! Stage `classify`: which triangles are in a target's set, in the mesh's order, as memory likes it; which items of the
//! sorted list these are; and, after a scan, the list of them.

use crate::compact::store_bits;
use crate::group::barrier;
use crate::trace::scaled_target;
use crate::{LANES, thread_index};
use glam::{UVec3, UVec4};
use slimbvh_core::IndexedTriangles;
use slimbvh_core::classify::{Sides, VisibleSet, is_in_set, packed_sides};
use slimbvh_core::compact::{is_set, pack_lanes, rank};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::frustum::Frustum;
use spirv_std_macros::spirv;

/// One thread per triangle. Reads the scene's exponent, the target, the frustum, whether anything needs the set, the mesh,
/// the components of its primitives and their sides. Stores a bit for each triangle that is in the set.
#[spirv(compute(threads(64)))]
pub fn classify(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
    #[spirv(uniform, descriptor_set = 0, binding = 2)] frustum: &[UVec4; 5],
    #[spirv(uniform, descriptor_set = 0, binding = 3)] needed: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] bits: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let i = thread_index(id);
    let mut flag = 0;
    if needed.x > 0 && (i as usize) < indices.len() {
        let reach = VisibleSet {
            sides: Sides { components, sides },
            target: scaled_target(target, exponent.x),
            frustum: scaled_frustum(frustum, exponent.x),
        };
        let mesh = IndexedTriangles { vertices, indices };
        flag = is_in_set(i, &mesh, &PowerOfTwo::new(exponent.x as i32), &reach) as u32;
    }
    flags[lane as usize % LANES] = flag;
    barrier();
    let word = (i / 32) as usize;
    if lane & 31 == 0 && word < bits.len() {
        bits[word] = pack_lanes(lane, flags);
    }
}

/// One thread per word. Reads the components of primitives and their sides. Stores the sides of the word's primitives.
#[spirv(compute(threads(64)))]
pub fn classify_sides(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] packed: &mut [u32],
) {
    let word = thread_index(id);
    if (word as usize) < packed.len() {
        packed[word as usize] = packed_sides(word, &Sides { components, sides });
    }
}

/// One thread per item. Reads the sorted items, and a bit for each triangle. Stores a bit for each item whose triangle has
/// it, and how many each word has.
#[spirv(compute(threads(64)))]
pub fn classify_order_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] members: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] bits: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] counts: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let i = thread_index(id) as usize;
    let mut flag = 0;
    if i < items.len() {
        flag = is_set(items[i][1], members) as u32;
    }
    store_bits(id, lane, flag, flags, bits, counts);
}

/// As [`classify_order_30`], of codes of two words.
#[spirv(compute(threads(64)))]
pub fn classify_order_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] items: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] members: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] bits: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] counts: &mut [u32],
    #[spirv(workgroup)] flags: &mut [u32; LANES],
) {
    let i = thread_index(id) as usize;
    let mut flag = 0;
    if i < items.len() {
        flag = is_set(items[i][2], members) as u32;
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

/// A frustum from its words, in the scene's magnitude.
#[inline(always)]
fn scaled_frustum(words: &[UVec4; 5], exponent: u32) -> Frustum {
    let first = words[0];
    let mut frustum = Frustum {
        eye: [
            f32::from_bits(first.x),
            f32::from_bits(first.y),
            f32::from_bits(first.z),
        ],
        is_bounded: first.w,
        planes: [[0.0; 4]; 4],
    };
    for i in 0..4 {
        let plane = words[i + 1];
        frustum.planes[i] = [
            f32::from_bits(plane.x),
            f32::from_bits(plane.y),
            f32::from_bits(plane.z),
            f32::from_bits(plane.w),
        ];
    }
    frustum.scaled(&PowerOfTwo::new(exponent as i32))
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
