//! Rays whose stack in workgroup memory was full: they are listed, and traced again from the start with private stacks.
//!
//! The list is the end of a buffer: its length, then the numbers of rays. It has room for all rays, so it begins one word more
//! than there are rays before the end; what is before it belongs to the caller.

use crate::group::atomic_add;
#[cfg(feature = "plain")]
use {
    glam::{UVec3, UVec4},
    slimbvh_core::launch::{count_in_part, dispatch_each},
    spirv_std_macros::spirv,
};

/// Where the list of a buffer of this many words begins.
#[inline(always)]
const fn list_begin(ray_count: u32, word_count: u32) -> u32 {
    word_count.wrapping_sub(ray_count).wrapping_sub(1)
}

/// Adds a ray to the list.
#[inline(always)]
#[expect(unsafe_code, reason = "rust-gpu has no safe atomics")]
pub fn note(ray: u32, ray_count: u32, list: &mut [u32]) {
    let begin = list_begin(ray_count, list.len() as u32);
    if (begin as usize) < list.len() {
        // SAFETY: all accesses to the length within a dispatch are atomic.
        let number = unsafe { atomic_add(&mut list[begin as usize], 1) };
        let place = begin.wrapping_add(1).wrapping_add(number) as usize;
        if place < list.len() {
            list[place] = ray;
        }
    }
}

/// The ray of a thread of the second pass, for the list's length as [`trace_groups`] stored it; `u32::MAX` beyond the end.
#[inline(always)]
#[must_use]
pub fn noted(thread: u32, length: u32, ray_count: u32, list: &[u32]) -> u32 {
    let begin = list_begin(ray_count, list.len() as u32);
    let place = begin.wrapping_add(1).wrapping_add(thread) as usize;
    if thread < length && place < list.len() {
        list[place]
    } else {
        u32::MAX
    }
}

/// One thread works. Reads the length of a list that is a buffer of its own, and clears it. Stores `[length, x, y, z]`, with the dispatch of
/// a thread for each ray of the list.
#[cfg(feature = "plain")]
#[spirv(compute(threads(64)))]
pub fn trace_groups(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] list: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] groups: &mut [[u32; 4]],
) {
    if id.x == 0 && !list.is_empty() && !groups.is_empty() {
        let length = list[0];
        list[0] = 0;
        groups[0] = dispatch_each(length);
    }
}

/// One thread works. Reads the number of rays, the word `params.x` of a buffer; `params.y` is the first ray of this dispatch, and
/// `params.z` how many rays it has room for. Stores `[count, x, y, z]`, with the dispatch of a thread for each ray of it.
#[cfg(feature = "plain")]
#[spirv(compute(threads(64)))]
pub fn trace_count(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] groups: &mut [[u32; 4]],
) {
    let word = params.x as usize;
    if id.x == 0 && word < words.len() && !groups.is_empty() {
        groups[0] = dispatch_each(count_in_part(words[word], params.y, params.z));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_ends_the_buffer() {
        let mut words = [7; 6];
        words[2] = 2;
        words[3] = 9;
        words[4] = 8;
        let rays: [u32; 3] = [0, 1, 2].map(|thread| noted(thread, 2, 3, &words));
        assert_eq!(rays, [9, 8, u32::MAX]);
        assert_eq!(noted(0, 2, 9, &words), u32::MAX);
    }

    #[test]
    fn counts_become_dispatches_of_parts() {
        let parts = [[0, 100], [100, 100], [200, 100]].map(|[first, most]| {
            let mut groups = [[7; 4]];
            let params = UVec4::new(1, first, most, 0);
            trace_count(UVec3::ZERO, &params, &[9, 165, 9], &mut groups);
            groups[0]
        });
        assert_eq!(parts, [[100, 2, 1, 1], [65, 2, 1, 1], [0, 0, 0, 1]]);
    }

    #[test]
    fn groups_are_made_and_the_list_is_cleared() {
        let (mut list, mut groups) = ([65, 1], [[0; 4]]);
        trace_groups(UVec3::ZERO, &mut list, &mut groups);
        assert_eq!((list[0], groups[0]), (0, [65, 2, 1, 1]));
    }
}
