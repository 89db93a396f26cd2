//! Pictures, render settings and render reports.

mod mean;

pub use mean::PictureMean;

use crate::Stages;
use slimbvh_core::color::srgb_bytes;

/// What a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum View {
    /// Shaded surfaces.
    #[default]
    Color,
    /// Surface normals, as colors.
    Normals,
    /// Distance along the view: near is bright.
    Depth,
    /// A color for each triangle.
    Primitives,
    /// Nodes visited for each pixel: black, blue, red, yellow, white.
    Heatmap,
}

/// How to render.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderSettings {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Samples a pixel.
    pub sample_count: u32,
    /// What to show.
    pub view: View,
    /// How many mirrors and surfaces of glass a path may meet.
    pub mirror_depth: u32,
    /// Whether shadow rays are traced even where the light contributes nothing: surfaces that face away from it, points
    /// beyond its range, black lights. The picture stays the same.
    pub dark_rays: bool,
}

impl Default for RenderSettings {
    fn default() -> Self {
        Self {
            size: [1280, 720],
            sample_count: 1,
            view: View::Color,
            mirror_depth: 4,
            dark_rays: false,
        }
    }
}

/// A picture in linear RGB, row by row from the upper left.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// `width · height` colors.
    pub pixels: Vec<[f32; 3]>,
}

impl Picture {
    /// 8-bit sRGB (IEC 61966-2-1), three bytes a pixel. Colors outside 0 to 1 are clipped.
    #[must_use]
    pub fn to_srgb(&self) -> Vec<u8> {
        self.pixels
            .iter()
            .flat_map(|&pixel| srgb_bytes(pixel.into()))
            .map(|byte| byte as u8)
            .collect()
    }
}

/// What a render did.
#[derive(Clone, Debug, Default)]
pub struct RenderReport {
    /// Time of each stage.
    pub stages: Stages,
    /// Rays from the camera.
    pub primary_ray_count: u64,
    /// Rays to lights.
    pub shadow_ray_count: u64,
    /// Rays from mirrors and through glass.
    pub mirror_ray_count: u64,
    /// Camera rays that hit a triangle.
    pub primary_hit_count: u64,
    /// Inner nodes opened. Counted in the heatmap view only.
    pub node_visit_count: u64,
}

impl RenderReport {
    /// All rays.
    #[must_use]
    pub fn ray_count(&self) -> u64 {
        self.primary_ray_count + self.shadow_ray_count + self.mirror_ray_count
    }
}
