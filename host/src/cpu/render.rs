//! Pictures on the CPU, in waves of samples: stages `camera`, `trace` and `shade` or `view`, one after the other.

use super::Cpu;
use super::camera::resolve;
use super::trees::Trees;
use super::view::{paint_depth, paint_heat};
use crate::backend::{DeferredTrees, Output, Shot};
use crate::picture::{Picture, RenderReport, RenderSettings, View};
use crate::scene::ViewError;
use crate::tree::Bvh;
use crate::{CpuError, Scene, Stages};
use slimbvh_core::camera::Camera as CoreCamera;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::ray::Hit;
use slimbvh_core::shade::{Environment, Light as CoreLight, Material as CoreMaterial, Path};
use slimbvh_core::view;
use std::time::Instant;

/// Samples in flight.
const WAVE: u32 = 1 << 18;

/// Samples that a task takes at once.
pub const BLOCK: usize = 512;

/// Renders pictures, and keeps its buffers from one to the next.
#[derive(Debug, Default)]
pub struct Renderer {
    pub(super) paths: Vec<Path>,
    pub(super) hits: Vec<Hit>,
    pub(super) heat: Vec<u32>,
    depths: Vec<u32>,
}

/// Trees that are built in the picture, and where the times of that go.
pub type Deferred<'a> = (&'a mut dyn DeferredTrees<Cpu>, &'a mut Stages);

/// All that a picture is made from, next to the tree.
pub struct Prepared<'a> {
    pub scene: &'a Scene,
    pub trees: Trees<'a>,
    pub scale: PowerOfTwo,
    pub camera: CoreCamera,
    pub lights: Vec<CoreLight>,
    pub materials: Vec<CoreMaterial>,
    pub environment: Environment,
    pub dark_rays: bool,
}

impl Renderer {
    /// A renderer without buffers yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Renders a scene, whose mesh the tree was built over, through its first camera; see [`Scene::complete`] for scenes
    /// without one. `progress` is told the share done, 0 to 1.
    ///
    /// # Errors
    /// For cameras and lights that make no picture, and a mesh with another number of triangles than the tree.
    pub fn render(
        &mut self,
        scene: &Scene,
        bvh: &Bvh,
        settings: &RenderSettings,
        picture: &mut Picture,
        progress: impl FnMut(f64),
    ) -> Result<RenderReport, ViewError> {
        let trees = Trees::all(bvh, scene.lights.len());
        self.render_with(scene, &trees, settings, picture, progress)
    }

    /// [`Self::render`], with a hierarchy for each kind of rays.
    ///
    /// # Errors
    /// Those of [`Self::render`].
    ///
    /// # Panics
    /// If there are not as many hierarchies for shadow rays as there are lights.
    pub fn render_with(
        &mut self,
        scene: &Scene,
        trees: &Trees,
        settings: &RenderSettings,
        picture: &mut Picture,
        mut progress: impl FnMut(f64),
    ) -> Result<RenderReport, ViewError> {
        let shot = Shot {
            scene,
            held: &(),
            trees,
            settings,
            begin: Instant::now(),
        };
        let output = Output {
            picture,
            progress: Some(&mut progress),
        };
        match self.render_shot(&shot, None, output) {
            Ok(report) => Ok(report),
            Err(CpuError::View(error)) => Err(error),
            Err(CpuError::Mesh(_) | CpuError::Refit(_)) => unreachable!("nothing is built"),
        }
    }

