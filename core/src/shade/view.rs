//! Colors that show what a ray met rather than how it looks. Linear RGB.
//!
//! The scales of depths and counts come from all samples, sorted: each has a value, a word that orders like what it stands
//! for, and the sort takes items `[value, sample]`.

use crate::geometry::float::abs;
use crate::geometry::ray::Hit;
use glam::Vec3;

/// The depth of a miss, beyond all others.
const MISS: u32 = f32::MAX.to_bits();

/// A unit normal's components as a color.
#[inline]
#[must_use]
pub fn normal_color(normal: Vec3) -> Vec3 {
    normal * 0.5 + Vec3::splat(0.5)
}

/// A color for each primitive, by a hash (Wellons 2018, lowbias32). The hash of 0, which is black, is left out.
#[inline]
#[must_use]
pub fn primitive_color(primitive: u32) -> Vec3 {
    let x = primitive.wrapping_add(1);
    let x = x ^ (x >> 16);
    let x = x.wrapping_mul(0x7feb_352d);
    let x = x ^ (x >> 15);
    let x = x.wrapping_mul(0x846c_a68b);
    let x = x ^ (x >> 16);
    let channel = |shift: u32| ((x >> shift) & 255) as f32 / 255.0;
    Vec3::new(channel(0), channel(8), channel(16))
}

/// Near is bright, far is dark: `depth` from `near` to `far`, by its reciprocal, so that a wide ground leaves contrast to
/// what stands on it.
#[inline]
#[must_use]
pub fn depth_color(depth: f32, near: f32, far: f32) -> Vec3 {
    let share =
        (depth - near) / crate::geometry::float::max(far - near, f32::MIN_POSITIVE) * (far / depth);
    let share = crate::geometry::float::max(crate::geometry::float::min(share, 1.0), 0.0);
    Vec3::splat(0.9 - 0.85 * share)
}

/// Black, blue, red, yellow, white, for counts from 0 to `most`.
#[inline]
#[must_use]
pub fn heat_color(count: u32, most: u32) -> Vec3 {
    let heat = crate::geometry::float::min(
        count as f32 / crate::geometry::float::max(most as f32, 1.0),
        1.0,
    ) * 4.0;
    let ramp = |begin: f32| {
        crate::geometry::float::max(crate::geometry::float::min(heat - begin, 1.0), 0.0)
    };
    let (blue, red, yellow, white) = (ramp(0.0), ramp(1.0), ramp(2.0), ramp(3.0));
    Vec3::new(red, yellow, 0.6 * blue * (1.0 - red) + white)
}

/// How far along the view a sample hit, as the bits of t: a camera ray advances by one for each unit of t.
#[inline]
#[must_use]
pub fn depth_value(hit: &Hit) -> u32 {
    // Zero may be negative, whose bits would come last.
    abs(hit.t).to_bits()
}

/// The ends of the depth scale, as bits, from items sorted by [`depth_value`]: the nearest hit, and the distance that one
/// hit in a hundred exceeds. Both 0 where nothing was hit.
#[inline]
#[must_use]
pub fn depth_range(sorted: &[[u32; 2]]) -> [u32; 2] {
    let hit_count = first_miss(sorted);
    if hit_count == 0 {
        return [0; 2];
    }
    let far = hit_count - 1 - hit_count / 100;
    [
        crate::load(sorted, 0, [0; 2])[0],
        crate::load(sorted, far, [0; 2])[0],
    ]
}

/// Where the misses begin among items sorted by depth: how many hits there are.
#[inline]
fn first_miss(sorted: &[[u32; 2]]) -> u32 {
    let (mut first, mut length) = (0, sorted.len() as u32);
    for _ in 0..32u32 {
        if length == 0 {
            break;
        }
        let half = length / 2;
        if crate::load(sorted, first + half, [MISS; 2])[0] < MISS {
            first += half + 1;
            length -= half + 1;
        } else {
            length = half;
        }
    }
    first
}

/// The top of the heat scale, from items sorted by count: the count that one sample in a thousand exceeds.
#[inline]
#[must_use]
pub fn heat_range(sorted: &[[u32; 2]]) -> u32 {
    let count = sorted.len() as u32;
    crate::load(sorted, count.wrapping_sub(1 + count / 1000), [0; 2])[0]
}

