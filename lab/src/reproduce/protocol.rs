//! How much is measured.

use serde::Serialize;

/// Sizes and repeats.
#[derive(Clone, Debug, Serialize)]
pub struct Protocol {
    /// Width and height of pictures.
    pub size: [u32; 2],
    /// Samples a pixel, and how often such a picture is made each way.
    pub pictures: Vec<(u32, u32)>,
    /// How often trees are built.
    pub build_rounds: u32,
    /// How often pictures under many lights are made each way.
    pub light_rounds: u32,
    /// How many lights these have.
    pub light_sides: Vec<u32>,
    /// How often pictures are made with each saving and without it.
    pub saving_rounds: u32,
}

impl Protocol {
    /// As printed: 1024×1024 pixels of 1, 16 and 256 samples.
    pub fn full() -> Self {
        Self {
            size: [1024; 2],
            pictures: vec![(1, 9), (16, 3), (256, 1)],
            build_rounds: 11,
            light_rounds: 5,
            light_sides: vec![2, 3],
            saving_rounds: 3,
        }
    }

    /// For half a minute.
    pub fn quick() -> Self {
        Self {
            size: [256; 2],
            pictures: vec![(1, 3), (16, 1)],
            build_rounds: 3,
            light_rounds: 1,
            light_sides: vec![2, 3],
            saving_rounds: 3,
        }
    }
}
