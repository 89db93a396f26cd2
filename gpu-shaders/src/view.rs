//! Colors that show what a ray met. Normals and primitives are added to the paths; depths and counts are values of all
//! samples, sorted for the ends of their scale before they become a picture.

use crate::shade::surface;
use crate::{texel_index, thread_index};
use glam::{UVec3, UVec4};
use slimbvh_core::shade::Path;
use slimbvh_core::view::{
    depth_range, depth_value, heat_range, mean_depth_color, mean_heat_color, normal_color,
    primitive_color,
};
use slimbvh_core::{Hit, IndexedTriangles};
use spirv_std_macros::spirv;

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

/// One thread per path. Reads its hit. Stores its depth's value.
#[spirv(compute(threads(64)))]
pub fn view_depth_values(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] values: &mut [u32],
) {
    let i = thread_index(id) as usize;
    if i < hits.len() && i < values.len() {
        values[i] = depth_value(&hits[i]);
    }
}

/// One thread per sample. Reads its value. Stores `[value, sample]`, to be sorted.
#[spirv(compute(threads(64)))]
pub fn view_items(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] values: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] items: &mut [[u32; 2]],
) {
    let sample = thread_index(id);
    let i = sample as usize;
    if i < values.len() && i < items.len() {
        items[i] = [values[i], sample];
    }
}

/// One thread. Reads the items sorted by depth. Stores the bits of the nearest and the farthest t of the scale.
#[spirv(compute(threads(1)))]
pub fn view_depth_range(
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] range: &mut [[u32; 4]],
) {
    if !range.is_empty() {
        let [near, far] = depth_range(items);
        range[0] = [near, far, 0, 0];
    }
}

/// One thread. Reads the items sorted by count. Stores the count at the top of the scale.
#[spirv(compute(threads(1)))]
pub fn view_heat_range(
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] items: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] range: &mut [[u32; 4]],
) {
    if !range.is_empty() {
        range[0] = [heat_range(items), 0, 0, 0];
    }
}

/// One thread per pixel. Reads what `view_depth_range` stored and the samples' values; `params` as for
/// `camera_resolve`.
/// Stores the mean color, as linear RGB and 1.
#[spirv(compute(threads(64)))]
pub fn view_depth(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] range: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] values: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] picture: &mut [[f32; 4]],
) {
    let (thread, samples) = (thread_index(id), params.x.max(1));
    let texel = texel_index(params, thread) as usize;
    if thread < values.len() as u32 / samples && texel < picture.len() {
        let ends = [range.x, range.y];
        let color = mean_depth_color(values, thread * samples, samples, ends);
        picture[texel] = color.extend(1.0).to_array();
    }
}

/// One thread per pixel. Reads what `view_heat_range` stored and the samples' counts; `params` as for
/// `camera_resolve`.
/// Stores the mean color, as linear RGB and 1.
#[spirv(compute(threads(64)))]
pub fn view_heat(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] range: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] values: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] picture: &mut [[f32; 4]],
) {
    let (thread, samples) = (thread_index(id), params.x.max(1));
    let texel = texel_index(params, thread) as usize;
    if thread < values.len() as u32 / samples && texel < picture.len() {
        let color = mean_heat_color(values, thread * samples, samples, range.x);
        picture[texel] = color.extend(1.0).to_array();
    }
}
