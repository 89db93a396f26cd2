//! Stage `morton`: items for the sort, a code and the triangle that it belongs to.

use crate::thread_index;
use glam::UVec3;
use slimbvh_core::IndexedTriangles;
use slimbvh_core::morton::{MortonGrid, morton_code_30, morton_code_63};
use spirv_std_macros::spirv;

/// One thread per triangle. Reads the grid and the mesh. Stores `[code, triangle]`.
#[spirv(compute(threads(64)))]
pub fn morton_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] grids: &[MortonGrid],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] items: &mut [[u32; 2]],
) {
    let triangle = thread_index(id);
    let i = triangle as usize;
    if i < items.len() && !grids.is_empty() {
        let bounds = IndexedTriangles { vertices, indices }
            .triangle(triangle)
            .bounds();
        items[i] = [morton_code_30(&bounds, &grids[0]), triangle];
    }
}

/// One thread per triangle. Reads the grid and the mesh. Stores `[high word, low word, triangle]`.
#[spirv(compute(threads(64)))]
pub fn morton_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] grids: &[MortonGrid],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] items: &mut [[u32; 3]],
) {
    let triangle = thread_index(id);
    let i = triangle as usize;
    if i < items.len() && !grids.is_empty() {
        let bounds = IndexedTriangles { vertices, indices }
            .triangle(triangle)
            .bounds();
        let [high, low] = morton_code_63(&bounds, &grids[0]);
        items[i] = [high, low, triangle];
    }
}
