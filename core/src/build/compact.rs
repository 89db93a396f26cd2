//! Compaction: the items whose bit is set, in order. Count the ones of each word, scan the counts (`scan`), and each item
//! knows its place.

/// Whether bit i is set; bits beyond the last word are not.
#[inline(always)]
#[must_use]
pub fn is_set(i: u32, bits: &[u32]) -> bool {
    (crate::load(bits, i >> 5, 0) >> (i & 31)) & 1 == 1
}

/// One thread per item. Reads the bits and the exclusive prefix sums of their words' counts. Returns how many set bits
/// come before i: its place among them.
#[inline(always)]
#[must_use]
pub fn rank(i: u32, bits: &[u32], before: &[u32]) -> u32 {
    let word = i >> 5;
    let below = crate::load(bits, word, 0) & !(u32::MAX << (i & 31));
    crate::load(before, word, 0) + below.count_ones()
}

/// One thread per 32 lanes, from `first` on. Reads the flags of its lanes, each 0 or 1. Returns them as the bits of a word.
#[inline(always)]
#[must_use]
pub fn pack_lanes<const LANES: usize>(first: u32, flags: &[u32; LANES]) -> u32 {
    let mut word = 0;
    for bit in 0..32u32 {
        word |= flags[(first + bit) as usize % LANES] << bit;
    }
    word
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::scan::run_scan;
    use proptest::prelude::*;
    use std::vec::Vec;

    #[test]
    fn lanes_are_packed_from_the_lowest_bit_on() {
        let mut flags = [0; 64];
        for lane in [0, 5, 31, 33, 63] {
            flags[lane] = 1;
        }
        assert_eq!(pack_lanes(0, &flags), 1 | 1 << 5 | 1 << 31);
        assert_eq!(pack_lanes(32, &flags), 1 << 1 | 1 << 31);
    }

    #[test]
    fn nothing_is_set_beyond_the_end() {
        assert!(is_set(31, &[1 << 31]) && !is_set(30, &[1 << 31]));
        assert!(!is_set(32, &[u32::MAX]) && !is_set(0, &[]));
    }

    proptest! {
        #[test]
        fn ranks_number_the_set_bits_in_order(bits in proptest::collection::vec(prop_oneof![Just(0), Just(u32::MAX), any::<u32>()], 0..20)) {
            let mut before: Vec<u32> = bits.iter().map(|word| word.count_ones()).collect();
            run_scan(&mut before, 0, bits.len() as u32, 0);
            let set = (0..bits.len() as u32 * 32).filter(|&i| (bits[i as usize / 32] >> (i % 32)) & 1 == 1);
            let mut count = 0;
            for i in set {
                prop_assert!(is_set(i, &bits));
                prop_assert_eq!(rank(i, &bits, &before), count);
                count += 1;
            }
            let all = (0..bits.len() as u32 * 32).filter(|&i| is_set(i, &bits)).count();
            prop_assert_eq!(all as u32, count);
        }
    }
}
