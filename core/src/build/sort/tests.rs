//! The sort, its pieces put together as a workgroup would, for tiles of several sizes.

use super::tile::{
    COUNTERS, clear, is_first, lane_scan, lane_sum, of_run, packed, packed_digit, packed_place,
    put, round_digit, swizzle, take, word,
};
use super::*;
use crate::build::scan::{doubling_step, run_scan};
use crate::launch::{DIGITS, RUN};
use proptest::prelude::*;
use std::{collections::BTreeSet, vec, vec::Vec};

/// A round over a tile, as all lanes of a workgroup. Also returns each item's rank.
fn round<const LANES: usize, const ITEMS: usize, const WORDS: usize>(
    shift: u32,
    from: &[u32; ITEMS],
) -> ([u32; ITEMS], Vec<u32>) {
    let lanes = 0..LANES as u32;
    let mut counters = [!0; WORDS];
    for lane in lanes.clone() {
        clear(lane, &mut counters);
    }
    for lane in lanes.clone() {
        for step in 0..RUN {
            take(
                round_digit(of_run(lane, step, from), shift),
                lane,
                &mut counters,
            );
        }
    }
    let own: [u32; LANES] = core::array::from_fn(|lane| lane_sum(lane as u32, &counters));
    let mut sums = own;
    let mut distance = 1;
    while distance < LANES as u32 {
        let before = sums;
        for lane in lanes.clone() {
            sums[lane as usize] = doubling_step(lane, distance, &before);
        }
        distance *= 2;
    }
    let all = sums[LANES - 1];
    for lane in lanes.clone() {
        let before = sums[lane as usize].wrapping_sub(own[lane as usize]);
        lane_scan(lane, before, all, &mut counters);
    }
    let (mut to, mut ranks) = ([!0; ITEMS], Vec::new());
    for lane in lanes {
        for step in 0..RUN {
            let item = of_run(lane, step, from);
            let rank = take(round_digit(item, shift), lane, &mut counters);
            put(rank, item, &mut to);
            ranks.push(rank);
        }
    }
    (to, ranks)
}

/// The items of an array in workgroup memory, in order.
fn unswizzled<const ITEMS: usize>(items: &[u32; ITEMS]) -> Vec<u32> {
    (0..ITEMS as u32).map(|i| word(i, items)).collect()
}

/// Tile of these digits; absent items have the last digit.
fn loaded<const ITEMS: usize>(digits: &[u32]) -> [u32; ITEMS] {
    let mut tile = [0; ITEMS];
    for i in 0..ITEMS as u32 {
        let digit = digits.get(i as usize).copied();
        put(i, packed(digit.unwrap_or(DIGITS as u32 - 1), i), &mut tile);
    }
    tile
}

/// One pass over items of `[key, value]`, in tiles of ITEMS, as on a GPU.
fn pass<const LANES: usize, const ITEMS: usize, const WORDS: usize>(
    items: &[[u32; 2]],
    shift: u32,
) -> Vec<[u32; 2]> {
    let tiles: Vec<&[[u32; 2]]> = items.chunks(ITEMS).collect();
    let tile_count = tiles.len() as u32;
    let digits = |items: &[[u32; 2]]| -> Vec<u32> {
        items
            .iter()
            .map(|item| digit::<DIGITS>(item[0], shift))
            .collect()
    };

    let mut totals = vec![0; DIGITS * tiles.len()];
    for (items, tile) in tiles.iter().zip(0..) {
        let mut count = |run: DigitRun| {
            totals[total_place(run.digit, tile, tile_count) as usize] += run.count;
        };
        let mut run = DigitRun::EMPTY;
        for digit in digits(items) {
            if run.ends_at(digit) {
                count(run);
            }
            run = run.with(digit);
        }
        count(run);
    }
    let total_count = totals.len() as u32;
    run_scan(&mut totals, 0, total_count, 0);

    let mut sorted = vec![[!0; 2]; items.len()];
    for (items, tile) in tiles.iter().zip(0..) {
        let first = loaded::<ITEMS>(&digits(items));
        let (second, _) = round::<LANES, ITEMS, WORDS>(0, &first);
        let (first, _) = round::<LANES, ITEMS, WORDS>(4, &second);
        let mut begin = 0;
        for i in 0..items.len() as u32 {
            let item = word(i, &first);
            if is_first(i, &first) {
                begin = totals[total_place(packed_digit(item), tile, tile_count) as usize] - i;
            }
            sorted[(begin + i) as usize] = items[packed_place(item) as usize];
        }
    }
    sorted
}

