//! Stage `shade`. A light takes two dispatches, as one could not bind both the mesh and the tree: `shade_light`, then
//! `trace_shadows`.

use crate::{count, thread_index};
use glam::{UVec3, UVec4, Vec3};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::sampling::Draw;
use slimbvh_core::shade::{
    Environment, Light, Material, Path, Shadow, ambient_light, direct_light, direct_light_or_dark,
};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::{Hit, IndexedTriangles};
use spirv_std_macros::spirv;

/// One thread per path. Reads the scene's exponent, one light, which is in the caller's magnitude, the mesh, the
/// materials, the path and its hit; `params` are the samples a pixel, how often the path has gone on, and whether rays go
/// where there is no light, too. Stores the light that the hit may get.
#[spirv(compute(threads(64)))]
pub fn shade_light(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] light: &[UVec4; 5],
    #[spirv(uniform, descriptor_set = 0, binding = 2)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] normals: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] material_indices: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] shadows: &mut [Shadow],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && i < shadows.len() {
        let (path, hit) = (paths[i], hits[i]);
        let mut shadow = Shadow::NONE;
        if path.is_alive() && hit.is_hit() && !materials.is_empty() {
            let mesh = IndexedTriangles { vertices, indices };
            let surface = surface(&path, &hit, exponent.x, &mesh, normals);
            let material = material(hit.primitive, material_indices, materials);
            let draw = Draw {
                sample: path.sample,
                sample_count: params.x,
                bounce: params.y,
            };
            let light = unpacked(light).scaled(&PowerOfTwo::new(exponent.x as i32));
            let light = light.sampled(&draw);
            shadow = if params.z == 1 {
                direct_light_or_dark(&surface, hit.primitive, &material, &light)
            } else {
                direct_light(&surface, hit.primitive, &material, &light)
            };
        }
        shadows[i] = shadow;
    }
}

/// One thread per path. Reads what `shade_light` stored. Counts the shadow rays that there will be.
#[spirv(compute(threads(64)))]
pub fn shade_reached(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] shadows: &[Shadow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] counters: &mut [u32],
) {
    let i = thread_index(id) as usize;
    if i < shadows.len() {
        count(counters, 0, shadows[i].is_possible() as u32);
    }
}

/// One thread per path. Reads the scene's exponent, the mesh, the materials, the environment and the path's hit. Stores
/// the path with the light from everywhere, ended, or on its way from a mirror or glass.
#[spirv(compute(threads(64)))]
pub fn shade_scatter(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] normals: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] material_indices: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] environments: &[Environment],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] paths: &mut [Path],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && !materials.is_empty() && !environments.is_empty() {
        let (path, hit) = (paths[i], hits[i]);
        if path.is_alive() {
            paths[i] = if hit.is_hit() {
                let mesh = IndexedTriangles { vertices, indices };
                let surface = surface(&path, &hit, exponent.x, &mesh, normals);
                let material = material(hit.primitive, material_indices, materials);
                path.with_light(ambient_light(&material, &environments[0]))
                    .scattered(&surface, &material, hit.primitive)
            } else {
                path.escaped(&environments[0])
            };
        }
    }
}

/// The point that a path hit. Corners without a normal ask for flat shading.
#[inline(always)]
pub(crate) fn surface(
    path: &Path,
    hit: &Hit,
    exponent: u32,
    mesh: &IndexedTriangles,
    normals: &[[f32; 3]],
) -> Surface {
    let scale = PowerOfTwo::new(exponent as i32);
    let triangle = leaf_triangle(hit.primitive, mesh, &scale).triangle();
    let mut corners = [0; 3];
    if (hit.primitive as usize) < mesh.indices.len() {
        corners = mesh.indices[hit.primitive as usize];
    }
    let normals = [
        normal(corners[0], normals),
        normal(corners[1], normals),
        normal(corners[2], normals),
    ];
    Surface::new(triangle, hit, Vec3::from_array(path.ray.direction), normals)
}

#[inline(always)]
fn normal(vertex: u32, normals: &[[f32; 3]]) -> Vec3 {
    if (vertex as usize) < normals.len() {
        Vec3::from_array(normals[vertex as usize])
    } else {
        Vec3::ZERO
    }
}

/// A triangle's material, the first where it names none. There must be one.
#[inline(always)]
fn material(primitive: u32, material_indices: &[u32], materials: &[Material]) -> Material {
    let mut i = 0;
    if (primitive as usize) < material_indices.len() {
        i = material_indices[primitive as usize];
    }
    if (i as usize) < materials.len() {
        materials[i as usize]
    } else {
        materials[0]
    }
}

/// A [`Light`] from its words: uniforms hold no arrays of three floats.
#[inline(always)]
fn unpacked(light: &[UVec4; 5]) -> Light {
    Light {
        point: three(light[0]),
        is_position: light[0].w,
        color: three(light[1]),
        range: f32::from_bits(light[1].w),
        edge_1: three(light[2]),
        shape: light[2].w,
        edge_2: three(light[3]),
        number: light[3].w,
        normal: three(light[4]),
        padding: light[4].w,
    }
}

/// The first three words, as numbers.
#[inline(always)]
fn three(words: UVec4) -> [f32; 3] {
    [
        f32::from_bits(words.x),
        f32::from_bits(words.y),
        f32::from_bits(words.z),
    ]
}
