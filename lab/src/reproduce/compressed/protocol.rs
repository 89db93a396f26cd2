//! Sizes and repeats of a measurement.

use serde::Serialize;

/// Sizes and repeats.
#[derive(Clone, Debug, Serialize)]
pub struct Protocol {
    /// Width and height of pictures, which have one sample per pixel.
    pub size: [u32; 2],
    /// Timed builds and pictures per method, alternating with as many of the plain tree.
    pub rounds: u32,
    /// Rays aimed at vertices and edges.
    pub aimed_rays: usize,
    /// Maximum number of mirrors and glass surfaces along a path.
    pub mirror_depth: u32,
}

impl Protocol {
    /// The paper's size: 1280×720 pixels.
    pub const FULL: Self = Self {
        size: [1280, 720],
        rounds: 5,
        aimed_rays: 400_000,
        mirror_depth: 8,
    };

    /// Takes half a minute.
    pub const QUICK: Self = Self {
        size: [192, 108],
        rounds: 2,
        aimed_rays: 20_000,
        ..Self::FULL
    };
}
