//! Stage `gather`: positions and indices out of buffers of any layout, without gaps.

/// One thread per vertex. Reads a buffer's words; positions begin at the word `first` and every `stride` words. Returns the bits of
/// the vertex's position, zeros beyond the buffer's end.
#[inline(always)]
#[must_use]
pub fn position(vertex: u32, first: u32, stride: u32, words: &[u32]) -> [u32; 3] {
    let x = first.wrapping_add(vertex.wrapping_mul(stride));
    [
        crate::load(words, x, 0),
        crate::load(words, x.wrapping_add(1), 0),
        crate::load(words, x.wrapping_add(2), 0),
    ]
}

/// One thread per triangle. Reads a buffer's words, each an index of 32 bits or two of 16 bits, the low half first. Returns the
/// triangle's three indices, of those from number `first` on; `u32::MAX` beyond the buffer's end.
#[inline(always)]
#[must_use]
pub fn corners(triangle: u32, first: u32, index_bits: u32, words: &[u32]) -> [u32; 3] {
    let a = first.wrapping_add(triangle.wrapping_mul(3));
    [
        index(a, index_bits, words),
        index(a.wrapping_add(1), index_bits, words),
        index(a.wrapping_add(2), index_bits, words),
    ]
}

#[inline(always)]
fn index(number: u32, index_bits: u32, words: &[u32]) -> u32 {
    if index_bits == 32 {
        return crate::load(words, number, u32::MAX);
    }
    if number / 2 < words.len() as u32 {
        crate::load(words, number / 2, 0) >> (number % 2 * 16) & 0xffff
    } else {
        u32::MAX
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::vec::Vec;

    #[test]
    fn positions_and_indices_of_known_words() {
        let words = [9, 10, 11, 12, 13, 20, 21, 22, 23];
        assert_eq!(position(0, 1, 5, &words), [10, 11, 12]);
        assert_eq!(position(1, 1, 5, &words), [21, 22, 23]);
        assert_eq!(position(2, 0, 4, &words), [23, 0, 0]);
        assert_eq!(position(u32::MAX, u32::MAX, u32::MAX, &words), [9, 10, 11]);
        assert_eq!(corners(1, 2, 32, &words), [20, 21, 22]);
        assert_eq!(corners(2, 1, 32, &words), [22, 23, u32::MAX]);
        let pairs = [0x0002_0001, 0x0004_0003, 0x0006_ffff];
        assert_eq!(corners(0, 1, 16, &pairs), [2, 3, 4]);
        assert_eq!(corners(1, 1, 16, &pairs), [0xffff, 6, u32::MAX]);
    }

    proptest! {
        /// As bytes have them.
        #[test]
        fn what_is_put_in_comes_out(
            elements in proptest::collection::vec(proptest::array::uniform3(any::<u16>()), 1..20),
            (gap, offset) in (0usize..5, 0usize..5),
        ) {
            let halves: Vec<u16> = core::iter::repeat_n(7, offset).chain(elements.iter().flatten().copied()).collect();
            let words: Vec<u32> = halves.chunks(2).map(|c| u32::from(c[0]) | u32::from(*c.get(1).unwrap_or(&0)) << 16).collect();
            let mut spread = std::vec![7; offset];
            for element in &elements {
                spread.extend(element.map(u32::from));
                spread.extend(core::iter::repeat_n(7, gap));
            }
            for (i, element) in (0..).zip(&elements) {
                let expected = element.map(u32::from);
                prop_assert_eq!(corners(i, offset as u32, 16, &words), expected);
                prop_assert_eq!(position(i, offset as u32, (3 + gap) as u32, &spread), expected);
                // The negative control: a layout that is off by one is noticed.
                if element[0] != element[1] {
                    prop_assert_ne!(corners(i, offset as u32 + 1, 16, &words), expected);
                    prop_assert_ne!(position(i, offset as u32 + 1, (3 + gap) as u32, &spread), expected);
                }
            }
        }
    }
}
