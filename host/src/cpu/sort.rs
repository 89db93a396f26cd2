//! Stage `sort`: core's radix sort, with one tile a task.

use super::scan::scan;
use crate::parallel::prelude::*;
use slimbvh_core::sort::{digit, total_place};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Bits of a digit: 30-bit codes take three passes.
const DIGIT_BITS: u32 = 10;
const DIGITS: usize = 1 << DIGIT_BITS;
type Counts = [u32; DIGITS];

/// The least number of items in a tile.
const SMALLEST_TILE: usize = 1 << 14;

/// A key of W words, the most significant first, and the item's position before sorting.
///
/// Destinations depend on data, so tasks store through relaxed atomics, each to its own places. They compile to plain
/// moves.
#[derive(Debug)]
pub struct Item<const W: usize> {
    key: [AtomicU32; W],
    index: AtomicU32,
}

impl<const W: usize> Default for Item<W> {
    fn default() -> Self {
        Self {
            key: std::array::from_fn(|_| AtomicU32::new(0)),
            index: AtomicU32::new(0),
        }
    }
}

impl<const W: usize> Item<W> {
    /// The key.
    pub fn key(&self) -> [u32; W] {
        std::array::from_fn(|word| self.key[word].load(Relaxed))
    }

    /// The position before sorting.
    pub fn index(&self) -> u32 {
        self.index.load(Relaxed)
    }

    /// Replaces both.
    pub fn set(&self, key: [u32; W], index: u32) {
        for (word, value) in self.key.iter().zip(key) {
            word.store(value, Relaxed);
        }
        self.index.store(index, Relaxed);
    }
}

/// Sorts items by their keys, stably. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Sorter<const W: usize> {
    items: Vec<Item<W>>,
    other: Vec<Item<W>>,
    counts: Vec<Counts>,
    offsets: Vec<u32>,
}

impl<const W: usize> Sorter<W> {
    /// Makes room for `count` items, to be set before sorting.
    pub fn resize(&mut self, count: usize) {
        self.items.resize_with(count, Item::default);
        self.other.resize_with(count, Item::default);
    }

    /// The items: sorted after [`Self::sort`].
    pub fn items(&mut self) -> &mut [Item<W>] {
        &mut self.items
    }

    /// The number of items.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Bytes of the buffers.
    pub fn bytes(&self) -> usize {
        2 * size_of_val(self.items.as_slice())
            + size_of_val(self.counts.as_slice())
            + size_of_val(self.offsets.as_slice())
    }

    /// Sorts by the low `key_bits[w]` bits of each word w.
    pub fn sort(&mut self, key_bits: [u32; W]) {
        for (word, bits) in key_bits.into_iter().enumerate().rev() {
            for shift in (0..bits).step_by(DIGIT_BITS as usize) {
                if self.pass(word, shift) {
                    std::mem::swap(&mut self.items, &mut self.other);
                }
            }
        }
    }

    /// Sorts by one digit from `items` to `other`. Returns `false` without moving anything if all items have the same
    /// digit.
    fn pass(&mut self, word: usize, shift: u32) -> bool {
        let count = self.items.len();
        let tile = count
            .div_ceil(4 * crate::parallel::current_num_threads())
            .max(SMALLEST_TILE);
        let item_digit = |item: &Item<W>| digit::<DIGITS>(item.key[word].load(Relaxed), shift);

        // Phase 1: each tile counts its digits.
        let tiles = self.items.par_chunks(tile);
        self.counts.resize(tiles.len(), [0; DIGITS]);
        tiles.zip(&mut self.counts).for_each(|(items, counts)| {
            *counts = [0; DIGITS];
            for item in items {
                counts[item_digit(item) as usize % DIGITS] += 1;
            }
        });

        // Phase 2: an exclusive prefix sum, by digit and then by tile, is where each run begins.
        let tile_count = self.counts.len() as u32;
        self.offsets.resize(DIGITS * self.counts.len(), 0);
        for digit in 0..DIGITS as u32 {
            let mut sum = 0;
            for (counts, tile) in self.counts.iter().zip(0..) {
                let total = counts[digit as usize];
                self.offsets[total_place(digit, tile, tile_count) as usize] = total;
                sum += total;
            }
            if sum as usize == count {
                return false;
            }
        }
        scan(&mut self.offsets);
        for (counts, tile) in self.counts.iter_mut().zip(0..) {
            for (next, digit) in counts.iter_mut().zip(0..) {
                *next = self.offsets[total_place(digit, tile, tile_count) as usize];
            }
        }

        // Phase 3: each tile moves its items in order.
        let other = &self.other;
        self.items
            .par_chunks(tile)
            .zip(&mut self.counts)
            .for_each(|(items, offsets)| {
                for item in items {
                    let next = &mut offsets[item_digit(item) as usize % DIGITS];
                    other[*next as usize].set(item.key(), item.index());
                    *next += 1;
                }
            });
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sorted<const W: usize>(keys: &[[u32; W]], key_bits: [u32; W]) -> Vec<([u32; W], u32)> {
        let mut sorter = Sorter::default();
        sorter.resize(keys.len());
        for (i, &key) in keys.iter().enumerate() {
            sorter.items()[i].set(key, i as u32);
        }
        sorter.sort(key_bits);
        sorter
            .items()
            .iter()
            .map(|item| (item.key(), item.index()))
            .collect()
    }

    #[test]
    fn many_tiles_sort_like_one_list() {
        // More items than a tile, with many equal keys.
        let mut state = 1u32;
        let keys: Vec<[u32; 2]> = (0..3 * SMALLEST_TILE + 5)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                [state >> 20, (state >> 3) & 3]
            })
            .collect();
        let mut expected: Vec<([u32; 2], u32)> = keys.iter().copied().zip(0..).collect();
        expected.sort_by_key(|item| item.0);
        assert_eq!(sorted(&keys, [31, 32]), expected);
    }

    #[test]
    fn no_items_and_equal_items() {
        assert_eq!(sorted::<1>(&[], [30]), []);
        assert_eq!(
            sorted(&[[7], [7], [7]], [30]),
            [([7], 0), ([7], 1), ([7], 2)]
        );
    }
}
