//! Pixels of two pictures of one size.

use slimbvh::Picture;

/// The number of pixels that differ by more than `most` in any channel.
pub fn changed(a: &Picture, b: &Picture, most: u8) -> usize {
    let (a, b) = (a.to_srgb(), b.to_srgb());
    let pixels = a.chunks(3).zip(b.chunks(3));
    let differ = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > most);
    pixels.filter(differ).count()
}
