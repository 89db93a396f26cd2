//! Stage `scan`: exclusive prefix sums, in phases over one workgroup.
//!
//! Each lane owns a run of values. Phase 1: every lane adds its run up ([`run_sum`]). Phase 2: the lanes' sums are
//! scanned by doubling ([`doubling_step`]). Phase 3: every lane rewrites its run, beginning with the sum of all lanes
//! before it ([`run_scan`]). A workgroup of one lane skips phase 2.
//!
//! Where several workgroups scan a block each, all store their block's sum first. Then the lanes of each workgroup add up the
//! sums of the blocks before its own ([`strided_sum`]): the block's prefix sums begin there.

/// Phase 1. Reads `values[first..first + count]`. Returns their wrapping sum.
#[inline]
#[must_use]
pub fn run_sum(values: &[u32], first: u32, count: u32) -> u32 {
    let mut sum = 0u32;
    for i in first..first + count {
        sum = sum.wrapping_add(crate::load(values, i, 0));
    }
    sum
}

/// Reads every `stride`-th of `values[..end]` from `first` on. Returns their wrapping sum. Lanes side by side, each of
/// which takes its number for `first` and the number of lanes for `stride`, read values side by side.
#[inline]
#[must_use]
pub fn strided_sum(values: &[u32], first: u32, end: u32, stride: u32) -> u32 {
    let mut sum = 0u32;
    let mut i = first;
    while i < end {
        sum = sum.wrapping_add(crate::load(values, i, 0));
        i = i.wrapping_add(stride);
    }
    sum
}

/// Phase 2, once for each `distance` = 1, 2, 4 … below LANES, with a barrier before each store. After all steps a
/// lane holds the sum of all lanes up to its own. Returns the lane's new sum.
#[inline(always)]
#[must_use]
pub fn doubling_step<const LANES: usize>(lane: u32, distance: u32, sums: &[u32; LANES]) -> u32 {
    let own = sums[lane as usize % LANES];
    if lane >= distance {
        own.wrapping_add(sums[(lane - distance) as usize % LANES])
    } else {
        own
    }
}

/// Phase 3. Replaces each of `values[first..first + count]` by `before` plus all values before it in the run. Returns
/// what comes after the last.
#[inline]
pub fn run_scan(values: &mut [u32], first: u32, count: u32, before: u32) -> u32 {
    let mut sum = before;
    for i in first..first + count {
        let i = i as usize;
        if i >= values.len() {
            break;
        }
        let next = sum.wrapping_add(values[i]);
        values[i] = sum;
        sum = next;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn workgroup_scan<const LANES: usize>(values: &mut [u32]) {
        let run = (values.len() as u32).div_ceil(LANES as u32);
        let bounds = |lane: u32| {
            let first = (lane * run).min(values.len() as u32);
            (first, run.min(values.len() as u32 - first))
        };
        let runs: [(u32, u32); LANES] = core::array::from_fn(|lane| bounds(lane as u32));
        let mut sums = runs.map(|(first, count)| run_sum(values, first, count));
        let mut distance = 1;
        while distance < LANES as u32 {
            let before = sums;
            for lane in 0..LANES as u32 {
                sums[lane as usize] = doubling_step(lane, distance, &before);
            }
            distance *= 2;
        }
        for lane in 0..LANES {
            let before = if lane == 0 { 0 } else { sums[lane - 1] };
            run_scan(values, runs[lane].0, runs[lane].1, before);
        }
    }

    proptest! {
        #[test]
        fn strided_sums_add_up_to_the_sum(values in proptest::collection::vec(any::<u32>(), 0..300), end in 0u32..400) {
            let end_in_list = values.len().min(end as usize);
            let sum = values[..end_in_list].iter().fold(0u32, |sum, v| sum.wrapping_add(*v));
            let parts = (0..64).map(|lane| strided_sum(&values, lane, end, 64));
            prop_assert_eq!(parts.fold(0u32, u32::wrapping_add), sum);
        }

        #[test]
        fn any_number_of_lanes_gives_the_prefix_sums(values in proptest::collection::vec(0u32..1000, 0..300)) {
            let expected: std::vec::Vec<u32> = values.iter().scan(0, |sum, &v| { let before = *sum; *sum += v; Some(before) }).collect();
            for lanes in [1, 8, 64] {
                let mut scanned = values.clone();
                match lanes {
                    1 => workgroup_scan::<1>(&mut scanned),
                    8 => workgroup_scan::<8>(&mut scanned),
                    _ => workgroup_scan::<64>(&mut scanned),
                }
                prop_assert_eq!(&scanned, &expected);
            }
        }
    }
}
