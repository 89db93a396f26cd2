//! Points that are spread out evenly over a pixel's samples: on a light, on a lens. Integers only, so that they have the
//! same bits on every device.
//!
//! A Sobol sequence, whose order and digits are scrambled by a hash of the pixel and of what the point is for (Burley 2020,
//! "Practical Hash-based Owen Scrambling"). Where a pixel has `2^k` samples, each interval of `2^-k` of the square's area
//! whose sides are powers of two has one of its points.

use crate::geometry::float::multiply_high;

/// Which of a picture's samples, and how far along its path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Draw {
    /// Number of the sample in the picture, a pixel's samples one after the other.
    pub sample: u32,
    /// Samples a pixel.
    pub sample_count: u32,
    /// How many mirrors the path has met.
    pub bounce: u32,
}

/// What points on the lens are drawn for. Those on the light of index `i` are for `i + 1`.
pub const LENS: u32 = 0;

impl Draw {
    /// The sample's point for this purpose: fractions of 2^32.
    #[inline]
    #[must_use]
    pub fn square(&self, purpose: u32) -> [u32; 2] {
        let count = self.sample_count.max(1);
        let (pixel, sample) = (self.sample / count, self.sample % count);
        let path = hash(pixel).wrapping_add(self.bounce);
        let seed = hash(hash(path).wrapping_add(purpose));
        let index = scrambled(sample, seed);
        [
            scrambled(index.reverse_bits(), hash(seed ^ 1)),
            scrambled(sobol(index), hash(seed ^ 2)),
        ]
    }
}

/// Coordinates from −1 to 1, neither included, of a point of the square.
#[inline]
#[must_use]
pub fn square_point(square: [u32; 2]) -> [f32; 2] {
    // Odd numbers of 23 bits, and a sign.
    let coordinate =
        |x: u32| ((2 * (x >> 9) + 1) as i32 - (1 << 23)) as f32 * (1.0 / (1u32 << 23) as f32);
    [coordinate(square[0]), coordinate(square[1])]
}

/// A point inside the unit disc, equal areas to equal areas: `(a cos φ, a sin φ)` with `φ = π/4 · b/a`, for the longer
/// coordinate a and the shorter b (Shirley and Chiu 1997, "A low distortion map between disk and square").
#[inline]
#[must_use]
pub fn disc_point(square: [u32; 2]) -> [f32; 2] {
    // Odd numbers of 16 bits, and a sign: never zero.
    let coordinate = |x: u32| (2 * (x >> 16) + 1) as i32 - (1 << 16);
    let (x, y) = (coordinate(square[0]), coordinate(square[1]));
    let (across, along) = (x.unsigned_abs(), y.unsigned_abs());
    let is_across = across > along;
    let (long, short) = if is_across {
        (across, along)
    } else {
        (along, across)
    };
    let [cos, sin] = eighth((short << 16) / long.max(1));
    let (long, short) = (product(long << 15, cos), product(long << 15, sin));
    let (across, along) = if is_across {
        (long, short)
    } else {
        (short, long)
    };
    // 24 bits, exact.
    let signed = |magnitude: u32, sign: i32| {
        let magnitude = (magnitude >> 7) as f32 * (1.0 / (1u32 << 24) as f32);
        if sign < 0 { -magnitude } else { magnitude }
    };
    [signed(across, x), signed(along, y)]
}

/// Cosine and sine of `π/4 · q`, as fractions of 2^31, for q from 0 to 1 as a fraction of 2^16: Taylor's series, whose
/// first terms left out are at most 3e-8 and 4e-7.
#[inline]
fn eighth(q: u32) -> [u32; 2] {
    // Powers of π/4 by factorials, as fractions of 2^31.
    const COS: [u32; 4] = [662_337_939, 34_046_945, 700_062, 7_711];
    const SIN: [u32; 4] = [1_686_629_713, 173_399_667, 5_348_082, 78_547];
    let q = q << 15;
    let square = product(q, q);
    // Each difference is above 0, as each term is far smaller than the one before.
    let cos = COS[2] - product(square, COS[3]);
    let cos = COS[1] - product(square, cos);
    let cos = COS[0] - product(square, cos);
    let sin = SIN[2] - product(square, SIN[3]);
    let sin = SIN[1] - product(square, sin);
    let sin = SIN[0] - product(square, sin);
    [(1 << 31) - product(square, cos), product(q, sin)]
}

/// The product of two fractions of 2^31, both from 0 to 1, rounded down.
#[inline(always)]
fn product(a: u32, b: u32) -> u32 {
    multiply_high(a, b) << 1
}

/// The second dimension of Sobol's sequence; the first is the index with its bits reversed.
#[inline]
fn sobol(index: u32) -> u32 {
    let (mut direction, mut point) = (1u32 << 31, 0);
    for bit in 0..32u32 {
        if (index >> bit) & 1 == 1 {
            point ^= direction;
        }
        direction ^= direction >> 1;
    }
    point
}

/// Owen's scrambling: each bit is flipped or not, by a hash of the seed and of all higher bits.
#[inline]
fn scrambled(x: u32, seed: u32) -> u32 {
    // Laine and Karras: in reversed bits, what is multiplied by an even number and mixed in comes from lower ones only.
    let mut x = x.reverse_bits().wrapping_add(seed);
    x ^= x.wrapping_mul(0x6c50_b47c);
    x ^= x.wrapping_mul(0xb82f_1e52);
    x ^= x.wrapping_mul(0xc7af_e638);
    x ^= x.wrapping_mul(0x8d22_f6e6);
    x.reverse_bits()
}

