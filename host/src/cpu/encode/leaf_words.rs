//! A leaf's triangles on the lattice.

use slimbvh_core::LeafTriangle;
use slimbvh_core::encode::{LeafCorner, LeafWidth, encode_narrow_triangle, encode_triangle};

const NARROW: usize = LeafWidth::Narrow.words() as usize;
const MIDDLE: usize = LeafWidth::Middle.words() as usize;
const WIDE: usize = LeafWidth::Wide.words() as usize;

/// A leaf's triangles, to be stored on a lattice with this step.
pub(in crate::cpu) struct Leaf<'a> {
    pub(in crate::cpu) triangles: &'a [LeafTriangle],
    pub(in crate::cpu) corner: LeafCorner,
    pub(in crate::cpu) step: f32,
}

impl Leaf<'_> {
    /// Stores them at the width that they need.
    pub(in crate::cpu) fn put(&self, words: &mut [u32]) {
        match self.corner.words as usize {
            NARROW => self.put_narrow(words),
            MIDDLE => self.put_middle(words),
            _ => self.put_as::<WIDE>(words),
        }
    }

    /// Stores them at narrow width.
    pub(in crate::cpu) fn put_narrow(&self, words: &mut [u32]) {
        let words = words.as_chunks_mut::<NARROW>().0;
        for (to, triangle) in words.iter_mut().zip(self.triangles) {
            *to = encode_narrow_triangle(triangle, &self.corner, self.step);
        }
    }

    /// Stores them at middle width.
    pub(in crate::cpu) fn put_middle(&self, words: &mut [u32]) {
        self.put_as::<MIDDLE>(words);
    }

    /// Stores them in `SIZE` words each.
    fn put_as<const SIZE: usize>(&self, words: &mut [u32]) {
        for (to, triangle) in words.chunks_exact_mut(SIZE).zip(self.triangles) {
            let words = encode_triangle(triangle, &self.corner, self.step);
            to.copy_from_slice(&words[..SIZE]);
        }
    }
}
