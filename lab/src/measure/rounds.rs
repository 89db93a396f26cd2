//! Repeated measurements.

pub use slimbvh_cli::median;

use serde::Serialize;

/// The measurements of each round. Everything to be compared is measured within each round, so that a slowdown of the
/// machine affects all of it.
#[derive(Clone, Debug, Default, Serialize)]
#[serde(transparent)]
pub struct Rounds<T>(pub Vec<T>);

impl<T> Rounds<T> {
    /// The median over rounds; NaN without rounds.
    pub fn median(&self, of: impl Fn(&T) -> f64) -> f64 {
        median(&mut self.0.iter().map(of).collect::<Vec<_>>())
    }

    /// Maximum minus minimum, as a share of the median.
    pub fn spread(&self, of: impl Fn(&T) -> f64) -> f64 {
        let mut values: Vec<f64> = self.0.iter().map(of).collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(0.0, f64::max);
        (most - least) / median(&mut values)
    }

    /// The median over rounds of the ratio to another measurement of the same round.
    pub fn ratio<U>(
        &self,
        of: impl Fn(&T) -> f64,
        others: &Rounds<U>,
        of_other: impl Fn(&U) -> f64,
    ) -> f64 {
        let pairs = self.0.iter().zip(&others.0);
        median(&mut pairs.map(|(a, b)| of(a) / of_other(b)).collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_and_spreads_of_known_values() {
        let rounds = Rounds(vec![9.0, 1.0, 4.0]);
        assert_eq!((rounds.median(|x| *x), rounds.spread(|x| *x)), (4.0, 2.0));
        assert_eq!(Rounds(vec![9.0, 1.0, 4.0, 5.0]).median(|x| x * 2.0), 9.0);
        assert!(Rounds::<f64>::default().median(|x| *x).is_nan());
    }

    #[test]
    fn ratios_are_taken_round_by_round() {
        let slowed_once = Rounds(vec![2.0, 20.0, 3.0]);
        let other = Rounds(vec![1.0, 10.0, 2.0]);
        assert_eq!(slowed_once.ratio(|x| *x, &other, |x| *x), 2.0);
    }
}