/// A number for a number, one to one and without a pattern (Wellons 2018, "Prospecting for Hash Functions").
#[inline]
fn hash(x: u32) -> u32 {
    let x = (x ^ (x >> 16)).wrapping_mul(0x21f0_aaad);
    let x = (x ^ (x >> 15)).wrapping_mul(0xd35a_2d97);
    x ^ (x >> 15)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;
    use std::vec::Vec;

    /// Whether of `2^k` points each has an interval of that area of its own, whatever the intervals' shape.
    fn is_net(points: &[[u32; 2]], k: u32) -> bool {
        (0..=k).all(|x_bits| {
            let top = |x: u32, bits: u32| u64::from(x) >> (32 - bits);
            let cells: BTreeSet<_> = points
                .iter()
                .map(|&[x, y]| (top(x, x_bits), top(y, k - x_bits)))
                .collect();
            cells.len() == points.len()
        })
    }

    fn of_pixel(pixel: u32, sample_count: u32, bounce: u32, purpose: u32) -> Vec<[u32; 2]> {
        let draw = |i| Draw {
            sample: pixel * sample_count + i,
            sample_count,
            bounce,
        };
        (0..sample_count).map(|i| draw(i).square(purpose)).collect()
    }

    proptest! {
        #[test]
        fn a_pixels_points_are_a_net(pixel in 0u32..1 << 22, k in 0u32..10, bounce in 0u32..4, purpose in 0u32..9) {
            let points = of_pixel(pixel, 1 << k, bounce, purpose);
            prop_assert!(is_net(&points, k));
            // The negative control: points at random are none.
            if k >= 4 {
                let random = |i: u32| [hash(pixel ^ i), hash(hash(i).wrapping_add(pixel))];
                let random: Vec<_> = (0..1 << k).map(random).collect();
                prop_assert!(!is_net(&random, k));
            }
        }

        #[test]
        fn disc_points_are_those_of_the_map(x: u32, y: u32) {
            let [a, b] = [x, y].map(|x| (f64::from(2 * (x >> 16) + 1) - 65536.0) / 65536.0);
            let quarter = core::f64::consts::FRAC_PI_4;
            let expected = if a.abs() > b.abs() {
                let (sin, cos) = (quarter * b / a).sin_cos();
                [a * cos, a * sin]
            } else {
                let (sin, cos) = (quarter * a / b).sin_cos();
                [b * sin, b * cos]
            };
            let found = disc_point([x, y]).map(f64::from);
            for axis in 0..2 {
                prop_assert!((found[axis] - expected[axis]).abs() < 2e-5, "{found:?} {expected:?}");
            }
        }
    }

    /// On the rim, in all directions.
    #[test]
    fn no_point_leaves_the_disc() {
        for i in 0..1u32 << 16 {
            for corner in [[u32::MAX, i << 16], [i << 16, 0], [0, i << 16]] {
                let [x, y] = disc_point(corner).map(f64::from);
                let radius = (x * x + y * y).sqrt();
                assert!(radius < 1.0 && radius > 0.9999, "{corner:?}: {radius}");
            }
        }
        for [x, y] in [[0, u32::MAX], [u32::MAX, 0]] {
            let [x, y] = square_point([x, y]);
            assert!(x.abs() < 1.0 && y.abs() < 1.0);
        }
    }

    /// Moments of the uniform disc: the mean is 0, that of x² and of y² 1/4, that of x⁴ 1/8, and that of x²y² 1/24.
    #[test]
    fn equal_areas_go_to_equal_areas() {
        let points = of_pixel(7, 1 << 14, 0, LENS);
        let mean = |of: &dyn Fn(f64, f64) -> f64| {
            let values = points.iter().map(|&point| {
                let [x, y] = disc_point(point).map(f64::from);
                of(x, y)
            });
            values.sum::<f64>() / points.len() as f64
        };
        for (found, expected) in [
            (mean(&|x, _| x), 0.0),
            (mean(&|_, y| y), 0.0),
            (mean(&|x, _| x * x), 0.25),
            (mean(&|_, y| y * y), 0.25),
            (mean(&|x, y| x * y), 0.0),
            (mean(&|x, _| x * x * x * x), 0.125),
            (mean(&|x, y| x * x * y * y), 1.0 / 24.0),
        ] {
            assert!((found - expected).abs() < 2e-4, "{found} {expected}");
        }
    }

    /// Pixels, bounces and purposes do not share points.
    #[test]
    fn every_purpose_has_points_of_its_own() {
        let first = of_pixel(3, 16, 0, 1);
        for other in [
            of_pixel(4, 16, 0, 1),
            of_pixel(3, 16, 1, 1),
            of_pixel(3, 16, 0, 2),
            of_pixel(3, 16, 0, LENS),
        ] {
            assert!(other.iter().all(|point| !first.contains(point)));
        }
        // With x at random against the other's x: no line through both.
        let (a, b) = (of_pixel(3, 1024, 0, 1), of_pixel(3, 1024, 0, 2));
        let centered = |x: u32| f64::from(x) / 4_294_967_296.0 - 0.5;
        let pairs = a.iter().zip(&b);
        let sum: f64 = pairs.map(|(a, b)| centered(a[0]) * centered(b[0])).sum();
        assert!((sum / 1024.0 * 12.0).abs() < 0.1, "{sum}");
    }
}
