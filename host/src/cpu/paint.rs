//! From samples to pixels.

use crate::Picture;
use rayon::prelude::*;
use slimbvh_core::Vec3;
use slimbvh_core::shade::{Path, mean_radiance};
use slimbvh_core::view::{depth_range, heat_range, mean_depth_color, mean_heat_color};

/// Pixels that a task takes at least.
const BLOCK: usize = 512;

/// Averages each pixel's samples.
pub fn resolve(paths: &[Path], sample_count: u32, pixels: &mut [[f32; 3]]) {
    paint(pixels, |pixel| {
        mean_radiance(paths, pixel * sample_count, sample_count)
    });
}

/// Colors each pixel by its samples' depths ([`slimbvh_core::view::depth_value`]).
pub fn paint_depth(depths: &[u32], sample_count: u32, picture: &mut Picture) {
    let range = depth_range(&sorted(depths));
    paint(&mut picture.pixels, |pixel| {
        mean_depth_color(depths, pixel * sample_count, sample_count, range)
    });
}

/// Colors each pixel by its samples' counts.
pub fn paint_heat(heat: &[u32], sample_count: u32, picture: &mut Picture) {
    let most = heat_range(&sorted(heat));
    paint(&mut picture.pixels, |pixel| {
        mean_heat_color(heat, pixel * sample_count, sample_count, most)
    });
}

fn paint(pixels: &mut [[f32; 3]], color: impl Fn(u32) -> Vec3 + Sync) {
    let numbered = pixels.par_iter_mut().enumerate().with_min_len(BLOCK);
    numbered.for_each(|(i, pixel)| *pixel = color(i as u32).to_array());
}

/// Each value and the sample that it belongs to, in the order of the values.
fn sorted(values: &[u32]) -> Vec<[u32; 2]> {
    let mut items: Vec<[u32; 2]> = values.iter().zip(0..).map(|(&v, i)| [v, i]).collect();
    items.par_sort_unstable();
    items
}
