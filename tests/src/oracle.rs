//! What answers are compared with.

pub mod brute;
pub mod double;
pub mod exact;
pub mod exact_sum;
pub mod unculled;
