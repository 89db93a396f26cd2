//! Marks on numbers, set by several threads.

use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

/// A mark for each number below a count.
pub struct Marks(Vec<AtomicU64>);

impl Marks {
    /// No marks on the numbers below a count.
    pub fn new(count: usize) -> Self {
        let words = 0..count.div_ceil(64);
        Self(words.map(|_| AtomicU64::new(0)).collect())
    }

    /// Marks a number. Returns whether it was there to be marked, and was not marked before.
    pub fn mark(&self, number: u32) -> bool {
        let bit = bit(number);
        let word = self.0.get(number as usize / 64);
        word.is_some_and(|word| word.fetch_or(bit, Relaxed) & bit == 0)
    }

    /// Whether a number is marked.
    pub fn is_marked(&self, number: u32) -> bool {
        let word = self.0.get(number as usize / 64);
        word.is_some_and(|word| word.load(Relaxed) & bit(number) != 0)
    }
}

const fn bit(number: u32) -> u64 {
    1 << (number % 64)
}
