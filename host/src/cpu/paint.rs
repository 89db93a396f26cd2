//! From samples to pixels.

use crate::Picture;
use rayon::prelude::*;
use slimbvh_core::shade::Path;
use slimbvh_core::view;

/// Pixels that a task takes at least.
const BLOCK: usize = 512;

/// Averages each pixel's samples, in order.
pub fn resolve(paths: &[Path], sample_count: usize, pixels: &mut [[f32; 3]]) {
    let samples = paths.par_chunks(sample_count);
    pixels
        .par_iter_mut()
        .zip(samples)
        .with_min_len(BLOCK)
        .for_each(|(pixel, paths)| {
            let sum = paths.iter().fold(glam::Vec3::ZERO, |sum, path| {
                sum + glam::Vec3::from_array(path.radiance)
            });
            *pixel = (sum / sample_count as f32).to_array();
        });
}

/// Colors each pixel by how far along the view its samples hit: a camera ray advances by one for each unit of t. The
/// scale reaches from the nearest hit to the distance that one hit in a hundred exceeds.
pub fn paint_depth(depths: &[f32], sample_count: usize, picture: &mut Picture) {
    let mut sorted: Vec<f32> = depths.iter().copied().filter(|&t| t < f32::MAX).collect();
    if sorted.is_empty() {
        return;
    }
    let rank = sorted.len() - 1 - sorted.len() / 100;
    let (nearer, &mut far, _) = sorted.select_nth_unstable_by(rank, f32::total_cmp);
    let near = nearer.iter().fold(far, |near, &t| near.min(t));
    let color = |t: f32| {
        if t < f32::MAX {
            view::depth_color(t, near, far)
        } else {
            glam::Vec3::ZERO
        }
    };
    for (pixel, depths) in picture.pixels.iter_mut().zip(depths.chunks(sample_count)) {
        let sum = depths
            .iter()
            .fold(glam::Vec3::ZERO, |sum, &t| sum + color(t));
        *pixel = (sum / sample_count as f32).to_array();
    }
}

/// Colors each pixel by its mean count, white being the count that one pixel in a thousand exceeds.
pub fn paint_heat(heat: &[u32], sample_count: usize, picture: &mut Picture) {
    let mut sorted = heat.to_vec();
    let rank = sorted.len() - 1 - sorted.len() / 1000;
    let (_, &mut most, _) = sorted.select_nth_unstable(rank);
    for (pixel, counts) in picture.pixels.iter_mut().zip(heat.chunks(sample_count)) {
        let sum = counts.iter().fold(glam::Vec3::ZERO, |sum, &count| {
            sum + view::heat_color(count, most)
        });
        *pixel = (sum / sample_count as f32).to_array();
    }
}
