//! Stage `sort`: core's radix sort, with one tile a task. A single tile counts the digits of all passes in one reading.

use super::scan::scan;
use crate::parallel::prelude::*;
use slimbvh_core::sort::{digit, total_place};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Bits of a digit: 30-bit codes take three passes.
const DIGIT_BITS: u32 = 11;
const DIGITS: usize = 1 << DIGIT_BITS;
type Counts = [u32; DIGITS];

/// The least number of items in a tile of several.
const SMALLEST_TILE: usize = 1 << 14;

/// A key of W words, the most significant first, and the item's position before sorting, in words of 64 bits.
///
/// Destinations depend on data, so tasks store through relaxed atomics, each to its own places. They compile to plain
/// moves.
#[derive(Debug)]
pub struct Item<const W: usize>([AtomicU64; W]);

impl<const W: usize> Default for Item<W> {
    fn default() -> Self {
        Self(std::array::from_fn(|_| AtomicU64::new(0)))
    }
}

impl<const W: usize> Item<W> {
    /// A word of 32 bits: of the key, or behind it the position.
    #[inline]
    fn half(&self, i: usize) -> u32 {
        let word = self.0[i / 2].load(Relaxed);
        (word >> (32 * (1 - i % 2))) as u32
    }

    /// The key.
    pub fn key(&self) -> [u32; W] {
        std::array::from_fn(|word| self.half(word))
    }

    /// The position before sorting.
    pub fn index(&self) -> u32 {
        self.half(W)
    }

    /// Replaces both.
    pub fn set(&self, key: [u32; W], index: u32) {
        let half = |i: usize| u64::from(*key.get(i).unwrap_or(&index));
        for (i, word) in self.0.iter().enumerate() {
            word.store(half(2 * i) << 32 | half(2 * i + 1), Relaxed);
        }
    }

    /// Replaces both by those of another item.
    fn copy(&self, from: &Self) {
        for (to, from) in self.0.iter().zip(&from.0) {
            to.store(from.load(Relaxed), Relaxed);
        }
    }
}

/// A digit of keys.
#[derive(Clone, Copy)]
struct Digit {
    word: usize,
    shift: u32,
}

impl Digit {
    #[inline]
    fn of<const W: usize>(self, item: &Item<W>) -> usize {
        digit::<DIGITS>(item.half(self.word), self.shift) as usize % DIGITS
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
        let words = key_bits.into_iter().enumerate().rev();
        let digits = words.flat_map(|(word, bits)| {
            let shifts = (0..bits).step_by(DIGIT_BITS as usize);
            shifts.map(move |shift| Digit { word, shift })
        });
        let digits: Vec<Digit> = digits.collect();
        let tile = match crate::parallel::current_num_threads() {
            1 => usize::MAX,
            threads => self.len().div_ceil(4 * threads).max(SMALLEST_TILE),
        };
        if self.len() <= tile {
            self.sort_tile(&digits);
        } else {
            self.sort_tiles(&digits, tile);
        }
    }

    /// Sorts a single tile.
    fn sort_tile(&mut self, digits: &[Digit]) {
        self.counts.clear();
        self.counts.resize(digits.len(), [0; DIGITS]);
        for item in &self.items {
            for (counts, digit) in self.counts.iter_mut().zip(digits) {
                counts[digit.of(item)] += 1;
            }
        }
        for (counts, &digit) in self.counts.iter_mut().zip(digits) {
            // All items have the same digit.
            if counts
                .iter()
                .any(|&count| count as usize == self.items.len())
            {
                continue;
            }
            scan(counts);
            move_items(&self.items, digit, counts, &self.other);
            std::mem::swap(&mut self.items, &mut self.other);
        }
    }

    fn sort_tiles(&mut self, digits: &[Digit], tile: usize) {
        for &digit in digits {
            if self.pass(digit, tile) {
                std::mem::swap(&mut self.items, &mut self.other);
            }
        }
    }

    /// Sorts by one digit from `items` to `other`. Returns `false` without moving anything if all items have the same
    /// digit.
    fn pass(&mut self, digit: Digit, tile: usize) -> bool {
        // Phase 1: each tile counts its digits.
        let tiles = self.items.par_chunks(tile);
        self.counts.resize(tiles.len(), [0; DIGITS]);
        tiles.zip(&mut self.counts).for_each(|(items, counts)| {
            *counts = [0; DIGITS];
            for item in items {
                counts[digit.of(item)] += 1;
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
            if sum as usize == self.items.len() {
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
        let tiles = self.items.par_chunks(tile).zip(&mut self.counts);
        tiles.for_each(|(items, next)| move_items(items, digit, next, &self.other));
        true
    }
}

/// Moves items, each to the next place of its digit.
fn move_items<const W: usize>(items: &[Item<W>], digit: Digit, next: &mut Counts, to: &[Item<W>]) {
    for item in items {
        let place = &mut next[digit.of(item)];
        to[*place as usize].copy(item);
        *place += 1;
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
        // On one thread there is a single tile.
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let alone = alone.expect("one thread");
        assert_eq!(alone.install(|| sorted(&keys, [31, 32])), expected);
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