/// A pixel's color: the mean of its samples' depths `values[first..first + count]`, black for misses, added in order.
#[inline]
#[must_use]
pub fn mean_depth_color(values: &[u32], first: u32, count: u32, [near, far]: [u32; 2]) -> Vec3 {
    let (near, far) = (f32::from_bits(near), f32::from_bits(far));
    let mut sum = Vec3::ZERO;
    for i in first..first + count {
        let value = crate::load(values, i, MISS);
        if value < MISS {
            sum += depth_color(f32::from_bits(value), near, far);
        }
    }
    sum / count as f32
}

/// A pixel's color: the mean of its samples' counts `values[first..first + count]`, added in order.
#[inline]
#[must_use]
pub fn mean_heat_color(values: &[u32], first: u32, count: u32, most: u32) -> Vec3 {
    let mut sum = Vec3::ZERO;
    for i in first..first + count {
        sum += heat_color(crate::load(values, i, 0), most);
    }
    sum / count as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Items in order, of `hits` hits at 1, 2, 3 … and as many misses as asked for.
    fn depths(hits: u32, misses: u32) -> std::vec::Vec<[u32; 2]> {
        let hits = (1..=hits).map(|t| (t as f32).to_bits());
        let misses = (0..misses).map(|_| depth_value(&Hit::MISS));
        hits.chain(misses).zip(0..).map(|(v, i)| [v, i]).collect()
    }

    #[test]
    fn scales_leave_out_the_extreme() {
        let range = |hits, misses| depth_range(&depths(hits, misses)).map(f32::from_bits);
        assert_eq!(range(1, 0), [1.0, 1.0]);
        assert_eq!(range(99, 0), [1.0, 99.0]);
        assert_eq!(range(100, 7), [1.0, 99.0]);
        assert_eq!(range(250, 1000), [1.0, 248.0]);
        assert_eq!((range(0, 5), range(0, 0)), ([0.0; 2], [0.0; 2]));
        for hits in 0..40 {
            assert_eq!(first_miss(&depths(hits, 40 - hits)), hits);
        }
        let counts =
            |count: u32| heat_range(&(1..=count).map(|c| [c, 0]).collect::<std::vec::Vec<_>>());
        assert_eq!([counts(0), counts(1), counts(999)], [0, 1, 999]);
        assert_eq!([counts(1000), counts(2500)], [999, 2498]);
    }

    #[test]
    fn pixels_are_means_of_their_samples() {
        let values = [9.0f32, 2.0, 6.0, 3.0, f32::MAX].map(f32::to_bits);
        let range = [2.0f32, 6.0].map(f32::to_bits);
        let color = |t| depth_color(t, 2.0, 6.0);
        let mean = (color(2.0) + color(6.0) + color(3.0)) / 3.0;
        assert_eq!(mean_depth_color(&values, 1, 3, range), mean);
        assert_eq!(mean_depth_color(&values, 3, 2, range), color(3.0) / 2.0);
        let mean = (heat_color(4, 10) + heat_color(7, 10)) / 2.0;
        assert_eq!(mean_heat_color(&[99, 4, 7], 1, 2, 10), mean);
    }

    #[test]
    fn ends_of_the_scales() {
        assert_eq!(heat_color(0, 10), Vec3::ZERO);
        assert_eq!(heat_color(10, 10), Vec3::ONE);
        assert_eq!(heat_color(10, 0), Vec3::ONE);
        assert!((depth_color(2.0, 2.0, 3.0).x - 0.9).abs() < 1e-6);
        assert!((depth_color(9.0, 2.0, 3.0).x - 0.05).abs() < 1e-6);
        assert!((depth_color(3.0, 2.0, 6.0).x - (0.9 - 0.85 * 0.5)).abs() < 1e-6);
        assert_eq!(
            normal_color(Vec3::new(0.0, -1.0, 1.0)),
            Vec3::new(0.5, 0.0, 1.0)
        );
        assert_ne!(primitive_color(0), primitive_color(1));
    }
}
