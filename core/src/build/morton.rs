//! Stage `morton`: the place of a triangle's box centre on a space-filling curve.
//!
//! Coordinates become integers by operations that are never rounded, and codes by integer arithmetic alone, so that every device
//! finds the same ones.

use crate::build::bounds::axis_magnitude;
use crate::geometry::aabb::Aabb;
use crate::geometry::float::{exponent, multiply_high};
use crate::geometry::lattice::lattice_steps;
use bytemuck::{Pod, Zeroable};

/// How box centres map to cells: cubes, `2^bits` of them along the longest side of the scene's box. 40 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct MortonGrid {
    /// Bytes 0–35: for x, y and z.
    pub axes: [GridAxis; 3],
    /// Bytes 36–39: `(2^63 - 1) / length` of the longest side, normalized: distances along it map to 31 bits.
    pub factor: u32,
}

/// One axis of a [`MortonGrid`]. 12 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct GridAxis {
    /// Exponent of the lattice step that centres are measured in.
    pub step_exponent: i32,
    /// Twice the box's min, in steps: where cell 0 begins.
    pub origin: i32,
    /// Low half: left shift that normalizes a distance from the origin to 32 bits. High half: right shift from 31
    /// bits to cells, on the scale of the longest side.
    pub shifts: u32,
}

impl MortonGrid {
    /// The grid of a scene's bounds for cells of 10 bits an axis (30-bit codes) or 21 (63-bit codes).
    #[must_use]
    pub fn new(bounds: &Aabb, bits: u32) -> Self {
        if bounds.is_empty() {
            return Self::default();
        }
        let measures = [
            AxisMeasure::new(bounds, 0),
            AxisMeasure::new(bounds, 1),
            AxisMeasure::new(bounds, 2),
        ];
        let longest = measures[0].longer(measures[1]).longer(measures[2]);
        Self {
            axes: [
                measures[0].relative_to(&longest, bits),
                measures[1].relative_to(&longest, bits),
                measures[2].relative_to(&longest, bits),
            ],
            // Rounded down, so that the far end of the longest side falls into the last cell.
            factor: divide_63_ones(longest.normalized),
        }
    }

    /// The cell of a box's centre, each coordinate below `2^bits`. The box must lie inside the grid's bounds.
    #[inline(always)]
    #[must_use]
    pub fn cell(&self, bounds: &Aabb) -> [u32; 3] {
        [
            self.cell_on_axis(0, bounds.min.x, bounds.max.x),
            self.cell_on_axis(1, bounds.min.y, bounds.max.y),
            self.cell_on_axis(2, bounds.min.z, bounds.max.z),
        ]
    }

    #[inline(always)]
    fn cell_on_axis(&self, axis: usize, low: f32, high: f32) -> u32 {
        let grid = self.axes[axis];
        // Twice the centre needs no division.
        let steps = |x: f32| lattice_steps(x, grid.step_exponent);
        let centre = steps(low) + steps(high);
        let distance = centre.wrapping_sub(grid.origin) as u32;
        let normalized = distance << (grid.shifts & 31);
        multiply_high(normalized, self.factor) >> ((grid.shifts >> 16) & 31)
    }
}

/// One side of the scene's box: its length is `normalized · 2^weight`.
#[derive(Clone, Copy)]
struct AxisMeasure {
    step_exponent: i32,
    origin: i32,
    normalized: u32,
    left_shift: u32,
    weight: i32,
}

impl AxisMeasure {
    fn new(bounds: &Aabb, axis: usize) -> Self {
        let (low, high) = match axis {
            0 => (bounds.min.x, bounds.max.x),
            1 => (bounds.min.y, bounds.max.y),
            _ => (bounds.min.z, bounds.max.z),
        };
        // Coordinates have at most 24 bits in these steps, twice their range at most 26. Scenes below 2^-103 have fewer: what a
        // device may flush to zero is less than a step.
        let finest = exponent(f32::from_bits(axis_magnitude(bounds, axis))) + 1 - 24;
        let step_exponent = if finest < -126 { -126 } else { finest };
        let origin = 2 * lattice_steps(low, step_exponent);
        let extent = (2 * lattice_steps(high, step_exponent)).wrapping_sub(origin) as u32;
        let left_shift = if extent == 0 {
            0
        } else {
            extent.leading_zeros()
        };
        Self {
            step_exponent,
            origin,
            normalized: extent << left_shift,
            left_shift,
            weight: step_exponent - left_shift as i32,
        }
    }

