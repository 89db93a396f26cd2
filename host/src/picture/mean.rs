//! The mean of several pictures.

use super::Picture;

/// The mean of pictures of the same size, in linear RGB, as an open shutter records it.
///
/// Sums are in f64, so that the mean of up to 2^29 equal pictures is that picture, to the bit.
///
/// ```
/// use slimbvh::{Picture, PictureMean};
/// let picture = |red| Picture { width: 1, height: 1, pixels: vec![[red, 0.5, 1.0]] };
/// let mut mean = PictureMean::new();
/// mean.add(&picture(0.0));
/// mean.add(&picture(3.0));
/// assert_eq!(mean.take().pixels, [[1.5, 0.5, 1.0]]);
/// ```
#[derive(Clone, Debug, Default)]
pub struct PictureMean {
    size: [u32; 2],
    sums: Vec<[f64; 3]>,
    count: u32,
}

impl PictureMean {
    /// The mean of no pictures yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a picture.
    ///
    /// # Panics
    /// If its size differs from the first one's.
    pub fn add(&mut self, picture: &Picture) {
        let size = [picture.width, picture.height];
        if self.count == 0 {
            self.size = size;
            self.sums.clear();
            let wide = |pixel: &[f32; 3]| pixel.map(f64::from);
            self.sums.extend(picture.pixels.iter().map(wide));
        } else {
            let lengths = (self.sums.len(), self.size);
            assert_eq!(
                lengths,
                (picture.pixels.len(), size),
                "pictures of one size"
            );
            for (sum, pixel) in self.sums.iter_mut().zip(&picture.pixels) {
                for (sum, &channel) in sum.iter_mut().zip(pixel) {
                    *sum += f64::from(channel);
                }
            }
        }
        self.count += 1;
    }

    /// Returns the mean and starts again in the same memory. The mean of no pictures is an empty picture.
    #[must_use]
    pub fn take(&mut self) -> Picture {
        let count = f64::from(self.count);
        let narrow = |sum: &[f64; 3]| sum.map(|channel| (channel / count) as f32);
        let picture = Picture {
            width: self.size[0],
            height: self.size[1],
            pixels: self.sums.iter().map(narrow).collect(),
        };
        (self.size, self.count) = ([0; 2], 0);
        self.sums.clear();
        picture
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn picture(pixels: Vec<[f32; 3]>) -> Picture {
        Picture {
            width: pixels.len() as u32,
            height: 1,
            pixels,
        }
    }

    proptest! {
        #[test]
        fn the_mean_of_equal_pictures_is_that_picture(
            pixels in proptest::collection::vec(proptest::array::uniform3(-1e6f32..1e6), 1..20),
            count in 1u32..40,
        ) {
            let equal = picture(pixels);
            let mut mean = PictureMean::new();
            for _ in 0..count {
                mean.add(&equal);
            }
            let found = mean.take();
            prop_assert_eq!(&found, &equal);
            // With a different picture among them the mean differs.
            let mut other = equal.clone();
            other.pixels[0][1] += 1e3;
            mean.add(&equal);
            mean.add(&other);
            prop_assert!(mean.take() != equal);
        }
    }

    #[test]
    fn it_begins_anew_with_another_size() {
        let mut mean = PictureMean::new();
        assert_eq!(mean.take(), Picture::default());
        mean.add(&picture(vec![[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]));
        mean.add(&picture(vec![[3.0, 2.0, 1.0], [0.0, 0.0, 0.0]]));
        assert_eq!(mean.take(), picture(vec![[2.0; 3], [2.0, 2.5, 3.0]]));
        mean.add(&picture(vec![[-0.0, 7.0, 9.0]]));
        let taken = mean.take();
        assert_eq!(
            taken.pixels[0].map(f32::to_bits),
            [-0.0f32, 7.0, 9.0].map(f32::to_bits)
        );
    }

    #[test]
    #[should_panic(expected = "pictures of one size")]
    fn pictures_of_two_sizes_have_no_mean() {
        let mut mean = PictureMean::new();
        mean.add(&picture(vec![[1.0; 3]]));
        mean.add(&picture(vec![[1.0; 3]; 2]));
    }
}
