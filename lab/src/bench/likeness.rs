//! Differences between two pictures, and between the hits of their rays.

use crate::measure::paths::Seen;
use crate::measure::pictures::changed;
use anyhow::{Context, Result, ensure};
use image_compare::Algorithm;
use slimbvh::Picture;

/// The differences from the plain tree's picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Likeness {
    /// The root mean square difference of 8-bit sRGB channels, 0 to 255.
    pub image_rmse: f64,
    /// Structural similarity of the luma: the mean over windows of 8×8 pixels, 1 for equal pictures (Wang, Bovik, Sheikh and
    /// Simoncelli, "Image quality assessment: from error visibility to structural similarity", 2004).
    pub ssim: f64,
    /// The share of pixels with a differing byte.
    pub changed_pixels: f64,
    /// The share of samples that hit another triangle, or that hit in only one of the pictures.
    pub changed_primitives: f64,
    /// The largest difference of hit distances where both samples hit, in the scene's unit.
    pub distance_most: f64,
    /// The root mean square of these differences.
    pub distance_rms: f64,
}

impl Likeness {
    /// # Errors
    /// If the pictures differ in size, or the samples in number.
    pub fn new(picture: &Picture, plain: &Picture, seen: [&[Seen]; 2]) -> Result<Self> {
        ensure!(
            (picture.width, picture.height) == (plain.width, plain.height)
                && seen[0].len() == seen[1].len(),
            "the pictures differ in size"
        );
        let (own, reference) = (picture.to_srgb(), plain.to_srgb());
        let pixel_count = picture.pixels.len().max(1) as f64;
        let others = seen[0].iter().zip(seen[1]);
        let other_count = others.filter(|(a, b)| a.primitive != b.primitive).count();
        let [distance_most, distance_rms] = distances(seen);
        Ok(Self {
            image_rmse: rmse(&own, &reference),
            ssim: ssim([picture.width, picture.height], &own, &reference)?,
            changed_pixels: changed(picture, plain, 0) as f64 / pixel_count,
            changed_primitives: other_count as f64 / seen[0].len().max(1) as f64,
            distance_most,
            distance_rms,
        })
    }
}

/// The largest and the root mean square difference of distances where both samples hit.
fn distances([own, plain]: [&[Seen]; 2]) -> [f64; 2] {
    let (mut most, mut squares, mut count) = (0.0f64, 0.0, 0u32);
    for (own, plain) in own.iter().zip(plain) {
        if own.is_anything() && plain.is_anything() {
            let difference = (f64::from(own.distance) - f64::from(plain.distance)).abs();
            most = most.max(difference);
            squares += difference * difference;
            count += 1;
        }
    }
    [most, (squares / f64::from(count.max(1))).sqrt()]
}

fn rmse(a: &[u8], b: &[u8]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| {
        let difference = f64::from(a.abs_diff(*b));
        difference * difference
    });
    (squares.sum::<f64>() / a.len().max(1) as f64).sqrt()
}

fn ssim([width, height]: [u32; 2], a: &[u8], b: &[u8]) -> Result<f64> {
    // The luma of Rec. 709.
    let luma = |rgb: &[u8]| {
        let [r, g, b] = [rgb[0], rgb[1], rgb[2]].map(f32::from);
        (0.2126 * r + 0.7152 * g + 0.0722 * b).round() as u8
    };
    let gray = |bytes: &[u8]| {
        let pixels = bytes.chunks(3).map(luma).collect();
        image::GrayImage::from_raw(width, height, pixels).context("a picture has too few pixels")
    };
    let (a, b) = (gray(a)?, gray(b)?);
    let similarity = image_compare::gray_similarity_structure(&Algorithm::MSSIMSimple, &a, &b)?;
    Ok(similarity.score)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ramp of 24×16 pixels.
    fn ramp() -> Picture {
        Picture {
            width: 24,
            height: 16,
            pixels: (0..24 * 16)
                .map(|i| [(i % 24) as f32 / 24.0, (i / 24) as f32 / 16.0, 0.25])
                .collect(),
        }
    }

    fn seen(primitive: u32, distance: f32) -> Seen {
        Seen {
            primitive,
            distance,
        }
    }

    #[test]
    fn equal_pictures_are_alike() {
        let all = [seen(3, 1.0), Seen::NOTHING];
        let likeness = Likeness::new(&ramp(), &ramp(), [&all, &all]).unwrap();
        let expected = Likeness {
            image_rmse: 0.0,
            ssim: 1.0,
            changed_pixels: 0.0,
            changed_primitives: 0.0,
            distance_most: 0.0,
            distance_rms: 0.0,
        };
        assert_eq!(likeness, expected);
    }

    #[test]
    fn one_changed_pixel_is_seen() {
        let mut other = ramp();
        other.pixels[3 * 24 + 5] = [0.0, 1.0, 1.0];
        let before = ramp().to_srgb();
        let place = 3 * (3 * 24 + 5);
        let squares: f64 = (0..3)
            .map(|i| f64::from(before[place + i]) - [0.0, 255.0, 255.0][i])
            .map(|difference| difference * difference)
            .sum();
        let likeness = Likeness::new(&other, &ramp(), [&[], &[]]).unwrap();
        let expected = (squares / f64::from(3 * 24 * 16)).sqrt();
        assert!((likeness.image_rmse - expected).abs() < 1e-9 && expected > 1.0);
        assert!(likeness.ssim < 0.9999, "{}", likeness.ssim);
        assert_eq!(likeness.changed_pixels, 1.0 / 384.0);
        assert!(Likeness::new(&Picture::default(), &ramp(), [&[], &[]]).is_err());
    }

    #[test]
    fn what_samples_see_is_compared() {
        let plain = [
            seen(1, 4.0),
            seen(2, 5.0),
            Seen::NOTHING,
            seen(7, 1.0),
            seen(8, 2.0),
        ];
        let own = [
            seen(1, 4.5),
            seen(3, 4.0),
            seen(9, 1.0),
            Seen::NOTHING,
            seen(8, 2.0),
        ];
        let likeness = Likeness::new(&ramp(), &ramp(), [&own, &plain]).unwrap();
        assert_eq!(likeness.changed_primitives, 3.0 / 5.0);
        assert_eq!(likeness.distance_most, 1.0);
        // The differences are 0.5, 1 and 0.
        assert!((likeness.distance_rms - (1.25f64 / 3.0).sqrt()).abs() < 1e-12);
    }
}
