//! Your own query: how many surfaces a ray crosses, and the distance from the first to the last.
//!
//! slimbvh's traversal passes every hit to a [`Collector`]. A new query is a new collector.
#![cfg_attr(target_arch = "spirv", no_std)]

use slimbvh_core::launch::thread_index;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{Collector, LeafTriangles, PlainNodes, Skip, traverse};
use slimbvh_core::{Hit, LeafTriangle, Node, Ray, Vec3};
use spirv_std::glam::{UVec3, UVec4};
use spirv_std::spirv;

/// The answer for a ray. 8 bytes.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Thickness {
    /// Bytes 0–3: triangles on the ray; two if it passes through a common edge.
    pub surface_count: u32,
    /// Bytes 4–7: the distance from the first to the last, in the scene's unit.
    pub distance: f32,
}

/// Counts all hits on a ray without storing them.
struct Crossings {
    count: u32,
    first: Hit,
    last: Hit,
    t_max: f32,
}

impl Collector for Crossings {
    /// Every hit counts, so the limit never shrinks.
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.t_max
    }

    #[inline(always)]
    fn offer(&mut self, hit: Hit) {
        if self.count == 0 || hit.t < self.first.t {
            self.first = hit;
        }
        if self.count == 0 || hit.t > self.last.t {
            self.last = hit;
        }
        self.count += 1;
    }
}

/// One thread per ray. Reads the scene's exponent, the tree and the ray. Stores the answer.
#[spirv(compute(threads(64)))]
pub fn thickness(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] found: &mut [Thickness],
) {
    let i = thread_index(id.x, id.y) as usize;
    if i < rays.len() && i < found.len() {
        let ray = PreparedRay::new(&rays[i], exponent.x as i32);
        let mut crossings = Crossings {
            count: 0,
            first: Hit::MISS,
            last: Hit::MISS,
            t_max: ray.t_max,
        };
        traverse(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &ray,
            &Skip::NONE,
            &mut crossings,
        );
        // Restored hits have t in units of the direction's length. The difference of two misses is 0.
        let (first, last) = (ray.restore(crossings.first), ray.restore(crossings.last));
        let unit = Vec3::from_array(rays[i].direction).length();
        found[i] = Thickness {
            surface_count: crossings.count,
            distance: (last.t - first.t) * unit,
        };
    }
}
