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
    /// How many terrains, each with four times as many triangles as the one before, costs are measured on as they grow.
    pub terrains: usize,
}

impl Protocol {
    pub const FULL: Self = Self {
        size: [1280, 720],
        rounds: 5,
        mirror_depth: 4,
        crossed: 12,
        terrains: 6,
    };

    /// For half a minute.
    pub const QUICK: Self = Self {
        size: [320, 180],
        rounds: 3,
        crossed: 6,
        terrains: 4,
        ..Self::FULL
    };
}
