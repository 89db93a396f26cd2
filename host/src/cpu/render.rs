//! Stages `trace` and `shade` on the CPU, in waves of samples.

use super::Cpu;
use super::paint::{paint_depth, paint_heat, resolve};
use super::trees::{Tree, Trees};
use crate::backend::{Deferral, DeferredTrees, Output, Shot};
use crate::picture::{Picture, RenderReport, RenderSettings, View};
use crate::scene::ViewError;
use crate::tree::{Bvh, Question};
use crate::{CpuError, Scene, Stages};
use rayon::prelude::*;
use slimbvh_core::camera::Camera as CoreCamera;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::ray::{Hit, PreparedRay};
use slimbvh_core::sampling::Draw;
use slimbvh_core::shade::{
    Environment, Light as CoreLight, Material as CoreMaterial, Path, Shadow, ambient_light,
    direct_light, direct_light_or_dark,
};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::trace::{ClosestHit, Counted};
use slimbvh_core::view;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Instant;

/// Samples in flight.
const WAVE: u32 = 1 << 18;

/// Samples that a task takes at once.
const BLOCK: usize = 512;

/// Renders pictures, and keeps its buffers from one to the next.
#[derive(Debug, Default)]
pub struct Renderer {
    paths: Vec<Path>,
    hits: Vec<Hit>,
    heat: Vec<u32>,
    depths: Vec<u32>,
}

/// Trees that are built in the picture, and where the times of that go.
type Deferred<'a> = (&'a mut dyn DeferredTrees<Cpu>, &'a mut Stages);

/// All that a picture is made from, next to the tree.
struct Stage<'a> {
    scene: &'a Scene,
    trees: Trees<'a>,
    scale: PowerOfTwo,
    camera: CoreCamera,
    lights: Vec<CoreLight>,
    materials: Vec<CoreMaterial>,
    environment: Environment,
    dark_rays: bool,
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
        let stage = Stage::new(scene, trees, settings)?;
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

    /// Sends the samples `first..first + count` off from the camera.
    fn begin(&mut self, stage: &Stage, first: u32, count: u32, report: &mut RenderReport) {
        self.paths.resize(count as usize, Path::default());
        self.hits.resize(count as usize, Hit::MISS);
        report.stages.time("camera", || {
            let blocks = self.paths.par_chunks_mut(BLOCK).enumerate();
            blocks.for_each(|(block, paths)| {
                for (path, sample) in paths.iter_mut().zip(first + (block * BLOCK) as u32..) {
                    *path = Path::new(stage.camera.ray(sample), sample);
                }
            });
        });
        report.primary_ray_count += u64::from(count);
    }

    fn trace_primary(&mut self, stage: &Stage, report: &mut RenderReport) {
        report
            .stages
            .time("trace primary", || self.trace_paths(&stage.trees.primary));
        let hits = self.hits.par_iter().filter(|hit| hit.is_hit()).count();
        report.primary_hit_count += hits as u64;
    }

    /// Finds what every living path meets.
    fn trace_paths(&mut self, tree: &Tree) {
        let blocks = self
            .hits
            .par_chunks_mut(BLOCK)
            .zip(self.paths.par_chunks(BLOCK));
        blocks.for_each(|(hits, paths)| {
            hits.fill(Hit::MISS);
            let alive = paths.iter().enumerate().filter(|(_, path)| path.is_alive());
            let rays = alive.map(|(i, path)| (i, path.ray, path.skip));
            tree.ask(Question::Closest, rays, |i, hit| hits[i] = hit);
        });
    }

    /// Gathers light, and follows mirrors and glass to the given depth.
    fn shade(
        &mut self,
        stage: &Stage,
        deferred: &mut Option<Deferred>,
        mirror_depth: u32,
        report: &mut RenderReport,
    ) -> Result<(), CpuError> {
        for depth in 0..=mirror_depth {
            for (index, light) in stage.lights.iter().enumerate() {
                let tree = match deferred {
                    None => stage.trees.lights[index],
                    Some((trees, build)) => {
                        let stages = &mut report.stages;
                        let mut reaches =
                            || stages.time("shade", || self.reaches(stage, (light, depth)));
                        match trees.deferral(index) {
                            Deferral::Ready => stage.trees.lights[index],
                            // No ray needs the tree of a light that reaches nothing.
                            Deferral::IfReached(..) if !reaches() => continue,
                            _ => Tree::all(trees.build(build, index)?),
                        }
                    }
                };
                report.stages.time("trace shadow", || {
                    report.shadow_ray_count += self.add_light(stage, (light, depth), &tree);
                });
            }
            let alive = report.stages.time("shade", || self.scatter(stage));
            let Some(bvh) = stage.trees.mirrors else {
                break;
            };
            if alive == 0 || depth == mirror_depth {
                break;
            }
            report.mirror_ray_count += alive;
            report
                .stages
                .time("trace mirror", || self.trace_paths(&Tree::all(bvh)));
        }
        Ok(())
    }

    /// Whether a light reaches anything, as far as nothing stands in its way.
    fn reaches(&self, stage: &Stage, light: (&CoreLight, u32)) -> bool {
        let blocks = self
            .paths
            .par_chunks(BLOCK)
            .zip(self.hits.par_chunks(BLOCK));
        blocks.into_par_iter().any(|(paths, hits)| {
            let mut pairs = paths.iter().zip(hits);
            pairs.any(|(path, hit)| {
                path.is_alive() && hit.is_hit() && stage.shadow(path, hit, light).is_possible()
            })
        })
    }

    /// Adds one light to all hits that it reaches, of paths that have met so many mirrors. Returns the number of shadow rays.
    fn add_light(&mut self, stage: &Stage, (light, bounce): (&CoreLight, u32), tree: &Tree) -> u64 {
        let ray_count = AtomicU64::new(0);
        let blocks = self
            .paths
            .par_chunks_mut(BLOCK)
            .zip(self.hits.par_chunks(BLOCK));
        blocks.for_each_init(Vec::new, |shadows, (paths, hits)| {
            shadows.clear();
            for (i, (path, hit)) in paths.iter().zip(hits).enumerate() {
                if path.is_alive() && hit.is_hit() {
                    let shadow = stage.shadow(path, hit, (light, bounce));
                    if shadow.is_possible() {
                        shadows.push((i, shadow));
                    }
                }
            }
            let numbered = shadows.iter().enumerate();
            let rays = numbered.map(|(number, (_, shadow))| (number, shadow.ray, shadow.skip));
            tree.ask(Question::Any, rays, |number, hit| {
                if !hit.is_hit() {
                    let (i, shadow) = &shadows[number];
                    paths[*i] = paths[*i].with_light(glam::Vec3::from_array(shadow.radiance));
                }
            });
            ray_count.fetch_add(shadows.len() as u64, Relaxed);
        });
        ray_count.into_inner()
    }

    /// Ends paths, or sends them on at mirrors and through glass. Returns how many go on.
    fn scatter(&mut self, stage: &Stage) -> u64 {
        let blocks = self
            .paths
            .par_chunks_mut(BLOCK)
            .zip(self.hits.par_chunks(BLOCK));
        let alive = blocks.map(|(paths, hits)| {
            let mut alive = 0;
            for (path, hit) in paths.iter_mut().zip(hits) {
                if !path.is_alive() {
                    continue;
                }
                *path = if hit.is_hit() {
                    let (surface, material) = stage.surface(path, hit);
                    let ambient = ambient_light(&material, &stage.environment);
                    path.with_light(ambient)
                        .scattered(&surface, &material, hit.primitive)
                } else {
                    path.escaped(&stage.environment)
                };
                alive += u64::from(path.is_alive());
            }
            alive
        });
        alive.sum()
    }

    /// Shows what the first hit is.
    fn show(&mut self, stage: &Stage, view: View, report: &mut RenderReport) {
        report.stages.time("shade", || {
            let blocks = self
                .paths
                .par_chunks_mut(BLOCK)
                .zip(self.hits.par_chunks(BLOCK));
            blocks.for_each(|(paths, hits)| {
                for (path, hit) in paths.iter_mut().zip(hits) {
                    if !hit.is_hit() {
                        continue;
                    }
                    let (surface, _) = stage.surface(path, hit);
                    let color = match view {
                        View::Normals => view::normal_color(surface.shading_normal),
                        _ => view::primitive_color(hit.primitive),
                    };
                    *path = path.with_light(color);
                }
            });
        });
    }

    /// Counts the nodes that each sample visits.
    fn count_nodes(&mut self, stage: &Stage, report: &mut RenderReport) {
        let bvh = stage.trees.primary.bvh;
        let begin = self.heat.len();
        self.heat.resize(begin + self.paths.len(), 0);
        let blocks = self.heat[begin..]
            .par_chunks_mut(BLOCK)
            .zip(self.paths.par_chunks(BLOCK));
        let hits = report.stages.time("trace primary", || {
            blocks
                .map(|(heat, paths)| {
                    let mut hits = 0;
                    for (count, path) in heat.iter_mut().zip(paths) {
                        let ray = PreparedRay::new(&path.ray, 0);
                        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
                        bvh.collect(&ray, path.skip, &mut collector);
                        *count = collector.node_count;
                        hits += u64::from(collector.inner.hit.is_hit());
                    }
                    hits
                })
                .sum::<u64>()
        });
        report.primary_hit_count += hits;
    }
}

