//! Stage `compact` on the CPU: selected items, in order.

use super::BLOCK;
use super::scan::scan;
use crate::parallel::prelude::*;
use slimbvh_core::compact::is_set;

/// Words in a parallel task.
const WORDS: usize = BLOCK / 32;

/// A bit for each item, and the number set before each word. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Selection {
    /// The bits.
    pub bits: Vec<u32>,
    /// Exclusive prefix sums of their counts.
    pub before: Vec<u32>,
    count: usize,
}

impl Selection {
    /// Selects items. Returns how many.
    pub fn select(&mut self, item_count: usize, counts: impl Fn(usize) -> bool + Sync) -> usize {
        self.mark(item_count, counts);
        self.scan()
    }

    /// Selects the items whose bit is set in the words that a kernel returns. Returns how many.
    pub fn fill(&mut self, word_count: usize, word: impl Fn(u32) -> u32 + Sync) -> usize {
        self.mark_words(word_count, word);
        self.scan()
    }

    /// First half of [`Self::select`]: the bits, and the number set in each word.
    pub fn mark(&mut self, item_count: usize, counts: impl Fn(usize) -> bool + Sync) {
        let word_count = item_count.div_ceil(32);
        self.mark_words(word_count, |word| {
            let first = 32 * word as usize;
            let items = first..item_count.min(first + 32);
            let bits = items.map(|i| u32::from(counts(i)) << (i - first));
            bits.sum()
        });
    }

    pub fn mark_words(&mut self, word_count: usize, word: impl Fn(u32) -> u32 + Sync) {
        self.bits.resize(word_count, 0);
        self.before.resize(word_count, 0);
        let bits = self.bits.par_chunks_mut(WORDS);
        let blocks = bits.zip(self.before.par_chunks_mut(WORDS)).enumerate();
        blocks.for_each(|(block, (bits, counts))| {
            for ((bits, count), i) in bits.iter_mut().zip(counts).zip((block * WORDS) as u32..) {
                *bits = word(i);
                *count = bits.count_ones();
            }
        });
    }

    /// Second half: the number set before each word. Returns the total.
    pub fn scan(&mut self) -> usize {
        self.count = scan(&mut self.before) as usize;
        self.count
    }

    /// The number of selected items.
    pub const fn len(&self) -> usize {
        self.count
    }

    /// Whether an item is selected.
    pub fn is_taken(&self, item: u32) -> bool {
        is_set(item, &self.bits)
    }

    /// Visits each selected item with its entries in two lists, both as long as the selection.
    pub fn for_each<A: Send, B: Send>(
        &self,
        a: &mut [A],
        b: &mut [B],
        visit: impl Fn(usize, &mut A, &mut B) + Sync,
    ) {
        // Each block of words fills a run of the lists; the prefix sums say where it begins.
        let mut blocks = Vec::with_capacity(self.bits.len().div_ceil(WORDS));
        let (mut rest_a, mut rest_b) = (a, b);
        for first_word in (0..self.bits.len()).step_by(WORDS) {
            let begin = self.before[first_word] as usize;
            let next = self.before.get(first_word + WORDS);
            let end = next.map_or(self.count, |&next| next as usize);
            let (run_a, after_a) = rest_a.split_at_mut(end - begin);
            let (run_b, after_b) = rest_b.split_at_mut(end - begin);
            (rest_a, rest_b) = (after_a, after_b);
            blocks.push((first_word, run_a, run_b));
        }
        blocks
            .into_par_iter()
            .for_each(|(first_word, run_a, run_b)| {
                let mut places = run_a.iter_mut().zip(run_b);
                for (word, &bits) in self.bits.iter().enumerate().skip(first_word).take(WORDS) {
                    let mut left = bits;
                    while left != 0 {
                        let i = word * 32 + left.trailing_zeros() as usize;
                        left &= left - 1;
                        if let Some((a, b)) = places.next() {
                            visit(i, a, b);
                        }
                    }
                }
            });
    }

    /// Bytes of the buffers that the last selection used.
    pub fn bytes(&self) -> usize {
        size_of_val(self.bits.as_slice()) + size_of_val(self.before.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_counts_is_shown_in_order() {
        for item_count in [0, 1, 31, 32, 33, BLOCK, BLOCK + 1, 3 * BLOCK + 77] {
            let mut selection = Selection::default();
            let count = selection.select(item_count, |i| i % 3 == 1 || i % 1000 == 0);
            let (mut items, mut copies) = (vec![0; count], vec![0; count]);
            selection.for_each(&mut items, &mut copies, |i, item, copy| {
                (*item, *copy) = (i, i);
            });
            let expected = (0..item_count).filter(|i| i % 3 == 1 || i % 1000 == 0);
            assert!(items.iter().copied().eq(expected), "{item_count}");
            let taken = (0..item_count).filter(|&i| selection.is_taken(i as u32));
            assert!(taken.eq(items.iter().copied()), "{item_count}");
            assert_eq!(items, copies);
        }
    }
}
