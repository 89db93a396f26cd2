//! How far vertices may move, and the lattice step that follows.

use crate::{Aabb, BuildConfig, MeshCodec, Processor, Projection, RenderSettings, Scene};
use glam::Vec3;

/// How far a vertex may move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// A distance in the scene's unit.
    Length(f32),
    /// Pixels of the picture, at the point nearest to the camera.
    Pixels(f32),
}

/// Points nearer to the camera than this share of the scene's diagonal may move further than the tolerance.
const NEAREST: f32 = 0.01;

/// A vertex moves at most half a step along each axis, so √3 / 2 steps in all.
const STEPS: f64 = 0.866_025_403_784_438_6;

impl Tolerance {
    /// The largest distance in the scene's unit.
    #[must_use]
    pub fn length(self, scene: &Scene, settings: &RenderSettings) -> f32 {
        match self {
            Self::Length(length) => length,
            Self::Pixels(count) => count * pixel(scene, settings),
        }
    }

    /// The exponent of the largest power of two that is a lattice step on which no vertex moves further. `None` if the step
    /// is finer than floats resolve: then no vertex should move.
    #[must_use]
    pub fn step_exponent(self, scene: &Scene, settings: &RenderSettings) -> Option<i32> {
        let length = f64::from(self.length(scene, settings));
        let finest = scene.mesh.finest_step();
        if !length.is_finite() || length <= 0.0 {
            return None;
        }
        let step = (length / STEPS).log2().floor() as i32;
        // Rounding of the logarithm must not let a vertex move further.
        let step = if 2f64.powi(step) * STEPS > length {
            step - 1
        } else {
            step
        };
        (step >= finest).then_some(step)
    }
}

impl Scene {
    /// Moves the vertices onto the coarsest lattice on which none moves further than the tolerance, seen in pictures with these
    /// settings. Returns settings of builds that store triangles on that lattice, and nodes as suits the processor. Where the
    /// lattice would be finer than floats resolve, nothing moves, and the settings store both in full.
    ///
    /// ```
    /// use slimbvh::{Processor, RenderSettings, Scene, Tolerance, generate};
    /// let mut scene = Scene { mesh: generate::teapot(), ..Scene::default() };
    /// let settings = RenderSettings::default();
    /// scene.complete(scene.mesh.bounds(), settings.size);
    /// let build = scene.compress(Tolerance::Pixels(0.5), &settings, Processor::Cpu);
    /// assert_eq!(build.nodes.name(), "w4-48");
    /// ```
    pub fn compress(
        &mut self,
        tolerance: Tolerance,
        settings: &RenderSettings,
        processor: Processor,
    ) -> BuildConfig {
        let mesh = match tolerance.step_exponent(self, settings) {
            Some(step_exponent) => {
                self.mesh.snap(step_exponent);
                MeshCodec::on_lattice(step_exponent)
            }
            None => MeshCodec::F32,
        };
        BuildConfig {
            nodes: mesh.nodes_for(processor),
            mesh,
            ..BuildConfig::default()
        }
    }
}

/// The size of a pixel at the scene's nearest point, at least a hundredth of the scene's diagonal away.
fn pixel(scene: &Scene, settings: &RenderSettings) -> f32 {
    let (Some(camera), Some(bounds)) = (scene.cameras.first(), scene.mesh.bounds()) else {
        return 0.0;
    };
    let height = settings.size[1] as f32;
    match camera.projection {
        Projection::Orthographic { height: picture } => picture / height,
        Projection::Perspective { vertical_fov } | Projection::ThinLens { vertical_fov, .. } => {
            let diagonal = (bounds.max - bounds.min).length();
            let distance = distance_to(&bounds, Vec3::from(camera.eye)).max(NEAREST * diagonal);
            2.0 * (0.5 * vertical_fov.to_radians()).tan() * distance / height
        }
    }
}

/// The distance of a point from a box, 0 inside.
fn distance_to(bounds: &Aabb, p: Vec3) -> f32 {
    p.distance(p.clamp(bounds.min, bounds.max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, Mesh};

    /// A square 8 wide at z = 0, seen from `eye` along −z.
    fn scene(eye: f32, projection: Projection) -> Scene {
        Scene {
            mesh: Mesh {
                vertices: vec![[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [4.0, 4.0, 0.0]],
                indices: vec![[0, 1, 2]],
                ..Mesh::default()
            },
            cameras: vec![Camera {
                eye: [1.0, 0.5, eye],
                target: [1.0, 0.5, 0.0],
                up: [0.0, 1.0, 0.0],
                projection,
            }],
            ..Scene::default()
        }
    }

    const SETTINGS: RenderSettings = RenderSettings {
        size: [400, 200],
        sample_count: 1,
        view: crate::View::Color,
        mirror_depth: 0,
        dark_rays: false,
    };

    #[test]
    fn a_pixel_is_as_large_as_it_is_at_the_nearest_point() {
        let wide = Projection::Perspective { vertical_fov: 90.0 };
        let length = |scene: &Scene| Tolerance::Pixels(0.5).length(scene, &SETTINGS);
        // 2 tan(45°) · 3 / 200, half of it.
        assert!((length(&scene(3.0, wide)) - 0.015).abs() < 1e-6);
        let parallel = Projection::Orthographic { height: 10.0 };
        assert!((length(&scene(3.0, parallel)) - 0.025).abs() < 1e-6);
        // No nearer than a hundredth of the diagonal.
        let near = 0.5 * 2.0 * 0.01 * 128f32.sqrt() / 200.0;
        assert!((length(&scene(1e-5, wide)) - near).abs() < 1e-6);
    }

    #[test]
    fn steps_keep_to_the_tolerance_and_are_hardly_finer() {
        let scene = scene(3.0, Projection::Perspective { vertical_fov: 90.0 });
        for length in [1e-6f32, 1e-3, 0.0137, 0.866_025, 0.866_026, 3.0] {
            let step = Tolerance::Length(length).step_exponent(&scene, &SETTINGS);
            let most = 0.75f64.sqrt() * 2f64.powi(step.expect("floats are finer"));
            assert!(
                most <= f64::from(length) && 2.0 * most > f64::from(length),
                "{length}"
            );
        }
        for length in [1e-9, 0.0, f32::NAN] {
            let step = Tolerance::Length(length).step_exponent(&scene, &SETTINGS);
            assert_eq!(step, None, "{length}");
        }
    }
}
