//! What the library calls of rayon, on the calling thread, in order.

use std::slice::{Chunks, ChunksMut, Iter, IterMut};

/// The traits of this file.
pub mod prelude {
    pub use super::{IntoParallelIterator, ParallelIterator, ParallelSlice};
}

/// Runs one closure, then the other.
pub fn join<A, B>(a: impl FnOnce() -> A, b: impl FnOnce() -> B) -> (A, B) {
    (a(), b())
}

/// One thread.
#[must_use]
pub fn current_num_threads() -> usize {
    1
}

/// The methods that rayon's iterators have beside the standard library's.
pub trait ParallelIterator: Iterator + Sized {
    /// The iterator itself: one thread has no tasks whose length matters.
    fn with_min_len(self, _: usize) -> Self {
        self
    }

    /// [`Iterator::for_each`] with a scratch value that all calls share.
    fn for_each_init<T>(self, init: impl FnOnce() -> T, mut each: impl FnMut(&mut T, Self::Item)) {
        let mut scratch = init();
        self.for_each(|item| each(&mut scratch, item));
    }

    /// [`Iterator::reduce`].
    fn reduce_with(
        self,
        join: impl FnMut(Self::Item, Self::Item) -> Self::Item,
    ) -> Option<Self::Item> {
        self.reduce(join)
    }

    /// Replaces a list's items.
    fn collect_into_vec(self, to: &mut Vec<Self::Item>) {
        to.clear();
        to.extend(self);
    }
}

impl<I: Iterator> ParallelIterator for I {}

/// [`IntoIterator`] by rayon's name.
pub trait IntoParallelIterator: IntoIterator + Sized {
    /// [`IntoIterator::into_iter`].
    fn into_par_iter(self) -> Self::IntoIter {
        self.into_iter()
    }
}

impl<I: IntoIterator> IntoParallelIterator for I {}

/// Methods of slices by rayon's names.
pub trait ParallelSlice<T> {
    /// [`slice::iter`].
    fn par_iter(&self) -> Iter<'_, T>;

    /// [`slice::iter_mut`].
    fn par_iter_mut(&mut self) -> IterMut<'_, T>;

    /// [`slice::chunks`].
    fn par_chunks(&self, size: usize) -> Chunks<'_, T>;

    /// [`slice::chunks_mut`].
    fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T>;

    /// [`slice::sort_unstable`].
    fn par_sort_unstable(&mut self)
    where
        T: Ord;

    /// [`slice::sort_unstable_by_key`].
    fn par_sort_unstable_by_key<K: Ord>(&mut self, key: impl FnMut(&T) -> K);
}

impl<T> ParallelSlice<T> for [T] {
    fn par_iter(&self) -> Iter<'_, T> {
        self.iter()
    }

    fn par_iter_mut(&mut self) -> IterMut<'_, T> {
        self.iter_mut()
    }

    fn par_chunks(&self, size: usize) -> Chunks<'_, T> {
        self.chunks(size)
    }

    fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T> {
        self.chunks_mut(size)
    }

    fn par_sort_unstable(&mut self)
    where
        T: Ord,
    {
        self.sort_unstable();
    }

    fn par_sort_unstable_by_key<K: Ord>(&mut self, key: impl FnMut(&T) -> K) {
        self.sort_unstable_by_key(key);
    }
}
