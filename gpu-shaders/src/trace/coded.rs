//! Kernels that trace trees in codecs, a row each.

use super::overflow::noted;
use super::{root_words, scaled_target, step, store};
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::classify::{FacingFilter, PackedSides};
use slimbvh_core::codec::{
    LatticeNodes, LatticeTriangles, Paper10Node, Paper10Nodes, Paper10Triangle, Paper10Triangles,
};
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::{LaneBoxStack, LaneBoxWords, TrianglePair, TriangleRows};
use slimbvh_core::{Hit, Ray};
use spirv_std_macros::spirv;

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: Paper10Node, triangles: TrianglePair|
        Paper10Nodes { nodes, root: root.paper10(), opaque_zero: root.opaque_zero() },
        TriangleRows(triangles);
    pub fn trace_closest_paper10_f32;
    pub fn trace_any_paper10_f32;
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
    [(root) 1 2 3 4 5 6 7 8 9]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: Paper10Node, triangles: Paper10Triangle|
        Paper10Nodes { nodes, root: root.paper10(), opaque_zero: root.opaque_zero() },
        Paper10Triangles { triangles, opaque_zero: root.opaque_zero() };
    pub fn trace_closest_paper10_leaf10;
    pub fn trace_any_paper10_leaf10;
    pub fn trace_nearest_paper10_leaf10;
    pub fn trace_rays_paper10_leaf10_overflow;
    pub fn trace_counted_paper10_leaf10;
    pub fn trace_paths_paper10_leaf10;
    pub fn trace_paths_paper10_leaf10_overflow;
    pub fn trace_paths_counted_paper10_leaf10;
    pub fn trace_shadows_paper10_leaf10;
    pub fn trace_shadows_paper10_leaf10_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: [u32; 4], triangles: TrianglePair|
        LatticeNodes::<10, 4, false> { nodes, root: root.lattice(), step: step(&root) },
        TriangleRows(triangles);
    pub fn trace_closest_q10_f32;
    pub fn trace_any_q10_f32;
    pub fn trace_nearest_q10_f32;
    pub fn trace_rays_q10_f32_overflow;
    pub fn trace_counted_q10_f32;
    pub fn trace_paths_q10_f32;
    pub fn trace_paths_q10_f32_overflow;
    pub fn trace_paths_counted_q10_f32;
    pub fn trace_shadows_q10_f32;
    pub fn trace_shadows_q10_f32_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: [u32; 4], triangles: u32|
        LatticeNodes::<10, 4, true> { nodes, root: root.lattice(), step: step(&root) },
        LatticeTriangles { words: triangles, step: step(&root) };
    pub fn trace_closest_q10_lattice;
    pub fn trace_any_q10_lattice;
    pub fn trace_nearest_q10_lattice;
    pub fn trace_rays_q10_lattice_overflow;
    pub fn trace_counted_q10_lattice;
    pub fn trace_paths_q10_lattice;
    pub fn trace_paths_q10_lattice_overflow;
    pub fn trace_paths_counted_q10_lattice;
    pub fn trace_shadows_q10_lattice;
    pub fn trace_shadows_q10_lattice_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: [u32; 7], triangles: TrianglePair|
        LatticeNodes::<21, 7, false> { nodes, root: root.lattice(), step: step(&root) },
        TriangleRows(triangles);
    pub fn trace_closest_q21_f32;
    pub fn trace_any_q21_f32;
    pub fn trace_nearest_q21_f32;
    pub fn trace_rays_q21_f32_overflow;
    pub fn trace_counted_q21_f32;
    pub fn trace_paths_q21_f32;
    pub fn trace_paths_q21_f32_overflow;
    pub fn trace_paths_counted_q21_f32;
    pub fn trace_shadows_q21_f32;
    pub fn trace_shadows_q21_f32_overflow;
}

trace_kernels! {
    [(root) 1 2 3 4 5 6 7 8 9]
    [LaneBoxWords, LaneBoxStack::new]
    |nodes: [u32; 7], triangles: u32|
        LatticeNodes::<21, 7, true> { nodes, root: root.lattice(), step: step(&root) },
        LatticeTriangles { words: triangles, step: step(&root) };
    pub fn trace_closest_q21_lattice;
    pub fn trace_any_q21_lattice;
    pub fn trace_nearest_q21_lattice;
    pub fn trace_rays_q21_lattice_overflow;
    pub fn trace_counted_q21_lattice;
    pub fn trace_paths_q21_lattice;
    pub fn trace_paths_q21_lattice_overflow;
    pub fn trace_paths_counted_q21_lattice;
    pub fn trace_shadows_q21_lattice;
    pub fn trace_shadows_q21_lattice_overflow;
}
