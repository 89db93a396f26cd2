//! From light to the bytes of a picture.

use crate::geometry::float::{max, min};
use glam::Vec3;

/// 8-bit sRGB (IEC 61966-2-1) of a linear RGB color, each component 0 to 255. Clipped; NaN counts as 0.
#[inline]
#[must_use]
pub fn srgb_bytes(linear: Vec3) -> [u32; 3] {
    let [r, g, b] = linear.to_array();
    let clipped = Vec3::new(clip(r), clip(g), clip(b));
    let [r, g, b] = clipped.to_array();
    // glam's power is that of libm on the CPU, and the device's own on the GPU.
    let [r_power, g_power, b_power] = clipped.powf(1.0 / 2.4).to_array();
    [byte(r, r_power), byte(g, g_power), byte(b, b_power)]
}

/// One word for a texel: four bytes, the first lowest, the last one opaque.
#[inline]
#[must_use]
pub fn pack_texel(bytes: [u32; 3]) -> u32 {
    bytes[0] | (bytes[1] << 8) | (bytes[2] << 16) | (255 << 24)
}

#[inline(always)]
fn clip(x: f32) -> f32 {
    min(max(x, 0.0), 1.0)
}

/// The byte of a component from 0 to 1; `power` is the component to the power of 1/2.4.
#[inline(always)]
fn byte(linear: f32, power: f32) -> u32 {
    let encoded = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * power - 0.055
    };
    (encoded * 255.0 + 0.5) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_of_known_values() {
        assert_eq!(srgb_bytes(Vec3::new(0.0, 1.0, 0.5)), [0, 255, 188]);
        assert_eq!(srgb_bytes(Vec3::new(0.002, 7.0, -1.0)), [7, 255, 0]);
        assert_eq!(
            srgb_bytes(Vec3::new(f32::NAN, f32::INFINITY, 0.0)),
            [0, 255, 0]
        );
    }

    #[test]
    fn bytes_never_fall_as_light_grows() {
        let mut before = 0;
        for i in 0..=4096u32 {
            let [byte, _, _] = srgb_bytes(Vec3::splat(i as f32 / 4096.0));
            assert!(byte >= before && byte <= 255);
            before = byte;
        }
        assert_eq!(before, 255);
    }

    #[test]
    fn texels_are_opaque() {
        assert_eq!(pack_texel([0x12, 0x34, 0x56]), 0xff56_3412);
    }
}
