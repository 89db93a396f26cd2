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

    /// The smaller of each, to be compared and dropped ([`Lanes::least`]).
    fn least(self, other: Self) -> Self;

    /// The larger of each, as [`Self::least`].
    fn most(self, other: Self) -> Self;

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

    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        self.min(other)
    }

    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        self.max(other)
    }

    #[cfg(target_arch = "spirv")]
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self::new(
            a.x.least(b.x),
            a.y.least(b.y),
            a.z.least(b.z),
            a.w.least(b.w),
        )
    }

    #[cfg(target_arch = "spirv")]
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self::new(a.x.most(b.x), a.y.most(b.y), a.z.most(b.z), a.w.most(b.w))
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
    fn least(self, other: Self) -> Self {
        self.both(other, W::least)
    }

    #[inline(always)]
    fn most(self, other: Self) -> Self {
        self.both(other, W::most)
    }

    #[inline(always)]
    fn opposite(self) -> Self {
        Self {
            low: self.high,
            high: self.low,
        }
    }
}
