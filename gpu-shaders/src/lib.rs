//! SPIR-V entry points of slimbvh, one file a stage, named as in `slimbvh_core`. An entry point unpacks its bindings,
//! calls core and stores what that returns; it has no arithmetic of its own beyond indices.
//!
//! All bindings are in set 0, in the order of the arguments: uniforms first, outputs last. The length of a bound range
//! is the number of its elements, so ranges are bound exactly. What lies outside of one is not stored.
#![no_std]
#![expect(
    clippy::too_many_arguments,
    reason = "an entry point's arguments are its bindings"
)]
#![cfg_attr(
    not(all(feature = "plain", feature = "paper10", feature = "wide")),
    allow(
        dead_code,
        reason = "a part of the entry points does not use all that they share"
    )
)]
#![allow(
    clippy::needless_range_loop,
    reason = "iterator chains over workgroup memory do not compile to SPIR-V"
)]

use glam::{UVec3, UVec4};
use group::atomic_add;
use slimbvh_core::launch::{self, LANES};
use slimbvh_core::tile::Tiles;

#[cfg(feature = "plain")]
pub mod bounds;
#[cfg(feature = "plain")]
pub mod camera;
#[cfg(feature = "plain")]
pub mod classify;
#[cfg(feature = "plain")]
pub mod compact;
#[cfg(feature = "plain")]
pub mod decide;
#[cfg(feature = "plain")]
pub mod encode;
#[cfg(feature = "plain")]
pub mod fit;
#[cfg(feature = "plain")]
pub mod gather;
mod group;
#[cfg(feature = "plain")]
pub mod morton;
#[cfg(feature = "plain")]
pub mod refit;
#[cfg(feature = "plain")]
pub mod scan;
#[cfg(feature = "plain")]
pub mod shade;
#[cfg(feature = "plain")]
pub mod snap;
#[cfg(feature = "plain")]
pub mod sort;
#[cfg(feature = "plain")]
pub mod topology;
pub mod trace;
#[cfg(feature = "plain")]
pub mod view;
#[cfg(feature = "plain")]
pub mod wide;

/// Steps that halve or double a distance between 1 and LANES.
const LANE_STEPS: u32 = LANES.ilog2();

/// A thread's number.
#[inline(always)]
const fn thread_index(id: UVec3) -> u32 {
    launch::thread_index(id.x, id.y)
}

/// A workgroup's number.
#[inline(always)]
const fn group_index(group: UVec3) -> u32 {
    launch::group_index(group.x, group.y)
}

/// A lane's number among all workgroups.
#[inline(always)]
const fn lane_index(group: UVec3, lane: u32) -> u32 {
    group_index(group) * LANES as u32 + lane
}

/// Where a thread's pixel lies in a picture, for `params` of samples a pixel, the picture's width and height, and the number
/// of the first thread's pixel in the picture's tiles.
#[inline(always)]
fn texel_index(params: &UVec4, thread: u32) -> u32 {
    let tiles = Tiles {
        width: params.y,
        height: params.z,
    };
    let [x, y] = tiles.pixel(params.w + thread);
    y * launch::row_texels(tiles.width) + x
}

/// Adds to one of the counters, 64 bits in two words, the low one first.
#[inline(always)]
#[expect(
    unsafe_code,
    reason = "rust-gpu has no safe atomics; these are plain additions, in range"
)]
fn count(counters: &mut [u32], pair: u32, amount: u32) {
    let low = pair.wrapping_mul(2);
    let (low, high) = (low as usize, low.wrapping_add(1) as usize);
    if amount > 0 && low < counters.len() && high < counters.len() {
        // SAFETY: all accesses to counters within a dispatch are atomic.
        let old = unsafe { atomic_add(&mut counters[low], amount) };
        if launch::carries(old, amount) {
            // SAFETY: as above.
            unsafe { atomic_add(&mut counters[high], 1) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_are_in_tiles_and_their_rows_padded() {
        let params = UVec4::new(4, 9, 8, 3);
        let texels: [u32; 5] = [0, 1, 60, 61, 68].map(|thread| texel_index(&params, thread));
        assert_eq!(texels, [65, 2, 7 * 64 + 7, 8, 7 * 64 + 8]);
    }
}
