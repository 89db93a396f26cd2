//! Camera rays.

use crate::geometry::float::PowerOfTwo;
use crate::geometry::ray::Ray;
use crate::shade::sampling::{Draw, LENS, disc_point};
use crate::shade::tile::Tiles;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// A pinhole, a thin lens, or a parallel camera. 96 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Camera {
    /// Bytes 0–11: where the rays of a perspective camera start, or the middle of a parallel camera's picture.
    pub eye: [f32; 3],
    /// Bytes 12–15: 0 for perspective, 1 for parallel rays.
    pub is_parallel: u32,
    /// Bytes 16–27: to the middle of the picture.
    pub forward: [f32; 3],
    /// Bytes 28–31: picture width in pixels.
    pub width: u32,
    /// Bytes 32–43: from the middle of the picture to its right edge, one `forward` away.
    pub right: [f32; 3],
    /// Bytes 44–47: picture height in pixels.
    pub height: u32,
    /// Bytes 48–59: from the middle of the picture to its upper edge.
    pub up: [f32; 3],
    /// Bytes 60–63: samples a pixel.
    pub sample_count: u32,
    /// Bytes 64–75: unit vector along `right`, where there is a lens.
    pub lens_right: [f32; 3],
    /// Bytes 76–79: radius of the disc around the eye that the rays of a perspective camera leave from; 0 for a pinhole.
    pub lens_radius: f32,
    /// Bytes 80–91: unit vector along `up`, where there is a lens.
    pub lens_up: [f32; 3],
    /// Bytes 92–95: the lens's radius by the distance, along `forward`, of what is in focus.
    pub lens_slope: f32,
}

const _: () = assert!(size_of::<Camera>() == 96);

impl Camera {
    /// The same picture of a scene whose coordinates are multiplied by a power of two.
    #[inline]
    #[must_use]
    pub fn scaled(&self, scale: &PowerOfTwo) -> Self {
        let mut camera = *self;
        camera.eye = scale.times_each(self.eye);
        camera.lens_radius = scale.times(self.lens_radius);
        // The edges of a perspective picture are directions.
        if self.is_parallel == 1 {
            camera.right = scale.times_each(self.right);
            camera.up = scale.times_each(self.up);
        }
        camera
    }

    /// The picture's pixels in tiles.
    #[inline]
    #[must_use]
    pub fn tiles(&self) -> Tiles {
        Tiles {
            width: self.width,
            height: self.height,
        }
    }

    /// The sample that a thread takes, for [`Self::ray`]. Threads take the pixels in [`Tiles`], a pixel's samples one after
    /// the other.
    #[inline]
    #[must_use]
    pub fn sample_of_thread(&self, thread: u32) -> u32 {
        let sample_count = self.sample_count.max(1);
        let pixel = self.tiles().pixel(thread / sample_count);
        self.sample(pixel, thread % sample_count)
    }

    /// The number of a sample, from its pixel and its number there. Pixels are numbered row by row from the upper left, a
    /// pixel's samples one after the other.
    #[inline]
    #[must_use]
    pub fn sample(&self, [x, y]: [u32; 2], in_pixel: u32) -> u32 {
        let pixel = y.wrapping_mul(self.width).wrapping_add(x);
        let first = pixel.wrapping_mul(self.sample_count.max(1));
        first.wrapping_add(in_pixel)
    }

    /// The ray of the sample with this number ([`Self::sample`]).
    #[inline]
    #[must_use]
    pub fn ray(&self, sample: u32) -> Ray {
        // At least 1, so that no division can fail.
        let (sample_count, width) = (self.sample_count.max(1), self.width.max(1));
        let pixel = sample / sample_count;
        self.ray_through([pixel % width, pixel / width], sample % sample_count)
    }

    /// The ray of a sample, from its pixel and its number there.
    #[inline]
    #[must_use]
    pub fn ray_through(&self, [x, y]: [u32; 2], in_pixel: u32) -> Ray {
        let [dx, dy] = sample_offset(in_pixel, self.sample_count.max(1));
        self.ray_at(
            [x as f32 + dx, y as f32 + dy],
            self.sample([x, y], in_pixel),
        )
    }

