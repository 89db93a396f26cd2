//! What answers are compared with.

pub mod brute;
pub mod double;
pub mod exact;
