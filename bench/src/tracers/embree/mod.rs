//! Embree 3 in robust mode, with single rays or packets of sixteen.

mod ffi;

pub use ffi::Quality;

use super::{Answer, Bytes, Tracer, answer_all, answer_rows, not_behind};
use anyhow::{Result, bail};
use ffi::{Device, MISS, Ray1, Ray16, RayHit1, RayHit16, Scene, Valid};
use slimbvh::{Mesh, Stages};
use slimbvh_core::Ray;

/// Embree's bound on the coordinates of rays (`FLT_LARGE`).
const LARGEST: f32 = 1.844e18;

/// The number of rays in a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// One ray a call.
    Single,
    /// Sixteen rays a call, marked as coherent.
    Packets,
}

/// Embree's tree for a mesh.
///
/// The first build starts a device with as many threads as the pool that builds; later builds keep it.
pub struct Embree<'a> {
    name: &'static str,
    quality: Quality,
    packing: Packing,
    /// Dropped before the device, which must be dropped last.
    scene: Option<Scene<'a>>,
    device: Option<Device>,
    vertices: &'a [[f32; 3]],
    indices: &'a [[u32; 3]],
}

impl<'a> Embree<'a> {
    /// A tracer without a tree yet. `vertices` are the mesh's and one more, unused.
    #[must_use]
    pub fn new(
        name: &'static str,
        (quality, packing): (Quality, Packing),
        vertices: &'a [[f32; 3]],
        mesh: &'a Mesh,
    ) -> Self {
        Self {
            name,
            quality,
            packing,
            scene: None,
            device: None,
            vertices,
            indices: &mesh.indices,
        }
    }
}

/// A ray, and the shift to add to its t. Embree's rays must not reach behind their origin.
fn peer_ray(ray: &Ray) -> (Ray1, f32) {
    let (ray, shift) = not_behind(ray);
    let ray = Ray1 {
        origin: ray.origin,
        near: ray.t_min,
        direction: ray.direction,
        time: 0.0,
        far: ray.t_max.min(f32::MAX),
        mask: u32::MAX,
        id: 0,
        flags: 0,
    };
    (ray, shift)
}

fn closest_hit(scene: &Scene<'_>, ray: &Ray) -> Answer {
    let (ray, shift) = peer_ray(ray);
    let mut hit = RayHit1 {
        ray,
        normal: [0.0; 3],
        uv: [0.0; 2],
        primitive: MISS,
        geometry: MISS,
        instance: MISS,
    };
    scene.intersect1(&mut hit);
    answer(hit.geometry, hit.primitive, hit.ray.far + shift)
}

fn any_hit(scene: &Scene<'_>, ray: &Ray) -> bool {
    let (mut ray, _) = peer_ray(ray);
    scene.occluded1(&mut ray);
    ray.far < 0.0
}

fn answer(geometry: u32, primitive: u32, t: f32) -> Answer {
    if geometry == MISS {
        Answer::MISS
    } else {
        Answer { t, primitive }
    }
}

/// Up to sixteen rays, which of them are valid, and the shifts to add to their t.
fn packet(rays: &[Ray]) -> (Valid, Ray16, [f32; 16]) {
    let mut valid = Valid([0; 16]);
    let mut shifts = [0.0; 16];
    let mut packet = Ray16 {
        origin: [[0.0; 16]; 3],
        near: [0.0; 16],
        direction: [[0.0; 16]; 3],
        time: [0.0; 16],
        far: [0.0; 16],
        mask: [u32::MAX; 16],
        id: [0; 16],
        flags: [0; 16],
    };
    for (i, ray) in rays.iter().enumerate() {
        let (ray, shift) = peer_ray(ray);
        (valid.0[i], shifts[i]) = (-1, shift);
        (packet.near[i], packet.far[i]) = (ray.near, ray.far);
        for axis in 0..3 {
            packet.origin[axis][i] = ray.origin[axis];
            packet.direction[axis][i] = ray.direction[axis];
        }
    }
    (valid, packet, shifts)
}

fn closest_hits_of_16(scene: &Scene<'_>, rays: &[Ray], answers: &mut [Answer]) {
    let (valid, ray, shifts) = packet(rays);
    let mut hits = RayHit16 {
        ray,
        normal: [[0.0; 16]; 3],
        uv: [[0.0; 16]; 2],
        primitive: [MISS; 16],
        geometry: [MISS; 16],
        instance: [MISS; 16],
    };
    scene.intersect16(&valid, &mut hits);
    for (i, to) in answers.iter_mut().enumerate() {
        let t = hits.ray.far[i] + shifts[i];
        *to = answer(hits.geometry[i], hits.primitive[i], t);
    }
}

fn any_hits_of_16(scene: &Scene<'_>, rays: &[Ray], answers: &mut [bool]) {
    let (valid, mut packet, _) = packet(rays);
    scene.occluded16(&valid, &mut packet);
    for (to, far) in answers.iter_mut().zip(packet.far) {
        *to = far < 0.0;
    }
}

impl Tracer for Embree<'_> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn build(&mut self) -> Result<Stages> {
        let device = match &mut self.device {
            Some(device) => device,
            none => none.insert(Device::new(rayon::current_num_threads())?),
        };
        let scene = match &mut self.scene {
            Some(scene) => scene,
            none => none.insert(Scene::new(
                device,
                self.quality,
                self.vertices,
                self.indices,
            )?),
        };
        if let Err(error) = scene.build(device) {
            self.scene = None;
            bail!(error);
        }
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        self.scene = None;
    }

    /// Whether Embree calls this a valid ray; Debian's build requires that.
    fn takes(&self, ray: &Ray) -> bool {
        let mut numbers = ray.origin.iter().chain(&ray.direction);
        numbers.all(|x| x.abs() < LARGEST)
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        match (&self.scene, self.packing) {
            (None, _) => {}
            (Some(scene), Packing::Single) => {
                answer_all(rays, answers, |ray| closest_hit(scene, ray));
            }
            (Some(scene), Packing::Packets) => answer_rows(rays, answers, |rays, answers| {
                for (rays, answers) in rays.chunks(16).zip(answers.chunks_mut(16)) {
                    closest_hits_of_16(scene, rays, answers);
                }
            }),
        }
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        match (&self.scene, self.packing) {
            (None, _) => {}
            (Some(scene), Packing::Single) => {
                answer_all(rays, answers, |ray| any_hit(scene, ray));
            }
            (Some(scene), Packing::Packets) => answer_rows(rays, answers, |rays, answers| {
                for (rays, answers) in rays.chunks(16).zip(answers.chunks_mut(16)) {
                    any_hits_of_16(scene, rays, answers);
                }
            }),
        }
    }

    /// Triangles lie in the leaves, so only the sum of both is known.
    fn bytes(&self) -> Bytes {
        Bytes {
            nodes: None,
            all: self.device.as_ref().map(Device::bytes),
        }
    }
}
