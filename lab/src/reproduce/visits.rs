//! Counts nodes and triangles that rays test; the counts are the same on every machine.

use super::facing_target::FacingTarget;
use anyhow::{Context, Result};
use rayon::prelude::*;
use serde::Serialize;
use slimbvh::topology::Topology;
use slimbvh::{BuildConfig, Builder, Bvh, Hit, Ray, Scene, Subset};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay};
use slimbvh_core::shade::{Light, Shadow, direct_light};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::trace::{AnyHit, ClosestHit, Collector, Counted, Skip, traverse};

/// Mean counts for each ray.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Mean {
    /// Inner nodes opened; each tests two boxes.
    pub nodes: f64,
    /// Triangles tested.
    pub triangles: f64,
}

/// The counts of one picture's rays, with one sample a pixel.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Visits {
    pub primary_rays: usize,
    pub primary_whole: Mean,
    pub primary_reduced: Mean,
    pub shadow_rays: usize,
    pub shadow_whole: Mean,
    /// Through the front set, L+: triangles that face the light.
    pub shadow_reduced: Mean,
    /// Through the back set, L−: triangles that face away from the light.
    pub shadow_away: Mean,
}

/// Traces a picture's primary rays and its shadow rays to the first light, through the whole tree and through the sets.
pub fn count(
    scene: &Scene,
    topology: &Topology,
    (camera, light): (&FacingTarget, &FacingTarget),
    size: [u32; 2],
) -> Result<Visits> {
    let mut builder = Builder::new(BuildConfig::default());
    builder.sort(&scene.mesh)?;
    let mut build = |subset: Subset| {
        let mut bvh = Bvh::default();
        builder.build_sorted(&scene.mesh, subset, &mut bvh);
        bvh
    };
    let whole = build(Subset::All);
    let seen = build(camera.subset(topology));
    let lit = build(light.subset(topology));
    let back = build(light.back().subset(topology));

    // Scale camera and light to the scene's magnitude, as the tree is.
    let scale = PowerOfTwo::new(whole.scene_exponent());
    let view = scene.cameras.first().context("the scene has no camera")?;
    let view = view.to_core(size, 1)?.scaled(&scale);
    let source = scene.lights.first().context("the scene has no light")?;
    let source = source.to_core(0)?.scaled(&scale);
    let rays = (0..size[0] * size[1])
        .into_par_iter()
        .map(|sample| view.ray(sample));
    let rays: Vec<(Ray, u32)> = rays.map(|ray| (ray, NO_PRIMITIVE)).collect();
    let shadows = rays.par_iter().filter_map(|(ray, _)| {
        let mut closest = ClosestHit::new(PreparedRay::new(ray, 0).t_max);
        walk(&whole, ray, NO_PRIMITIVE, &mut closest);
        let shadow = shadow_ray(scene, &scale, ray, &closest.hit, &source);
        shadow.is_possible().then_some((shadow.ray, shadow.skip))
    });
    let shadows: Vec<(Ray, u32)> = shadows.collect();
    Ok(Visits {
        primary_rays: rays.len(),
        primary_whole: mean(&whole, &rays, ClosestHit::new),
        primary_reduced: mean(&seen, &rays, ClosestHit::new),
        shadow_rays: shadows.len(),
        shadow_whole: mean(&whole, &shadows, AnyHit::new),
        shadow_reduced: mean(&lit, &shadows, AnyHit::new),
        shadow_away: mean(&back, &shadows, AnyHit::new),
    })
}

/// The ray from a hit to a light, without normals or materials.
fn shadow_ray(scene: &Scene, scale: &PowerOfTwo, ray: &Ray, hit: &Hit, light: &Light) -> Shadow {
    if !hit.is_hit() {
        return Shadow::NONE;
    }
    let triangle = leaf_triangle(hit.primitive, &scene.mesh.triangles(), scale).triangle();
    let direction = glam::Vec3::from_array(ray.direction);
    let surface = Surface::new(triangle, hit, direction, [glam::Vec3::ZERO; 3]);
    let material = slimbvh_core::shade::Material {
        base_color: [1.0; 3],
        ..Default::default()
    };
    direct_light(&surface, hit.primitive, &material, light)
}

/// Traces rays and returns their mean counts. Each ray skips the triangle that it starts on.
fn mean<C: Collector>(bvh: &Bvh, rays: &[(Ray, u32)], collector: impl Fn(f32) -> C + Sync) -> Mean {
    let counts = rays.par_iter().map(|(ray, skip)| {
        let mut counted = Counted::new(collector(PreparedRay::new(ray, 0).t_max));
        walk(bvh, ray, *skip, &mut counted);
        [
            u64::from(counted.node_count),
            u64::from(counted.triangle_count),
        ]
    });
    let sums = counts.reduce(|| [0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
    let [nodes, triangles] = sums.map(|sum| sum as f64 / rays.len().max(1) as f64);
    Mean { nodes, triangles }
}

fn walk(bvh: &Bvh, ray: &Ray, skip: u32, collector: &mut impl Collector) {
    let ray = PreparedRay::new(ray, 0);
    let (nodes, triangles) = (bvh.node_source(), bvh.triangle_source());
    traverse(&nodes, &triangles, &ray, &Skip(skip), collector);
}
