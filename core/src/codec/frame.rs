//! One axis of a wide node's own frame: planes of its children in 8 bits, on the lattice.
//!
//! A frame is cut into cells of a power of two of steps, at most 256. A lower plane is the number of cells from the node's lower
//! side up, an upper plane that from its upper side down, both rounded down: no child loses anything, none reaches beyond its
//! node, and one at a side of the node is exact there.
//!
//! ```text
//! last   = extent − 1, or 0
//! shift  = bits(last) − 8, or 0
//! lower  plane d → min(d, last) >> shift            number q → q << shift
//! upper  plane d → min(extent − d, last) >> shift   number q → extent − (q << shift)
//! ```
//!
//! Where the extent is not stored, upper planes count from the lower side, too. The number is then that of the cell below the plane,
//! so that the end of the 256th cell has a number:
//!
//! ```text
//! upper  plane d → (d − 1, or 0) >> shift           number q → (q + 1) << shift
//! ```

/// Bits of a plane.
pub const PLANE_BITS: u32 = 8;

/// An axis of a node: how many steps its box has there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Steps from the smallest to the largest coordinate. At most `2^31`.
    pub extent: u32,
}

impl Frame {
    /// Where the last step begins.
    #[inline(always)]
    const fn last(self) -> u32 {
        less(self.extent, 1)
    }

    /// Bits of steps in a cell.
    #[inline(always)]
    #[must_use]
    pub const fn shift(self) -> u32 {
        less(u32::BITS - self.last().leading_zeros(), PLANE_BITS)
    }

    /// The number of a lower plane this many steps above the node's.
    #[inline(always)]
    #[must_use]
    pub const fn lower(self, steps: u32) -> u32 {
        let last = self.last();
        (if steps < last { steps } else { last }) >> self.shift()
    }

    /// The number of an upper plane this many steps above the node's lower one, from its upper one down.
    #[cfg(test)]
    pub(super) const fn upper(self, steps: u32) -> u32 {
        self.lower(self.extent.wrapping_sub(steps))
    }

    /// The number of the cell below an upper plane this many steps above the node's lower one.
    #[inline(always)]
    #[must_use]
    pub const fn upper_cell(self, steps: u32) -> u32 {
        less(steps, 1) >> self.shift()
    }
}

/// The difference, or 0 where there is less.
#[inline(always)]
const fn less(x: u32, by: u32) -> u32 {
    x - if x < by { x } else { by }
}

/// Steps above the node's lower plane of a lower plane with this number.
#[inline(always)]
#[must_use]
pub const fn lower_steps(number: u32, shift: u32) -> u32 {
    number << shift
}

/// The same of an upper plane whose number counts from the upper side.
#[inline(always)]
#[must_use]
pub const fn upper_steps(number: u32, shift: u32, extent: u32) -> u32 {
    extent.wrapping_sub(number << shift)
}

/// Where a cell ends: at the last one up to a cell beyond the node.
#[inline(always)]
#[must_use]
pub const fn end_of_cell(number: u32, shift: u32) -> u32 {
    number.wrapping_add(1) << shift
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Extents around all powers of two.
    fn extent() -> impl Strategy<Value = u32> {
        let near = (0..=24u32, -3..=3i32)
            .prop_map(|(bits, off)| (1i64 << bits).saturating_add(off.into()).max(0) as u32);
        prop_oneof![near, 0..(1u32 << 25)]
    }

    /// The laws of both planes of one child. Returns by how many steps it grew.
    fn check(frame: Frame, lower: u32, upper: u32) -> u32 {
        let (a, b, shift) = (frame.lower(lower), frame.upper(upper), frame.shift());
        assert!(a < 256 && b < 256, "{frame:?}: {a} {b}");
        let (below, above) = (lower_steps(a, shift), upper_steps(b, shift, frame.extent));
        assert!(
            below <= lower && upper <= above,
            "{frame:?} {lower} {upper}: {below} {above}"
        );
        assert!(
            above <= frame.extent && below <= frame.extent,
            "{frame:?}: {below} {above}"
        );
        // Without the extent nothing is lost either.
        let cell = frame.upper_cell(upper);
        let (end, size) = (end_of_cell(cell, shift), 1 << shift);
        assert!(
            cell < 256 && upper <= end && end < upper.max(1) + size,
            "{frame:?}: {upper} {end}"
        );
        (lower - below) + (above - upper)
    }

    #[test]
    fn every_pair_of_planes_of_small_extents() {
        for extent in 0..=600 {
            for lower in 0..=extent {
                for upper in lower..=extent {
                    check(Frame { extent }, lower, upper);
                }
            }
        }
    }

    #[test]
    fn planes_of_small_extents_are_exact_but_for_those_of_flat_children() {
        for extent in 1..=256 {
            for lower in 0..extent {
                for upper in lower + 1..=extent {
                    assert_eq!(check(Frame { extent }, lower, upper), 0);
                }
            }
        }
        assert_eq!(check(Frame { extent: 0 }, 0, 0), 0);
        // The negative control: one step more makes cells of two.
        assert_eq!(check(Frame { extent: 257 }, 1, 256), 2);
    }

    proptest! {
        #[test]
        fn no_child_loses_anything_or_leaves_its_node(extent in extent(), a: u32, b: u32) {
            let frame = Frame { extent };
            let at = |x: u32| ((u64::from(x) * (u64::from(extent) + 1)) >> 32) as u32;
            let (lower, upper) = (at(a.min(b)), at(a.max(b)));
            let cell = 1u32 << frame.shift();
            prop_assert!(check(frame, lower, upper) <= 2 * cell);
            check(frame, 0, extent);
            prop_assert_eq!(frame.upper(extent), 0);
            prop_assert!(u64::from(cell) * 256 >= u64::from(extent));
            prop_assert!(frame.shift() == 0 || cell * 128 < extent, "cells are as small as 256 allow");
        }
    }
}
