//! Sums without rounding.

/// An exact sum of up to `N` doubles, as parts that do not overlap, smallest first: GROW-EXPANSION of Shewchuk,
/// "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates" (1997), section 2.4, with zeros
/// left out. Terms must be so large that their roundings do not underflow.
pub(super) struct Expansion<const N: usize> {
    parts: [f64; N],
    count: usize,
}

impl<const N: usize> Expansion<N> {
    /// Nothing.
    pub(super) const ZERO: Self = Self {
        parts: [0.0; N],
        count: 0,
    };

    /// Adds one term.
    pub(super) fn add(&mut self, term: f64) {
        let (mut carry, mut kept) = (term, 0);
        for i in 0..self.count {
            let (sum, rest) = two_sum(carry, self.parts[i]);
            if rest != 0.0 {
                self.parts[kept] = rest;
                kept += 1;
            }
            carry = sum;
        }
        if carry != 0.0 {
            self.parts[kept] = carry;
            kept += 1;
        }
        self.count = kept;
    }

    /// −1, 0 or 1: the sign of the largest part, as the others together cannot outweigh it.
    pub(super) fn sign(&self) -> i32 {
        match self.parts[..self.count].last() {
            Some(&part) => sign(part),
            None => 0,
        }
    }
}

/// −1, 0 or 1.
pub(super) fn sign(x: f64) -> i32 {
    i32::from(x > 0.0) - i32::from(x < 0.0)
}

/// `a + b` rounded, and what the rounding left out (Knuth).
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_share = sum - a;
    let a_share = sum - b_share;
    (sum, (a - a_share) + (b - b_share))
}

/// `a * b` rounded, and what the rounding left out.
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign_of_sum(terms: &[f64]) -> i32 {
        let mut sum = Expansion::<8>::ZERO;
        terms.iter().for_each(|&term| sum.add(term));
        sum.sign()
    }

    #[test]
    fn nothing_is_lost() {
        assert_eq!(sign_of_sum(&[1e300, 1e-300, -1e300]), 1);
        assert_eq!(sign_of_sum(&[1e300, -1e-300, 1.0, -1e300, -1.0]), -1);
        assert_eq!(sign_of_sum(&[0.1, 0.2, -0.3]), 1);
        assert_eq!(sign_of_sum(&[0.1, 0.2, -0.2, -0.1]), 0);
        assert_eq!(sign_of_sum(&[]), 0);
        let (product, rest) = two_product(0.1, 0.3);
        assert_eq!(sign_of_sum(&[product, rest, -product]), sign(rest));
    }
}
