//! Stage `camera` on the CPU: rays from samples, and pixels from samples.

use super::render::{BLOCK, Prepared, Renderer};
use crate::parallel::prelude::*;
use crate::picture::{Picture, RenderReport};
use slimbvh_core::Vec3;
use slimbvh_core::ray::Hit;
use slimbvh_core::shade::{Path, mean_radiance};
use slimbvh_core::tile::{SIDE, Tiles};

impl Renderer {
    /// Starts the camera rays of threads `first..first + count`.
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
            let camera = &stage.camera;
            let samples = camera.sample_count;
            let blocks = self.paths.par_chunks_mut(BLOCK).enumerate();
            blocks.for_each(|(block, paths)| {
                let thread = first + (block * BLOCK) as u32;
                let mut in_pixel = thread % samples;
                let mut paths = paths.iter_mut();
                for pixel in camera.tiles().pixels_from(thread / samples) {
                    for i in in_pixel..samples {
                        let Some(path) = paths.next() else { return };
                        let ray = camera.ray_through(pixel, i);
                        *path = Path::new(ray, camera.sample(pixel, i));
                    }
                    in_pixel = 0;
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

/// Moves pixels from the order of [`Tiles`] to rows.
pub fn order_by_rows(picture: &mut Picture) {
    let (width, height) = (picture.width, picture.height);
    let tiles = Tiles { width, height };
    // A band of tiles and its rows are the same part of the picture.
    let bands = picture.pixels.par_chunks_mut((SIDE * width) as usize);
    let bands = bands.enumerate();
    bands.for_each_init(Vec::new, |in_tiles, (band, rows)| {
        in_tiles.clear();
        in_tiles.extend_from_slice(rows);
        let top = band as u32 * SIDE;
        let pixels = tiles.pixels_from(top * width);
        for (color, [x, y]) in in_tiles.iter().zip(pixels) {
            rows[((y - top) * width + x) as usize] = *color;
        }
    });
}
