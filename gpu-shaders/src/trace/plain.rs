//! Kernels that trace trees in full.

use super::overflow::noted;
use super::rays::{FilteredRays, PlainRays};
use super::{scaled_target, store};
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::classify::{FacingFilter, PackedSides};
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{
    LaneStack, LaneWords, NodeRow, NodeRows, Skip, TrianglePair, TriangleRows,
};
use slimbvh_core::{Hit, Ray, RayEnds};
use spirv_std_macros::spirv;

trace_kernels! {
    [() 0 1 2 3 4 5 6 7 8 9 10]
    [LaneWords, LaneStack::new]
    |nodes: NodeRow, triangles: TrianglePair| NodeRows(nodes), TriangleRows(triangles);
    pub fn trace_closest;
    pub fn trace_any;
    pub fn trace_filtered_closest;
    pub fn trace_filtered_any;
    pub fn trace_nearest;
    pub fn trace_rays_overflow;
    pub fn trace_counted;
    pub fn trace_paths_facing;
    pub fn trace_paths_overflow;
    pub fn trace_paths_counted;
    pub fn trace_shadows_facing;
    pub fn trace_shadows_overflow;
}

/// One thread per path. Reads the tree and the path. Stores the closest hit, a miss for paths that have ended. Counts
/// the paths that go on and the hits.
#[spirv(compute(threads(64)))]
pub fn trace_paths(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[NodeRow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[TrianglePair],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: &mut [Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] tally: &mut [u32],
    #[spirv(workgroup)] words: &mut LaneWords,
) {
    let i = thread_index(id);
    let (stack, tree) = (
        &mut LaneStack::new(words, lane),
        (&NodeRows(nodes), &TriangleRows(triangles)),
    );
    let filter = Skip(store::path_skip(i, paths));
    store::paths(stack, tree, i, &filter, paths, hits, tally);
}

/// One thread per path. Reads the tree and what `shade_light` stored. Stores the path with the light, where nothing is
/// in its way. Counts the shadow rays.
#[spirv(compute(threads(64)))]
pub fn trace_shadows(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[NodeRow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[TrianglePair],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] shadows: &[Shadow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] paths: &mut [Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] tally: &mut [u32],
    #[spirv(workgroup)] words: &mut LaneWords,
) {
    let i = thread_index(id);
    let (stack, tree) = (
        &mut LaneStack::new(words, lane),
        (&NodeRows(nodes), &TriangleRows(triangles)),
    );
    let filter = Skip(store::shadow_skip(i, shadows));
    store::shadows(stack, tree, i, &filter, shadows, paths, tally);
}
