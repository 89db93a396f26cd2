//! What one thread does of each question, whatever the tree.

use super::overflow::{note, noted};
use super::rays::RaySource;
use crate::count;
use glam::Vec3;
use slimbvh_core::Hit;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay};
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{
    AnyHit, ClosestHit, Counted, Empty, Fork, HitFilter, NearestHits, NodeSource, Skip,
    TriangleSource, UpTo, Waiting, traverse, traverse_with,
};

#[inline(always)]
pub fn closest<S, N, T, R>(
    stack: &mut S,
    (nodes, triangles): (&N, &T),
    i: u32,
    rays: R,
    hits: &mut [Hit],
    list: &mut [u32],
) where
    S: Waiting<N::Node, Enter = ()>,
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    R: RaySource,
{
    let slot = i as usize;
    if rays.has(i) && slot < hits.len() {
        let ray = rays.prepared(i);
        let filter = rays.filter(i, ray);
        let mut collector = ClosestHit::new(ray.t_max);
        if traverse_with(stack, nodes, triangles, &ray, &filter, &mut collector) {
            hits[slot] = ray.restore(collector.hit);
        } else {
            note(i, rays.room(), list);
        }
    }
}

#[inline(always)]
pub fn any<S, N, T, R>(
    stack: &mut S,
    (nodes, triangles): (&N, &T),
    i: u32,
    rays: R,
    found: &mut [u32],
    list: &mut [u32],
) where
    S: Waiting<N::Node, Enter = ()>,
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    R: RaySource,
{
    let slot = i as usize;
    if rays.has(i) && slot < found.len() {
        let ray = rays.prepared(i);
        let filter = rays.filter(i, ray);
        let mut collector = AnyHit::new(ray.t_max);
        if traverse_with(stack, nodes, triangles, &ray, &filter, &mut collector) {
            found[slot] = collector.found as u32;
        } else {
            note(i, rays.room(), list);
        }
    }
}

#[inline(always)]
pub fn nearest<S, N, T, R>(
    stack: &mut S,
    (nodes, triangles): (&N, &T),
    i: u32,
    rays: R,
    hits: &mut [[Hit; NEAREST_COUNT]],
    list: &mut [u32],
) where
    S: Waiting<N::Node, Enter = ()>,
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    R: RaySource,
{
    let slot = i as usize;
    if rays.has(i) && slot < hits.len() {
        let ray = rays.prepared(i);
        let filter = rays.filter(i, ray);
        let mut collector = NearestHits::<NEAREST_COUNT>::new(ray.t_max);
        if traverse_with(stack, nodes, triangles, &ray, &filter, &mut collector) {
            for k in 0..NEAREST_COUNT {
                hits[slot][k] = ray.restore(collector.hits[k]);
            }
        } else {
            note(i, rays.room(), list);
        }
    }
}

/// The second pass of [`closest`], [`any`] and [`nearest`], for 1, 0 and [`NEAREST_COUNT`] hits a ray. `length` is that of the list.
#[inline(always)]
pub fn listed_rays<N: NodeSource, T: TriangleSource<N::Bounds>, R: RaySource>(
    (nodes, triangles): (&N, &T),
    (thread, length): (u32, u32),
    hit_count: u32,
    rays: R,
    list: &[u32],
    answers: &mut [u32],
) {
    let i = noted(thread, length, rays.room(), list);
    if rays.has(i) {
        let ray = rays.prepared(i);
        let filter = rays.filter(i, ray);
        let mut collector = UpTo::<NEAREST_COUNT>::new(hit_count, ray.t_max);
        let mut stack = <<N::Node as Fork>::PrivateStack as Empty>::EMPTY;
        traverse_with(&mut stack, nodes, triangles, &ray, &filter, &mut collector);
        if hit_count == 0 {
            put(i, collector.hits[0].is_hit() as u32, answers);
        } else {
            for k in 0..NEAREST_COUNT {
                if (k as u32) < hit_count {
                    let hit = ray.restore(collector.hits[k]);
                    let first = i
                        .wrapping_mul(hit_count)
                        .wrapping_add(k as u32)
                        .wrapping_mul(4);
                    put(first, hit.t.to_bits(), answers);
                    put(first.wrapping_add(1), hit.u.to_bits(), answers);
                    put(first.wrapping_add(2), hit.v.to_bits(), answers);
                    put(first.wrapping_add(3), hit.primitive, answers);
                }
            }
        }
    }
}

/// Stores a word, if there is room.
#[inline(always)]
fn put(place: u32, word: u32, words: &mut [u32]) {
    if (place as usize) < words.len() {
        words[place as usize] = word;
    }
}

