//! The rays, the same for all tracers.

use anyhow::{Context, Result};
use glam::Vec3;
use rayon::prelude::*;
use slimbvh::{Builder, Bvh, Camera, Mesh, Projection};
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
        let diagonal = (bounds.max - bounds.min).length();
        let center = (bounds.min + bounds.max) * 0.5;
        let camera = Camera {
            eye: (center + EYE.normalize() * EYE_DISTANCE * diagonal).to_array(),
            target: center.to_array(),
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective {
                vertical_fov: VERTICAL_FOV,
            },
        };
        let camera = camera.to_core(PICTURE, 1)?;
        let primary: Vec<Ray> = (0..PICTURE[0] * PICTURE[1])
            .into_par_iter()
            .map(|number| {
                let ray = camera.ray(match order {
                    RayOrder::Tiles => camera.sample_of_thread(number),
                    RayOrder::Rows => number,
                });
                let direction = Vec3::from_array(ray.direction).normalize();
                Ray::new(ray.origin, direction.to_array())
            })
            .collect();
        let shadow = primary
            .par_iter()
            .filter_map(|ray| shadow_ray(mesh, &bvh, ray, SURFACE_OFFSET * diagonal))
            .collect();
        Ok(Self { primary, shadow })
    }
}

/// The shadow ray from a hit to the sun, if that side of the triangle faces it.
fn shadow_ray(mesh: &Mesh, bvh: &Bvh, ray: &Ray, offset: f32) -> Option<Ray> {
    let hit: Hit = bvh.closest_hit(ray);
    if !hit.is_hit() {
        return None;
    }
    let triangles = IndexedTriangles {
        vertices: &mesh.vertices,
        indices: &mesh.indices,
    };
    let normal = triangles.triangle(hit.primitive).normal();
    let direction = Vec3::from_array(ray.direction);
    let normal = (normal * -normal.dot(direction).signum()).normalize_or_zero();
    let point = Vec3::from_array(ray.origin) + direction * hit.t;
    let sun = SUN.normalize();
    (normal.dot(sun) > 0.0).then(|| Ray::new((point + normal * offset).to_array(), sun.to_array()))
}
