//! Test inputs from bytes.

use arbitrary::{Arbitrary, Unstructured};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use slimbvh_core::lattice::LatticeBox;

/// An arbitrary value of a type; after the last byte zeros follow.
pub fn any<'a, T: Arbitrary<'a>>(data: &'a [u8]) -> Option<T> {
    T::arbitrary_take_rest(Unstructured::new(data)).ok()
}

/// A value of a property test's strategy, with the bytes as the seed of its random numbers. (Bytes in place of the random
/// numbers would not do: a union of strategies hands half of the remaining bytes to each strategy that it does not take.)
pub fn drawn<S: Strategy>(strategy: S, data: &[u8]) -> Option<S::Value> {
    let mut seed = [0; 32];
    for (i, byte) in data.iter().enumerate() {
        seed[i % 32] ^= byte;
    }
    let numbers = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(Config::default(), numbers);
    Some(strategy.new_tree(&mut runner).ok()?.current())
}

/// The number with these bits if its magnitude is below 1, as in a scene of magnitude 1, else a smaller number with the same
/// significand. Never negative zero.
pub fn below_one(bits: u32) -> f32 {
    const EXPONENT_OF_ONE: u32 = 127;
    let exponent = (bits >> 23 & 0xff) % EXPONENT_OF_ONE;
    f32::from_bits(bits & 0x807f_ffff | exponent << 23) + 0.0
}

/// A range of whole numbers: its start and its length, with the given number of bits fewer than possible.
pub type Extent = (i32, u32, u8);

/// The largest coordinate on a lattice.
pub const FARTHEST: i32 = (1 << 24) - 1;

/// A box on the lattice, of any size.
pub fn lattice_box(axes: [Extent; 3]) -> LatticeBox {
    let ends = axes.map(|(low, extent, bits)| {
        let low = (low >> 7).max(-FARTHEST);
        let extent = extent >> (7 + bits % 25);
        [low, low.saturating_add_unsigned(extent).min(FARTHEST)]
    });
    LatticeBox {
        min: ends.map(|[low, _]| low),
        max: ends.map(|[_, high]| high),
    }
}

/// A coordinate between two planes.
pub fn between(low: i32, high: i32, choice: u32) -> i32 {
    low.wrapping_add((u64::from(choice) % (u64::from(high.abs_diff(low)) + 1)) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strategies::any_mesh;

    #[test]
    fn what_is_drawn_follows_from_the_bytes() {
        let draw = |data| drawn(any_mesh(), data).map(|mesh| (mesh.vertices, mesh.indices));
        assert_eq!(draw(b"one"), draw(b"one"));
        assert_ne!(draw(b"one"), draw(b"two"));
    }

    #[test]
    fn numbers_are_below_one() {
        assert_eq!(below_one(0.75f32.to_bits()), 0.75);
        assert_eq!(below_one((-0.0f32).to_bits()).to_bits(), 0);
        for bits in [u32::MAX, f32::INFINITY.to_bits(), 1.0f32.to_bits()] {
            assert!(below_one(bits).abs() < 1.0);
        }
    }

    #[test]
    fn boxes_lie_on_the_lattice() {
        let far = lattice_box([(i32::MIN, u32::MAX, 0), (i32::MAX, 3, 0), (0, u32::MAX, 24)]);
        assert_eq!(far.min, [-FARTHEST, FARTHEST, 0]);
        assert_eq!(far.max, [FARTHEST, FARTHEST, 1]);
        assert_eq!(between(-5, 5, 21), 5);
    }
}
