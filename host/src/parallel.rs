//! Loops over all cores with feature `parallel`, on one thread without it. The results are the same to the bit.
//!
//! The code is written for rayon. [`serial`] has the same methods over the standard library's iterators, as far as the
//! library calls them.

#[cfg(any(test, not(feature = "parallel")))]
mod serial;
#[cfg(test)]
mod tests;

#[cfg(feature = "parallel")]
pub use rayon::{current_num_threads, join, prelude};
#[cfg(not(feature = "parallel"))]
pub use serial::{current_num_threads, join, prelude};
