//! Light sources, and the points on those that have an extent.

use crate::geometry::float::{PowerOfTwo, max, min};
use crate::shade::sampling::{Draw, disc_point, square_point};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// A light's [`Light::shape`]: a point, or infinitely far away.
pub const NO_EXTENT: u32 = 0;

/// A light's [`Light::shape`]: the ellipse of all `s · edge_1 + t · edge_2` around its middle with `s² + t² < 1`.
pub const DISC: u32 = 1;

/// A light's [`Light::shape`]: the parallelogram of all `s · edge_1 + t · edge_2` around its middle with s and t from −1 to 1.
pub const RECTANGLE: u32 = 2;

/// A light source. One with extent shines to the side of its normal only, with Lambert's cosine, from a point for each
/// sample ([`Self::sampled`]); no ray sees it, and none is stopped by it. 80 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Light {
    /// Bytes 0–11: a position, the middle of a light with extent, or the direction to a light infinitely far away.
    pub point: [f32; 3],
    /// Bytes 12–15: 1 for a position, 0 for a direction.
    pub is_position: u32,
    /// Bytes 16–27: linear RGB irradiance, at distance 1 from a point, or straight ahead of a light with extent as if all
    /// of it were in one point.
    pub color: [f32; 3],
    /// Bytes 28–31: no point of a light at a position shines farther; `f32::MAX` for no limit.
    pub range: f32,
    /// Bytes 32–43: from the middle to the rim, where there is an extent.
    pub edge_1: [f32; 3],
    /// Bytes 44–47: [`NO_EXTENT`], [`DISC`] or [`RECTANGLE`].
    pub shape: u32,
    /// Bytes 48–59: from the middle to the rim, in another direction.
    pub edge_2: [f32; 3],
    /// Bytes 60–63: which of the scene's lights it is; each has sample points of its own.
    pub number: u32,
    /// Bytes 64–75: unit vector along `edge_1 × edge_2`.
    pub normal: [f32; 3],
    /// Bytes 76–79: unused.
    pub padding: u32,
}

const _: () = assert!(size_of::<Light>() == 80);

impl Light {
    /// The same light in a scene whose coordinates are multiplied by a power of two.
    #[inline]
    #[must_use]
    pub fn scaled(&self, scale: &PowerOfTwo) -> Self {
        let mut light = *self;
        if self.is_position == 1 {
            light.point = scale.times_each(self.point);
            light.edge_1 = scale.times_each(self.edge_1);
            light.edge_2 = scale.times_each(self.edge_2);
            // Irradiance falls off with the squared distance, which is scaled twice.
            for channel in 0..3 {
                let twice = scale.times(scale.times(self.color[channel]));
                light.color[channel] = min(twice, f32::MAX);
            }
            if self.range < f32::MAX {
                light.range = min(scale.times(self.range), f32::MAX);
            }
        }
        light
    }

    /// The light as a sample sees it: at one point of its extent. Over a pixel's samples these points are spread out.
    #[inline]
    #[must_use]
    pub fn sampled(&self, draw: &Draw) -> Self {
        let mut light = *self;
        if self.shape != NO_EXTENT {
            let square = draw.square(self.number.wrapping_add(1));
            let [s, t] = if self.shape == DISC {
                disc_point(square)
            } else {
                square_point(square)
            };
            let (edge_1, edge_2) = (Vec3::from_array(self.edge_1), Vec3::from_array(self.edge_2));
            let point = Vec3::from_array(self.point) + (edge_1 * s + edge_2 * t);
            light.point = point.to_array();
        }
        light
    }

    /// The share of its light that leaves in a direction, of any length.
    #[inline]
    pub(crate) fn share(&self, direction: Vec3) -> f32 {
        if self.shape == NO_EXTENT {
            return 1.0;
        }
        max(
            Vec3::from_array(self.normal).dot(direction) / direction.length(),
            0.0,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 × 6, and it shines down.
    const PANEL: Light = Light {
        point: [0.5, 2.0, 0.25],
        is_position: 1,
        color: [4.0, 2.0, 1.0],
        range: f32::MAX,
        edge_1: [1.0, 0.0, 0.0],
        shape: RECTANGLE,
        edge_2: [0.0, 0.0, 3.0],
        number: 2,
        normal: [0.0, -1.0, 0.0],
        padding: 0,
    };

    fn draw(sample: u32) -> Draw {
        Draw {
            sample,
            sample_count: 64,
            bounce: 0,
        }
    }

    #[test]
    fn points_of_a_light_lie_on_it() {
        for shape in [DISC, RECTANGLE] {
            let panel = Light { shape, ..PANEL };
            let mut far = 0;
            for sample in 0..64 {
                let [x, y, z] = panel.sampled(&draw(sample)).point;
                let (s, t) = (x - 0.5, (z - 0.25) / 3.0);
                assert_eq!(y, 2.0);
                assert!(s.abs() < 1.0 && t.abs() < 1.0);
                far += u32::from(s * s + t * t > 1.0);
            }
            // The square's corners have 21 % of its area.
            assert!(far == 0 || shape == RECTANGLE && (10..18).contains(&far));
        }
        // What has no extent is left alone.
        let lamp = Light {
            shape: NO_EXTENT,
            ..PANEL
        };
        assert_eq!(lamp.sampled(&draw(3)), lamp);
    }

    #[test]
    fn a_panel_is_scaled_with_its_points() {
        let scale = PowerOfTwo::new(-3);
        let small = PANEL.scaled(&scale);
        assert_eq!(small.edge_2, [0.0, 0.0, 0.375]);
        assert_eq!(small.normal, PANEL.normal);
        for sample in 0..64 {
            let point = PANEL.sampled(&draw(sample)).point;
            assert_eq!(small.sampled(&draw(sample)).point, scale.times_each(point));
        }
    }

    #[test]
    fn lamps_are_scaled_and_suns_are_not() {
        let lamp = Light {
            point: [1.0, 2.0, -3.0],
            is_position: 1,
            color: [1.0, 3.0, f32::MAX],
            range: 5.0,
            ..Light::default()
        };
        let scale = PowerOfTwo::new(2);
        let expected = Light {
            point: [4.0, 8.0, -12.0],
            color: [16.0, 48.0, f32::MAX],
            range: 20.0,
            ..lamp
        };
        assert_eq!(lamp.scaled(&scale), expected);
        let sun = Light {
            is_position: 0,
            ..lamp
        };
        assert_eq!(sun.scaled(&scale), sun);
        // What has no limit has none at any magnitude.
        let endless = Light {
            range: f32::MAX,
            ..lamp
        };
        assert_eq!(endless.scaled(&PowerOfTwo::new(-130)).range, f32::MAX);
    }
}
