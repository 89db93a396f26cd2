//! The order in which a picture's pixels are taken: tiles of 8×8 pixels, so that rays that follow each other are near each
//! other.
//!
//! The picture is cut into bands of 8 rows and these into tiles of 8 columns, from the upper left; at the right and lower
//! edge tiles are smaller. Whole tiles are in Morton order (Morton 1966): eight pixels from a multiple of 8 are a block 4
//! wide and 2 high. Smaller tiles are row by row.

/// Pixels along a side of a tile.
pub const SIDE: u32 = 8;

/// A picture's pixels in tiles, the order in which its rays are traced fastest. [`Self::pixel`] and [`Self::number`] are each
/// other's inverse: each pixel has one number below `width · height`, which must fit into 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiles {
    /// Picture width in pixels.
    pub width: u32,
    /// Picture height in pixels.
    pub height: u32,
}

/// A tile of a picture: its upper left pixel and its size, each side 1 to 8.
#[derive(Clone, Copy, Debug)]
struct Tile {
    left: u32,
    top: u32,
    columns: u32,
    rows: u32,
}

impl Tiles {
    /// The pixel with this number: column and row from the upper left.
    #[inline]
    #[must_use]
    pub fn pixel(&self, number: u32) -> [u32; 2] {
        let (tile, i) = self.place(number);
        tile.pixel(i)
    }

    /// The number of the pixel in this column and row.
    #[inline]
    #[must_use]
    pub fn number(&self, [x, y]: [u32; 2]) -> u32 {
        let tile = self.tile(x / SIDE * SIDE, y / SIDE * SIDE);
        let before = tile.top.wrapping_mul(self.width);
        let before = before.wrapping_add(tile.left.wrapping_mul(tile.rows));
        before.wrapping_add(tile.number([x % SIDE, y % SIDE]))
    }

    /// The pixels from this number on, in their order, without end. No pixel costs a division, except in smaller tiles.
    #[must_use]
    pub fn pixels_from(&self, number: u32) -> Pixels {
        let (tile, i) = self.place(number);
        Pixels {
            tiles: *self,
            tile,
            i,
        }
    }

    /// The tile of the pixel with this number, and the pixel's number in its tile.
    #[inline(always)]
    fn place(&self, number: u32) -> (Tile, u32) {
        // At least 1, so that no division can fail.
        let width = self.width.max(1);
        let top = number / width / SIDE * SIDE;
        let rows = side(self.height, top);
        let in_band = number.wrapping_sub(top.wrapping_mul(width));
        let left = in_band / (SIDE * rows) * SIDE;
        let i = in_band.wrapping_sub(left.wrapping_mul(rows));
        (self.tile(left, top), i)
    }

    /// The tile that begins at this column and row.
    #[inline(always)]
    fn tile(&self, left: u32, top: u32) -> Tile {
        Tile {
            left,
            top,
            columns: side(self.width, left),
            rows: side(self.height, top),
        }
    }
}

impl Tile {
    /// The pixel of the picture that has this number in the tile.
    #[inline(always)]
    fn pixel(&self, i: u32) -> [u32; 2] {
        self.moved(if self.is_whole() {
            morton_pixel(i)
        } else {
            [i % self.columns, i / self.columns]
        })
    }

    /// The pixel of the picture at this column and row of the tile.
    #[inline(always)]
    fn moved(&self, [x, y]: [u32; 2]) -> [u32; 2] {
        [self.left.wrapping_add(x), self.top.wrapping_add(y)]
    }

    /// The number of the tile's pixel in this column and row of the tile.
    #[inline(always)]
    fn number(&self, [x, y]: [u32; 2]) -> u32 {
        if self.is_whole() {
            spread(x) | spread(y) << 1
        } else {
            y * self.columns + x
        }
    }

    #[inline(always)]
    fn is_whole(&self) -> bool {
        self.columns == SIDE && self.rows == SIDE
    }
}

/// A tile's side, 1 to 8, that begins at `first` in a picture with a side of `length`, which is greater.
#[inline(always)]
fn side(length: u32, first: u32) -> u32 {
    let rest = length.wrapping_sub(first);
    if rest < SIDE { rest.max(1) } else { SIDE }
}

/// [`Tiles::pixels_from`].
#[derive(Clone, Debug)]
pub struct Pixels {
    tiles: Tiles,
    tile: Tile,
    i: u32,
}

/// Columns and rows of a whole tile's pixels.
const WHOLE: [[u32; 2]; (SIDE * SIDE) as usize] = {
    let mut pixels = [[0; 2]; (SIDE * SIDE) as usize];
    let mut i = 0;
    while i < SIDE * SIDE {
        pixels[i as usize] = morton_pixel(i);
        i += 1;
    }
    pixels
};

impl Iterator for Pixels {
    type Item = [u32; 2];

    #[inline]
    fn next(&mut self) -> Option<[u32; 2]> {
        if self.i == self.tile.columns * self.tile.rows {
            let Tile { left, top, .. } = self.tile;
            let right = left.wrapping_add(self.tile.columns);
            self.tile = if right < self.tiles.width {
                self.tiles.tile(right, top)
            } else {
                self.tiles.tile(0, top.wrapping_add(SIDE))
            };
            self.i = 0;
        }
        let i = self.i;
        self.i += 1;
        Some(if self.tile.is_whole() {
            self.tile.moved(WHOLE[i as usize % WHOLE.len()])
        } else {
            self.tile.pixel(i)
        })
    }
}

/// Column and row in a whole tile of the pixel with this number there.
#[inline(always)]
const fn morton_pixel(i: u32) -> [u32; 2] {
    [even_bits(i), even_bits(i >> 1)]
}

/// Bits 0, 2 and 4, side by side.
#[inline(always)]
const fn even_bits(i: u32) -> u32 {
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
        fn each_pixel_has_one_number(width in 1u32..70, height in 1u32..70, first: prop::sample::Index) {
            let tiles = Tiles { width, height };
            prop_assert!(is_bijection(&tiles, |number| tiles.pixel(number)));
            for number in 0..width * height {
                prop_assert_eq!(tiles.number(tiles.pixel(number)), number);
            }
            let first = first.index((width * height) as usize) as u32;
            for (number, pixel) in (first..width * height).zip(tiles.pixels_from(first)) {
                prop_assert_eq!(pixel, tiles.pixel(number));
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
            let first = SIDE * block.index((tiles.width * tiles.height / SIDE) as usize) as u32;
            prop_assert!(is_block(|i| tiles.pixel(first + i)));
            // The negative controls: rows, and a start between two blocks.
            prop_assert!(!is_block(|i| [(first + i) % tiles.width, (first + i) / tiles.width]));
            prop_assert!(!is_block(|i| tiles.pixel(first + 4 + i)));
        }
    }

    /// Whether eight pixels are a block 4 wide and 2 high.
    fn is_block(pixel: impl Fn(u32) -> [u32; 2]) -> bool {
        let [left, top] = pixel(0);
        left % 4 == 0
            && top % 2 == 0
            && (0..8).all(|i| {
                let [x, y] = pixel(i);
                (left..left + 4).contains(&x) && (top..top + 2).contains(&y)
            })
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
