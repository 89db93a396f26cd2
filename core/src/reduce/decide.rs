//! Stage `decide`: which side of each closed component faces out for a target, from where the vertices are now. Where only
//! the GPU knows that, only the GPU can say.
//!
//! Two phases over workgroups measure moved vertices: each span is measured by its lanes ([`lane_measure`]), and each
//! component by its spans ([`lane_joined`]), both reduced by [`join_step`]. Then each target asks: [`Measure::side`]. A light
//! may be answered by the triangles that face it (L+) or by those that face away (L−), whichever are fewer
//! ([`lane_counts`], [`SetCounts::decided`]): L− is L+ of the negated sides, so nothing that follows needs to know.
//!
//! All that is not certain is answered by 0: the component stays whole. The host, which takes solid angles where a target
//! touches a component's box, may know more; it never knows the contrary.

mod clear;
mod counts;
mod measure;

#[cfg(test)]
mod tests;

pub use clear::is_clear_of_box;
pub use counts::{Choice, SetCounts, count_step, lane_counts, lane_total};
pub use measure::{Component, Measure, Span, Surfaces, Unit, join_step, lane_joined, lane_measure};
