//! Kernels that trace trees of wide nodes, a row each.

use super::overflow::noted;
use super::rays::{FilteredRays, PlainRays};
use super::{root_words, scaled_target, step, store};
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::classify::{FacingFilter, PackedSides};
use slimbvh_core::codec::{
    LatticeTriangles, MixedWideRow, PackedWideNodes, PackedWideRow, SharedTriangles,
    WideMixedNodes, WideNodes, WideRow,
};
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{
    FullWideNodes, FullWideRow, LaneListStack, LaneWords, TrianglePair, TriangleRows,
};
use slimbvh_core::{Hit, Ray, RayEnds};
use spirv_std_macros::spirv;

trace_kernels! {
    [() 0 1 2 3 4 5 6 7 8 9 10]
    [LaneWords, LaneListStack::new]
    |nodes: FullWideRow, triangles: TrianglePair| FullWideNodes(nodes), TriangleRows(triangles);
    pub fn trace_closest_w4_f32;
    pub fn trace_any_w4_f32;
    pub fn trace_filtered_closest_w4_f32;
    pub fn trace_filtered_any_w4_f32;
    pub fn trace_nearest_w4_f32;
    pub fn trace_rays_w4_f32_overflow;
    pub fn trace_counted_w4_f32;
    pub fn trace_paths_w4_f32;
    pub fn trace_paths_w4_f32_overflow;
    pub fn trace_paths_counted_w4_f32;
    pub fn trace_shadows_w4_f32;
    pub fn trace_shadows_w4_f32_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9 10 11]
    [LaneWords, LaneListStack::new]
    |nodes: WideRow, triangles: TrianglePair|
        WideNodes { nodes, root: root.lattice(), step: step(&root) },
        TriangleRows(triangles);
    pub fn trace_closest_w4_64_f32;
    pub fn trace_any_w4_64_f32;
    pub fn trace_filtered_closest_w4_64_f32;
    pub fn trace_filtered_any_w4_64_f32;
    pub fn trace_nearest_w4_64_f32;
    pub fn trace_rays_w4_64_f32_overflow;
    pub fn trace_counted_w4_64_f32;
    pub fn trace_paths_w4_64_f32;
    pub fn trace_paths_w4_64_f32_overflow;
    pub fn trace_paths_counted_w4_64_f32;
    pub fn trace_shadows_w4_64_f32;
    pub fn trace_shadows_w4_64_f32_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9 10 11]
    [LaneWords, LaneListStack::new]
    |nodes: MixedWideRow, triangles: u32|
        WideMixedNodes { nodes, root: root.lattice(), step: step(&root) },
        LatticeTriangles { words: triangles, step: step(&root) };
    pub fn trace_closest_w4_64_lattice;
    pub fn trace_any_w4_64_lattice;
    pub fn trace_filtered_closest_w4_64_lattice;
    pub fn trace_filtered_any_w4_64_lattice;
    pub fn trace_nearest_w4_64_lattice;
    pub fn trace_rays_w4_64_lattice_overflow;
    pub fn trace_counted_w4_64_lattice;
    pub fn trace_paths_w4_64_lattice;
    pub fn trace_paths_w4_64_lattice_overflow;
    pub fn trace_paths_counted_w4_64_lattice;
    pub fn trace_shadows_w4_64_lattice;
    pub fn trace_shadows_w4_64_lattice_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9 10 11]
    [LaneWords, LaneListStack::new]
    |nodes: PackedWideRow, triangles: u32|
        PackedWideNodes { nodes, root: root.lattice(), step: step(&root) },
        SharedTriangles { words: triangles, step: step(&root) };
    pub fn trace_closest_w4_48_lattice;
    pub fn trace_any_w4_48_lattice;
    pub fn trace_filtered_closest_w4_48_lattice;
    pub fn trace_filtered_any_w4_48_lattice;
    pub fn trace_nearest_w4_48_lattice;
    pub fn trace_rays_w4_48_lattice_overflow;
    pub fn trace_counted_w4_48_lattice;
    pub fn trace_paths_w4_48_lattice;
    pub fn trace_paths_w4_48_lattice_overflow;
    pub fn trace_paths_counted_w4_48_lattice;
    pub fn trace_shadows_w4_48_lattice;
    pub fn trace_shadows_w4_48_lattice_overflow;
}
