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

/// Whether each point would be on the front wherever within their ranges the values of all points lay. A range is the least and
/// the most that a value may be.
pub fn stays<const N: usize>(points: &[[[f64; 2]; N]]) -> Vec<bool> {
    let ends = |which: usize| -> Vec<[f64; N]> {
        let all = points.iter();
        all.map(|point| point.map(|range| range[which])).collect()
    };
    let (best, worst) = (ends(0), ends(1));
    let stays = |own: usize| {
        let mut others = best.iter().enumerate().filter(|(other, _)| *other != own);
        !others.any(|(_, other)| dominates(other, &worst[own]))
    };
    (0..points.len()).map(stays).collect()
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

    #[test]
    fn points_stay_if_no_range_reaches_past_them() {
        let exactly = |value: f64| [value, value];
        // The second is slower and smaller. The third is a bit faster than the first by the medians, but not for sure.
        let points = [
            [[0.98, 1.02], exactly(5.0)],
            [[2.0, 2.2], exactly(3.0)],
            [[0.95, 1.0], exactly(5.0)],
        ];
        assert_eq!(stays(&points), [false, true, false]);
        assert_eq!(stays(&points[..2]), [true, true]);
        // The same bytes, clearly faster.
        let faster = [[[0.5, 0.6], exactly(5.0)], [[0.9, 1.1], exactly(5.0)]];
        assert_eq!(stays(&faster), [true, false]);
        // Nothing is known of the time.
        let unknown = [
            [[0.0, f64::INFINITY], exactly(5.0)],
            [[0.9, 1.1], exactly(5.0)],
        ];
        assert_eq!(stays(&unknown), [false, false]);
    }

    proptest! {
        /// Without ranges the points that stay are those of the front.
        #[test]
        fn exact_points_stay_on_their_front(points in proptest::collection::vec([0u8..6, 0u8..6], 0..24)) {
            let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
            let ranges: Vec<_> = points.iter().map(|point| point.map(|value| [value; 2])).collect();
            prop_assert_eq!(stays(&ranges), front(&points));
        }

        /// Wherever within their ranges the values lie, a point that stays is on the front.
        #[test]
        fn points_that_stay_are_on_every_front(
            points in proptest::collection::vec([(0u8..6, 0u8..3), (0u8..6, 0u8..3)], 0..24),
            shares in proptest::collection::vec(0f64..=1.0, 48),
        ) {
            let ranges: Vec<[[f64; 2]; 2]> = points
                .iter()
                .map(|point| point.map(|(least, more)| [f64::from(least), f64::from(least + more)]))
                .collect();
            let mut shares = shares.into_iter();
            let somewhere: Vec<[f64; 2]> = ranges
                .iter()
                .map(|point| point.map(|[least, most]| least + shares.next().unwrap_or(0.5) * (most - least)))
                .collect();
            for (stays, is_there) in stays(&ranges).into_iter().zip(front(&somewhere)) {
                prop_assert!(is_there || !stays);
            }
        }

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
