//! What one thread does of each question, whatever the tree.

use crate::count;
use glam::Vec3;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay};
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{
    ClosestHit, Counted, HitFilter, NodeSource, Skip, TriangleSource, any_hit, closest_hit,
    nearest_hits, traverse,
};
use slimbvh_core::{Hit, Ray};

#[inline(always)]
pub fn closest<N: NodeSource, T: TriangleSource<N::Bounds>>(
    i: u32,
    exponent: i32,
    nodes: &N,
    triangles: &T,
    rays: &[Ray],
    hits: &mut [Hit],
) {
    let i = i as usize;
    if i < rays.len() && i < hits.len() {
        hits[i] = closest_hit(nodes, triangles, &rays[i], exponent, &Skip::NONE);
    }
}

#[inline(always)]
pub fn any<N: NodeSource, T: TriangleSource<N::Bounds>>(
    i: u32,
    exponent: i32,
    nodes: &N,
    triangles: &T,
    rays: &[Ray],
    found: &mut [u32],
) {
    let i = i as usize;
    if i < rays.len() && i < found.len() {
        found[i] = any_hit(nodes, triangles, &rays[i], exponent, &Skip::NONE) as u32;
    }
}

#[inline(always)]
pub fn nearest<N: NodeSource, T: TriangleSource<N::Bounds>>(
    i: u32,
    exponent: i32,
    nodes: &N,
    triangles: &T,
    rays: &[Ray],
    hits: &mut [[Hit; NEAREST_COUNT]],
) {
    let i = i as usize;
    if i < rays.len() && i < hits.len() {
        hits[i] = nearest_hits::<NEAREST_COUNT, _, _>(nodes, triangles, &rays[i], exponent);
    }
}

#[inline(always)]
pub fn counted<N: NodeSource, T: TriangleSource<N::Bounds>>(
    i: u32,
    exponent: i32,
    nodes: &N,
    triangles: &T,
    rays: &[Ray],
    counts: &mut [[u32; 2]],
) {
    let i = i as usize;
    if i < rays.len() && i < counts.len() {
        let ray = PreparedRay::new(&rays[i], exponent);
        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
        traverse(nodes, triangles, &ray, &Skip::NONE, &mut collector);
        counts[i] = [collector.node_count, collector.triangle_count];
    }
}

/// The primitive that a path starts on.
#[inline(always)]
pub fn path_skip(i: u32, paths: &[Path]) -> u32 {
    if (i as usize) < paths.len() {
        paths[i as usize].skip
    } else {
        NO_PRIMITIVE
    }
}

/// The primitive that a shadow ray starts on.
#[inline(always)]
pub fn shadow_skip(i: u32, shadows: &[Shadow]) -> u32 {
    if (i as usize) < shadows.len() {
        shadows[i as usize].skip
    } else {
        NO_PRIMITIVE
    }
}

/// The range of an ended path's ray is empty: it meets nothing.
#[inline(always)]
pub fn paths<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    i: u32,
    nodes: &N,
    triangles: &T,
    filter: &F,
    paths: &[Path],
    hits: &mut [Hit],
    counters: &mut [u32],
) {
    let i = i as usize;
    if i < paths.len() && i < hits.len() {
        let hit = closest_hit(nodes, triangles, &paths[i].ray, 0, filter);
        hits[i] = hit;
        count(counters, 0, paths[i].is_alive() as u32);
        count(counters, 1, hit.is_hit() as u32);
    }
}

#[inline(always)]
pub fn paths_counted<N: NodeSource, T: TriangleSource<N::Bounds>>(
    i: u32,
    nodes: &N,
    triangles: &T,
    paths: &[Path],
    hits: &mut [Hit],
    counts: &mut [u32],
    counters: &mut [u32],
) {
    let i = i as usize;
    if i < paths.len() && i < hits.len() && i < counts.len() {
        let ray = PreparedRay::new(&paths[i].ray, 0);
        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
        let filter = Skip(paths[i].skip);
        traverse(nodes, triangles, &ray, &filter, &mut collector);
        let hit = ray.restore(collector.inner.hit);
        hits[i] = hit;
        counts[i] = collector.node_count;
        count(counters, 0, paths[i].is_alive() as u32);
        count(counters, 1, hit.is_hit() as u32);
        count(counters, 2, collector.node_count);
    }
}

#[inline(always)]
pub fn shadows<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    i: u32,
    nodes: &N,
    triangles: &T,
    filter: &F,
    shadows: &[Shadow],
    paths: &mut [Path],
    counters: &mut [u32],
) {
    let i = i as usize;
    if i < shadows.len() && i < paths.len() && shadows[i].is_possible() {
        count(counters, 0, 1);
        if !any_hit(nodes, triangles, &shadows[i].ray, 0, filter) {
            paths[i] = paths[i].with_light(Vec3::from_array(shadows[i].radiance));
        }
    }
}
