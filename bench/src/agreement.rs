//! Compares the answers of two tracers.

use crate::Answer;

/// The allowed difference of two numbers of hits, as a share of the reference's.
pub const TOLERANCE: f64 = 1e-4;

/// The allowed relative difference of two distances.
const SAME_DISTANCE: f32 = 1e-3;

/// Counts of equal and different answers, ray by ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Agreement {
    /// Hits of the reference.
    pub expected_hits: usize,
    /// Hits of the other tracer.
    pub hits: usize,
    /// Rays that hit only for the reference.
    pub missed: usize,
    /// Rays that hit only for the other tracer.
    pub extra: usize,
    /// Rays that hit for both, at different distances.
    pub distance: usize,
}

impl Agreement {
    /// Compares closest hits.
    #[must_use]
    pub fn of_closest(expected: &[Answer], other: &[Answer]) -> Self {
        let mut agreement = Self::default();
        for (a, b) in expected.iter().zip(other) {
            agreement.add(a.is_hit(), b.is_hit());
            let apart = (a.t - b.t).abs() > a.t.abs() * SAME_DISTANCE;
            agreement.distance += usize::from(a.is_hit() && b.is_hit() && apart);
        }
        agreement
    }

    /// Compares answers to shadow rays.
    #[must_use]
    pub fn of_any(expected: &[bool], other: &[bool]) -> Self {
        let mut agreement = Self::default();
        for (&a, &b) in expected.iter().zip(other) {
            agreement.add(a, b);
        }
        agreement
    }

    /// Rays with different answers of any kind.
    #[must_use]
    pub fn disagreements(&self) -> usize {
        self.missed + self.extra + self.distance
    }

    /// Whether the numbers of hits are within [`TOLERANCE`].
    #[must_use]
    pub fn is_close(&self) -> bool {
        let apart = self.hits.abs_diff(self.expected_hits);
        apart as f64 <= self.expected_hits as f64 * TOLERANCE
    }

    fn add(&mut self, expected: bool, other: bool) {
        self.expected_hits += usize::from(expected);
        self.hits += usize::from(other);
        self.missed += usize::from(expected && !other);
        self.extra += usize::from(other && !expected);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_known_answers() {
        let at = |t| Answer { t, primitive: 5 };
        let expected = [at(1.0), at(2.0), Answer::MISS, at(3.0), Answer::MISS];
        let other = [at(1.0005), at(2.1), at(7.0), Answer::MISS, Answer::MISS];
        let agreement = Agreement::of_closest(&expected, &other);
        assert_eq!(agreement.expected_hits, 3);
        assert_eq!(agreement.hits, 3);
        assert_eq!((agreement.missed, agreement.extra), (1, 1));
        assert_eq!(agreement.distance, 1);
        assert_eq!(agreement.disagreements(), 3);
        assert!(agreement.is_close());
    }

    #[test]
    fn one_hit_in_ten_thousand_is_close_and_two_are_not() {
        let mut other = vec![true; 10_000];
        other[17] = false;
        assert!(Agreement::of_any(&[true; 10_000], &other).is_close());
        other[18] = false;
        assert!(!Agreement::of_any(&[true; 10_000], &other).is_close());
    }
}
