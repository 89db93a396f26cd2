//! Pareto dominance and the Pareto front.

use std::cmp::Ordering;

/// Whether `a` dominates `b`: it is at least as good in all objectives and better in one. Less is better; NaN is worst.
pub fn dominates(a: &[f64], b: &[f64]) -> bool {
    let pairs = || a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
    pairs().all(Ordering::is_le) && pairs().any(Ordering::is_lt)
}

/// The Pareto front: whether each point is dominated by no other. Equal points are all on the front, or none is.
pub fn front<P: AsRef<[f64]>>(points: &[P]) -> Vec<bool> {
    let is_on_front = |point: &P| {
        let others = &mut points.iter();
        !others.any(|other| dominates(other.as_ref(), point.as_ref()))
    };
    points.iter().map(is_on_front).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn of_five_points() {
        let points = [[1.0, 5.0], [2.0, 3.0], [2.0, 4.0], [4.0, 3.0], [5.0, 1.0]];
        assert_eq!(front(&points), [true, true, false, false, true]);
        assert_eq!(front(&[[1.0, 1.0], [1.0, 1.0]]), [true, true]);
        assert_eq!(front(&[[f64::NAN, 1.0], [7.0, 1.0]]), [false, true]);
        assert!(!dominates(&[1.0, 2.0], &[1.0, 2.0]) && !dominates(&[1.0, 2.0], &[2.0, 1.0]));
    }

    proptest! {
        /// No point of the front is dominated, and every other point is dominated by a point of the front.
        #[test]
        fn fronts_are_fronts(points in proptest::collection::vec([0u8..6, 0u8..6, 0u8..6], 0..24)) {
            let points: Vec<[f64; 3]> = points.iter().map(|p| p.map(f64::from)).collect();
            let on_front = front(&points);
            prop_assert_eq!(on_front.len(), points.len());
            for (point, is_on_front) in points.iter().zip(&on_front) {
                let pairs = points.iter().zip(&on_front);
                let is_dominated = pairs.filter(|(_, on)| **on).any(|(other, _)| dominates(other, point));
                prop_assert_eq!(is_dominated, !is_on_front);
            }
        }
    }
}
