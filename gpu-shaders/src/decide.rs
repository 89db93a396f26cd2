//! Stage `decide`: components are measured by their spans, then each target finds their outer sides; a light may turn them
//! round.

use crate::group::barrier;
use crate::trace::scaled_target;
use crate::{LANE_STEPS, group_index, thread_index};
use glam::{UVec3, UVec4};
use slimbvh_core::IndexedTriangles;
use slimbvh_core::classify::Sides;
use slimbvh_core::decide::{
    Choice, Component, Measure, SetCounts, Span, Surfaces, Unit, count_step, join_step,
    lane_counts, lane_joined, lane_measure, lane_total,
};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::launch::LANES;
use spirv_std_macros::spirv;

/// One workgroup per span. Reads the scene's exponent, the vertices, the faces and links by component, and the spans;
/// `params` are zeros. Stores what is known of the span.
#[spirv(compute(threads(64)))]
pub fn decide_spans(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] faces: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] links: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] spans: &[Span],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] measured: &mut [Measure],
    #[spirv(workgroup)] measures: &mut [Measure; LANES],
) {
    let i = group_index(group) as usize;
    let span = if i < spans.len() {
        spans[i]
    } else {
        Span::EMPTY
    };
    let surfaces = Surfaces {
        vertices,
        faces,
        links,
    };
    let unit = Unit {
        scale: PowerOfTwo::new(exponent.x as i32),
        opaque_zero: params.x,
    };
    join(lane, lane_measure(lane, &span, &surfaces, &unit), measures);
    if lane == 0 && i < spans.len() && i < measured.len() {
        measured[i] = measures[0];
    }
}

/// One workgroup per component. Reads the components and what is known of their spans. Stores what is known of each.
#[spirv(compute(threads(64)))]
pub fn decide_components(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] components: &[Component],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] spans: &[Measure],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] measured: &mut [Measure],
    #[spirv(workgroup)] measures: &mut [Measure; LANES],
) {
    let i = group_index(group) as usize;
    let component = if i < components.len() {
        components[i]
    } else {
        Component::EMPTY
    };
    join(lane, lane_joined(lane, &component, spans), measures);
    if lane == 0 && i < components.len() && i < measured.len() {
        measured[i] = measures[0];
    }
}

/// One thread per component. Reads the target in the mesh's unit, the components and what is known of them. Stores their
/// outer sides where their numbers say.
#[spirv(compute(threads(64)))]
pub fn decide_sides(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] target: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] components: &[Component],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] measured: &[Measure],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sides: &mut [i32],
) {
    let i = thread_index(id) as usize;
    if i < components.len() && i < measured.len() {
        let number = components[i].number as usize;
        if number < sides.len() {
            sides[number] = measured[i].side(&scaled_target(target, 0));
        }
    }
}

/// One workgroup per block of triangles. Reads the scene's exponent, a light, the mesh, the components of its triangles,
/// their outer sides for the light and those for the eye. Stores how many triangles are in which set.
#[spirv(compute(threads(64)))]
pub fn decide_counts(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] exponent: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] target: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] components: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] eye_sides: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] blocks: &mut [SetCounts],
    #[spirv(workgroup)] counts: &mut [SetCounts; LANES],
) {
    let block = group_index(group);
    let choice = Choice {
        mesh: IndexedTriangles { vertices, indices },
        scale: PowerOfTwo::new(exponent.x as i32),
        sides: Sides { components, sides },
        eye_sides,
        target: scaled_target(target, exponent.x),
    };
    add(lane, lane_counts(block, lane, &choice), counts);
    if lane == 0 && (block as usize) < blocks.len() {
        blocks[block as usize] = counts[0];
    }
}

/// One workgroup. Reads the counts of all blocks. Stores their sum, and which set is taken.
#[spirv(compute(threads(64)))]
pub fn decide_smaller(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] blocks: &[SetCounts],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] decided: &mut [SetCounts],
    #[spirv(workgroup)] counts: &mut [SetCounts; LANES],
) {
    add(lane, lane_total(lane, blocks), counts);
    if lane == 0 && !decided.is_empty() {
        decided[0] = counts[0].decided();
    }
}

/// One thread per component. Reads which set is taken, and the components. Negates their sides for L−.
#[spirv(compute(threads(64)))]
pub fn decide_negate(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] decided: &[SetCounts],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] components: &[Component],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] sides: &mut [i32],
) {
    let i = thread_index(id) as usize;
    if i < components.len() && !decided.is_empty() && decided[0].is_minus == 1 {
        let number = components[i].number as usize;
        if number < sides.len() {
            sides[number] = -sides[number];
        }
    }
}

/// Leaves what all lanes know together in the first.
#[inline(always)]
fn join(lane: u32, own: Measure, measures: &mut [Measure; LANES]) {
    measures[lane as usize % LANES] = own;
    barrier();
    let mut distance = LANES as u32 / 2;
    for _ in 0..LANE_STEPS {
        if lane < distance {
            measures[lane as usize % LANES] = join_step(lane, distance, measures);
        }
        barrier();
        distance /= 2;
    }
}

/// Leaves the sum of all lanes' counts in the first.
#[inline(always)]
fn add(lane: u32, own: SetCounts, counts: &mut [SetCounts; LANES]) {
    counts[lane as usize % LANES] = own;
    barrier();
    let mut distance = LANES as u32 / 2;
    for _ in 0..LANE_STEPS {
        if lane < distance {
            counts[lane as usize % LANES] = count_step(lane, distance, counts);
        }
        barrier();
        distance /= 2;
    }
}
