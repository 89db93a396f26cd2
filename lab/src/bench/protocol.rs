//! Sizes and repeats of a measurement.

use serde::Serialize;

/// Sizes and repeats.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Protocol {
    /// Width and height of pictures, which have one sample per pixel.
    pub size: [u32; 2],
    /// Timed pictures per setup, alternating with as many of the default. One more picture before them is not timed.
    pub rounds: u32,
    /// Maximum number of mirrors and glass surfaces along a path.
    pub mirror_depth: u32,
    /// Maximum number of setups with several changed knobs.
    pub crossed: usize,
    /// Number of terrains on which growing costs are measured, each with √10 times as many triangles as the one before.
    pub terrains: usize,
    /// Width and height of the pictures for growing rays or lights.
    pub small_size: [u32; 2],
    /// Samples per pixel for growing rays.
    pub samples: &'static [u32],
    /// Maximum number of lights.
    pub lights: usize,
}

impl Protocol {
    pub const FULL: Self = Self {
        size: [1280, 720],
        rounds: 5,
        mirror_depth: 4,
        crossed: 12,
        terrains: 9,
        small_size: [400, 256],
        samples: &[1, 3, 10, 32, 100, 316, 1000],
        lights: 64,
    };

    /// Takes half a minute.
    pub const QUICK: Self = Self {
        size: [320, 180],
        rounds: 3,
        crossed: 6,
        terrains: 5,
        small_size: [160, 90],
        samples: &[1, 2, 4, 8],
        lights: 16,
        ..Self::FULL
    };
}
