//! Colors that show what a ray met, added to its path.

use crate::shade::surface;
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::shade::Path;
use slimbvh_core::view::{depth_color, heat_color, normal_color, primitive_color};
use slimbvh_core::{Hit, IndexedTriangles};
use spirv_std::spirv;

/// One thread per path. Reads the scene's exponent, the mesh and the path's hit. Stores the path with the shading
/// normal's color.
#[spirv(compute(threads(64)))]
pub fn view_normals(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] normals: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] paths: &mut [Path],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && hits[i].is_hit() {
        let (path, hit) = (paths[i], hits[i]);
        let mesh = IndexedTriangles { vertices, indices };
        let surface = surface(&path, &hit, exponent.x, &mesh, normals);
        paths[i] = path.with_light(normal_color(surface.shading_normal));
    }
}

/// One thread per path. Reads its hit. Stores the path with the primitive's color.
#[spirv(compute(threads(64)))]
pub fn view_primitives(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &mut [Path],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && hits[i].is_hit() {
        paths[i] = paths[i].with_light(primitive_color(hits[i].primitive));
    }
}

/// One thread per path. Reads its hit; `params.xy` are the bits of the nearest and the farthest t. Stores the path with
/// the depth's color.
#[spirv(compute(threads(64)))]
pub fn view_depth(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &mut [Path],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && hits[i].is_hit() {
        let (near, far) = (f32::from_bits(params.x), f32::from_bits(params.y));
        paths[i] = paths[i].with_light(depth_color(hits[i].t, near, far));
    }
}

/// One thread per path. Reads its count of nodes; `params.x` is the count shown as white. Stores the path with the
/// count's color.
#[spirv(compute(threads(64)))]
pub fn view_heat(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] counts: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &mut [Path],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < counts.len() {
        paths[i] = paths[i].with_light(heat_color(counts[i], params.x));
    }
}
