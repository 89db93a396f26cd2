//! Stage `camera` on the CPU: rays from samples, and pixels from samples.

use super::render::{BLOCK, Prepared, Renderer};
use crate::picture::{Picture, RenderReport};
use rayon::prelude::*;
use slimbvh_core::Vec3;
use slimbvh_core::ray::Hit;
use slimbvh_core::shade::{Path, mean_radiance};
use slimbvh_core::tile::Tiles;
use std::ops::Range;

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
            let blocks = self.paths.par_chunks_mut(BLOCK).enumerate();
            blocks.for_each(|(block, paths)| {
                for (path, thread) in paths.iter_mut().zip(first + (block * BLOCK) as u32..) {
                    let sample = stage.camera.sample_of_thread(thread);
                    *path = Path::new(stage.camera.ray(sample), sample);
                }
            });
        });
        report.primary_ray_count += u64::from(count);
    }
}

/// Averages the samples of each pixel whose number among the tiles is in `numbers`.
pub fn resolve(paths: &[Path], sample_count: u32, numbers: Range<u32>, picture: &mut Picture) {
    paint(picture, numbers.clone(), |number| {
        mean_radiance(paths, (number - numbers.start) * sample_count, sample_count)
    });
}

/// Colors each pixel whose number among the tiles is in `numbers`, which are not empty.
pub fn paint(picture: &mut Picture, numbers: Range<u32>, color: impl Fn(u32) -> Vec3 + Sync) {
    let (width, height) = (picture.width, picture.height);
    let tiles = Tiles { width, height };
    // Bands of rows are numbered one after the other.
    let [first, last] = [numbers.start, numbers.end - 1].map(|number| tiles.pixel(number)[1]);
    let first = first - first % 8;
    let rows = picture.pixels.par_chunks_mut(width as usize).zip(0..height);
    let rows = rows
        .skip(first as usize)
        .take((last / 8 * 8 + 8 - first) as usize);
    rows.for_each(|(row, y)| {
        for (pixel, x) in row.iter_mut().zip(0..) {
            let number = tiles.number([x, y]);
            if numbers.contains(&number) {
                *pixel = color(number).to_array();
            }
        }
    });
}