/// All four passes.
fn sort<const LANES: usize, const ITEMS: usize, const WORDS: usize>(
    items: &[[u32; 2]],
) -> Vec<[u32; 2]> {
    (0..32).step_by(8).fold(items.to_vec(), |items, shift| {
        pass::<LANES, ITEMS, WORDS>(&items, shift)
    })
}

/// A tile's digits: random, few, equal or nearly sorted.
fn any_digits(most: usize) -> impl Strategy<Value = Vec<u32>> {
    let digits = |digit: BoxedStrategy<u32>| proptest::collection::vec(digit, 0..=most);
    let mut nearly = digits((0..256u32).boxed()).boxed();
    nearly = nearly
        .prop_map(|mut digits| {
            digits.sort_unstable();
            let third = digits.len() / 3;
            digits.rotate_left(third);
            digits
        })
        .boxed();
    prop_oneof![
        digits((0..256u32).boxed()),
        digits(prop_oneof![Just(0u32), Just(15), Just(16), Just(240), Just(255)].boxed()),
        (0..256u32, 0..=most).prop_map(|(digit, count)| vec![digit; count]),
        nearly,
    ]
}

/// Whether a tile holds these digits in order, equal ones in order of their places, and then what is absent.
fn is_sorted_tile(tile: &[u32], digits: &[u32]) -> bool {
    let mut expected: Vec<(u32, u32)> = digits.iter().copied().zip(0..).collect();
    expected.sort_by_key(|item| item.0);
    let found = tile
        .iter()
        .map(|&item| (packed_digit(item), packed_place(item)));
    let absent = digits.len() as u32..tile.len() as u32;
    expected.extend(absent.map(|place| (DIGITS as u32 - 1, place)));
    found.eq(expected)
}

#[test]
fn totals_are_stored_digit_by_digit() {
    let places: Vec<u32> = (0..3)
        .flat_map(|digit| (0..5).map(move |tile| total_place(digit, tile, 5)))
        .collect();
    assert_eq!(places, (0..15).collect::<Vec<_>>());
}

#[test]
fn lanes_that_scan_or_walk_their_runs_meet_different_banks() {
    let all: BTreeSet<u32> = (0..1024).map(swizzle).collect();
    assert_eq!(all, (0..1024).collect());
    for stride in [1, COUNTERS, RUN] {
        for step in 0..stride {
            let banks = |word: fn(u32) -> u32| -> usize {
                let banks = (0..32).map(|lane| word(lane * stride + step) % 32);
                banks.collect::<BTreeSet<_>>().len()
            };
            assert_eq!(banks(swizzle), 32);
            // Without it, lanes with runs of 8 share four banks.
            assert_eq!(banks(|i| i), 32 / stride as usize);
        }
    }
}

#[test]
fn both_halves_of_a_word_count_alone() {
    let mut counters = [7; 64];
    for lane in 0..8 {
        clear(lane, &mut counters);
    }
    assert_eq!(counters, [0; 64]);
    // Digits 3 and 11 of lane 5 share a word.
    let taken = [3, 11, 11, 3, 11].map(|digit| take(digit, 5, &mut counters));
    assert_eq!(taken, [0, 0, 1, 1, 2]);
    assert_eq!(counters.iter().sum::<u32>(), 3 << 16 | 2);
    let sums: [u32; 8] = core::array::from_fn(|lane| lane_sum(lane as u32, &counters));
    assert_eq!(sums, [0, 0, 0, 3 << 16 | 2, 0, 0, 0, 0]);
    lane_scan(3, 0, 3 << 16 | 2, &mut counters);
    assert_eq!([3, 11].map(|digit| take(digit, 5, &mut counters)), [0, 2]);
    // The lane after begins behind it.
    assert_eq!([3, 11].map(|digit| take(digit, 6, &mut counters)), [2, 5]);
}

