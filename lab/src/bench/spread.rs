//! When a difference of times is told, and when it lies within the spread of the rounds.

use crate::measure::rounds::median;

/// Times that differ by less than this share count as equal.
pub const LEAST_DIFFERENCE: f64 = 0.03;

/// Fewer rounds show no spread, so that nothing is concluded from them.
pub const LEAST_ROUNDS: usize = 3;

/// What a sentence says that compares times without a clear difference.
pub const WITHIN: &str = "which is within the spread of these runs";

/// The rule of [`Ratios::is_clear`], for the head of a report.
pub fn rule() -> String {
    format!(
        "a difference of times counts if it is larger than {:.0} % and than the spread of its rounds, which is the largest of \
         their ratios over the smallest; fewer than {LEAST_ROUNDS} rounds show no spread, and nothing is concluded from them",
        100.0 * LEAST_DIFFERENCE
    )
}

/// The ratios of a time to another of the same round, over all rounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratios {
    pub least: f64,
    pub median: f64,
    pub most: f64,
    pub count: usize,
}

impl Ratios {
    pub fn new(ratios: impl Iterator<Item = f64>) -> Self {
        let mut ratios: Vec<f64> = ratios.collect();
        Self {
            least: ratios.iter().copied().fold(f64::INFINITY, f64::min),
            most: ratios.iter().copied().fold(0.0, f64::max),
            count: ratios.len(),
            median: median(&mut ratios),
        }
    }

    /// Maximum minus minimum, as a share of the median.
    pub fn spread(&self) -> f64 {
        (self.most - self.least) / self.median
    }

    /// Whether the median differs from 1 by more than the spread, see [`rule`]. It does for a time and its inverse alike.
    pub fn is_clear(&self) -> bool {
        let difference = self.median.ln().abs();
        self.count >= LEAST_ROUNDS
            && difference > LEAST_DIFFERENCE.ln_1p()
            && difference > (self.most / self.least).ln()
    }

    /// The quotient of two ratios to the same time of other rounds; its range has room for both spreads.
    pub fn over(&self, other: &Self) -> Self {
        Self {
            least: self.least / other.most,
            median: self.median / other.median,
            most: self.most / other.least,
            count: self.count.min(other.count),
        }
    }

    /// Where the ratio may lie; anywhere if there are too few rounds.
    pub fn range(&self) -> [f64; 2] {
        match self.count >= LEAST_ROUNDS {
            true => [self.least, self.most],
            false => [0.0, f64::INFINITY],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_clear(ratios: &[f64]) -> bool {
        let all = Ratios::new(ratios.iter().copied());
        let inverse = Ratios::new(ratios.iter().map(|ratio| 1.0 / ratio));
        assert_eq!(all.is_clear(), inverse.is_clear(), "{ratios:?}");
        all.is_clear()
    }

    #[test]
    fn differences_beyond_the_spread_are_clear() {
        assert!(is_clear(&[0.5, 0.52, 0.49]));
        assert!(is_clear(&[1.1, 1.11, 1.12]));
        assert!(is_clear(&[2.0, 2.4, 1.9, 2.1]));
    }

    #[test]
    fn differences_within_the_spread_are_not() {
        // All rounds agree, but by less than they differ among themselves.
        assert!(!is_clear(&[0.85, 0.9, 0.96]));
        assert!(!is_clear(&[0.5, 0.9, 1.4]));
        // Too small, whatever the spread.
        assert!(!is_clear(&[1.02, 1.02, 1.02]));
        // Too few rounds.
        assert!(!is_clear(&[0.5, 0.5]));
        assert!(!is_clear(&[]));
        assert!(!is_clear(&[f64::NAN, 0.5, 0.5, f64::NAN]));
    }

    #[test]
    fn quotients_have_room_for_both_spreads() {
        let half = Ratios::new([0.45, 0.5, 0.55].into_iter());
        let twice = Ratios::new([1.9, 2.0, 2.1].into_iter());
        let quotient = half.over(&twice);
        assert_eq!(quotient.median, 0.25);
        assert!(quotient.least < 0.22 && quotient.most > 0.28);
        assert!(quotient.is_clear() && !half.over(&half).is_clear());
        assert_eq!(Ratios::new([1.0].into_iter()).range(), [0.0, f64::INFINITY]);
    }
}
