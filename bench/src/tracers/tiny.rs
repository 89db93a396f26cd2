//! tinybvh, through the crate tinybvh-rs.

// The wrapper's trees are neither `Send` nor `Sync`.
#![allow(unsafe_code)]

use super::{Answer, Bytes, TINY, Tracer, answer_all, from_start, length};
use anyhow::{Result, anyhow};
use glam::Vec3;
use slimbvh::Stages;
use slimbvh_core::Ray;
use tinybvh_rs::{INFINITE, Intersector, Ray as PeerRay, bvh};
#[cfg(target_feature = "avx2")]
use tinybvh_rs::{bvh8_cpu, mbvh};

/// tinybvh's tree of eight children a node, which needs AVX2; without AVX2 its binary tree.
pub struct Tiny<'a> {
    positions: &'a [[f32; 4]],
    built: Option<Shared<'a>>,
}

/// The tree that is traced. The tree of eight children owns a copy of the corners that it needs.
struct Shared<'a> {
    #[cfg(target_feature = "avx2")]
    tree: bvh8_cpu::BVH,
    #[cfg(not(target_feature = "avx2"))]
    tree: bvh::BVH<'a>,
    _positions: &'a [[f32; 4]],
}

// SAFETY: the tree owns its memory or borrows the list's, and nothing in it belongs to the thread that made it.
unsafe impl Send for Shared<'_> {}
// SAFETY: the only call through a shared reference is `Intersect`, which is const: it reads the tree and writes to the ray
// and to its own stack.
unsafe impl Sync for Shared<'_> {}

impl<'a> Tiny<'a> {
    /// A tracer without a tree yet. `positions` has three corners a triangle.
    #[must_use]
    pub fn new(positions: &'a [[f32; 4]]) -> Self {
        Self {
            positions,
            built: None,
        }
    }
}

impl<'a> Shared<'a> {
    fn new(positions: &'a [[f32; 4]]) -> Result<Self> {
        #[cfg_attr(not(target_feature = "avx2"), allow(unused_mut))]
        let mut tree = bvh::BVH::new(positions.into()).map_err(|error| anyhow!("{error}"))?;
        #[cfg(target_feature = "avx2")]
        let tree = {
            tree.split_leaves(4);
            bvh8_cpu::BVH::new(&mbvh::BVH::new(&tree)).map_err(|error| anyhow!("{error}"))?
        };
        Ok(Self {
            tree,
            _positions: positions,
        })
    }

    /// tinybvh normalizes directions, and reads the end of a ray's range from the place where it stores the hit.
    fn closest_hit(&self, ray: &Ray) -> Answer {
        let (ray, shift) = from_start(ray);
        let direction = Vec3::from_array(ray.direction);
        let length = length(direction);
        let end = (ray.t_max * length).min(INFINITE);
        let mut room = Room::new(ray.origin, direction / length, end);
        self.tree.intersect(&mut room.ray);
        let hit = room.ray.hit;
        if hit.t < end {
            Answer {
                t: hit.t / length + shift,
                primitive: hit.prim,
            }
        } else {
            Answer::MISS
        }
    }
}

/// A ray with the size and alignment that tinybvh 1.6 expects: the wrapper's own type is half as large, and its `Ray::new`
/// writes beyond it.
#[repr(C, align(64))]
struct Room {
    ray: PeerRay,
    rest: [u8; 64],
}

const _: () = assert!(size_of::<Room>() == 128);

impl Room {
    #[inline]
    fn new(origin: [f32; 3], direction: Vec3, end: f32) -> Self {
        let mut ray = PeerRay {
            origin,
            dir: direction.to_array(),
            r_d: direction.to_array().map(reciprocal),
            ..PeerRay::default()
        };
        ray.hit.t = end;
        Self { ray, rest: [0; 64] }
    }
}

/// The reciprocal, with tinybvh's bound for small numbers.
fn reciprocal(x: f32) -> f32 {
    if x.abs() > 1e-12 {
        x.recip()
    } else {
        INFINITE.copysign(x)
    }
}

impl Tracer for Tiny<'_> {
    fn name(&self) -> &'static str {
        TINY
    }

    fn build(&mut self) -> Result<Stages> {
        self.built = Some(Shared::new(self.positions)?);
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        self.built = None;
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        if let Some(built) = &self.built {
            answer_all(rays, answers, |ray| built.closest_hit(ray));
        }
    }

    /// The wrapper has closest hits only.
    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        if let Some(built) = &self.built {
            answer_all(rays, answers, |ray| built.closest_hit(ray).is_hit());
        }
    }

    fn bytes(&self) -> Bytes {
        Bytes::default()
    }
}
