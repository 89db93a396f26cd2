//! Camera rays, from samples to pixels, and from pixels to bytes.

use crate::{texel_index, thread_index};
use glam::{UVec3, UVec4, Vec3};
use slimbvh_core::camera::Camera;
use slimbvh_core::color::{pack_texel, srgb_bytes};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::shade::{Path, mean_radiance};
use spirv_std_macros::spirv;

/// One thread per sample. Reads the scene's exponent and the camera, which is in the caller's magnitude; `params.x` is
/// the number of the first thread among those of the picture. Stores the path of the thread's sample.
#[spirv(compute(threads(64)))]
pub fn camera_rays(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] cameras: &[Camera],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] paths: &mut [Path],
) {
    let thread = thread_index(id);
    let i = thread as usize;
    if i < paths.len() && !cameras.is_empty() {
        let camera = cameras[0].scaled(&PowerOfTwo::new(exponent.x as i32));
        let sample = camera.sample_of_thread(params.x + thread);
        paths[i] = Path::new(camera.ray(sample), sample);
    }
}

/// One thread per pixel. Reads its samples' paths; `params` are the samples a pixel, the width and the height of what is
/// bound of the picture, and the number of the first pixel in its tiles. Stores their mean, as linear RGB and 1.
#[spirv(compute(threads(64)))]
pub fn camera_resolve(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] picture: &mut [[f32; 4]],
) {
    let (thread, samples) = (thread_index(id), params.x.max(1));
    let texel = texel_index(params, thread) as usize;
    if thread < paths.len() as u32 / samples && texel < picture.len() {
        let color = mean_radiance(paths, thread * samples, samples);
        picture[texel] = color.extend(1.0).to_array();
    }
}

/// One thread per texel. Reads the picture; `params.x` is 0 for bytes in the order RGBA, 1 for BGRA. Stores 8-bit sRGB,
/// opaque.
#[spirv(compute(threads(64)))]
pub fn camera_encode(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] picture: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] texels: &mut [u32],
) {
    let i = thread_index(id) as usize;
    if i < picture.len() && i < texels.len() {
        let [r, g, b, _] = picture[i];
        let [r, g, b] = srgb_bytes(Vec3::new(r, g, b));
        texels[i] = if params.x == 0 {
            pack_texel([r, g, b])
        } else {
            pack_texel([b, g, r])
        };
    }
}