    /// The longer of two, the first of equals.
    fn longer(self, other: Self) -> Self {
        let other_is_longer = other.normalized > 0
            && (self.normalized == 0
                || other.weight > self.weight
                || (other.weight == self.weight && other.normalized > self.normalized));
        if other_is_longer { other } else { self }
    }

    fn relative_to(&self, longest: &Self, bits: u32) -> GridAxis {
        let difference = longest.weight - self.weight + 31 - bits as i32;
        // A side that is shorter than one cell has only cell 0; so has one without length.
        let right_shift = if self.normalized == 0 || difference > 31 {
            31
        } else {
            difference as u32
        };
        GridAxis {
            step_exponent: self.step_exponent,
            origin: self.origin,
            shifts: self.left_shift | (right_shift << 16),
        }
    }
}

/// `(2^63 - 1) / divisor` rounded down, for a divisor of at least `2^31`; 0 for a divisor of 0. By long division, as
/// GPUs need no 64-bit integers for it.
fn divide_63_ones(divisor: u32) -> u32 {
    if divisor == 0 {
        return 0;
    }
    let mut quotient = 0;
    let mut remainder = 0u32;
    for _ in 0..63u32 {
        let carry = remainder >> 31;
        remainder = (remainder << 1) | 1;
        quotient <<= 1;
        if carry == 1 || remainder >= divisor {
            remainder = remainder.wrapping_sub(divisor);
            quotient |= 1;
        }
    }
    quotient
}

/// One thread per triangle. Reads its box and the grid. Returns its 30-bit code: the cell's bits, x first.
#[inline(always)]
#[must_use]
pub fn morton_code_30(bounds: &Aabb, grid: &MortonGrid) -> u32 {
    let [x, y, z] = grid.cell(bounds);
    interleave_10(x, y, z)
}

/// One thread per triangle. Reads its box and the grid. Returns its 63-bit code as `[high 31 bits, low 32 bits]`.
#[inline(always)]
#[must_use]
pub fn morton_code_63(bounds: &Aabb, grid: &MortonGrid) -> [u32; 2] {
    let [x, y, z] = grid.cell(bounds);
    interleave_21(x, y, z)
}

/// Interleaves the low 10 bits of three numbers: `x9 y9 z9 … x0 y0 z0`.
#[inline(always)]
#[must_use]
pub const fn interleave_10(x: u32, y: u32, z: u32) -> u32 {
    (spread(x) << 2) | (spread(y) << 1) | spread(z)
}

/// Interleaves the low 21 bits of three numbers: `[x20 y20 … z11 x10, y10 z10 x9 … z0]`.
#[inline(always)]
#[must_use]
pub const fn interleave_21(x: u32, y: u32, z: u32) -> [u32; 2] {
    let top = interleave_10(x >> 11, y >> 11, z >> 11);
    let bottom = interleave_10(x, y, z);
    let (x10, y10, z10) = ((x >> 10) & 1, (y >> 10) & 1, (z >> 10) & 1);
    [(top << 1) | x10, (y10 << 31) | (z10 << 30) | bottom]
}

