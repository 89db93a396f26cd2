//! Rendering on the CPU in waves of samples: stage `camera`, then `trace`, then `shade` or `view`.

use super::Cpu;
use super::camera::{order_by_rows, resolve};
use super::trees::Trees;
use super::view::{paint_depth, paint_heat};
use crate::backend::{DeferredTrees, Output, Shot};
use crate::picture::{Picture, RenderReport, RenderSettings, View};
use crate::scene::ViewError;
use crate::tree::Bvh;
use crate::{CpuError, Scene, Stages, Stopwatch};
use slimbvh_core::camera::Camera as CoreCamera;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::ray::Hit;
use slimbvh_core::shade::{Environment, Light as CoreLight, Material as CoreMaterial, Path};
use slimbvh_core::view;

/// Samples in flight.
const WAVE: u32 = 1 << 18;

/// Samples in a parallel task.
pub const BLOCK: usize = 512;

/// Renders pictures. Keeps its buffers from one to the next.
#[derive(Debug, Default)]
pub struct Renderer {
    pub(super) paths: Vec<Path>,
    pub(super) hits: Vec<Hit>,
    pub(super) heat: Vec<u32>,
    depths: Vec<u32>,
}

/// Trees that are built during the picture, and the times of their builds.
pub type Deferred<'a> = (&'a mut dyn DeferredTrees<Cpu>, &'a mut Stages);

/// The inputs of a picture besides the trees.
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
    /// A renderer with empty buffers.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Renders a scene through its first camera; see [`Scene::complete`] for scenes without one. The tree must be over the
    /// scene's mesh. `progress` is called with the share done, 0 to 1.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered, and a mesh with a different number of triangles than the tree's.
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

    /// [`Self::render`] with one hierarchy for each kind of rays.
    ///
    /// # Errors
    /// Those of [`Self::render`].
    ///
    /// # Panics
    /// If the number of hierarchies for shadow rays differs from the number of lights.
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
            begin: Stopwatch::start(),
        };
        let output = Output {
            picture,
            progress: Some(&mut progress),
        };
        match self.render_shot(&shot, None, output) {
            Ok(report) => Ok(report),
            Err(CpuError::View(error)) => Err(error),
            Err(CpuError::Mesh(_) | CpuError::Refit(_)) => {
                unreachable!("a render without deferred trees builds none")
            }
        }
    }

    /// Renders, builds deferred trees and adds their times. With deferred trees all samples are in flight together, so that
    /// each tree is built once, or once for each mirror along the paths. No tree is built for a light that reaches no hit.
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
        report.stages.time("resolve", || order_by_rows(picture));
        Ok(report)
    }

    /// Bytes of the buffers that the last picture used. The next picture reuses them.
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
