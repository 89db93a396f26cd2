//! Axis-aligned boxes.

use crate::geometry::float::{max, min};
use glam::Vec3;

/// A box between two corners. Holds all points with `min <= p <= max` on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Aabb {
    /// Smallest coordinates.
    pub min: Vec3,
    /// Largest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// The box that holds nothing: the union with it changes nothing.
    pub const EMPTY: Self = Self {
        min: Vec3::splat(f32::MAX),
        max: Vec3::splat(-f32::MAX),
    };

    /// The smallest box that holds both. Exact, so that the order of unions does not matter (no zero may be negative).
    #[inline(always)]
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: lesser(self.min, other.min),
            max: greater(self.max, other.max),
        }
    }

    /// The smallest box that holds this one and a point.
    #[inline(always)]
    #[must_use]
    pub fn union_point(self, p: Vec3) -> Self {
        Self {
            min: lesser(self.min, p),
            max: greater(self.max, p),
        }
    }

    /// Whether the whole of `other` lies inside.
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        self.min.cmple(other.min).all() && self.max.cmpge(other.max).all()
    }

    /// Whether it holds nothing.
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x
    }

    /// Half of the surface's area, `xy + yz + zx`; 0 for the empty box.
    #[inline]
    #[must_use]
    pub fn half_area(&self) -> f32 {
        if self.is_empty() {
            return 0.0;
        }
        let size = self.max - self.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// The smaller coordinates of two points.
#[inline(always)]
pub(crate) fn lesser(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z))
}

/// The larger coordinates of two points.
#[inline(always)]
pub(crate) fn greater(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_area_of_a_1_2_3_box() {
        let b = Aabb {
            min: Vec3::new(-1.0, 0.5, 2.0),
            max: Vec3::new(0.0, 2.5, 5.0),
        };
        assert_eq!(b.half_area(), 1.0 * 2.0 + 2.0 * 3.0 + 3.0 * 1.0);
        assert_eq!(Aabb::EMPTY.half_area(), 0.0);
        assert_eq!(Aabb::EMPTY.union(b), b);
        assert!(b.contains(&Aabb::EMPTY) && !Aabb::EMPTY.contains(&b));
    }
}
