//! Numbers of one ray, or of several at once: the same arithmetic either way.

use crate::geometry::float;
#[cfg(not(target_arch = "spirv"))]
use core::array::from_fn;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

#[cfg(not(target_arch = "spirv"))]
mod each;

#[cfg(not(target_arch = "spirv"))]
pub use each::{Each, EachMask};

/// A number for each lane: `f32` for one, [`Wide`] for several.
pub trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Zero in all lanes.
    const ZERO: Self;

    /// A yes or no for each lane.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + Not<Output = Self::Mask>;

    /// The same in all lanes.
    fn splat(x: f32) -> Self;

    /// The smaller in each lane.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The larger in each lane.
    #[must_use]
    fn max(self, other: Self) -> Self;

    /// The smaller in each lane, to be compared and dropped: of two zeros it may be either. No lane is NaN.
    #[inline(always)]
    #[must_use]
    fn least(self, other: Self) -> Self {
        self.min(other)
    }

    /// The larger in each lane, as [`Self::least`].
    #[inline(always)]
    #[must_use]
    fn most(self, other: Self) -> Self {
        self.max(other)
    }

    /// With 0 for −0.
    #[inline(always)]
    #[must_use]
    fn positive_zero(self) -> Self {
        let is_zero = self.at_most(Self::ZERO) & self.at_least(Self::ZERO);
        Self::select(is_zero, Self::ZERO, self)
    }

    /// Without its sign.
    #[must_use]
    fn abs(self) -> Self;

    /// Where it is smaller or equal.
    fn at_most(self, other: Self) -> Self::Mask;

    /// Where it is larger or equal.
    fn at_least(self, other: Self) -> Self::Mask;

    /// One number where the mask says yes, another where it says no.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Whether a mask says yes anywhere.
    fn any(mask: Self::Mask) -> bool;
}

impl Lanes for f32 {
    const ZERO: Self = 0.0;

    type Mask = bool;

    #[inline(always)]
    fn splat(x: f32) -> Self {
        x
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        float::min(self, other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        float::max(self, other)
    }

    #[inline(always)]
    fn least(self, other: Self) -> Self {
        float::least(self, other)
    }

    #[inline(always)]
    fn most(self, other: Self) -> Self {
        float::most(self, other)
    }

    #[inline(always)]
    fn positive_zero(self) -> Self {
        float::positive_zero(self)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        float::abs(self)
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> bool {
        self >= other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
}

/// Numbers of several rays, 32 at most.
///
/// Each lane computes what `f32` does, to the bit. Hosts have types of their own, as wide as a processor's registers; [`Each`]
/// is what they are held to.
#[cfg(not(target_arch = "spirv"))]
pub trait Wide<const LANES: usize>: Lanes {
    /// A number for each lane.
    fn from_array(numbers: [f32; LANES]) -> Self;

    /// The number of each lane.
    fn to_array(self) -> [f32; LANES];

    /// The number of one lane, where it lies. Of one beyond the last, that of another.
    #[inline(always)]
    fn lane(&self, i: usize) -> f32 {
        self.to_array()[i % LANES]
    }

    /// Transposes: takes a row of numbers for each lane, returns the first numbers of all rows, then the second, and so on.
    #[inline(always)]
    #[must_use]
    fn columns(rows: [[f32; 8]; LANES]) -> [Self; 8] {
        from_fn(|column| Self::from_array(from_fn(|lane| rows[lane][column])))
    }

    /// The largest power of two that is no larger, of normal numbers above 0.
    #[must_use]
    fn power_below(self) -> Self;

    /// A bit for each lane, the first lane's lowest.
    fn bits(mask: Self::Mask) -> u32;
}
