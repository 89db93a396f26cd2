//! Rays from inside a mesh, and a list of those that escape.

use crate::meshes::Solid;
use glam::Vec3;
use slimbvh::{Bvh, Mesh};
use slimbvh_core::Ray;
use slimbvh_tests::random::Random;
use std::collections::BTreeSet;

/// The number of rays of each kind at each point.
#[derive(Clone, Copy)]
pub struct Aims {
    /// In random directions.
    pub random_count: usize,
    /// At random points of each edge.
    pub per_edge: usize,
}

/// Rays from every inner point: in random directions, at every vertex, and at points of every edge, mostly near its ends.
pub fn rays(solid: &Solid, aims: Aims) -> Vec<Ray> {
    let mut random = Random::new(17);
    let edges = edges(&solid.mesh);
    let mut rays = Vec::new();
    for &eye in &solid.inside {
        for _ in 0..aims.random_count {
            rays.push(Ray::new(eye.to_array(), random.direction().to_array()));
        }
        for &vertex in &solid.mesh.vertices {
            rays.push(at(eye, Vec3::from(vertex)));
        }
        for &[a, b] in &edges {
            let [a, b] = [a, b].map(|v| Vec3::from(solid.mesh.vertices[v as usize]));
            for _ in 0..aims.per_edge {
                let s = random.unit();
                let s = if random.below(2) == 0 {
                    s
                } else {
                    0.1f32.powf(6.0 * s)
                };
                rays.push(at(eye, a + s * (b - a)));
            }
        }
    }
    rays
}

/// The rays from inside that hit nothing.
pub fn escapes(bvh: &Bvh, rays: &[Ray]) -> Vec<Ray> {
    let escapes = |ray: &Ray| !bvh.closest_hit(ray).is_hit() || !bvh.any_hit(ray);
    rays.iter().filter(|&ray| escapes(ray)).copied().collect()
}

pub fn at(eye: Vec3, target: Vec3) -> Ray {
    Ray::new(eye.to_array(), (target - eye).to_array())
}

/// Each edge once.
pub fn edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let edges = mesh
        .indices
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let sorted = edges.map(|[a, b]| [a.min(b), a.max(b)]);
    sorted.collect::<BTreeSet<_>>().into_iter().collect()
}
