//! The sort, for any size and keys of both lengths.

use super::SIZES;
use slimbvh::gpu::{Gpu, Keys, Sort};
use slimbvh_tests::gpu::{contents, done, gpu, storage};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;

/// Distributions of keys.
#[derive(Clone, Copy, Debug)]
enum Spread {
    /// Random keys.
    Even,
    /// Few different keys, which differ in high and low bits.
    Few,
    /// All keys are equal.
    Equal,
    /// Descending keys.
    Falling,
}

const SPREADS: [Spread; 4] = [Spread::Even, Spread::Few, Spread::Equal, Spread::Falling];

fn keys(spread: Spread, count: u32) -> Vec<u64> {
    let mut random = Random::new(u64::from(count));
    (0..u64::from(count))
        .map(|i| match spread {
            Spread::Even => random.bits(),
            Spread::Few => random.bits() & 0x8000_0001_4000_0002,
            Spread::Equal => 0x1234_5678_9abc_def0,
            Spread::Falling => (u64::MAX - i).rotate_left(20),
        })
        .collect()
}

/// Sorts keys with their places, and compares with the standard library's stable sort.
fn check(gpu: &Gpu, sort: &mut Sort, width: Keys, keys: &[u64]) -> Result<(), String> {
    let short = |key: u64| (key >> 32) as u32 ^ key as u32;
    let items = |numbered: &[(u64, u32)]| -> Vec<u32> {
        let words = |&(key, place): &(u64, u32)| match width {
            Keys::OneWord => vec![key as u32, place],
            Keys::TwoWords => vec![(key >> 32) as u32, key as u32, place],
        };
        numbered.iter().flat_map(words).collect()
    };
    let numbered = keys.iter().zip(0..).map(|(&key, place)| match width {
        Keys::OneWord => (u64::from(short(key)), place),
        Keys::TwoWords => (key, place),
    });
    let mut numbered: Vec<(u64, u32)> = numbered.collect();
    let buffer = storage(gpu, &items(&numbered));
    let mut frame = gpu.frame();
    done(sort.encode(&mut frame, width, buffer.slice(..)));
    done(frame.submit());
    numbered.sort_by_key(|item| item.0);
    same_bits(&contents::<u32>(gpu, &buffer), &items(&numbered))
}

#[test]
fn sorts_of_any_size_are_stable() {
    let Some(gpu) = gpu() else { return };
    for width in [Keys::OneWord, Keys::TwoWords] {
        let mut sort = Sort::new();
        for count in SIZES {
            for spread in SPREADS {
                let result = check(gpu, &mut sort, width, &keys(spread, count));
                assert_eq!(result, Ok(()), "{count} keys, {width:?}, {spread:?}");
            }
        }
    }
}

#[test]
fn equal_keys_of_a_hundred_thousand_items_stay_in_order() {
    let Some(gpu) = gpu() else { return };
    for width in [Keys::OneWord, Keys::TwoWords] {
        for spread in [Spread::Equal, Spread::Few] {
            let keys = keys(spread, 100_000);
            assert_eq!(check(gpu, &mut Sort::new(), width, &keys), Ok(()));
        }
    }
}

#[test]
fn an_unstable_order_is_found() {
    let Some(gpu) = gpu() else { return };
    // Sorted keys with descending values: a stable sort leaves them unchanged.
    let items: Vec<[u32; 2]> = (0..2000).map(|i| [i / 100, 2000 - i]).collect();
    let buffer = storage(gpu, &items);
    let mut frame = gpu.frame();
    done(Sort::new().encode(&mut frame, Keys::OneWord, buffer.slice(..)));
    done(frame.submit());
    let sorted: Vec<[u32; 2]> = contents(gpu, &buffer);
    done(same_bits(&sorted, &items));
    let mut by_value = items;
    by_value.sort_unstable();
    assert!(same_bits(&sorted, &by_value).is_err());
}
