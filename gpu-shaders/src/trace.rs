//! Stage `trace`. Rays are in the caller's magnitude, paths and shadow rays in the scene's.

use crate::shade::Shadow;
use crate::{NEAREST_COUNT, thread_index};
use glam::{UVec3, UVec4, Vec3};
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::shade::Path;
use slimbvh_core::trace::{
    ClosestHit, Counted, LeafTriangles, PlainNodes, any_hit, closest_hit, nearest_hits, traverse,
};
use slimbvh_core::{Hit, LeafTriangle, NO_PRIMITIVE, Node, Ray};
use spirv_std::spirv;

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
    let i = thread_index(id) as usize;
    if i < rays.len() && i < hits.len() {
        hits[i] = closest_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &rays[i],
            exponent.x as i32,
            NO_PRIMITIVE,
        );
    }
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
    let i = thread_index(id) as usize;
    if i < rays.len() && i < found.len() {
        found[i] = any_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &rays[i],
            exponent.x as i32,
            NO_PRIMITIVE,
        ) as u32;
    }
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
    let i = thread_index(id) as usize;
    if i < rays.len() && i < hits.len() {
        hits[i] = nearest_hits::<NEAREST_COUNT, _, _>(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &rays[i],
            exponent.x as i32,
        );
    }
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
    let i = thread_index(id) as usize;
    if i < rays.len() && i < counts.len() {
        let ray = PreparedRay::new(&rays[i], exponent.x as i32);
        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
        traverse(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &ray,
            NO_PRIMITIVE,
            &mut collector,
        );
        counts[i] = [collector.node_count, collector.triangle_count];
    }
}

/// One thread per path. Reads the tree and the path. Stores the closest hit, a miss for paths that have ended.
#[spirv(compute(threads(64)))]
pub fn trace_paths(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: &mut [Hit],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() {
        // The range of an ended path's ray is empty: it meets nothing.
        hits[i] = closest_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &paths[i].ray,
            0,
            paths[i].skip,
        );
    }
}

/// One thread per path. Reads the tree and the path. Stores the closest hit, and how many nodes the search for it opens.
#[spirv(compute(threads(64)))]
pub fn trace_paths_counted(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: &mut [Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counts: &mut [u32],
) {
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && i < counts.len() {
        let ray = PreparedRay::new(&paths[i].ray, 0);
        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
        traverse(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &ray,
            paths[i].skip,
            &mut collector,
        );
        hits[i] = ray.restore(collector.inner.hit);
        counts[i] = collector.node_count;
    }
}

/// One thread per path. Reads the tree and what `shade_light` stored. Stores the path with the light, where nothing is
/// in its way.
#[spirv(compute(threads(64)))]
pub fn trace_shadows(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[LeafTriangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] shadows: &[Shadow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] paths: &mut [Path],
) {
    let i = thread_index(id) as usize;
    if i < shadows.len() && i < paths.len() && shadows[i].is_possible() {
        let is_blocked = any_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &shadows[i].ray,
            0,
            shadows[i].skip,
        );
        if !is_blocked {
            paths[i] = paths[i].with_light(Vec3::from_array(shadows[i].radiance));
        }
    }
}
