//! Exact intersection of rays and triangles, by which every tracer is judged.
//!
//! [`Unculled`] tests all triangles: in doubles where their result is certain, else in exact sums of doubles. It accepts
//! every finite `f32`. [`distance`] computes in doubles, 2^29 times as fine as the numbers that it judges.

pub mod distance;
mod exact_sum;
mod unculled;

pub use exact_sum::ExactSum;
pub use unculled::{Crossing, Unculled};
