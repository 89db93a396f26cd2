//! Arithmetic without rounding.

use std::cmp::Ordering;

/// A number as a sum of doubles that do not overlap, smallest first (Shewchuk 1997, "Adaptive Precision Floating-Point
/// Arithmetic and Fast Robust Geometric Predicates", section 2). It is exact unless a part underflows or overflows. None
/// does for products of up to six numbers below 2^160 that are multiples of 2^-160, as all `f32` and their differences are.
#[derive(Clone, Debug, Default)]
pub struct ExactSum(Vec<f64>);

impl ExactSum {
    /// `a - b`.
    #[must_use]
    pub fn difference(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, -b);
        let mut sum = Self::default();
        sum.add(low);
        sum.add(high);
        sum
    }

    /// Adds one number (GROW-EXPANSION, without zeros).
    pub fn add(&mut self, term: f64) {
        let mut carry = term;
        self.0.retain_mut(|part| {
            let (sum, rest) = two_sum(carry, *part);
            carry = sum;
            *part = rest;
            rest != 0.0
        });
        if carry != 0.0 {
            self.0.push(carry);
        }
    }

    /// `self + other`.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        other.0.iter().for_each(|&part| self.add(part));
        self
    }

    /// `self - other`.
    #[must_use]
    pub fn minus(mut self, other: &Self) -> Self {
        other.0.iter().for_each(|&part| self.add(-part));
        self
    }

    /// `self * other`.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for a in &self.0 {
            for b in &other.0 {
                let (high, low) = two_product(*a, *b);
                product.add(low);
                product.add(high);
            }
        }
        product
    }

    /// −1, 0 or 1: the sign of the largest part, which the others together cannot outweigh.
    #[must_use]
    pub fn sign(&self) -> i32 {
        match self.0.last() {
            Some(part) if *part > 0.0 => 1,
            Some(_) => -1,
            None => 0,
        }
    }

    /// Compares with another number.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        self.clone().minus(other).sign().cmp(&0)
    }

    /// The nearest double, or a neighbour of it.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.0.iter().sum()
    }
}

/// `a + b` rounded, and the rounding error (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_share = sum - a;
    let a_share = sum - b_share;
    (sum, (a - a_share) + (b - b_share))
}

/// `a * b` rounded, and the rounding error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn nothing_is_lost() {
        let mut sum = ExactSum::default();
        for term in [1e300, 1e-300, -1e300] {
            sum.add(term);
        }
        assert_eq!((sum.sign(), sum.value()), (1, 1e-300));
        let thirds = ExactSum::difference(1.0 / 3.0, 0.0);
        let product = thirds.times(&ExactSum::difference(3.0, 0.0));
        assert_eq!(
            product.compare(&ExactSum::difference(1.0, 0.0)),
            Ordering::Less
        );
    }

    proptest! {
        #[test]
        fn agrees_with_integers(a in proptest::array::uniform4(-(1i64 << 40)..1 << 40), shift in -80i32..80) {
            let number = |x: i64| ExactSum::difference(x as f64 * 2f64.powi(shift), 0.0);
            let [a0, a1, a2, a3] = a.map(i128::from);
            let exact = a0 * a1 - a2 * a3;
            let [b0, b1, b2, b3] = a.map(number);
            prop_assert_eq!(b0.times(&b1).minus(&b2.times(&b3)).sign(), exact.signum() as i32);
            let sum = b0.plus(&b1).minus(&b2);
            prop_assert_eq!(sum.compare(&b3), (a0 + a1 - a2).cmp(&a3));
        }
    }
}
