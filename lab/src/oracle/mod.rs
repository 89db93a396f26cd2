//! What rays meet, without rounding: the judge of every tracer.
//!
//! [`Unculled`] asks all triangles, in doubles where these leave no doubt and in sums of doubles that lose nothing else.
//! Every finite `f32` will do. [`distance`] is in doubles, 2^29 times as fine as what it is compared with.

pub mod distance;
mod exact_sum;
mod unculled;

pub use exact_sum::ExactSum;
pub use unculled::{Crossing, Unculled};
