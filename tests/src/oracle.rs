//! What answers are compared with. Exact answers for any numbers are [`slimbvh_lab::oracle`]'s, which the binary has, too.

pub mod brute;
pub mod double;
pub mod exact;
