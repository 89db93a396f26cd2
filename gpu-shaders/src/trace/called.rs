//! Entry points that become functions for other people's WGSL: the shader builder makes private variables of the bindings from 3
//! on, and the texts `host/shaders/slimbvh.wgsl` and `slimbvh_compute.wgsl` of it all.
//!
//! Both read the scene's exponent, the tree, a ray's origin with `t_min` and its direction with `t_max`, and whether any hit will
//! do: 1, or else 0. Both store the hit, as bits.

use glam::{UVec4, Vec4};
use slimbvh_core::launch::LANES;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    ClosestOrAny, Distance, LaneStack, LaneWords, NodeRow, NodeRows, Skip, Stack, TrianglePair,
    TriangleRows, Waiting, traverse_with,
};
use slimbvh_core::{Hit, NodeRef, Ray};
use spirv_std_macros::spirv;

/// For any stage: the stack is the invocation's own.
#[spirv(compute(threads(1)))]
pub fn call_trace(
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[NodeRow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[TrianglePair],
    #[spirv(uniform, descriptor_set = 0, binding = 3)] origin: &Vec4,
    #[spirv(uniform, descriptor_set = 0, binding = 4)] direction: &Vec4,
    #[spirv(uniform, descriptor_set = 0, binding = 5)] any_will_do: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] hit: &mut UVec4,
) {
    let mut stack: Stack<NodeRef> = Stack::EMPTY;
    let tree = (&NodeRows(nodes), &TriangleRows(triangles));
    let ray = prepared(origin, direction, exponent);
    answer(&mut stack, tree, &ray, *any_will_do, hit);
}

/// For compute shaders: the stack is the lane's rows of an array of the workgroup. Stores also whether the stack was full; the hit
/// is then a miss. For lanes without rows, those from [`LANES`] on, it always is.
#[spirv(compute(threads(64)))]
pub fn call_trace_in_group(
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[NodeRow],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[TrianglePair],
    #[spirv(uniform, descriptor_set = 0, binding = 3)] origin: &Vec4,
    #[spirv(uniform, descriptor_set = 0, binding = 4)] direction: &Vec4,
    #[spirv(uniform, descriptor_set = 0, binding = 5)] any_will_do: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] hit: &mut UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 7)] lane: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] overflowed: &mut u32,
    #[spirv(workgroup)] words: &mut LaneWords,
) {
    let tree = (&NodeRows(nodes), &TriangleRows(triangles));
    let ray = prepared(origin, direction, exponent);
    let mut is_whole = false;
    if *lane < LANES as u32 {
        let stack = &mut LaneStack::new(words, *lane);
        is_whole = answer(stack, tree, &ray, *any_will_do, hit);
    }
    if !is_whole {
        *hit = bits(Hit::MISS);
    }
    *overflowed = !is_whole as u32;
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
fn answer<S: Waiting<NodeRef, Enter: Distance>>(
    stack: &mut S,
    (nodes, triangles): (&NodeRows<'_>, &TriangleRows<'_>),
    ray: &PreparedRay,
    any_will_do: u32,
    hit: &mut UVec4,
) -> bool {
    let mut collector = if any_will_do == 1 {
        ClosestOrAny::any(ray.t_max)
    } else {
        ClosestOrAny::closest(ray.t_max)
    };
    let is_whole = traverse_with(stack, nodes, triangles, ray, &Skip::NONE, &mut collector);
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
