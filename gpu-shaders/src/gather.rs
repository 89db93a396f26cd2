//! Stage `gather`.

use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::gather::{corners, position};
use spirv_std_macros::spirv;

/// One thread per vertex. Reads a buffer of any layout; `params` are the word of the first position and the words from one to the
/// next. Stores the position's bits.
#[spirv(compute(threads(64)))]
pub fn gather_positions(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] vertices: &mut [[u32; 3]],
) {
    let vertex = thread_index(id);
    let i = vertex as usize;
    if i < vertices.len() {
        vertices[i] = position(vertex, params.x, params.y, words);
    }
}

/// One thread per triangle. Reads a buffer of indices; `params` are the number of the first index and the bits of each, 16 or 32.
/// Stores the triangle's indices.
#[spirv(compute(threads(64)))]
pub fn gather_indices(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &mut [[u32; 3]],
) {
    let triangle = thread_index(id);
    let i = triangle as usize;
    if i < indices.len() {
        indices[i] = corners(triangle, params.x, params.y, words);
    }
}
