//! One axis of a wide node's frame, with the planes of its children.

use super::frame::{Frame, end_of_cell, lower_steps, upper_steps};
use super::rounded_children::RoundedChildren;
use crate::build::wide::WIDTH;
use crate::geometry::float::power_of_two;
use crate::geometry::lattice::{LatticeBox, lattice_steps};
use bytemuck::{Pod, Zeroable};

/// Bits of the shift in [`WideAxis::scale`]. What is above them depends on the node.
pub const SHIFT_BITS: u32 = 5;

/// The planes of a child that is not there: its lower byte, then its upper one. No ray meets an inverted box.
#[inline(always)]
const fn absent(counts_cells: bool) -> [u32; 2] {
    [0xff, if counts_cells { 0 } else { 0xff }]
}

/// An axis of a node of up to four children. 16 bytes.
///
/// ```text
/// origin   the node's smallest coordinate, in the scene's magnitude: exact, as coordinates on the lattice have 24 bits
/// lower    a byte a child, the first child's lowest: its lower plane, by Frame::lower; 255 where there is no child
/// upper    a byte a child: its upper plane, by Frame::upper, in nodes of 48 bytes by Frame::upper_cell; 255, or there 0, where
///          there is no child
/// scale    bits 0–4   cells have two to this power of steps, by Frame::shift
///          bits 5–31  in nodes of 64 bytes the node's extent in steps, in nodes of 48 bytes links
/// ```
///
/// An extent of more than 2^24 steps, of which no scene has more than 2^25, is rounded up to an even number: floats hold it exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct WideAxis {
    /// Bytes 0–3.
    pub origin: f32,
    /// Bytes 4–7.
    pub lower: u32,
    /// Bytes 8–11.
    pub upper: u32,
    /// Bytes 12–15.
    pub scale: u32,
}

const _: () = assert!(size_of::<WideAxis>() == 16);

impl WideAxis {
    /// One axis of the children's planes: the smallest coordinates of the first `count`, and their largest. In steps, at most
    /// `2^24` from zero. The scale holds the extent, as in a node of 64 bytes; `COUNTS_CELLS` has the planes of one of 48 bytes.
    #[inline(always)]
    fn new<const COUNTS_CELLS: bool>(
        low: [i32; WIDTH],
        high: [i32; WIDTH],
        count: u32,
        step_exponent: i32,
    ) -> Self {
        let [a, b, c, d] = low;
        let least = |i: u32, x: i32| if i < count { x } else { i32::MAX };
        let origin = least(0, a)
            .min(least(1, b))
            .min(least(2, c).min(least(3, d)));
        let [a, b, c, d] = high;
        let most = |i: u32, x: i32| if i < count { x } else { i32::MIN };
        let end = most(0, a).max(most(1, b)).max(most(2, c).max(most(3, d)));
        let (origin, end) = if count == 0 { (0, 0) } else { (origin, end) };
        let frame = Frame {
            extent: float_extent(end.wrapping_sub(origin) as u32),
        };
        let [lower_absent, upper_absent] = absent(COUNTS_CELLS);
        let lower = |i: usize| {
            let number = if (i as u32) < count {
                frame.lower(low[i].wrapping_sub(origin) as u32)
            } else {
                lower_absent
            };
            number << (8 * i)
        };
        let upper = |i: usize| {
            let number = if i as u32 >= count {
                upper_absent
            } else if COUNTS_CELLS {
                frame.upper_cell(high[i].wrapping_sub(origin) as u32)
            } else {
                // From the exact upper side, also where the extent is rounded.
                frame.lower(end.wrapping_sub(high[i]) as u32)
            };
            number << (8 * i)
        };
        let lower = lower(0) | lower(1) | lower(2) | lower(3);
        let upper = upper(0) | upper(1) | upper(2) | upper(3);
        Self {
            origin: origin as f32 * power_of_two(step_exponent),
            lower,
            upper,
            scale: frame.shift() | frame.extent << SHIFT_BITS,
        }
    }

    /// Cells have two to this power of steps.
    #[inline(always)]
    #[must_use]
    pub const fn shift(&self) -> u32 {
        self.scale & ((1 << SHIFT_BITS) - 1)
    }

    /// Steps from the origin to the node's largest coordinate, in a node of 64 bytes.
    #[inline(always)]
    #[must_use]
    pub const fn extent(&self) -> u32 {
        self.scale >> SHIFT_BITS
    }

    /// The numbers of a child's lower and upper plane.
    #[inline(always)]
    #[must_use]
    pub const fn numbers(&self, child: u32) -> [u32; 2] {
        let at = (8 * child) & 31;
        [(self.lower >> at) & 0xff, (self.upper >> at) & 0xff]
    }

    /// Whether a child's planes are those of a child that is not there, in a node of 48 bytes or of 64.
    #[inline(always)]
    #[must_use]
    pub const fn is_absent(&self, child: u32, counts_cells: bool) -> bool {
        let ([lower, upper], absent) = (self.numbers(child), absent(counts_cells));
        lower == absent[0] && upper == absent[1]
    }

    /// Steps from the origin to a child's lower and upper plane, in a node of 64 bytes: none beyond the node's.
    #[inline(always)]
    #[must_use]
    pub const fn planes(&self, child: u32) -> [u32; 2] {
        let ([lower, upper], shift) = (self.numbers(child), self.shift());
        [
            lower_steps(lower, shift),
            upper_steps(upper, shift, self.extent()),
        ]
    }

    /// The same in a node of 48 bytes, which holds no extent: upper planes may lie up to a cell beyond the node's.
    #[inline(always)]
    #[must_use]
    pub const fn cell_planes(&self, child: u32) -> [u32; 2] {
        let ([lower, upper], shift) = (self.numbers(child), self.shift());
        [lower_steps(lower, shift), end_of_cell(upper, shift)]
    }

    /// The origin, in steps.
    #[inline(always)]
    #[must_use]
    pub const fn origin_steps(&self, step_exponent: i32) -> i32 {
        lattice_steps(self.origin, step_exponent)
    }
}

/// The extent that floats hold: the same up to 2^24, up to 2^25 the next even number.
#[inline(always)]
const fn float_extent(extent: u32) -> u32 {
    extent + (extent >> 24 & extent & 1)
}

/// The axes of a node over these children, as a node of 64 bytes has them, or but for the extents one of 48.
#[inline(always)]
#[must_use]
pub fn wide_axes<const COUNTS_CELLS: bool>(from: &RoundedChildren) -> [WideAxis; 3] {
    let [a, b, c, d] = &from.boxes;
    let axis = |i: usize| {
        WideAxis::new::<COUNTS_CELLS>(
            [a.min[i], b.min[i], c.min[i], d.min[i]],
            [a.max[i], b.max[i], c.max[i], d.max[i]],
            from.count,
            from.step_exponent,
        )
    };
    [axis(0), axis(1), axis(2)]
}

/// A child's box in steps, from its planes on x, y and z in steps from the origins.
#[inline(always)]
pub(super) fn box_above(
    [x, y, z]: &[WideAxis; 3],
    [[a, d], [b, e], [c, f]]: [[u32; 2]; 3],
    step_exponent: i32,
) -> LatticeBox {
    let above = |axis: &WideAxis, steps: u32| {
        let origin = axis.origin_steps(step_exponent);
        origin.wrapping_add(steps as i32)
    };
    LatticeBox {
        min: [above(x, a), above(y, b), above(z, c)],
        max: [above(x, d), above(y, e), above(z, f)],
    }
}
