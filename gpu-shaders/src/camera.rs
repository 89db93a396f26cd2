//! Camera rays, and from samples to pixels.

use crate::thread_index;
use glam::{UVec3, UVec4, Vec3};
use slimbvh_core::camera::Camera;
use slimbvh_core::shade::Path;
use spirv_std::spirv;

/// One thread per sample. Reads the camera; `params.x` is the number of the first sample. Stores the path.
#[spirv(compute(threads(64)))]
pub fn camera_rays(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] cameras: &[Camera],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &mut [Path],
) {
    let sample = thread_index(id);
    let i = sample as usize;
    if i < paths.len() && !cameras.is_empty() {
        paths[i] = Path::new(cameras[0].ray(params.x + sample));
    }
}

/// One thread per pixel. Reads its samples' paths; `params.x` is the number of samples a pixel. Stores their mean, as
/// linear RGB.
#[spirv(compute(threads(64)))]
pub fn camera_resolve(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] pixels: &mut [[f32; 3]],
) {
    let pixel = thread_index(id);
    let i = pixel as usize;
    if i < pixels.len() {
        let mut sum = Vec3::ZERO;
        let first = pixel * params.x;
        for sample in first..first + params.x {
            if (sample as usize) < paths.len() {
                sum += Vec3::from_array(paths[sample as usize].radiance);
            }
        }
        pixels[i] = (sum / params.x as f32).to_array();
    }
}
