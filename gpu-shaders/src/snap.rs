//! Stage `snap`.

use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::{IndexedTriangles, LeafTriangle};
use spirv_std_macros::spirv;

/// One thread per triangle, in leaf order. Reads the scene's exponent, the mesh and the sorted items. Stores the
/// triangle as leaves have it, and its code.
#[spirv(compute(threads(64)))]
pub fn snap_30(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sorted: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] triangles: &mut [LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] codes: &mut [u32],
) {
    let i = thread_index(id) as usize;
    if i < triangles.len() && i < sorted.len() && i < codes.len() {
        let scale = PowerOfTwo::new(exponent.x as i32);
        let [code, primitive] = sorted[i];
        triangles[i] = leaf_triangle(primitive, &IndexedTriangles { vertices, indices }, &scale);
        codes[i] = code;
    }
}

/// As [`snap_30`], of codes of two words.
#[spirv(compute(threads(64)))]
pub fn snap_63(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sorted: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] triangles: &mut [LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] codes: &mut [[u32; 2]],
) {
    let i = thread_index(id) as usize;
    if i < triangles.len() && i < sorted.len() && i < codes.len() {
        let scale = PowerOfTwo::new(exponent.x as i32);
        let [high, low, primitive] = sorted[i];
        triangles[i] = leaf_triangle(primitive, &IndexedTriangles { vertices, indices }, &scale);
        codes[i] = [high, low];
    }
}

/// One thread per triangle that is in leaf order already and has moved. Reads the scene's exponent, the mesh and the
/// leaf's primitive. Stores the triangle in its place.
#[spirv(compute(threads(64)))]
pub fn snap_again(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &mut [LeafTriangle],
) {
    let i = thread_index(id) as usize;
    if i < triangles.len() {
        let scale = PowerOfTwo::new(exponent.x as i32);
        let primitive = triangles[i].primitive;
        triangles[i] = leaf_triangle(primitive, &IndexedTriangles { vertices, indices }, &scale);
    }
}
