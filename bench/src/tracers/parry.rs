//! parry3d: the mesh of a physics engine.

use super::{Answer, Bytes, Tracer, answer_all, from_start};
use anyhow::{Context, Result};
use parry3d::math::Vector;
use parry3d::query::{Ray as PeerRay, RayCast};
use parry3d::shape::{CompositeShapeRef, TriMesh};
use slimbvh::{Mesh, Stages};
use slimbvh_core::Ray;

/// parry3d's `TriMesh`.
///
/// A build first copies vertices and indices, as parry3d's mesh owns them.
pub struct Parry<'a> {
    mesh: &'a Mesh,
    built: Option<TriMesh>,
}

impl<'a> Parry<'a> {
    /// A tracer without a tree yet.
    #[must_use]
    pub fn new(mesh: &'a Mesh) -> Self {
        Self { mesh, built: None }
    }
}

fn peer_ray(ray: &Ray) -> PeerRay {
    let [origin, direction] = [ray.origin, ray.direction].map(Vector::from_array);
    PeerRay::new(origin, direction)
}

fn closest_hit(mesh: &TriMesh, ray: &Ray) -> Answer {
    let (ray, shift) = from_start(ray);
    let hit = CompositeShapeRef(mesh).cast_local_ray(&peer_ray(&ray), ray.t_max, false);
    hit.map_or(Answer::MISS, |(primitive, t)| Answer {
        t: t + shift,
        primitive,
    })
}

/// parry3d has closest hits only. The first hit is reported as the nearest possible, which ends the search.
fn any_hit(mesh: &TriMesh, ray: &Ray) -> bool {
    let (ray, _) = from_start(ray);
    let peer_ray = peer_ray(&ray);
    let hit = mesh.bvh().cast_ray(&peer_ray, ray.t_max, |triangle, best| {
        let hit = mesh
            .triangle(triangle)
            .cast_local_ray(&peer_ray, best, false);
        hit.map(|_| f32::MIN)
    });
    hit.is_some()
}

impl Tracer for Parry<'_> {
    fn name(&self) -> &'static str {
        "parry3d"
    }

    fn build(&mut self) -> Result<Stages> {
        let vertices = self.mesh.vertices.iter().copied().map(Vector::from_array);
        let built = TriMesh::new(vertices.collect(), self.mesh.indices.clone());
        self.built = Some(built.context("parry3d refuses the mesh")?);
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        self.built = None;
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        if let Some(mesh) = &self.built {
            answer_all(rays, answers, |ray| closest_hit(mesh, ray));
        }
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        if let Some(mesh) = &self.built {
            answer_all(rays, answers, |ray| any_hit(mesh, ray));
        }
    }

    fn bytes(&self) -> Bytes {
        let built = self.built.as_ref();
        Bytes {
            nodes: built.map(|mesh| mesh.bvh().heap_memory_size()),
            all: built.map(TriMesh::heap_memory_size),
        }
    }
}