/// Puts two zero bits before each of the low 10 bits.
///
/// ```text
/// 000000000000000000000098 76543210
/// 00000098000000000000000076543210   · 0x0001_0001 would overlap; shift by 16
/// 00000098 00000000 76540000 00003210   … by 8, 4 and 2
/// 000090080070060050040030020010 0
/// ```
#[inline(always)]
const fn spread(x: u32) -> u32 {
    let x = x & 0x0000_03ff;
    let x = (x | (x << 16)) & 0x0300_00ff;
    let x = (x | (x << 8)) & 0x0300_f00f;
    let x = (x | (x << 4)) & 0x030c_30c3;
    (x | (x << 2)) & 0x0924_9249
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;

    fn point(p: [f32; 3]) -> Aabb {
        Aabb {
            min: Vec3::from_array(p),
            max: Vec3::from_array(p),
        }
    }

    fn slow_interleave(x: u32, y: u32, z: u32, bits: u32) -> u64 {
        (0..bits).rev().fold(0, |code, bit| {
            [x, y, z]
                .iter()
                .fold(code, |code, c| (code << 1) | u64::from((c >> bit) & 1))
        })
    }

    #[test]
    fn the_top_of_the_grid_stays_in_the_last_cell() {
        let bounds = point([-3.0, 1.0, 5.0]).union(point([6.0, 2.0, 7.0]));
        assert_eq!(
            MortonGrid::new(&bounds, 10).cell(&point([6.0, 2.0, 7.0])),
            [1023, 113, 227]
        );
        assert_eq!(
            MortonGrid::new(&bounds, 21).cell(&point([6.0, 1.0, 7.0]))[0],
            (1 << 21) - 1
        );
        assert_eq!(
            MortonGrid::new(&bounds, 10).cell(&point([-3.0, 1.0, 5.0])),
            [0, 0, 0]
        );
    }

    #[test]
    fn flat_and_point_like_grids_have_cells() {
        let flat = point([1.0, 2.0, 3.0]).union(point([5.0, 2.0, 4.0]));
        assert_eq!(
            MortonGrid::new(&flat, 10).cell(&point([5.0, 2.0, 4.0])),
            [1023, 0, 255]
        );
        let single = point([1.0, 2.0, 3.0]);
        assert_eq!(MortonGrid::new(&single, 21).cell(&single), [0, 0, 0]);
        let origin = point([0.0; 3]);
        assert_eq!(MortonGrid::new(&origin, 10).cell(&origin), [0, 0, 0]);
        assert_eq!(MortonGrid::new(&Aabb::EMPTY, 10), MortonGrid::default());
    }

    #[test]
    fn the_smallest_scenes_have_cells() {
        let tiny = |x: f32| f32::MIN_POSITIVE * x;
        let bounds = point([0.0; 3]).union(point([tiny(64.0), tiny(32.0), tiny(0.5)]));
        let grid = MortonGrid::new(&bounds, 10);
        let top = [tiny(64.0), tiny(32.0), tiny(0.5)];
        assert_eq!(grid.cell(&point(top)), [1023, 511, 0]);
        assert_eq!(
            grid.cell(&point([tiny(16.0), tiny(8.0), 0.0])),
            [255, 127, 0]
        );
        // Not a step.
        let denormal = point([0.0; 3]).union(point([tiny(0.5), tiny(0.25), 0.0]));
        let grid = MortonGrid::new(&denormal, 10);
        assert_eq!(grid.cell(&point([tiny(0.5), 0.0, 0.0])), [0, 0, 0]);
    }

    #[test]
    fn a_far_and_thin_grid_keeps_the_precision_of_each_axis() {
        // x has few bits left at this distance, y and z all of theirs.
        let bounds = point([1e6, 0.0, 0.0]).union(point([1_000_001.0, 1.0, 1.0]));
        let grid = MortonGrid::new(&bounds, 10);
        assert_eq!(
            grid.cell(&point([1_000_000.5, 0.25, 0.999])),
            [511, 255, 1022]
        );
    }

    proptest! {
        #[test]
        fn interleaving_is_the_bit_by_bit_one(x in 0u32..1 << 21, y in 0u32..1 << 21, z in 0u32..1 << 21) {
            prop_assert_eq!(u64::from(interleave_10(x & 1023, y & 1023, z & 1023)), slow_interleave(x & 1023, y & 1023, z & 1023, 10));
            let [high, low] = interleave_21(x, y, z);
            prop_assert_eq!((u64::from(high) << 32) | u64::from(low), slow_interleave(x, y, z, 21));
        }

        #[test]
        fn division_is_the_wide_one(divisor in 1u32 << 31..=u32::MAX) {
            prop_assert_eq!(u64::from(divide_63_ones(divisor)), ((1u64 << 63) - 1) / u64::from(divisor));
        }

        #[test]
        fn cells_are_in_range_monotone_and_near_the_exact_ones(
            a in proptest::array::uniform3(-100.0f32..100.0),
            b in proptest::array::uniform3(-100.0f32..100.0),
            s in proptest::array::uniform3(0.0f32..=1.0),
            bits in prop_oneof![Just(10u32), Just(21)],
        ) {
            let bounds = point(a).union(point(b));
            let grid = MortonGrid::new(&bounds, bits);
            let size = bounds.max - bounds.min;
            let p = (bounds.min + size * Vec3::from_array(s)).min(bounds.max);
            let cell = grid.cell(&point(p.to_array()));
            let top = grid.cell(&point(bounds.max.to_array()));
            let longest = f64::from(size.max_element());
            for axis in 0..3 {
                prop_assert!(cell[axis] < 1 << bits);
                prop_assert!(cell[axis] <= top[axis]);
                let exact = f64::from(p[axis] - bounds.min[axis]) / longest * f64::from(1u32 << bits);
                // The lattice resolves 24 bits of the largest magnitude on the axis.
                let blur = 100.0 / longest * f64::from(1u32 << bits) * 2f64.powi(-21) + 1.0;
                prop_assert!((f64::from(cell[axis]) - exact).abs() <= blur, "{} {} {}", cell[axis], exact, blur);
            }
        }
    }
}
