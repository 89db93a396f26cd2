//! Colors that show what a ray met rather than how it looks. Linear RGB.

use glam::Vec3;

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
    let share = (depth - near) / crate::float::max(far - near, f32::MIN_POSITIVE) * (far / depth);
    let share = crate::float::max(crate::float::min(share, 1.0), 0.0);
    Vec3::splat(0.9 - 0.85 * share)
}

/// Black, blue, red, yellow, white, for counts from 0 to `most`.
#[inline]
#[must_use]
pub fn heat_color(count: u32, most: u32) -> Vec3 {
    let heat = crate::float::min(count as f32 / crate::float::max(most as f32, 1.0), 1.0) * 4.0;
    let ramp = |begin: f32| crate::float::max(crate::float::min(heat - begin, 1.0), 0.0);
    let (blue, red, yellow, white) = (ramp(0.0), ramp(1.0), ramp(2.0), ramp(3.0));
    Vec3::new(red, yellow, 0.6 * blue * (1.0 - red) + white)
}

#[cfg(test)]
mod tests {
    use super::*;

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
