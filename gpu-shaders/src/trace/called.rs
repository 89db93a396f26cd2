//! Entry points that become functions for other people's WGSL: the shader builder makes private variables of the bindings behind
//! the tree's, and of it all the texts `host/shaders/slimbvh.wgsl` and `slimbvh_compute.wgsl`, and those of wide trees.
//!
//! All read the scene's exponent and where the tree begins in the lists of nodes and triangles, these, the packed sides of the
//! primitives and a target, a ray's origin with `t_min` and its direction with `t_max`, whether any hit will do (1, or else 0), and a
//! primitive that is no hit. All store the hit, as bits.

use super::rays::SkipFilter;
use super::{root_words, step};
use glam::{UVec2, UVec4, Vec2, Vec3, Vec4};
use slimbvh_core::codec::{
    LatticeTriangles, MixedWideRow, PackedWideNodes, PackedWideRow, SharedTriangles,
    WideMixedNodes, WideNodes, WideRow,
};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::launch::LANES;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::snap::snap_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::trace::{
    Based, ClosestOrAny, Distance, Empty, Fork, FullWideNodes, FullWideRow, LaneListStack,
    LaneStack, LaneWords, NodeRow, NodeRows, NodeSource, TrianglePair, TriangleRows,
    TriangleSource, Waiting, traverse_with,
};
use slimbvh_core::{Hit, Ray, SurfacePoint, Triangle};
use spirv_std_macros::spirv;

/// Both entry points of one kind of tree. The first line lists the bindings: after the root, where the tree has one, come the numbers
/// for a call's arguments; the second names the lane's stack. Sources as in `trace_kernels`.
///
/// - For any stage: the stack is the invocation's own.
/// - For compute shaders: the stack is the lane's rows of an array of the workgroup. Stores also whether the stack was full; the hit is
///   then a miss. For lanes without rows, those from [`LANES`] on, it always is.
macro_rules! call_kernels {
    (
        [($($root:ident 3)?) $a:tt $b:tt $c:tt $d:tt $e:tt $f:tt $g:tt $h:tt]
        [$stack:path]
        |$nodes:ident: $node:ty, $triangles:ident: $triangle:ty| $node_source:expr, $triangle_source:expr;
        pub fn $alone:ident;
        pub fn $in_group:ident;
    ) => {
        /// For any stage: the stack is the invocation's own.
        #[spirv(compute(threads(1)))]
        pub fn $alone(
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $triangles: &[$triangle],
            $(#[spirv(uniform, descriptor_set = 0, binding = 3)] $root: &[UVec4; 2],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $a)] sides: &[u32],
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] origin: &Vec4,
            #[spirv(uniform, descriptor_set = 0, binding = $d)] direction: &Vec4,
            #[spirv(uniform, descriptor_set = 0, binding = $e)] question: &UVec2,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] hit: &mut UVec4,
        ) {
            $(let $root = root_words($root);)?
            let (nodes, triangles) = (based($node_source, exponent), $triangle_source);
            let mut stack = private_stack(&nodes);
            let ray = prepared(origin, direction, exponent);
            let filter = SkipFilter { skip: question.y, exponent: exponent.x, sides, target };
            answer(&mut stack, (&nodes, &triangles), &ray, &filter, question, hit);
        }

        /// For compute shaders: the stack is the lane's rows of an array of the workgroup.
        #[spirv(compute(threads(64)))]
        pub fn $in_group(
            #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] $triangles: &[$triangle],
            $(#[spirv(uniform, descriptor_set = 0, binding = 3)] $root: &[UVec4; 2],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $a)] sides: &[u32],
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] origin: &Vec4,
            #[spirv(uniform, descriptor_set = 0, binding = $d)] direction: &Vec4,
            #[spirv(uniform, descriptor_set = 0, binding = $e)] question: &UVec2,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] hit: &mut UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $g)] lane: &u32,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] overflowed: &mut u32,
            #[spirv(workgroup)] words: &mut LaneWords,
        ) {
            $(let $root = root_words($root);)?
            let tree = (&based($node_source, exponent), &$triangle_source);
            let ray = prepared(origin, direction, exponent);
            let filter = SkipFilter { skip: question.y, exponent: exponent.x, sides, target };
            let mut is_whole = false;
            if *lane < LANES as u32 {
                let stack = &mut $stack(words, *lane);
                is_whole = answer(stack, tree, &ray, &filter, question, hit);
            }
            if !is_whole {
                *hit = bits(Hit::MISS);
            }
            *overflowed = !is_whole as u32;
        }
    };
}

call_kernels! {
    [() 3 4 5 6 7 8 9 10]
    [LaneStack::new]
    |nodes: NodeRow, triangles: TrianglePair| NodeRows(nodes), TriangleRows(triangles);
    pub fn call_trace;
    pub fn call_trace_in_group;
}

