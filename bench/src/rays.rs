//! The rays, the same for all tracers.

use anyhow::{Context, Result};
use glam::Vec3;
use rayon::prelude::*;
use slimbvh::internals::Random;
use slimbvh::{Aabb, Builder, Camera, Light, Mesh, Projection};
use slimbvh_core::{Hit, IndexedTriangles, Ray};
use std::fmt;

/// Width and height of the picture; each pixel has one ray.
pub const PICTURE: [u32; 2] = [1280, 720];

/// Rays of a task: as many as a row of the picture has.
pub const BLOCK: usize = PICTURE[0] as usize;

/// The order of the picture's rays in their list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RayOrder {
    /// Tiles of 8×8 pixels in Morton order ([`slimbvh::Tiles`]).
    #[default]
    Tiles,
    /// Row by row.
    Rows,
}

impl fmt::Display for RayOrder {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str(match self {
            Self::Tiles => "in tiles of 8×8 pixels",
            Self::Rows => "row by row",
        })
    }
}

/// The option that orders rays by rows.
pub const ROWS_OPTION: &str = "--rows";

/// The direction from the scene's middle to the eye, and the distance in diagonals of the scene.
const EYE: Vec3 = Vec3::new(0.35, 0.25, 1.0);
const EYE_DISTANCE: f32 = 1.1;
const VERTICAL_FOV: f32 = 35.0;

/// The direction to the sun.
const SUN: Vec3 = Vec3::new(0.3, 0.8, 0.5);

/// The distance from the surface to the start of shadow rays, in diagonals of the scene.
const SURFACE_OFFSET: f32 = 1e-4;

/// Rays from the eye through every pixel, and a ray to the sun from each hit, if the side of the triangle that the eye sees
/// faces the sun. Directions have length 1, up to rounding. Shadow rays are in the order of the rays whose hits they leave.
#[derive(Clone, Debug)]
pub struct RayLists {
    /// Rays for closest hits.
    pub primary: Vec<Ray>,
    /// Rays for any hit.
    pub shadow: Vec<Ray>,
}

impl RayLists {
    /// The rays for a mesh.
    ///
    /// # Errors
    /// For meshes that are not valid or have no triangles.
    pub fn new(mesh: &Mesh, order: RayOrder) -> Result<Self> {
        let bvh = Builder::default().build(mesh)?;
        let bounds = bvh.bounds().context("the mesh has no triangles")?;
        let primary = primary_rays(&bounds, PICTURE, order)?;
        let mut hits = Vec::new();
        bvh.closest_hits(&primary, &mut hits);
        let surfaces = Surfaces::new(mesh, &bounds, &primary, &hits);
        Ok(Self {
            shadow: surfaces.shadow_rays(),
            primary,
        })
    }
}

/// The camera of a scene with this box.
#[must_use]
pub fn camera(bounds: &Aabb) -> Camera {
    let center = (bounds.min + bounds.max) * 0.5;
    Camera {
        eye: (center + EYE.normalize() * EYE_DISTANCE * diagonal(bounds)).to_array(),
        target: center.to_array(),
        up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective {
            vertical_fov: VERTICAL_FOV,
        },
    }
}

/// The light that shadow rays go to.
#[must_use]
pub fn sun() -> Light {
    Light::Directional {
        direction: (-SUN).to_array(),
        color: [3.0; 3],
    }
}

/// Rays of the [`camera`] of a scene with this box, one through every pixel of a picture of this width and height.
///
/// # Errors
/// If the box is a point, or not finite.
pub fn primary_rays(bounds: &Aabb, size: [u32; 2], order: RayOrder) -> Result<Vec<Ray>> {
    let camera = camera(bounds).to_core(size, 1)?;
    let rays = (0..size[0] * size[1]).into_par_iter().map(|number| {
        let ray = camera.ray(match order {
            RayOrder::Tiles => camera.sample_of_thread(number),
            RayOrder::Rows => number,
        });
        let direction = Vec3::from_array(ray.direction).normalize();
        Ray::new(ray.origin, direction.to_array())
    });
    Ok(rays.collect())
}

fn diagonal(bounds: &Aabb) -> f32 {
    (bounds.max - bounds.min).length()
}

