//! Stage `camera` on the CPU: rays from samples, and pixels from samples.

use super::render::{BLOCK, Prepared, Renderer};
use crate::picture::RenderReport;
use rayon::prelude::*;
use slimbvh_core::Vec3;
use slimbvh_core::ray::Hit;
use slimbvh_core::shade::{Path, mean_radiance};

impl Renderer {
    /// Starts the camera rays of samples `first..first + count`.
    pub(super) fn begin(
        &mut self,
        stage: &Prepared,
        first: u32,
        count: u32,
        report: &mut RenderReport,
    ) {
        self.paths.resize(count as usize, Path::default());
        self.hits.resize(count as usize, Hit::MISS);
        report.stages.time("camera", || {
            let blocks = self.paths.par_chunks_mut(BLOCK).enumerate();
            blocks.for_each(|(block, paths)| {
                for (path, sample) in paths.iter_mut().zip(first + (block * BLOCK) as u32..) {
                    *path = Path::new(stage.camera.ray(sample), sample);
                }
            });
        });
        report.primary_ray_count += u64::from(count);
    }
}

/// Averages each pixel's samples.
pub fn resolve(paths: &[Path], sample_count: u32, pixels: &mut [[f32; 3]]) {
    paint(pixels, |pixel| {
        mean_radiance(paths, pixel * sample_count, sample_count)
    });
}

/// Colors each pixel.
pub fn paint(pixels: &mut [[f32; 3]], color: impl Fn(u32) -> Vec3 + Sync) {
    let numbered = pixels.par_iter_mut().enumerate().with_min_len(BLOCK);
    numbered.for_each(|(i, pixel)| *pixel = color(i as u32).to_array());
}
