//! Your own query: how many surfaces a ray crosses, and the distance from the first to the last.
//!
//! slimbvh's traversal passes every hit to a [`Collector`]. A new query is a new collector.
#![cfg_attr(target_arch = "spirv", no_std)]

use slimbvh_core::codec::{PackedWideNodes, PackedWideRow, RootWords, SharedTriangles};
use slimbvh_core::float::power_of_two;
use slimbvh_core::launch::thread_index;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    Collector, LeafTriangles, NodeSource, PlainNodes, Skip, TriangleSource, traverse,
};
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
    let (nodes, triangles) = (PlainNodes(nodes), LeafTriangles(triangles));
    measure(id, exponent, (&nodes, &triangles), rays, found);
}

/// The same in a tree of nodes of 48 bytes (`w4-48`), whose root is one more binding.
#[spirv(compute(threads(64)))]
pub fn thickness_w4_48(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[PackedWideRow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &[u32],
    #[spirv(uniform, descriptor_set = 0, binding = 3)] root: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] found: &mut [Thickness],
) {
    let root = RootWords {
        low: root[0].to_array(),
        high: root[1].to_array(),
    };
    let step = power_of_two(root.step_exponent());
    let nodes = PackedWideNodes {
        nodes,
        root: root.lattice(),
        step,
    };
    let triangles = SharedTriangles { words, step };
    measure(id, exponent, (&nodes, &triangles), rays, found);
}

/// The query, over any tree.
#[inline(always)]
fn measure<N: NodeSource, T: TriangleSource<N::Bounds>>(
    id: UVec3,
    exponent: &UVec4,
    (nodes, triangles): (&N, &T),
    rays: &[Ray],
    found: &mut [Thickness],
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
        traverse(nodes, triangles, &ray, &Skip::NONE, &mut crossings);
        // Restored hits have t in units of the direction's length. The difference of two misses is 0.
        let (first, last) = (ray.restore(crossings.first), ray.restore(crossings.last));
        let unit = Vec3::from_array(rays[i].direction).length();
        found[i] = Thickness {
            surface_count: crossings.count,
            distance: (last.t - first.t) * unit,
        };
    }
}
