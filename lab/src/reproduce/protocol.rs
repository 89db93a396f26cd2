//! Sizes and repeats of a measurement.

use serde::Serialize;

/// Sizes and repeats.
#[derive(Clone, Debug, Serialize)]
pub struct Protocol {
    /// Width and height of pictures.
    pub size: [u32; 2],
    /// Samples per pixel, and the number of rounds with as many.
    pub pictures: Vec<(u32, u32)>,
    /// Rounds of builds.
    pub build_rounds: u32,
    /// Rounds of pictures under many lights.
    pub light_rounds: u32,
    /// Lights along each side of their square.
    pub light_sides: Vec<u32>,
    /// Rounds of pictures with and without each saving.
    pub saving_rounds: u32,
}

impl Protocol {
    /// The paper's sizes: 1024×1024 pixels of 1, 16 and 256 samples.
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

    /// Takes half a minute.
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