    /// Renders, and builds deferred trees, whose times are added: then all samples are in flight at once, so that each tree is
    /// built once, or once for each mirror that paths meet. None is built for a light that reaches nothing.
    pub(super) fn render_shot(
        &mut self,
        shot: &Shot<Cpu>,
        mut deferred: Option<Deferred>,
        output: Output,
    ) -> Result<RenderReport, CpuError> {
        let Shot {
            scene,
            trees,
            settings,
            ..
        } = *shot;
        let Output {
            picture,
            mut progress,
        } = output;
        let wave = if deferred.is_some() { u32::MAX } else { WAVE };
        assert_eq!(
            trees.lights.len(),
            scene.lights.len(),
            "a tree for each light"
        );
        let stage = Prepared::new(scene, trees, settings)?;
        let mut report = RenderReport::default();
        let [width, height] = settings.size;
        let pixel_count = width * height;
        picture.width = width;
        picture.height = height;
        picture.pixels.clear();
        picture.pixels.resize(pixel_count as usize, [0.0; 3]);
        self.heat.clear();
        self.depths.clear();

        let wave_pixels = (wave / settings.sample_count).max(1);
        for first_pixel in (0..pixel_count).step_by(wave_pixels as usize) {
            let pixels = wave_pixels.min(pixel_count - first_pixel);
            let first = first_pixel * settings.sample_count;
            self.begin(&stage, first, pixels * settings.sample_count, &mut report);
            if settings.view == View::Heatmap {
                self.count_nodes(&stage, &mut report);
            } else {
                self.trace_primary(&stage, &mut report);
                match settings.view {
                    View::Color => {
                        self.shade(&stage, &mut deferred, settings.mirror_depth, &mut report)?;
                    }
                    View::Depth => self.depths.extend(self.hits.iter().map(view::depth_value)),
                    view => self.show(&stage, view, &mut report),
                }
            }
            let to = &mut picture.pixels[first_pixel as usize..(first_pixel + pixels) as usize];
            report.stages.time("resolve", || {
                resolve(&self.paths, settings.sample_count, to);
            });
            if let Some(progress) = &mut progress {
                progress(f64::from(first_pixel + pixels) / f64::from(pixel_count));
            }
        }
        if settings.view == View::Depth {
            paint_depth(&self.depths, settings.sample_count, picture);
        }
        if settings.view == View::Heatmap {
            paint_heat(&self.heat, settings.sample_count, picture);
            report.node_visit_count = self.heat.iter().map(|&count| u64::from(count)).sum();
        }
        Ok(report)
    }

    /// Bytes of the buffers that the last picture used; they are kept for the next.
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        size_of_val(self.paths.as_slice())
            + size_of_val(self.hits.as_slice())
            + size_of_val(self.heat.as_slice())
            + size_of_val(self.depths.as_slice())
    }
}

impl<'a> Prepared<'a> {
    fn new(
        scene: &'a Scene,
        trees: &Trees<'a>,
        settings: &RenderSettings,
    ) -> Result<Self, ViewError> {
        let camera = scene.cameras.first().ok_or(ViewError::NoCamera)?;
        let light_trees = trees.lights.iter().map(|tree| tree.bvh);
        let all = light_trees.chain(trees.mirrors).chain([trees.primary.bvh]);
        for bvh in all {
            if scene.mesh.indices.len() != bvh.mesh_triangle_count() {
                return Err(ViewError::OtherMesh {
                    triangle_count: scene.mesh.indices.len(),
                    expected: bvh.mesh_triangle_count(),
                });
            }
        }
        let exponent = trees.primary.bvh.scene_exponent();
        let scale = PowerOfTwo::new(exponent);
        let core_camera = camera.to_core(settings.size, settings.sample_count)?;
        camera.check_reach(exponent)?;
        let lights = scene.lights.iter().enumerate();
        Ok(Self {
            scene,
            trees: Trees {
                primary: trees.primary.scaled(&scale),
                lights: trees
                    .lights
                    .iter()
                    .map(|tree| tree.scaled(&scale))
                    .collect(),
                mirrors: trees.mirrors,
            },
            scale,
            camera: core_camera.scaled(&scale),
            lights: lights
                .map(|(index, light)| Ok(light.to_core(index)?.scaled(&scale)))
                .collect::<Result<_, ViewError>>()?,
            materials: scene.core_materials(),
            environment: Scene::environment(camera.up),
            dark_rays: settings.dark_rays,
        })
    }
}
