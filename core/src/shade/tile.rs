//! The order in which a picture's pixels are taken: tiles of 8×8 pixels, so that rays that follow each other are near each
//! other.
//!
//! The picture is cut into bands of 8 rows and these into tiles of 8 columns, from the upper left; at the right and lower
//! edge tiles are smaller. Whole tiles are in Morton order (Morton 1966): eight pixels from a multiple of 8 are a block 4
//! wide and 2 high. Smaller tiles are row by row.

/// Pixels along a side of a tile.
const SIDE: u32 = 8;

/// A picture's pixels in tiles. [`Self::pixel`] and [`Self::number`] are each other's inverse: each pixel has one number
/// below `width · height`, which must fit into 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiles {
    /// Picture width in pixels.
    pub width: u32,
    /// Picture height in pixels.
    pub height: u32,
}

impl Tiles {
    /// The pixel with this number: column and row from the upper left.
    #[inline]
    #[must_use]
    pub fn pixel(&self, number: u32) -> [u32; 2] {
        // At least 1, so that no division can fail.
        let width = self.width.max(1);
        let top = number / width / SIDE * SIDE;
        let rows = self.rows(top);
        let in_band = number.wrapping_sub(top.wrapping_mul(width));
        let left = in_band / (SIDE * rows) * SIDE;
        let columns = self.columns(left);
        let i = in_band.wrapping_sub(left.wrapping_mul(rows));
        let [x, y] = if rows == SIDE && columns == SIDE {
            [even_bits(i), even_bits(i >> 1)]
        } else {
            [i % columns, i / columns]
        };
        [left.wrapping_add(x), top.wrapping_add(y)]
    }

    /// The number of the pixel in this column and row.
    #[inline]
    #[must_use]
    pub fn number(&self, [x, y]: [u32; 2]) -> u32 {
        let (left, top) = (x / SIDE * SIDE, y / SIDE * SIDE);
        let (rows, columns) = (self.rows(top), self.columns(left));
        let (x, y) = (x % SIDE, y % SIDE);
        let i = if rows == SIDE && columns == SIDE {
            spread(x) | spread(y) << 1
        } else {
            y * columns + x
        };
        let before = top.wrapping_mul(self.width);
        before.wrapping_add(left.wrapping_mul(rows)).wrapping_add(i)
    }

    /// Rows of the band that begins at row `top`, 1 to 8.
    #[inline(always)]
    fn rows(&self, top: u32) -> u32 {
        self.height.saturating_sub(top).clamp(1, SIDE)
    }

    /// Columns of the tile that begins at column `left`, 1 to 8.
    #[inline(always)]
    fn columns(&self, left: u32) -> u32 {
        self.width.saturating_sub(left).clamp(1, SIDE)
    }
}

/// Bits 0, 2 and 4, side by side.
#[inline(always)]
fn even_bits(i: u32) -> u32 {
    (i & 1) | (i >> 1 & 2) | (i >> 2 & 4)
}

/// The inverse of [`even_bits`].
#[inline(always)]
fn spread(x: u32) -> u32 {
    (x & 1) | (x & 2) << 1 | (x & 4) << 2
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::vec;

    /// Whether a map takes the numbers below `width · height` to the picture's pixels, one to one.
    fn is_bijection(tiles: &Tiles, map: impl Fn(u32) -> [u32; 2]) -> bool {
        let mut seen = vec![false; (tiles.width * tiles.height) as usize];
        (0..tiles.width * tiles.height).all(|number| {
            let [x, y] = map(number);
            let is_inside = x < tiles.width && y < tiles.height;
            is_inside && !core::mem::replace(&mut seen[(y * tiles.width + x) as usize], true)
        })
    }

    proptest! {
        #[test]
        fn each_pixel_has_one_number(width in 1u32..70, height in 1u32..70) {
            let tiles = Tiles { width, height };
            prop_assert!(is_bijection(&tiles, |number| tiles.pixel(number)));
            for number in 0..width * height {
                prop_assert_eq!(tiles.number(tiles.pixel(number)), number);
            }
            // The negative control: tiles of a picture one row higher.
            if width > SIDE && !height.is_multiple_of(SIDE) {
                let other = Tiles { width, height: height + 1 };
                prop_assert!(!is_bijection(&tiles, |number| other.pixel(number)));
            }
        }

        #[test]
        fn eight_in_a_row_are_a_block(columns in 1u32..9, bands in 1u32..9, block: prop::sample::Index) {
            let tiles = Tiles { width: SIDE * columns, height: SIDE * bands };
            let first = 8 * block.index((tiles.width * tiles.height / 8) as usize) as u32;
            let [left, top] = tiles.pixel(first);
            prop_assert_eq!([left % 4, top % 2], [0, 0]);
            for i in 0..8 {
                let [x, y] = tiles.pixel(first + i);
                prop_assert!(x - left < 4 && y - top < 2);
            }
        }
    }

    #[test]
    fn edges_hold_smaller_tiles() {
        let tiles = Tiles {
            width: 11,
            height: 10,
        };
        let expected = [
            (0, [0, 0]),
            (1, [1, 0]),
            (2, [0, 1]),
            (4, [2, 0]),
            (63, [7, 7]),
        ];
        let edges = [
            (64, [8, 0]),
            (67, [8, 1]),
            (88, [0, 8]),
            (96, [0, 9]),
            (104, [8, 8]),
            (109, [10, 9]),
        ];
        for (number, pixel) in expected.into_iter().chain(edges) {
            assert_eq!(tiles.pixel(number), pixel);
        }
        let widest = Tiles {
            width: u32::MAX,
            height: 1,
        };
        assert_eq!(widest.pixel(u32::MAX - 1), [u32::MAX - 1, 0]);
        assert_eq!(widest.number([u32::MAX - 1, 0]), u32::MAX - 1);
    }
}
