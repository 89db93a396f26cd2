//! Kernels that trace trees in the paper10 codec, a row each.

use super::overflow::noted;
use super::rays::{FilteredRays, PlainRays};
use super::{root_words, scaled_target, store};
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::classify::{FacingFilter, PackedSides};
use slimbvh_core::codec::{Paper10Node, Paper10Nodes, Paper10Triangle, Paper10Triangles};
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{LaneBoxStack, LaneBoxWords, TrianglePair, TriangleRows};
use slimbvh_core::{Hit, Ray, RayEnds};
use spirv_std_macros::spirv;

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9 10 11]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: Paper10Node, triangles: TrianglePair|
        Paper10Nodes { nodes, root: root.paper10(), opaque_zero: root.opaque_zero() },
        TriangleRows(triangles);
    pub fn trace_closest_paper10_f32;
    pub fn trace_any_paper10_f32;
    pub fn trace_filtered_closest_paper10_f32;
    pub fn trace_filtered_any_paper10_f32;
    pub fn trace_nearest_paper10_f32;
    pub fn trace_rays_paper10_f32_overflow;
    pub fn trace_counted_paper10_f32;
    pub fn trace_paths_paper10_f32;
    pub fn trace_paths_paper10_f32_overflow;
    pub fn trace_paths_counted_paper10_f32;
    pub fn trace_shadows_paper10_f32;
    pub fn trace_shadows_paper10_f32_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9 10 11]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: Paper10Node, triangles: Paper10Triangle|
        Paper10Nodes { nodes, root: root.paper10(), opaque_zero: root.opaque_zero() },
        Paper10Triangles { triangles, opaque_zero: root.opaque_zero() };
    pub fn trace_closest_paper10_leaf10;
    pub fn trace_any_paper10_leaf10;
    pub fn trace_filtered_closest_paper10_leaf10;
    pub fn trace_filtered_any_paper10_leaf10;
    pub fn trace_nearest_paper10_leaf10;
    pub fn trace_rays_paper10_leaf10_overflow;
    pub fn trace_counted_paper10_leaf10;
    pub fn trace_paths_paper10_leaf10;
    pub fn trace_paths_paper10_leaf10_overflow;
    pub fn trace_paths_counted_paper10_leaf10;
    pub fn trace_shadows_paper10_leaf10;
    pub fn trace_shadows_paper10_leaf10_overflow;
}
