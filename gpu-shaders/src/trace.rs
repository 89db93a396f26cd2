//! Stage `trace`. Rays are in the caller's magnitude, paths and shadow rays in the scene's.

use crate::{count, thread_index};
use glam::{UVec3, UVec4, Vec3, Vec4};
use slimbvh_core::classify::{Except, Facing, Sides};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{
    ClosestHit, ClosestOrAny, Counted, LeafTriangles, PlainNodes, any_hit, closest_hit,
    nearest_hits, traverse,
};
use slimbvh_core::{Hit, LeafTriangle, Node, Ray};
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
            &Except::NOTHING,
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
            &Except::NOTHING,
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
            &Except::NOTHING,
            &mut collector,
        );
        counts[i] = [collector.node_count, collector.triangle_count];
    }
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
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() {
        // The range of an ended path's ray is empty: it meets nothing.
        let hit = closest_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &paths[i].ray,
            0,
            &Except(paths[i].skip),
        );
        hits[i] = hit;
        count(counters, 0, paths[i].is_alive() as u32);
        count(counters, 1, hit.is_hit() as u32);
    }
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
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() && i < counts.len() {
        let ray = PreparedRay::new(&paths[i].ray, 0);
        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
        traverse(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &ray,
            &Except(paths[i].skip),
            &mut collector,
        );
        let hit = ray.restore(collector.inner.hit);
        hits[i] = hit;
        counts[i] = collector.node_count;
        count(counters, 0, paths[i].is_alive() as u32);
        count(counters, 1, hit.is_hit() as u32);
        count(counters, 2, collector.node_count);
    }
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
    let i = thread_index(id) as usize;
    if i < shadows.len() && i < paths.len() && shadows[i].is_possible() {
        count(counters, 0, 1);
        let is_blocked = any_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &shadows[i].ray,
            0,
            &Except(shadows[i].skip),
        );
        if !is_blocked {
            paths[i] = paths[i].with_light(Vec3::from_array(shadows[i].radiance));
        }
    }
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
    let i = thread_index(id) as usize;
    if i < paths.len() && i < hits.len() {
        let target = scaled_target(target, exponent.x);
        let hit = closest_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &paths[i].ray,
            0,
            &Facing {
                skip: paths[i].skip,
                sides: Sides { components, sides },
                target,
            },
        );
        hits[i] = hit;
        count(counters, 0, paths[i].is_alive() as u32);
        count(counters, 1, hit.is_hit() as u32);
    }
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
    let i = thread_index(id) as usize;
    if i < shadows.len() && i < paths.len() && shadows[i].is_possible() {
        count(counters, 0, 1);
        let target = scaled_target(target, exponent.x);
        let is_blocked = any_hit(
            &PlainNodes(nodes),
            &LeafTriangles(triangles),
            &shadows[i].ray,
            0,
            &Facing {
                skip: shadows[i].skip,
                sides: Sides { components, sides },
                target,
            },
        );
        if !is_blocked {
            paths[i] = paths[i].with_light(Vec3::from_array(shadows[i].radiance));
        }
    }
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
        &Except::NOTHING,
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
