//! How much is measured.

use serde::Serialize;

/// Sizes and repeats.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Protocol {
    /// Width and height of pictures, one sample a pixel.
    pub size: [u32; 2],
    /// How often a picture is made with each setup, and as often with the default in turn. One before does not count.
    pub rounds: u32,
    /// How many mirrors and surfaces of glass a path meets.
    pub mirror_depth: u32,
    /// How many setups with several knobs moved are tried at most.
    pub crossed: usize,
    /// How many terrains, each with √10 times as many triangles as the one before, costs are measured on as they grow.
    pub terrains: usize,
    /// Width and height of pictures where rays or lights grow.
    pub small_size: [u32; 2],
    /// Samples a pixel where rays grow.
    pub samples: &'static [u32],
    /// Up to how many lights.
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

    /// For half a minute.
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