#[inline(always)]
pub fn counted<N: NodeSource, T: TriangleSource<N::Bounds>, R: RaySource>(
    i: u32,
    nodes: &N,
    triangles: &T,
    rays: R,
    counts: &mut [[u32; 2]],
) {
    let slot = i as usize;
    if rays.has(i) && slot < counts.len() {
        let ray = rays.prepared(i);
        let filter = rays.filter(i, ray);
        let mut collector = Counted::new(ClosestHit::new(ray.t_max));
        traverse(nodes, triangles, &ray, &filter, &mut collector);
        counts[slot] = [collector.node_count, collector.triangle_count];
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

/// The range of an ended path's ray is empty: it meets nothing. `tally` begins with the counters, and ends with the list.
#[inline(always)]
pub fn paths<S, N, T, F: HitFilter>(
    stack: &mut S,
    (nodes, triangles): (&N, &T),
    i: u32,
    filter: &F,
    paths: &[Path],
    hits: &mut [Hit],
    tally: &mut [u32],
) where
    S: Waiting<N::Node, Enter = ()>,
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
{
    let i = i as usize;
    if i < paths.len() && i < hits.len() {
        let ray = PreparedRay::new(&paths[i].ray, 0);
        let mut collector = ClosestHit::new(ray.t_max);
        let is_whole = traverse_with(stack, nodes, triangles, &ray, filter, &mut collector);
        count(tally, 0, paths[i].is_alive() as u32);
        if is_whole {
            let hit = ray.restore(collector.hit);
            hits[i] = hit;
            count(tally, 1, hit.is_hit() as u32);
        } else {
            note(i as u32, paths.len() as u32, tally);
        }
    }
}

/// The second pass of [`paths`] for one path of the list, which has been counted.
#[inline(always)]
pub fn listed_path<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    (nodes, triangles): (&N, &T),
    i: u32,
    filter: &F,
    paths: &[Path],
    hits: &mut [Hit],
    tally: &mut [u32],
) {
    let i = i as usize;
    if i < paths.len() && i < hits.len() {
        let ray = PreparedRay::new(&paths[i].ray, 0);
        let mut collector = ClosestHit::new(ray.t_max);
        let mut stack = <<N::Node as Fork>::PrivateStack as Empty>::EMPTY;
        traverse_with(&mut stack, nodes, triangles, &ray, filter, &mut collector);
        let hit = ray.restore(collector.hit);
        hits[i] = hit;
        count(tally, 1, hit.is_hit() as u32);
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

/// `tally` begins with the counters, and ends with the list.
#[inline(always)]
pub fn shadows<S, N, T, F: HitFilter>(
    stack: &mut S,
    (nodes, triangles): (&N, &T),
    i: u32,
    filter: &F,
    shadows: &[Shadow],
    paths: &mut [Path],
    tally: &mut [u32],
) where
    S: Waiting<N::Node, Enter = ()>,
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
{
    let i = i as usize;
    if i < shadows.len() && i < paths.len() && shadows[i].is_possible() {
        count(tally, 0, 1);
        let ray = PreparedRay::new(&shadows[i].ray, 0);
        let mut collector = AnyHit::new(ray.t_max);
        if traverse_with(stack, nodes, triangles, &ray, filter, &mut collector) {
            if !collector.found {
                light(i, shadows, paths);
            }
        } else {
            note(i as u32, shadows.len() as u32, tally);
        }
    }
}

/// The second pass of [`shadows`] for one ray of the list, which has been counted.
#[inline(always)]
pub fn listed_shadow<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    (nodes, triangles): (&N, &T),
    i: u32,
    filter: &F,
    shadows: &[Shadow],
    paths: &mut [Path],
) {
    let i = i as usize;
    if i < shadows.len() && i < paths.len() {
        let ray = PreparedRay::new(&shadows[i].ray, 0);
        let mut collector = AnyHit::new(ray.t_max);
        let mut stack = <<N::Node as Fork>::PrivateStack as Empty>::EMPTY;
        traverse_with(&mut stack, nodes, triangles, &ray, filter, &mut collector);
        if !collector.found {
            light(i, shadows, paths);
        }
    }
}

/// Adds a shadow ray's light to its path.
#[inline(always)]
fn light(i: usize, shadows: &[Shadow], paths: &mut [Path]) {
    if i < shadows.len() && i < paths.len() {
        paths[i] = paths[i].with_light(Vec3::from_array(shadows[i].radiance));
    }
}
