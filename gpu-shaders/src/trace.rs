//! Stage `trace`. Rays are in the caller's magnitude, paths and shadow rays in the scene's.
//!
//! The kernels are a matrix: its columns are the kernels of `trace_kernels`, and each codec is a row, a call of that macro. Only
//! trees in full have kernels for paths and shadow rays without a filter as well: the filter takes 14 % more instructions there.

use glam::UVec4;
use slimbvh_core::encode::RootWords;
use slimbvh_core::float::{PowerOfTwo, power_of_two};
use slimbvh_core::orientation::Target;

#[macro_use]
mod kernels;
#[cfg(feature = "wide")]
pub mod called;
pub mod overflow;
#[cfg(feature = "paper10")]
pub mod paper10;
#[cfg(feature = "plain")]
pub mod plain;
mod rays;
mod store;
#[cfg(feature = "wide")]
pub mod wide;

/// The root of a coded tree, from a uniform.
#[inline(always)]
pub(crate) fn root_words(root: &[UVec4; 2]) -> RootWords {
    RootWords {
        low: root[0].to_array(),
        high: root[1].to_array(),
    }
}

/// The lattice's step.
#[inline(always)]
pub(crate) fn step(root: &RootWords) -> f32 {
    power_of_two(root.step_exponent())
}

/// A target from its words, in the scene's magnitude.
#[inline(always)]
pub(crate) fn scaled_target(words: &[UVec4; 2], exponent: u32) -> Target {
    let (a, b) = (words[0], words[1]);
    let target = Target {
        point: [
            f32::from_bits(a.x),
            f32::from_bits(a.y),
            f32::from_bits(a.z),
        ],
        is_position: a.w,
        radius: f32::from_bits(b.x),
        padding: [b.y, b.z, b.w],
    };
    target.scaled(&PowerOfTwo::new(exponent as i32))
}