#[test]
fn a_run_ends_where_another_digit_begins() {
    let mut run = DigitRun::EMPTY;
    let mut ended = Vec::new();
    for digit in [0, 0, 7, 7, 7, 0] {
        if run.ends_at(digit) {
            ended.push((run.digit, run.count));
        }
        run = run.with(digit);
    }
    assert_eq!(ended, [(0, 2), (7, 3)]);
    assert_eq!(run, DigitRun { digit: 0, count: 1 });
}

#[test]
fn a_sorted_tile_with_two_items_exchanged_is_found() {
    let digits = [5, 3, 5, 255, 3];
    let sorted = |tile: &[u32; 128]| {
        let (second, _) = round::<8, 128, 64>(0, tile);
        unswizzled(&round::<8, 128, 64>(4, &second).0)
    };
    let mut tile = sorted(&loaded(&digits));
    assert!(is_sorted_tile(&tile, &digits));
    // Equal digits, out of order.
    tile.swap(0, 1);
    assert!(!is_sorted_tile(&tile, &digits));
    // Rounds in the wrong order.
    let (second, _) = round::<8, 128, 64>(4, &loaded(&[0x12, 0x21]));
    let tile = unswizzled(&round::<8, 128, 64>(0, &second).0);
    assert!(!is_sorted_tile(&tile, &[0x12, 0x21]));
}

proptest! {
    #[test]
    fn ranks_of_a_round_are_stable(digits in any_digits(1024), shift in prop_oneof![Just(0u32), Just(4)]) {
        let tile = loaded::<1024>(&digits);
        let (_, ranks) = round::<64, 1024, 512>(shift, &tile);
        let keys: Vec<u32> = unswizzled(&tile).iter().map(|&item| round_digit(item, shift)).collect();
        for (i, &rank) in ranks.iter().enumerate() {
            let smaller = keys.iter().filter(|&&key| key < keys[i]).count();
            let equal_before = keys[..i].iter().filter(|&&key| key == keys[i]).count();
            prop_assert_eq!(rank as usize, smaller + equal_before);
        }
    }

    #[test]
    fn two_rounds_sort_a_tile(digits in any_digits(1024)) {
        let (second, _) = round::<64, 1024, 512>(0, &loaded::<1024>(&digits));
        let tile = unswizzled(&round::<64, 1024, 512>(4, &second).0);
        prop_assert!(is_sorted_tile(&tile, &digits));
        let (first, _) = round::<64, 1024, 512>(4, &second);
        prop_assert!(is_first(0, &first));
        for i in 1..1024 {
            let is_new = packed_digit(tile[i]) != packed_digit(tile[i - 1]);
            prop_assert_eq!(is_first(i as u32, &first), is_new);
        }
    }

    #[test]
    fn stable_for_any_lanes_and_tiles(keys in proptest::collection::vec(prop_oneof![any::<u32>(), 0u32..4, Just(u32::MAX)], 0..700)) {
        let items: Vec<[u32; 2]> = keys.iter().copied().zip(0..).map(|(key, value)| [key, value]).collect();
        let mut expected = items.clone();
        expected.sort_by_key(|item| item[0]);
        prop_assert_eq!(&sort::<4, 64, 32>(&items), &expected);
        prop_assert_eq!(&sort::<16, 256, 128>(&items), &expected);
        prop_assert_eq!(&sort::<64, 1024, 512>(&items), &expected);
    }
}
