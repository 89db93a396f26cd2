//! Stage `shade` on the CPU: light, shadow rays, mirrors and glass.

use super::render::{BLOCK, Deferred, Prepared, Renderer};
use super::trees::{Tree, skipping};
use crate::CpuError;
use crate::backend::Deferral;
use crate::picture::RenderReport;
use crate::tree::{Question, surface_at};
use rayon::prelude::*;
use slimbvh_core::ray::Hit;
use slimbvh_core::sampling::Draw;
use slimbvh_core::shade::{
    Light as CoreLight, Material as CoreMaterial, Path, Shadow, ambient_light, direct_light,
    direct_light_or_dark,
};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

impl Renderer {
    /// Adds light, and follows paths through mirrors and glass to the given depth.
    pub(super) fn shade(
        &mut self,
        stage: &Prepared,
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
                            // A light that reaches no hit needs no tree.
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

    /// Whether a light could reach any hit, occlusion aside.
    fn reaches(&self, stage: &Prepared, light: (&CoreLight, u32)) -> bool {
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

    /// Adds one light to all hits that it reaches, at this bounce. Returns the number of shadow rays.
    fn add_light(
        &mut self,
        stage: &Prepared,
        (light, bounce): (&CoreLight, u32),
        tree: &Tree,
    ) -> u64 {
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
            let rays =
                numbered.map(|(number, (_, shadow))| (number, skipping(shadow.ray, shadow.skip)));
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

    /// Ends paths, or continues them at mirrors and through glass. Returns how many continue.
    fn scatter(&mut self, stage: &Prepared) -> u64 {
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
}

impl Prepared<'_> {
    /// The light that a hit may receive, at this bounce.
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

    /// The point that a path hit, and its material.
    pub(super) fn surface(&self, path: &Path, hit: &Hit) -> (Surface, CoreMaterial) {
        let mesh = &self.scene.mesh;
        let triangle = leaf_triangle(hit.primitive, &mesh.triangles(), &self.scale).triangle();
        let material = mesh
            .materials
            .get(hit.primitive as usize)
            .map_or(0, |&m| m as usize);
        let material = self.materials.get(material).or(self.materials.first());
        let direction = glam::Vec3::from_array(path.ray.direction);
        (
            surface_at(mesh, triangle, hit, direction),
            material.copied().unwrap_or(DEFAULT_MATERIAL),
        )
    }
}

/// Used for a triangle whose material index is out of range.
const DEFAULT_MATERIAL: CoreMaterial = CoreMaterial {
    base_color: [0.8; 3],
    mirror: 0.0,
    transmission: 0.0,
    ior: 1.0,
    padding: [0; 2],
};
