//! How many words a vertex takes in a leaf with some box, and the box that the traversal carries down a tree of the parent-frame codec.

use crate::geometry::float::max;
use crate::geometry::lattice::LatticeBox;
use glam::Vec4;

/// A box on the lattice as the traversal carries it: the same numbers in the scene's unit, which floats hold exactly, with
/// coordinates in the order of the ray's axes. Last lanes are unused: what is stored as a vector can be loaded as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeBounds {
    /// Smallest coordinates.
    pub min: Vec4,
    /// Largest coordinates.
    pub max: Vec4,
}

impl LatticeBounds {
    /// The box of the origin alone; all bits zero.
    pub const ZERO: Self = Self {
        min: Vec4::ZERO,
        max: Vec4::ZERO,
    };

    /// A box whose steps have this length, for a ray whose axes are in this order.
    #[inline(always)]
    #[must_use]
    pub fn new(bounds: &LatticeBox, step: f32, axes: [u32; 3]) -> Self {
        let [a, b, c] = axes;
        let min = |axis: u32| bounds.min[axis as usize % 3] as f32 * step;
        let max = |axis: u32| bounds.max[axis as usize % 3] as f32 * step;
        Self {
            min: Vec4::new(min(a), min(b), min(c), 0.0),
            max: Vec4::new(max(a), max(b), max(c), 0.0),
        }
    }
}

/// What a leaf's triangles are decoded relative to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(16))]
pub struct LeafFrame {
    /// The smallest coordinates of the leaf's decoded box, in the scene's unit and in the order of the ray's axes.
    pub min: Vec4,
    /// The width of its triangles.
    pub width: LeafWidth,
}

impl LeafFrame {
    /// The frame of a leaf with this box.
    #[inline(always)]
    #[must_use]
    pub fn of(bounds: &LatticeBounds, step: f32) -> Self {
        Self {
            min: bounds.min,
            width: LeafWidth::of_bounds(bounds, step),
        }
    }
}

/// How many bits a coordinate takes, by the extent of the leaf's box: in nodes of 48 bytes, of the widest leaf's of the node. All
/// triangles of a leaf have the same. A triangle by itself takes:
///
/// ```text
/// narrow   16 bytes   3 vertices × 1 word:   z (10 bits) y (10) x (10), from the box's min; index
/// middle   28 bytes   3 vertices × 2 words:  z (21 bits) y (21) x (21), from the box's min; index
/// wide     40 bytes   3 vertices × 3 words:  lattice coordinates; index
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum LeafWidth {
    /// No extent over 1023 steps.
    Narrow,
    /// No extent over 2^21 − 1 steps.
    Middle,
    /// Any.
    Wide,
}

impl LeafWidth {
    /// The width of the triangles in a leaf with this box.
    #[inline(always)]
    #[must_use]
    pub fn of(bounds: &LatticeBox) -> Self {
        let extent = |axis: usize| bounds.max[axis].wrapping_sub(bounds.min[axis]) as u32;
        Self::of_extents([extent(0), extent(1), extent(2)])
    }

    /// The width of the triangles in a leaf whose box has these extents in steps.
    #[inline(always)]
    #[must_use]
    pub const fn of_extents([a, b, c]: [u32; 3]) -> Self {
        // Their bits together are as long as the longest.
        let any = a | b | c;
        if any < 1 << 10 {
            Self::Narrow
        } else if any < 1 << 21 {
            Self::Middle
        } else {
            Self::Wide
        }
    }

    /// The width with this number; above 2, wide.
    #[inline(always)]
    #[must_use]
    pub const fn of_number(number: u32) -> Self {
        match number {
            0 => Self::Narrow,
            1 => Self::Middle,
            _ => Self::Wide,
        }
    }

    /// The same from the box that the traversal carries.
    #[inline(always)]
    #[must_use]
    pub fn of_bounds(frame: &LatticeBounds, step: f32) -> Self {
        let extent = frame.max - frame.min;
        let largest = max(max(extent.x, extent.y), extent.z);
        if largest < 1024.0 * step {
            Self::Narrow
        } else if largest < 2_097_152.0 * step {
            Self::Middle
        } else {
            Self::Wide
        }
    }

    /// Words of a triangle.
    #[inline(always)]
    #[must_use]
    pub const fn words(self) -> u32 {
        3 * self.vertex_words() + 1
    }

    /// Words of a vertex.
    #[inline(always)]
    #[must_use]
    pub const fn vertex_words(self) -> u32 {
        match self {
            Self::Narrow => 1,
            Self::Middle => 2,
            Self::Wide => 3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_end_where_they_say() {
        let of = |extent: i32| {
            LeafWidth::of(&LatticeBox {
                min: [5; 3],
                max: [5, 5 + extent, 6],
            })
        };
        assert_eq!([of(0), of(1023), of(1024)].map(LeafWidth::words), [4, 4, 7]);
        assert_eq!(
            [of((1 << 21) - 1), of(1 << 21)].map(LeafWidth::words),
            [7, 10]
        );
    }
}