/// Where rays meet a mesh: rays that start there, in the order of the rays that hit. Directions have length 1, up to rounding.
pub struct Surfaces<'a> {
    mesh: &'a Mesh,
    offset: f32,
    rays: &'a [Ray],
    hits: &'a [Hit],
}

impl<'a> Surfaces<'a> {
    /// The hits of these rays on a mesh with this box.
    #[must_use]
    pub fn new(mesh: &'a Mesh, bounds: &Aabb, rays: &'a [Ray], hits: &'a [Hit]) -> Self {
        Self {
            mesh,
            offset: SURFACE_OFFSET * diagonal(bounds),
            rays,
            hits,
        }
    }

    /// A ray to the sun from each hit whose seen side faces it.
    #[must_use]
    pub fn shadow_rays(&self) -> Vec<Ray> {
        let sun = SUN.normalize();
        let pairs = self.rays.par_iter().zip(self.hits);
        let rays = pairs.filter_map(|(ray, hit)| {
            let (point, normal) = self.seen(ray, hit)?;
            let faces_sun = normal.dot(sun) > 0.0;
            faces_sun.then(|| Ray::new(point.to_array(), sun.to_array()))
        });
        rays.collect()
    }

    /// A ray from each hit in a random direction on its seen side, with a density in proportion to the cosine to the normal.
    #[must_use]
    pub fn bounce_rays(&self, seed: u64) -> Vec<Ray> {
        let mut random = Random::new(seed);
        let pairs = self.rays.iter().zip(self.hits);
        let rays = pairs.filter_map(|(ray, hit)| {
            let (point, normal) = self.seen(ray, hit)?;
            // A point of the unit sphere that touches the surface.
            let direction = (normal + random.direction()).normalize_or(normal);
            Some(Ray::new(point.to_array(), direction.to_array()))
        });
        rays.collect()
    }

    /// A point close to a hit, and the normal there, both on the side that the ray comes from. `None` for a miss, and on
    /// triangles without an area.
    fn seen(&self, ray: &Ray, hit: &Hit) -> Option<(Vec3, Vec3)> {
        if !hit.is_hit() {
            return None;
        }
        let triangles = IndexedTriangles {
            vertices: &self.mesh.vertices,
            indices: &self.mesh.indices,
        };
        let normal = triangles.triangle(hit.primitive).normal();
        let direction = Vec3::from_array(ray.direction);
        let normal = (normal * -normal.dot(direction).signum()).normalize_or_zero();
        let point = Vec3::from_array(ray.origin) + direction * hit.t;
        (normal != Vec3::ZERO).then(|| (point + normal * self.offset, normal))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::generate;

    #[test]
    fn bounce_rays_leave_the_seen_side_and_differ_by_seed() -> Result<()> {
        let mesh = generate::icosphere(Vec3::ZERO, 1.0, 3);
        let bvh = Builder::default().build(&mesh)?;
        let bounds = bvh.bounds().context("a sphere has a box")?;
        let primary = primary_rays(&bounds, [64, 48], RayOrder::Tiles)?;
        let mut hits = Vec::new();
        bvh.closest_hits(&primary, &mut hits);
        let surfaces = Surfaces::new(&mesh, &bounds, &primary, &hits);
        let rays = surfaces.bounce_rays(7);
        assert_eq!(rays.len(), hits.iter().filter(|hit| hit.is_hit()).count());
        let mut cosines = 0.0;
        for ray in &rays {
            let [point, direction] = [ray.origin, ray.direction].map(Vec3::from_array);
            assert!((direction.length() - 1.0).abs() < 1e-5);
            // From a convex body no ray that leaves it hits it.
            assert!(!bvh.any_hit(ray));
            cosines += point.normalize().dot(direction);
        }
        // The mean cosine under this density is 2/3; a uniform one has 1/2.
        let mean = cosines / rays.len() as f32;
        assert!((mean - 2.0 / 3.0).abs() < 0.03, "{mean}");
        assert_eq!(rays, surfaces.bounce_rays(7));
        assert_ne!(rays, surfaces.bounce_rays(8));
        Ok(())
    }
}
