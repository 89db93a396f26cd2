//! Rayon and its stand-in give the same results.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// What both give for each method that the library calls, over the same numbers.
macro_rules! results {
    ($($from:ident)::+) => {{
        use $($from)::+::{join, prelude::*};
        let numbers: Vec<u64> = (0..1000).map(|i| i * 7919 % 1009).collect();
        let mut squares = vec![0; numbers.len()];
        let pairs = squares.par_iter_mut().zip(&numbers).with_min_len(10);
        pairs.for_each(|(square, number)| *square = number * number);

        let mut sums = vec![0; numbers.len().div_ceil(64)];
        let blocks = sums.par_chunks_mut(1).zip(numbers.par_chunks(64)).enumerate();
        let places = AtomicUsize::new(0);
        blocks.for_each_init(Vec::new, |scratch: &mut Vec<u64>, (place, (sum, block))| {
            scratch.clear();
            scratch.extend_from_slice(block);
            sum[0] = scratch.iter().sum();
            places.fetch_add(place, Relaxed);
        });

        let mut odd = vec![5; 3];
        numbers.par_iter().map(|number| number % 2).collect_into_vec(&mut odd);
        let mut sorted = numbers.clone();
        sorted.par_sort_unstable();
        let mut keyed = numbers.clone();
        keyed.par_sort_unstable_by_key(|number| std::cmp::Reverse(*number));
        (
            (squares, sums, places.into_inner(), odd, sorted, keyed),
            (0..numbers.len()).into_par_iter().map(|i| numbers[i]).reduce_with(u64::max),
            (0..0).into_par_iter().reduce_with(u64::max),
            join(|| numbers.len(), || numbers[1]),
        )
    }};
}

#[test]
fn one_thread_gives_what_rayon_gives() {
    let serial = results!(super::serial);
    let parallel = results!(rayon);
    assert_eq!(serial, parallel);
    let ((squares, sums, ..), largest, none, joined) = serial;
    assert_eq!((squares[2], sums.len(), sums[0]), (494_209, 16, 32_594));
    assert_eq!((largest, none, joined), (Some(1008), None, (1000, 856)));
}

#[test]
fn the_stand_in_has_one_thread() {
    assert_eq!(super::serial::current_num_threads(), 1);
}
