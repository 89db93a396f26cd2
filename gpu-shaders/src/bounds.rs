//! Stage `bounds`.

use crate::group::barrier;
use crate::{LANE_STEPS, group_index, lane_index};
use glam::{UVec3, UVec4, Vec3};
use slimbvh_core::bounds::{reduce_step, run_bounds, scene_exponent, unite};
use slimbvh_core::launch::{LANES, RUN, run_begin, run_length};
use slimbvh_core::morton::MortonGrid;
use slimbvh_core::{Aabb, IndexedTriangles};
use spirv_std_macros::spirv;

/// One workgroup per block of triangles. Reads the mesh. Stores the block's box: min, max.
#[spirv(compute(threads(64)))]
pub fn bounds(
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] vertices: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] indices: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] blocks: &mut [[f32; 6]],
    #[spirv(workgroup)] boxes: &mut [Aabb; LANES],
) {
    let triangles = IndexedTriangles { vertices, indices };
    let count = indices.len() as u32;
    let first = run_begin(lane_index(group, lane), RUN, count);
    let own = run_bounds(first, run_length(first, RUN, count), &triangles);
    reduce(lane, own, boxes);
    let block = group_index(group) as usize;
    if lane == 0 && block < blocks.len() {
        blocks[block] = unpacked(boxes[0]);
    }
}

/// One workgroup. Reads the boxes of all blocks; `params.x` is the bits of a cell's number on an axis, 10 or 21. Stores
/// the grid of the codes, the scene's exponent and its box.
#[spirv(compute(threads(64)))]
pub fn bounds_grid(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] blocks: &[[f32; 6]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] grids: &mut [MortonGrid],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] exponents: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] scene: &mut [[f32; 6]],
    #[spirv(workgroup)] boxes: &mut [Aabb; LANES],
) {
    // Lanes side by side read blocks side by side.
    let mut own = Aabb::EMPTY;
    let rows = (blocks.len() as u32).div_ceil(LANES as u32);
    for row in 0..rows {
        let block = (row * LANES as u32 + lane) as usize;
        if block < blocks.len() {
            own = unite(own, packed(blocks[block]));
        }
    }
    reduce(lane, own, boxes);
    if lane == 0 && !grids.is_empty() && !exponents.is_empty() && !scene.is_empty() {
        let all = boxes[0];
        grids[0] = MortonGrid::new(&all, params.x);
        exponents[0] = scene_exponent(&all) as u32;
        scene[0] = unpacked(all);
    }
}

/// Leaves the union of all lanes' boxes in the first.
#[inline(always)]
fn reduce(lane: u32, own: Aabb, boxes: &mut [Aabb; LANES]) {
    boxes[lane as usize % LANES] = own;
    barrier();
    let mut distance = LANES as u32 / 2;
    for _ in 0..LANE_STEPS {
        if lane < distance {
            boxes[lane as usize % LANES] = reduce_step(lane, distance, boxes);
        }
        barrier();
        distance /= 2;
    }
}

#[inline(always)]
fn packed(b: [f32; 6]) -> Aabb {
    Aabb {
        min: Vec3::new(b[0], b[1], b[2]),
        max: Vec3::new(b[3], b[4], b[5]),
    }
}

#[inline(always)]
fn unpacked(b: Aabb) -> [f32; 6] {
    [b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z]
}
