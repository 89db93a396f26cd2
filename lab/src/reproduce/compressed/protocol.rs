//! How much is measured.

use serde::Serialize;

/// Sizes and repeats.
#[derive(Clone, Debug, Serialize)]
pub struct Protocol {
    /// Width and height of pictures, one sample a pixel.
    pub size: [u32; 2],
    /// How often trees are built and pictures made with each method, and as often without it.
    pub rounds: u32,
    /// Rays that are aimed at vertices and edges.
    pub aimed_rays: usize,
    /// How many mirrors and surfaces of glass a path meets.
    pub mirror_depth: u32,
}

impl Protocol {
    /// As printed: 1280×720 pixels.
    pub const FULL: Self = Self {
        size: [1280, 720],
        rounds: 5,
        aimed_rays: 400_000,
        mirror_depth: 8,
    };

    /// For half a minute.
    pub const QUICK: Self = Self {
        size: [192, 108],
        rounds: 2,
        aimed_rays: 20_000,
        ..Self::FULL
    };
}
