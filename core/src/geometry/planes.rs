//! The planes of boxes on one axis: two boxes for one ray, or one box for several rays.

use crate::geometry::lanes::Lanes;
use core::ops::{Add, Neg, Sub};
use glam::{Vec4, Vec4Swizzles};

/// Two boxes' planes on one axis: `(a.min, b.min, a.max, b.max)`.
pub type PlanePair = Vec4;

/// Planes on one axis: of two boxes for one ray ([`PlanePair`]), or of one box for several rays ([`BoxSpan`]).
pub trait Planes: Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> {
    /// A number for each ray.
    type Numbers: Lanes;

    /// One box for each ray, in the place of both where there are two.
    fn new(low: Self::Numbers, high: Self::Numbers) -> Self;

    /// For the plane at the smaller coordinate, of the first box where there are two.
    fn low(self) -> Self::Numbers;

    /// Each distance times the ray's factor.
    fn times(self, factor: Self::Numbers) -> Self;

    /// All distances times the same.
    fn scaled(self, factor: f32) -> Self;

    /// The smaller of each.
    fn min(self, other: Self) -> Self;

    /// The larger of each.
    fn max(self, other: Self) -> Self;

    /// In the place of each plane the other one of its box.
    fn opposite(self) -> Self;
}

impl Planes for PlanePair {
    type Numbers = f32;

    #[inline(always)]
    fn new(low: f32, high: f32) -> Self {
        Self::new(low, low, high, high)
    }

    #[inline(always)]
    fn low(self) -> f32 {
        self.x
    }

    #[inline(always)]
    fn times(self, factor: f32) -> Self {
        self * factor
    }

    #[inline(always)]
    fn scaled(self, factor: f32) -> Self {
        self * factor
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }

    #[inline(always)]
    fn opposite(self) -> Self {
        self.zwxy()
    }
}

/// A box's planes on one axis, or what is computed with them, for several rays.
#[derive(Clone, Copy, Debug)]
pub struct BoxSpan<W> {
    /// The number of the plane at the smaller coordinate.
    pub low: W,
    /// The number of the plane at the larger coordinate.
    pub high: W,
}

impl<W: Lanes> BoxSpan<W> {
    #[inline(always)]
    fn each(self, of: impl Fn(W) -> W) -> Self {
        Self {
            low: of(self.low),
            high: of(self.high),
        }
    }

    #[inline(always)]
    fn both(self, other: Self, of: impl Fn(W, W) -> W) -> Self {
        Self {
            low: of(self.low, other.low),
            high: of(self.high, other.high),
        }
    }
}

impl<W: Lanes> Add for BoxSpan<W> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.both(other, W::add)
    }
}

impl<W: Lanes> Sub for BoxSpan<W> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.both(other, W::sub)
    }
}

impl<W: Lanes> Neg for BoxSpan<W> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.each(W::neg)
    }
}

impl<W: Lanes> Planes for BoxSpan<W> {
    type Numbers = W;

    #[inline(always)]
    fn new(low: W, high: W) -> Self {
        Self { low, high }
    }

    #[inline(always)]
    fn low(self) -> W {
        self.low
    }

    #[inline(always)]
    fn times(self, factor: W) -> Self {
        self.each(|x| x * factor)
    }

    #[inline(always)]
    fn scaled(self, factor: f32) -> Self {
        self.each(|x| x * W::splat(factor))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.both(other, W::min)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.both(other, W::max)
    }

    #[inline(always)]
    fn opposite(self) -> Self {
        Self {
            low: self.high,
            high: self.low,
        }
    }
}
