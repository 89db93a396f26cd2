//! Traces through trees in codecs: the questions of [`super`], asked of each kind of nodes and triangles.

use super::{scaled_target, store};
use crate::encode::root_words;
use crate::thread_index;
use glam::{UVec3, UVec4};
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::encode::{
    LatticeNodes, LatticeTriangles, Paper10Node, Paper10Nodes, Paper10Triangle, Paper10Triangles,
    RootWords,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::shade::{Path, Shadow};
use slimbvh_core::trace::LeafTriangles;
use slimbvh_core::{Hit, LeafTriangle, Ray};
use spirv_std::spirv;

/// The lattice's step.
#[inline(always)]
fn step(root: &RootWords) -> f32 {
    power_of_two(root.step_exponent())
}

/// All questions about one kind of trees: as the entry points of [`super`] with the same beginning, but they read the tree's root,
/// too. Those for paths and shadow rays always read components, their sides and a target, as `trace_paths_facing` does; where
/// sides are 0, all triangles count.
macro_rules! traces {
    (
        |$root:ident, $nodes:ident: $node:ty, $triangles:ident: $triangle:ty| $node_source:expr, $triangle_source:expr;
        pub fn $closest:ident;
        pub fn $any:ident;
        pub fn $nearest:ident;
        pub fn $counted:ident;
        pub fn $paths:ident;
        pub fn $paths_counted:ident;
        pub fn $shadows:ident;
    ) => {
        /// One thread per ray. Stores the closest hit.
        #[spirv(compute(threads(64)))]
        pub fn $closest(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = 1)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] hits: &mut [Hit],
        ) {
            let ($root, exponent) = (root_words($root), exponent.x as i32);
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::closest(thread_index(id), exponent, nodes, triangles, rays, hits);
        }

        /// One thread per ray. Stores 1 where it meets anything, else 0.
        #[spirv(compute(threads(64)))]
        pub fn $any(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = 1)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] found: &mut [u32],
        ) {
            let ($root, exponent) = (root_words($root), exponent.x as i32);
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::any(thread_index(id), exponent, nodes, triangles, rays, found);
        }

        /// One thread per ray. Stores the nearest hits in order, misses at the end.
        #[spirv(compute(threads(64)))]
        pub fn $nearest(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = 1)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)]
            hits: &mut [[Hit; NEAREST_COUNT]],
        ) {
            let ($root, exponent) = (root_words($root), exponent.x as i32);
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::nearest(thread_index(id), exponent, nodes, triangles, rays, hits);
        }

        /// One thread per ray. Stores how many nodes and triangles the search for the closest hit touches.
        #[spirv(compute(threads(64)))]
        pub fn $counted(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = 1)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] counts: &mut [[u32; 2]],
        ) {
            let ($root, exponent) = (root_words($root), exponent.x as i32);
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::counted(thread_index(id), exponent, nodes, triangles, rays, counts);
        }

        /// One thread per path. Stores the closest hit of those triangles that count.
        #[spirv(compute(threads(64)))]
        pub fn $paths(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = 2)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] components: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] sides: &[i32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] counters: &mut [u32],
        ) {
            let ($root, i) = (root_words($root), thread_index(id));
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            let rule = FacingFilter {
                skip: store::path_skip(i, paths),
                sides: Sides { components, sides },
                target: scaled_target(target, exponent.x),
            };
            store::paths(i, nodes, triangles, &rule, paths, hits, counters);
        }

        /// One thread per path. Stores the closest hit, and how many nodes the search for it opens.
        #[spirv(compute(threads(64)))]
        pub fn $paths_counted(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] counts: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] counters: &mut [u32],
        ) {
            let ($root, i) = (root_words($root), thread_index(id));
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::paths_counted(i, nodes, triangles, paths, hits, counts, counters);
        }

        /// One thread per path. Stores the path with the light, where nothing that counts is in its way.
        #[spirv(compute(threads(64)))]
        pub fn $shadows(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = 2)] $root: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] components: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] sides: &[i32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] shadows: &[Shadow],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] paths: &mut [Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] counters: &mut [u32],
        ) {
            let ($root, i) = (root_words($root), thread_index(id));
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            let rule = FacingFilter {
                skip: store::shadow_skip(i, shadows),
                sides: Sides { components, sides },
                target: scaled_target(target, exponent.x),
            };
            store::shadows(i, nodes, triangles, &rule, shadows, paths, counters);
        }
    };
}