    /// The ray at a position in the picture, in pixels from its upper left corner; through a lens, that of this sample.
    #[inline]
    #[must_use]
    pub fn ray_at(&self, [x, y]: [f32; 2], sample: u32) -> Ray {
        let s = x / self.width as f32 * 2.0 - 1.0;
        let t = 1.0 - y / self.height as f32 * 2.0;
        let spread = Vec3::from_array(self.right) * s + Vec3::from_array(self.up) * t;
        let eye = Vec3::from_array(self.eye);
        let forward = Vec3::from_array(self.forward);
        if self.is_parallel == 1 {
            Ray::new((eye + spread).to_array(), self.forward)
        } else if self.lens_radius > 0.0 {
            let aside = self.lens_point(sample);
            // All that leave the lens meet where the eye's own ray passes the plane in focus.
            let direction = forward + spread - aside * self.lens_slope;
            let origin = eye + aside * self.lens_radius;
            Ray::new(origin.to_array(), direction.to_array())
        } else {
            Ray::new(self.eye, (forward + spread).to_array())
        }
    }

    /// Where on a lens of radius 1 a sample's ray leaves it, from its middle.
    #[inline]
    fn lens_point(&self, sample: u32) -> Vec3 {
        let draw = Draw {
            sample,
            sample_count: self.sample_count,
            bounce: 0,
        };
        let [x, y] = disc_point(draw.square(LENS));
        Vec3::from_array(self.lens_right) * x + Vec3::from_array(self.lens_up) * y
    }
}