call_kernels! {
    [() 3 4 5 6 7 8 9 10]
    [LaneListStack::new]
    |nodes: FullWideRow, triangles: TrianglePair| FullWideNodes(nodes), TriangleRows(triangles);
    pub fn call_trace_w4_f32;
    pub fn call_trace_in_group_w4_f32;
}

call_kernels! {
    [(root 3) 4 5 6 7 8 9 10 11]
    [LaneListStack::new]
    |nodes: WideRow, triangles: TrianglePair|
        WideNodes { nodes, root: root.lattice(), step: step(&root) }, TriangleRows(triangles);
    pub fn call_trace_w4_64_f32;
    pub fn call_trace_in_group_w4_64_f32;
}

call_kernels! {
    [(root 3) 4 5 6 7 8 9 10 11]
    [LaneListStack::new]
    |nodes: MixedWideRow, triangles: u32|
        WideMixedNodes { nodes, root: root.lattice(), step: step(&root) },
        LatticeTriangles { words: triangles, step: step(&root) };
    pub fn call_trace_w4_64_lattice;
    pub fn call_trace_in_group_w4_64_lattice;
}

call_kernels! {
    [(root 3) 4 5 6 7 8 9 10 11]
    [LaneListStack::new]
    |nodes: PackedWideRow, triangles: u32|
        PackedWideNodes { nodes, root: root.lattice(), step: step(&root) },
        SharedTriangles { words: triangles, step: step(&root) };
    pub fn call_trace_w4_48_lattice;
    pub fn call_trace_in_group_w4_48_lattice;
}

/// The nodes of the tree that begins where the words behind the exponent say.
#[inline(always)]
const fn based<N>(list: N, exponent: &UVec4) -> Based<N> {
    Based {
        list,
        first_node: exponent.y,
        first_triangle: exponent.z,
    }
}

/// A stack of the invocation's own for these nodes.
#[inline(always)]
fn private_stack<N: NodeSource>(_: &N) -> <N::Node as Fork>::PrivateStack {
    Empty::EMPTY
}

/// The point of a triangle that a ray hits, for any stage. Reads the scene's exponent, the triangle's corners in the caller's unit, the
/// hit's u and v, and the ray's direction. Stores the position and the side that the ray came from, the position's error, the normal,
/// and where rays leave the surface on that side and on the other.
#[spirv(compute(threads(1)))]
pub fn call_surface(
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] corners: &[Vec4; 3],
    #[spirv(uniform, descriptor_set = 0, binding = 2)] weights: &Vec2,
    #[spirv(uniform, descriptor_set = 0, binding = 3)] direction: &Vec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] point: &mut [Vec4; 5],
) {
    let triangle = Triangle {
        v0: corners[0].truncate(),
        v1: corners[1].truncate(),
        v2: corners[2].truncate(),
    };
    let exponent = exponent.x as i32;
    let triangle = snap_triangle(&triangle, &PowerOfTwo::new(exponent));
    let hit = Hit {
        u: weights.x,
        v: weights.y,
        ..Hit::MISS
    };
    let surface = Surface::new(triangle, &hit, direction.truncate(), [Vec3::ZERO; 3]);
    let found = SurfacePoint::new(&surface, hit.primitive, exponent);
    point[0] = four(found.position, found.side);
    point[1] = four(found.error, 0.0);
    point[2] = four(found.normal, 0.0);
    point[3] = four(found.leave(), 0.0);
    point[4] = four(found.enter(), 0.0);
}

#[inline(always)]
const fn four([x, y, z]: [f32; 3], w: f32) -> Vec4 {
    Vec4::new(x, y, z, w)
}

#[inline(always)]
fn prepared(origin: &Vec4, direction: &Vec4, exponent: &UVec4) -> PreparedRay {
    let ray = Ray {
        origin: origin.truncate().to_array(),
        t_min: origin.w,
        direction: direction.truncate().to_array(),
        t_max: direction.w,
    };
    PreparedRay::new(&ray, exponent.x as i32)
}

/// Stores the hit. Returns whether the stack sufficed.
#[inline(always)]
fn answer<S, N, T>(
    stack: &mut S,
    (nodes, triangles): (&N, &T),
    ray: &PreparedRay,
    filter: &SkipFilter,
    question: &UVec2,
    hit: &mut UVec4,
) -> bool
where
    S: Waiting<N::Node, Enter: Distance>,
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
{
    let mut collector = if question.x == 1 {
        ClosestOrAny::any(ray.t_max)
    } else {
        ClosestOrAny::closest(ray.t_max)
    };
    let is_whole = traverse_with(stack, nodes, triangles, ray, filter, &mut collector);
    *hit = bits(ray.restore(collector.closest.hit));
    is_whole
}

#[inline(always)]
const fn bits(hit: Hit) -> UVec4 {
    UVec4::new(
        hit.t.to_bits(),
        hit.u.to_bits(),
        hit.v.to_bits(),
        hit.primitive,
    )
}
