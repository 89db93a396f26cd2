//! SPIR-V entry points of slimbvh, one file a stage, named as in `slimbvh_core`. An entry point unpacks its bindings,
//! calls core and stores what that returns; it has no arithmetic of its own beyond indices.
//!
//! All bindings are in set 0, in the order of the arguments: uniforms first, outputs last. The length of a bound range
//! is the number of its elements, so ranges are bound exactly. What lies outside of one is not stored.
#![cfg_attr(target_arch = "spirv", no_std)]
#![expect(
    clippy::too_many_arguments,
    reason = "an entry point's arguments are its bindings"
)]
#![allow(
    clippy::needless_range_loop,
    reason = "iterator chains over workgroup memory do not compile to SPIR-V"
)]

use glam::UVec3;

pub mod bounds;
pub mod camera;
pub mod morton;
pub mod refit;
pub mod scan;
pub mod shade;
pub mod snap;
pub mod sort;
pub mod topology;
pub mod trace;
pub mod view;

/// Threads in a workgroup, of all entry points but `topology_single`.
pub const LANES: usize = 64;

/// Digits that a pass of the sort tells apart: 4 bits.
pub const DIGITS: usize = 16;

/// Items that a lane takes in `bounds`, `sort` and `scan`.
pub const RUN: u32 = 16;

/// Items that a workgroup takes in `bounds`, `sort` and `scan`: a block.
pub const BLOCK: u32 = LANES as u32 * RUN;

/// Hits that `trace_nearest` finds.
pub const NEAREST_COUNT: usize = 8;

/// Workgroups along x in a dispatch; what is more goes on in the next row. Each axis takes at most 65,535.
pub const GROUPS_PER_ROW: u32 = 1 << 15;

/// The dispatch of this many workgroups, and of as many more as fill the last row.
#[inline(always)]
#[must_use]
pub const fn dispatch(group_count: u32) -> [u32; 3] {
    let row = if group_count < GROUPS_PER_ROW {
        group_count
    } else {
        GROUPS_PER_ROW
    };
    [row, group_count.div_ceil(GROUPS_PER_ROW), 1]
}

/// Steps that halve or double a distance between 1 and LANES.
const LANE_STEPS: u32 = LANES.ilog2();

/// A thread's number among all rows of a [`dispatch`].
#[inline(always)]
const fn thread_index(id: UVec3) -> u32 {
    id.x + id.y * (GROUPS_PER_ROW * LANES as u32)
}

/// A workgroup's number among all rows of a [`dispatch`].
#[inline(always)]
const fn group_index(group: UVec3) -> u32 {
    group.x + group.y * GROUPS_PER_ROW
}

/// Where the run of a lane begins, at most `count`.
#[inline(always)]
fn run_begin(group: UVec3, lane: u32, count: u32) -> u32 {
    let begin = group_index(group) * BLOCK + lane * RUN;
    if begin < count { begin } else { count }
}

/// How long the run of a lane is, at most RUN.
#[inline(always)]
fn run_length(begin: u32, count: u32) -> u32 {
    let rest = count - begin;
    if rest < RUN { rest } else { RUN }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_hold_every_group_once() {
        assert_eq!(dispatch(0), [0, 0, 1]);
        assert_eq!(dispatch(5), [5, 1, 1]);
        assert_eq!(dispatch(GROUPS_PER_ROW), [GROUPS_PER_ROW, 1, 1]);
        assert_eq!(dispatch(GROUPS_PER_ROW + 1), [GROUPS_PER_ROW, 2, 1]);
        assert_eq!(group_index(UVec3::new(3, 1, 0)), GROUPS_PER_ROW + 3);
        assert_eq!(
            thread_index(UVec3::new(7, 1, 0)),
            GROUPS_PER_ROW * LANES as u32 + 7
        );
    }
}
