//! Stage `view` on the CPU: normals, primitives, depth and heatmap.

use super::camera::paint;
use super::render::{BLOCK, Prepared, Renderer};
use crate::Picture;
use crate::parallel::prelude::*;
use crate::picture::{RenderReport, View};
use slimbvh_core::view::{
    depth_range, heat_range, mean_depth_color, mean_heat_color, normal_color, primitive_color,
};

impl Renderer {
    /// Colors by the first hit.
    pub(super) fn show(&mut self, stage: &Prepared, view: View, report: &mut RenderReport) {
        report.stages.time("shade", || {
            let blocks = self
                .paths
                .par_chunks_mut(BLOCK)
                .zip(self.hits.par_chunks(BLOCK));
            blocks.for_each(|(paths, hits)| {
                for (path, hit) in paths.iter_mut().zip(hits) {
                    if !hit.is_hit() {
                        continue;
                    }
                    let (surface, _) = stage.surface(path, hit);
                    let color = match view {
                        View::Normals => normal_color(surface.shading_normal),
                        _ => primitive_color(hit.primitive),
                    };
                    *path = path.with_light(color);
                }
            });
        });
    }
}

/// Colors each pixel by its samples' depths ([`slimbvh_core::view::depth_value`]).
pub fn paint_depth(depths: &[u32], sample_count: u32, picture: &mut Picture) {
    let range = depth_range(&sorted(depths));
    paint(&mut picture.pixels, |pixel| {
        mean_depth_color(depths, pixel * sample_count, sample_count, range)
    });
}

/// Colors each pixel by its samples' node counts.
pub fn paint_heat(heat: &[u32], sample_count: u32, picture: &mut Picture) {
    let most = heat_range(&sorted(heat));
    paint(&mut picture.pixels, |pixel| {
        mean_heat_color(heat, pixel * sample_count, sample_count, most)
    });
}

/// Values with the samples that they belong to, in the order of the values.
fn sorted(values: &[u32]) -> Vec<[u32; 2]> {
    let mut items: Vec<[u32; 2]> = values.iter().zip(0..).map(|(&v, i)| [v, i]).collect();
    items.par_sort_unstable();
    items
}
