//! What is known of a coded tree before its nodes.

use super::paper10::Paper10Box;
use crate::geometry::lattice::LatticeBox;
use bytemuck::{Pod, Zeroable};

/// The root's box and the lattice's step. 32 bytes, laid out as a uniform of two vectors.
///
/// ```text
///  0  smallest coordinates   12  exponent of the lattice's step
/// 16  largest coordinates    28  `opaque_zero`
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct RootWords {
    /// Bytes 0–15.
    pub low: [u32; 4],
    /// Bytes 16–31.
    pub high: [u32; 4],
}

const _: () = assert!(size_of::<RootWords>() == 32);

impl RootWords {
    /// The root of a tree of the lattice codec.
    #[inline(always)]
    #[must_use]
    pub const fn of_lattice(bounds: &LatticeBox, step_exponent: i32) -> Self {
        let ([a, b, c], [x, y, z]) = (bounds.min, bounds.max);
        Self {
            low: [a as u32, b as u32, c as u32, step_exponent as u32],
            high: [x as u32, y as u32, z as u32, 0],
        }
    }

    /// The root of a tree of the paper10 codec.
    #[inline(always)]
    #[must_use]
    pub const fn of_paper10(bounds: &Paper10Box) -> Self {
        let ([a, b, c], [x, y, z]) = (bounds.min, bounds.max);
        Self {
            low: [a.to_bits(), b.to_bits(), c.to_bits(), 0],
            high: [x.to_bits(), y.to_bits(), z.to_bits(), 0],
        }
    }

    /// The root's box of the lattice codec.
    #[inline(always)]
    #[must_use]
    pub const fn lattice(&self) -> LatticeBox {
        let ([a, b, c, _], [x, y, z, _]) = (self.low, self.high);
        LatticeBox {
            min: [a as i32, b as i32, c as i32],
            max: [x as i32, y as i32, z as i32],
        }
    }

    /// The root's box of the paper10 codec.
    #[inline(always)]
    #[must_use]
    pub const fn paper10(&self) -> Paper10Box {
        let ([a, b, c, _], [x, y, z, _]) = (self.low, self.high);
        Paper10Box {
            min: [f32::from_bits(a), f32::from_bits(b), f32::from_bits(c)],
            max: [f32::from_bits(x), f32::from_bits(y), f32::from_bits(z)],
        }
    }

    /// The lattice's step is two to this power, in the scene's magnitude.
    #[inline(always)]
    #[must_use]
    pub const fn step_exponent(&self) -> i32 {
        self.low[3] as i32
    }

    /// Always 0, hidden from the compiler so that it cannot fuse a product with a sum.
    #[inline(always)]
    #[must_use]
    pub const fn opaque_zero(&self) -> u32 {
        self.high[3]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_come_back_as_they_went_in() {
        let lattice = LatticeBox {
            min: [-1, 2, i32::MIN],
            max: [3, 1 << 24, 7],
        };
        let root = RootWords::of_lattice(&lattice, -24);
        assert_eq!((root.lattice(), root.step_exponent()), (lattice, -24));
        let paper10 = Paper10Box {
            min: [-0.0, 0.25, -1.0],
            max: [f32::MIN_POSITIVE, 0.5, -0.75],
        };
        let root = RootWords::of_paper10(&paper10);
        assert_eq!(root.paper10(), paper10);
        assert_eq!((root.opaque_zero(), root.step_exponent()), (0, 0));
    }
}