/// Where in its pixel a sample lies, each coordinate in `[0, 1)`. A square number of samples up to 289 forms a regular grid; any
/// other number a Fibonacci lattice.
#[inline]
#[must_use]
pub fn sample_offset(sample: u32, sample_count: u32) -> [f32; 2] {
    let mut side = 1;
    for _ in 0..16u32 {
        if side * side < sample_count {
            side += 1;
        }
    }
    if side * side == sample_count {
        let place = |i: u32| (i as f32 + 0.5) / side as f32;
        return [place(sample % side), place(sample / side)];
    }
    // A step is the inverse of the golden ratio, as a fraction of 2^32.
    let step = 0x9e37_79b9u32;
    let turn = sample.wrapping_mul(step).wrapping_add(step / 2);
    [
        (sample as f32 + 0.5) / sample_count as f32,
        (turn >> 8) as f32 / 16_777_216.0,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_pass_the_corners_of_the_picture() {
        let camera = Camera {
            eye: [1.0, 2.0, 3.0],
            forward: [0.0, 0.0, -1.0],
            right: [2.0, 0.0, 0.0],
            up: [0.0, 0.5, 0.0],
            width: 4,
            height: 2,
            sample_count: 1,
            is_parallel: 0,
            ..Camera::default()
        };
        // The pixels' centres are half a pixel from the edges.
        assert_eq!(camera.ray(0).direction, [-1.5, 0.25, -1.0]);
        assert_eq!(camera.ray(7).direction, [1.5, -0.25, -1.0]);
        let parallel = Camera {
            is_parallel: 1,
            ..camera
        };
        assert_eq!(parallel.ray(4).origin, [-0.5, 1.75, 3.0]);
        assert_eq!(parallel.ray(4).direction, [0.0, 0.0, -1.0]);
    }

    /// A lens of radius 0.5, in focus at 8.
    const LENS_CAMERA: Camera = Camera {
        eye: [1.0, 2.0, 3.0],
        forward: [0.0, 0.0, -1.0],
        right: [2.0, 0.0, 0.0],
        up: [0.0, 0.5, 0.0],
        width: 4,
        height: 2,
        sample_count: 64,
        is_parallel: 0,
        lens_right: [1.0, 0.0, 0.0],
        lens_radius: 0.5,
        lens_up: [0.0, 1.0, 0.0],
        lens_slope: 0.0625,
    };

    #[test]
    fn a_lens_is_sharp_in_focus_and_blurs_by_its_size_elsewhere() {
        let pinhole = Camera {
            lens_radius: 0.0,
            ..LENS_CAMERA
        };
        let at =
            |ray: &Ray, t: f32| Vec3::from_array(ray.origin) + Vec3::from_array(ray.direction) * t;
        let mut widest = 0.0f32;
        for sample in 0..8 * 64 {
            let (through, straight) = (LENS_CAMERA.ray(sample), pinhole.ray(sample));
            // t is the distance along the view, for both.
            assert_eq!(through.direction[2], -1.0);
            let apart = |t: f32| (at(&through, t) - at(&straight, t)).length();
            assert!(apart(8.0) < 2e-6);
            let (near, half, far) = (apart(0.0), apart(4.0), apart(16.0));
            assert!(near < 0.5 && (half - near / 2.0).abs() < 2e-6 && (far - near).abs() < 4e-6);
            widest = widest.max(near);
        }
        assert!(widest > 0.49);
    }

    #[test]
    fn without_a_radius_a_lens_is_a_pinhole_to_the_bit() {
        let closed = Camera {
            lens_radius: 0.0,
            eye: [-0.0, 2.0, 0.0],
            ..LENS_CAMERA
        };
        let never = Camera {
            lens_right: [0.0; 3],
            lens_up: [0.0; 3],
            lens_slope: 0.0,
            ..closed
        };
        for sample in 0..8 * 64 {
            let (a, b) = (closed.ray(sample), never.ray(sample));
            assert_eq!(bytemuck::bytes_of(&a), bytemuck::bytes_of(&b));
            assert_eq!(a.origin.map(f32::to_bits), closed.eye.map(f32::to_bits));
        }
    }

    #[test]
    fn a_lens_is_scaled_with_its_rays() {
        let scale = PowerOfTwo::new(-5);
        let small = LENS_CAMERA.scaled(&scale);
        assert_eq!((small.lens_radius, small.lens_slope), (0.015625, 0.0625));
        for sample in 0..64 {
            let (ray, expected) = (small.ray(sample), LENS_CAMERA.ray(sample));
            assert_eq!(ray.origin, scale.times_each(expected.origin));
            assert_eq!(ray.direction, expected.direction);
        }
    }

    #[test]
    fn only_positions_and_lengths_are_scaled() {
        let camera = Camera {
            eye: [1.0, -2.0, 3.0],
            forward: [0.0, 0.6, -0.8],
            right: [2.0, 0.0, 0.0],
            up: [0.0, 0.5, 0.25],
            ..Camera::default()
        };
        let scaled = camera.scaled(&PowerOfTwo::new(-3));
        let expected = Camera {
            eye: [0.125, -0.25, 0.375],
            ..camera
        };
        assert_eq!(scaled, expected);
        let parallel = |camera: Camera| Camera {
            is_parallel: 1,
            ..camera
        };
        let expected = Camera {
            right: [0.25, 0.0, 0.0],
            up: [0.0, 0.0625, 0.03125],
            ..expected
        };
        let scaled = parallel(camera).scaled(&PowerOfTwo::new(-3));
        assert_eq!(scaled, parallel(expected));
    }

    #[test]
    fn samples_are_a_grid_or_spread_out() {
        assert_eq!(sample_offset(0, 1), [0.5, 0.5]);
        assert_eq!(sample_offset(2, 4), [0.25, 0.75]);
        assert_eq!(sample_offset(255, 256), [0.96875, 0.96875]);
        assert_eq!(sample_offset(1, 2)[0], 0.75);
        for count in [2, 3, 5, 7, 12, 100, 1000] {
            let mut mean = [0.0f64; 2];
            for sample in 0..count {
                let [x, y] = sample_offset(sample, count);
                assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
                mean = [
                    mean[0] + f64::from(x) / f64::from(count),
                    mean[1] + f64::from(y) / f64::from(count),
                ];
            }
            let off_centre = f64::max((mean[0] - 0.5).abs(), (mean[1] - 0.5).abs());
            assert!(off_centre < 1.0 / f64::from(count), "{count} {off_centre}");
        }
    }
}