impl<'a> Stage<'a> {
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

    /// What a light may add to a hit, of a path that has met so many mirrors.
    fn shadow(&self, path: &Path, hit: &Hit, (light, bounce): (&CoreLight, u32)) -> Shadow {
        let (surface, material) = self.surface(path, hit);
        let draw = Draw {
            sample: path.sample,
            sample_count: self.camera.sample_count,
            bounce,
        };
        let light = light.sampled(&draw);
        if self.dark_rays {
            direct_light_or_dark(&surface, hit.primitive, &material, &light)
        } else {
            direct_light(&surface, hit.primitive, &material, &light)
        }
    }

    /// The point that a path hit, and what it is made of.
    fn surface(&self, path: &Path, hit: &Hit) -> (Surface, CoreMaterial) {
        let mesh = &self.scene.mesh;
        let triangle = leaf_triangle(hit.primitive, &mesh.triangles(), &self.scale).triangle();
        let corners = mesh.indices.get(hit.primitive as usize);
        let corners = corners.copied().unwrap_or_default();
        let normals = corners.map(|corner| {
            mesh.normals
                .get(corner as usize)
                .map_or(glam::Vec3::ZERO, |&n| glam::Vec3::from_array(n))
        });
        let material = mesh
            .materials
            .get(hit.primitive as usize)
            .map_or(0, |&m| m as usize);
        let material = self.materials.get(material).or(self.materials.first());
        let direction = glam::Vec3::from_array(path.ray.direction);
        (
            Surface::new(triangle, hit, direction, normals),
            material.copied().unwrap_or(DEFAULT_MATERIAL),
        )
    }
}

/// Stands in where a triangle names a material that is not there.
const DEFAULT_MATERIAL: CoreMaterial = CoreMaterial {
    base_color: [0.8; 3],
    mirror: 0.0,
    transmission: 0.0,
    ior: 1.0,
    padding: [0; 2],
};
