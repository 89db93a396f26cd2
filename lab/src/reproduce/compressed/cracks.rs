//! Cracks in surfaces: rays that are aimed at vertices and edges of a closed mesh, and get inside.

use anyhow::{Context, Result};
use rayon::prelude::*;
use serde::Serialize;
use slimbvh::{Bvh, Ray, Scene};

/// The outcomes of the aimed rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Cracks {
    pub aimed: usize,
    /// Rays that hit nothing.
    pub lost: usize,
    /// Rays that passed their target and first hit a triangle from behind: they got in between two triangles.
    pub leaked: usize,
}

/// A triangle faces the eye if the cosine of its normal is above this, and is hit from behind if the cosine is below the
/// negative of this.
const COSINE: f64 = 0.05;

/// A ray passed its target if its hit is farther behind the target than this share of the way.
const BEHIND: f32 = 1e-4;

/// Aims about `ray_count` rays from the eye at corners and middles of edges of triangles that face it, spread evenly. The
/// mesh must be closed, with the eye outside.
pub fn aim(scene: &Scene, bvh: &Bvh, ray_count: usize) -> Result<Cracks> {
    let eye = scene
        .cameras
        .first()
        .context("the scene has no camera")?
        .eye;
    let mesh = &scene.mesh;
    let cosine = |triangle: usize, direction: Wide| {
        let corners = mesh.indices[triangle].map(|v| mesh.vertices[v as usize].map(f64::from));
        let [a, b, c] = corners;
        let normal = cross(minus(b, a), minus(c, a));
        -dot(normal, direction) / (dot(normal, normal) * dot(direction, direction)).sqrt()
    };
    let targets = |triangle: usize| {
        let [a, b, c] = mesh.indices[triangle].map(|v| mesh.vertices[v as usize]);
        let middle = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|i| 0.5 * a[i] + 0.5 * b[i]);
        [a, middle(a, b), middle(b, c), middle(c, a)]
    };
    // About half of the triangles face the eye, and each is the target of four rays.
    let stride = (2 * mesh.indices.len() / ray_count.max(1)).max(1);
    let triangles = (0..mesh.indices.len()).into_par_iter().step_by(stride);
    let cracks = triangles.map(|triangle| {
        let mut cracks = Cracks::default();
        for target in targets(triangle) {
            let direction = [0, 1, 2].map(|i| target[i] - eye[i]);
            if cosine(triangle, direction.map(f64::from)) > COSINE {
                let hit = bvh.closest_hit(Ray::new(eye, direction));
                let from_behind =
                    || cosine(hit.primitive as usize, direction.map(f64::from)) < -COSINE;
                cracks.aimed += 1;
                cracks.lost += usize::from(!hit.is_hit());
                let passed = hit.is_hit() && hit.t > 1.0 + BEHIND;
                cracks.leaked += usize::from(passed && from_behind());
            }
        }
        cracks
    });
    Ok(cracks.reduce(Cracks::default, Cracks::plus))
}

impl Cracks {
    fn plus(self, other: Self) -> Self {
        Self {
            aimed: self.aimed + other.aimed,
            lost: self.lost + other.lost,
            leaked: self.leaked + other.leaked,
        }
    }
}

type Wide = [f64; 3];

fn minus(a: Wide, b: Wide) -> Wide {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Wide, b: Wide) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Wide, b: Wide) -> Wide {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