traces! {
    |root, nodes: Paper10Node, triangles: LeafTriangle| Paper10Nodes { nodes, root: root.paper10(), opaque_zero: root.opaque_zero() }, LeafTriangles(triangles);
    pub fn trace_closest_paper10_f32;
    pub fn trace_any_paper10_f32;
    pub fn trace_nearest_paper10_f32;
    pub fn trace_counted_paper10_f32;
    pub fn trace_paths_paper10_f32;
    pub fn trace_paths_counted_paper10_f32;
    pub fn trace_shadows_paper10_f32;
}

traces! {
    |root, nodes: Paper10Node, triangles: Paper10Triangle| Paper10Nodes { nodes, root: root.paper10(), opaque_zero: root.opaque_zero() }, Paper10Triangles { triangles, opaque_zero: root.opaque_zero() };
    pub fn trace_closest_paper10_leaf10;
    pub fn trace_any_paper10_leaf10;
    pub fn trace_nearest_paper10_leaf10;
    pub fn trace_counted_paper10_leaf10;
    pub fn trace_paths_paper10_leaf10;
    pub fn trace_paths_counted_paper10_leaf10;
    pub fn trace_shadows_paper10_leaf10;
}

traces! {
    |root, nodes: [u32; 4], triangles: LeafTriangle| LatticeNodes::<10, 4, false> { nodes, root: root.lattice(), step: step(&root) }, LeafTriangles(triangles);
    pub fn trace_closest_q10_f32;
    pub fn trace_any_q10_f32;
    pub fn trace_nearest_q10_f32;
    pub fn trace_counted_q10_f32;
    pub fn trace_paths_q10_f32;
    pub fn trace_paths_counted_q10_f32;
    pub fn trace_shadows_q10_f32;
}

traces! {
    |root, nodes: [u32; 4], triangles: u32| LatticeNodes::<10, 4, true> { nodes, root: root.lattice(), step: step(&root) }, LatticeTriangles { words: triangles, step: step(&root) };
    pub fn trace_closest_q10_lattice;
    pub fn trace_any_q10_lattice;
    pub fn trace_nearest_q10_lattice;
    pub fn trace_counted_q10_lattice;
    pub fn trace_paths_q10_lattice;
    pub fn trace_paths_counted_q10_lattice;
    pub fn trace_shadows_q10_lattice;
}

traces! {
    |root, nodes: [u32; 7], triangles: LeafTriangle| LatticeNodes::<21, 7, false> { nodes, root: root.lattice(), step: step(&root) }, LeafTriangles(triangles);
    pub fn trace_closest_q21_f32;
    pub fn trace_any_q21_f32;
    pub fn trace_nearest_q21_f32;
    pub fn trace_counted_q21_f32;
    pub fn trace_paths_q21_f32;
    pub fn trace_paths_counted_q21_f32;
    pub fn trace_shadows_q21_f32;
}

traces! {
    |root, nodes: [u32; 7], triangles: u32| LatticeNodes::<21, 7, true> { nodes, root: root.lattice(), step: step(&root) }, LatticeTriangles { words: triangles, step: step(&root) };
    pub fn trace_closest_q21_lattice;
    pub fn trace_any_q21_lattice;
    pub fn trace_nearest_q21_lattice;
    pub fn trace_counted_q21_lattice;
    pub fn trace_paths_q21_lattice;
    pub fn trace_paths_counted_q21_lattice;
    pub fn trace_shadows_q21_lattice;
}
