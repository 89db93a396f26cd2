//! Steps of lattices.

use slimbvh::{RenderSettings, Scene, Tolerance, View};

/// The step of a lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// As fine as floats are.
    Finest,
    /// No vertex moves by more than this many pixels.
    Pixels(f32),
}

/// The picture whose pixels tolerances refer to, whatever picture is rendered.
pub const PIXELS: RenderSettings = RenderSettings {
    size: [1280, 720],
    sample_count: 1,
    view: View::Color,
    mirror_depth: 0,
    dark_rays: false,
};

impl Step {
    /// The step's exponent for a scene. Pixels are those of a picture with these settings.
    pub fn exponent(self, scene: &Scene, settings: &RenderSettings) -> i32 {
        let finest = scene.mesh.finest_step();
        match self {
            Self::Finest => finest,
            Self::Pixels(pixels) => {
                let tolerance = Tolerance::Pixels(pixels);
                tolerance.step_exponent(scene, settings).unwrap_or(finest)
            }
        }
    }
}
