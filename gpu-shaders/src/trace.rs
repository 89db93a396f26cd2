//! Stage `trace`. Rays are in the caller's magnitude, paths and shadow rays in the scene's.

use crate::thread_index;
use glam::{UVec3, UVec4, Vec4};
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{ClosestOrAny, LeafTriangles, PlainNodes, Skip, traverse};
use slimbvh_core::{Hit, LeafTriangle, Node, Ray};
use spirv_std::spirv;

pub mod coded;
mod store;

/// One thread per ray. Reads the scene's exponent, the tree and the ray. Stores the closest hit.
#[spirv(compute(threads(64)))]
pub fn trace_closest(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] hits: &mut [Hit],
) {
    let (i, exponent) = (thread_index(id), exponent.x as i32);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    store::closest(i, exponent, nodes, triangles, rays, hits);
}

/// One thread per ray. Reads the scene's exponent, the tree and the ray. Stores 1 where it meets anything, else 0.
#[spirv(compute(threads(64)))]
pub fn trace_any(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] found: &mut [u32],
) {
    let (i, exponent) = (thread_index(id), exponent.x as i32);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    store::any(i, exponent, nodes, triangles, rays, found);
}

/// One thread per ray. Reads the scene's exponent, the tree and the ray. Stores the nearest hits in order, misses at the
/// end.
#[spirv(compute(threads(64)))]
pub fn trace_nearest(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] hits: &mut [[Hit; NEAREST_COUNT]],
) {
    let (i, exponent) = (thread_index(id), exponent.x as i32);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    store::nearest(i, exponent, nodes, triangles, rays, hits);
}

/// One thread per ray. Reads the scene's exponent, the tree and the ray. Stores how many nodes and triangles the search
/// for the closest hit touches.
#[spirv(compute(threads(64)))]
pub fn trace_counted(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counts: &mut [[u32; 2]],
) {
    let (i, exponent) = (thread_index(id), exponent.x as i32);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    store::counted(i, exponent, nodes, triangles, rays, counts);
}

/// One thread per path. Reads the tree and the path. Stores the closest hit, a miss for paths that have ended. Counts
/// the paths that go on and the hits.
#[spirv(compute(threads(64)))]
pub fn trace_paths(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: &mut [Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counters: &mut [u32],
) {
    let i = thread_index(id);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    let rule = Skip(store::path_skip(i, paths));
    store::paths(i, nodes, triangles, &rule, paths, hits, counters);
}

/// One thread per path. Reads the tree and the path. Stores the closest hit, and how many nodes the search for it opens.
/// Counts the paths that go on, the hits and the nodes.
#[spirv(compute(threads(64)))]
pub fn trace_paths_counted(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: &mut [Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counts: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] counters: &mut [u32],
) {
    let i = thread_index(id);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    store::paths_counted(i, nodes, triangles, paths, hits, counts, counters);
}

/// One thread per path. Reads the tree and what `shade_light` stored. Stores the path with the light, where nothing is
/// in its way. Counts the shadow rays.
#[spirv(compute(threads(64)))]
pub fn trace_shadows(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] shadows: &[Shadow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] paths: &mut [Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counters: &mut [u32],
) {
    let i = thread_index(id);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    let rule = Skip(store::shadow_skip(i, shadows));
    store::shadows(i, nodes, triangles, &rule, shadows, paths, counters);
}

/// As [`trace_paths`], through a whole tree where only triangles count that face the paths' origin: reads the scene's
/// exponent, that target, the components of the primitives and their outer sides, too.
#[spirv(compute(threads(64)))]
pub fn trace_paths_facing(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] hits: &mut [Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] counters: &mut [u32],
) {
    let i = thread_index(id);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    let rule = FacingFilter {
        skip: store::path_skip(i, paths),
        sides: Sides { components, sides },
        target: scaled_target(target, exponent.x),
    };
    store::paths(i, nodes, triangles, &rule, paths, hits, counters);
}

/// As [`trace_shadows`], through a whole tree where only triangles count that face the light: reads the scene's exponent,
/// that target, the components of the primitives and their outer sides, too.
#[spirv(compute(threads(64)))]
pub fn trace_shadows_facing(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] shadows: &[Shadow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] paths: &mut [Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] counters: &mut [u32],
) {
    let i = thread_index(id);
    let (nodes, triangles) = (&PlainNodes(nodes), &LeafTriangles(triangles));
    let rule = FacingFilter {
        skip: store::shadow_skip(i, shadows),
        sides: Sides { components, sides },
        target: scaled_target(target, exponent.x),
    };
    store::shadows(i, nodes, triangles, &rule, shadows, paths, counters);
}

/// A target from its words, in the scene's magnitude.
#[inline(always)]
pub(crate) fn scaled_target(words: &[UVec4; 2], exponent: u32) -> Target {
    let (a, b) = (words[0], words[1]);
    let target = Target {
        point: [
            f32::from_bits(a.x),
            f32::from_bits(a.y),
            f32::from_bits(a.z),
        ],
        is_position: a.w,
        radius: f32::from_bits(b.x),
        padding: [b.y, b.z, b.w],
    };
    target.scaled(&PowerOfTwo::new(exponent as i32))
}

/// Becomes a function that other people's WGSL can call: the shader builder makes private variables of the bindings from
/// 3 on, and `host/shaders/slimbvh.wgsl` of it all. Reads the scene's exponent, the tree, a ray's origin with `t_min` and
/// its direction with `t_max`, and whether any hit will do: 1, or else 0. Stores the hit, as bits.
#[spirv(compute(threads(1)))]
pub fn call_trace(
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[LeafTriangle],
    #[spirv(uniform, descriptor_set = 0, binding = 3)] origin: &Vec4,
    #[spirv(uniform, descriptor_set = 0, binding = 4)] direction: &Vec4,
    #[spirv(uniform, descriptor_set = 0, binding = 5)] any_will_do: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] hit: &mut UVec4,
) {
    let ray = Ray {
        origin: origin.truncate().to_array(),
        t_min: origin.w,
        direction: direction.truncate().to_array(),
        t_max: direction.w,
    };
    let ray = PreparedRay::new(&ray, exponent.x as i32);
    let mut collector = if *any_will_do == 1 {
        ClosestOrAny::any(ray.t_max)
    } else {
        ClosestOrAny::closest(ray.t_max)
    };
    traverse(
        &PlainNodes(nodes),
        &LeafTriangles(triangles),
        &ray,
        &Skip::NONE,
        &mut collector,
    );
    let found = ray.restore(collector.closest.hit);
    *hit = UVec4::new(
        found.t.to_bits(),
        found.u.to_bits(),
        found.v.to_bits(),
        found.primitive,
    );
}
