//! Reference answers for tests. The laboratory's [`slimbvh_lab::oracle`] has exact answers for any numbers.

pub mod brute;
pub mod double;
pub mod exact;
