//! A picture from a scene in one call.

use super::{Renderer, check, waves};
use crate::gpu::{Bvh, Frame, Gpu, GpuError, Scene, Trees};
use crate::scene::{Camera, Light, ViewError};
use crate::{Picture, RenderReport, RenderSettings, Stages, Stopwatch};
use slimbvh_core::Aabb;
use slimbvh_core::bounds::scene_exponent;

impl Renderer {
    /// Uploads a scene, renders it through its first camera with a hierarchy over its mesh, and waits for the picture.
    /// Builds nothing. `progress` is called with the share done, 0 to 1.
    ///
    /// # Errors
    /// Those of [`Scene::upload`] and [`Self::render`]. The check of sizes precedes every allocation.
    pub fn render_image(
        &mut self,
        gpu: &Gpu,
        (scene, bvh): (&crate::Scene, &Bvh),
        settings: &RenderSettings,
        picture: &mut Picture,
        progress: impl FnMut(f64),
    ) -> Result<RenderReport, GpuError> {
        let begin = Stopwatch::start();
        scene.mesh.validate()?;
        let camera = check_view(gpu, scene, settings)?;
        let uploaded = Scene::upload(gpu, scene)?;
        let image = Image {
            uploaded: &uploaded,
            trees: &Trees::all(bvh, scene.lights.len()),
            view: (camera, &scene.lights),
            settings,
            begin,
        };
        let (_, report) = image.render(self, gpu.frame(), picture, progress)?;
        Ok(report)
    }
}

/// Refuses a view that cannot be rendered, and a picture above the GPU's limits. Returns the camera.
pub fn check_view<'a>(
    gpu: &Gpu,
    scene: &'a crate::Scene,
    settings: &RenderSettings,
) -> Result<&'a Camera, GpuError> {
    let camera = scene.cameras.first().ok_or(ViewError::NoCamera)?;
    let bounds = scene.mesh.bounds().unwrap_or(Aabb::EMPTY);
    camera.check_reach(scene_exponent(&bounds))?;
    camera.to_core(settings.size, settings.sample_count)?;
    let limit = gpu.limits().max_storage_buffer_binding_size;
    check(gpu, settings, &waves(settings, limit))?;
    Ok(camera)
}

/// The inputs of a picture. They are on the GPU already, or will be in the frame that begins the picture.
pub struct Image<'a, 't> {
    pub uploaded: &'a Scene,
    pub trees: &'a Trees<'t>,
    pub view: (&'a Camera, &'a [Light]),
    pub settings: &'a RenderSettings,
    pub begin: Stopwatch,
}

impl Image<'_, '_> {
    /// Renders wave after wave, each a submission that the call waits for; the first is that of the frame. Returns the
    /// times of the frame's builds, and the report of the render.
    pub fn render(
        self,
        renderer: &mut Renderer,
        mut frame: Frame,
        picture: &mut Picture,
        mut progress: impl FnMut(f64),
    ) -> Result<(Stages, RenderReport), GpuError> {
        let gpu = frame.gpu();
        let plan = renderer.plan(
            &mut frame,
            self.uploaded,
            self.trees,
            self.view,
            self.settings,
        )?;
        let wave_count = plan.waves.len();
        let mut stages = Stages::default();
        for wave in 0..wave_count {
            renderer.encode(&mut frame, &plan, wave..wave + 1, None)?;
            if wave + 1 == wave_count {
                break;
            }
            stages.merge(&frame.submit()?.wait()?);
            progress((wave + 1) as f64 / wave_count as f64);
            frame = gpu.frame();
        }
        let times = renderer.finish(frame, stages, self.begin, picture)?;
        progress(1.0);
        Ok(times)
    }
}
