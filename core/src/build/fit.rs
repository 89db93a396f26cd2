//! Stage `fit`: a set of triangles whose tree has less memory than a tree of all would take. Only a GPU needs it, which counts the set
//! after its memory was reserved. A set that does not fit is not built: its rays go through the whole tree.

use bytemuck::{Pod, Zeroable};

/// A set that was counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Fit {
    /// Triangles of the set.
    pub count: u32,
    /// The most triangles that there is memory for.
    pub limit: u32,
    /// Unused.
    pub padding: [u32; 2],
}

impl Fit {
    /// A set of so many triangles, with memory for so many.
    #[inline(always)]
    #[must_use]
    pub const fn new(count: u32, limit: u32) -> Self {
        Self {
            count,
            limit,
            padding: [0; 2],
        }
    }

    /// Whether it fits.
    #[inline(always)]
    #[must_use]
    pub const fn fits(&self) -> bool {
        self.count <= self.limit
    }

    /// The number of triangles that are built: all, or none.
    #[inline(always)]
    #[must_use]
    pub const fn built_count(&self) -> u32 {
        if self.fits() { self.count } else { 0 }
    }

    /// How many of the rays go through the set, and how many through the whole tree.
    #[inline(always)]
    #[must_use]
    pub const fn parts(&self, ray_count: u32) -> [u32; 2] {
        if self.fits() {
            [ray_count, 0]
        } else {
            [0, ray_count]
        }
    }

    /// Where the tree begins that rays go through, for a set that begins here in lists that begin with the whole tree.
    #[inline(always)]
    #[must_use]
    pub const fn base(&self, set: u32) -> u32 {
        if self.fits() { set } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_or_none_is_built() {
        for (count, fits) in [
            (0, true),
            (6, true),
            (7, true),
            (8, false),
            (u32::MAX, false),
        ] {
            let fit = Fit::new(count, 7);
            assert_eq!(fit.fits(), fits);
            assert_eq!(fit.built_count(), if fits { count } else { 0 });
            assert_eq!(fit.parts(9), if fits { [9, 0] } else { [0, 9] });
            assert_eq!(fit.base(5), if fits { 5 } else { 0 });
        }
    }
}
