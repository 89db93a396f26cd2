//! Grouping of lights that share a set.
//!
//! Nearby lights see almost the same triangles. One set for all of them keeps a triangle unless the ball around them is
//! certainly behind it (Wong, Cheng and Lii 2012, the rule with R). It is built once, but holds more triangles.

use super::set::{TreeChoice, ViewSet};
use slimbvh_core::orientation::Target;
use std::collections::BTreeSet;

/// The largest number of pairs tried, as a multiple of the number of lights.
const TRIES: usize = 4;

/// Merges targets of lights, nearest first, while one set costs less than two. `join` returns the target that both share,
/// or `None` if they cannot share one. `cost_ms` is the cost of building and tracing a set. Directional lights stay alone.
pub fn group(
    targets: Vec<ViewSet>,
    join: impl Fn(&ViewSet, &ViewSet) -> Option<ViewSet>,
    cost_ms: impl Fn(&ViewSet) -> f64,
) -> Vec<ViewSet> {
    let mut tries = TRIES * targets.len();
    let mut groups: Vec<(usize, ViewSet)> = targets.into_iter().enumerate().collect();
    let mut next = groups.len();
    let mut refused = BTreeSet::new();
    while let Some([a, b]) = nearest(&groups, &refused).filter(|_| tries > 0) {
        tries -= 1;
        let (first, second) = (&groups[a].1, &groups[b].1);
        let apart = cost_ms(first) + cost_ms(second);
        match join(first, second).filter(|joined| cost_ms(joined) < apart) {
            Some(joined) => {
                groups[a] = (next, joined);
                groups.remove(b);
                next += 1;
            }
            None => {
                refused.insert([groups[a].0, groups[b].0]);
            }
        }
    }
    groups.into_iter().map(|(_, view)| view).collect()
}

/// The indices of the two nearest groups of positional lights that were not refused, the lower first.
fn nearest(groups: &[(usize, ViewSet)], refused: &BTreeSet<[usize; 2]>) -> Option<[usize; 2]> {
    let is_lamp =
        |view: &ViewSet| view.choice != TreeChoice::Unused && view.target.is_position == 1;
    let mut best = None;
    for (b, (id_b, second)) in groups.iter().enumerate() {
        for (a, (id_a, first)) in groups[..b].iter().enumerate() {
            if is_lamp(first) && is_lamp(second) && !refused.contains(&[*id_a, *id_b]) {
                let distance = distance(first.target.point, second.target.point);
                if best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, [a, b]));
                }
            }
        }
    }
    best.map(|(_, pair)| pair)
}

/// The smallest ball around two balls; a radius of 0 is a point.
#[must_use]
pub fn joined_target(a: &Target, b: &Target) -> Target {
    let apart = distance(a.point, b.point);
    let (radius_a, radius_b) = (f64::from(a.radius), f64::from(b.radius));
    // One contains the other.
    if apart + radius_b <= radius_a {
        return *a;
    }
    if apart + radius_a <= radius_b {
        return *b;
    }
    let radius = 0.5 * (apart + radius_a + radius_b);
    let share = (radius - radius_a) / apart;
    let center = std::array::from_fn(|i| {
        let (a, b) = (f64::from(a.point[i]), f64::from(b.point[i]));
        (a + (b - a) * share) as f32
    });
    // Radii from the rounded center, rounded up.
    let reach_a = distance(center, a.point) + radius_a;
    let reach_b = distance(center, b.point) + radius_b;
    let radius = (reach_a.max(reach_b) * (1.0 + 1e-6)) as f32;
    Target::ball(center, radius)
}

fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
    let squared = |i: usize| (f64::from(a[i]) - f64::from(b[i])).powi(2);
    (squared(0) + squared(1) + squared(2)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reduce::set::tests::lamp;
    use proptest::prelude::*;

    fn ball() -> impl Strategy<Value = Target> {
        let point = proptest::array::uniform3(-100f32..100.0);
        (point, prop_oneof![Just(0.0), 0f32..80.0])
            .prop_map(|(center, radius)| Target::ball(center, radius))
    }

    proptest! {
        #[test]
        fn a_joined_ball_holds_both_and_is_no_larger_than_it_must(a in ball(), b in ball()) {
            let joined = joined_target(&a, &b);
            let (radius, apart) = (f64::from(joined.radius), distance(a.point, b.point));
            for part in [a, b] {
                prop_assert!(distance(joined.point, part.point) + f64::from(part.radius) <= radius + 1e-9);
            }
            let [ra, rb] = [a, b].map(|part| f64::from(part.radius));
            let least = (0.5 * (apart + ra + rb)).max(ra).max(rb);
            prop_assert!(radius <= least * (1.0 + 1e-5) + 1e-4);
        }
    }

    /// With costs of 5 for each set plus the cube of the ball's radius, near lamps merge and far ones do not.
    #[test]
    fn lamps_come_together_while_it_pays() {
        let join =
            |a: &ViewSet, b: &ViewSet| Some(a.joined(b, joined_target(&a.target, &b.target)));
        let places = [0.0, 1.0, 9.0, 2.0, 10.0, 50.0];
        let lamps: Vec<ViewSet> = places
            .iter()
            .enumerate()
            .map(|(i, &x)| lamp(i, Target::position([x, 0.0, 0.0])))
            .collect();
        let cost = |view: &ViewSet| 5.0 + f64::from(view.target.radius).powi(3);
        let lights = |groups: &[ViewSet]| -> Vec<Vec<usize>> {
            groups.iter().map(|view| view.targets.clone()).collect()
        };
        let groups = group(lamps.clone(), join, cost);
        assert_eq!(lights(&groups), [vec![0, 1, 3], vec![2, 4], vec![5]]);
        // A refused pair stays apart, and directional lights are not tried.
        let groups = group(lamps.clone(), |_, _| None, cost);
        assert_eq!(groups, lamps);
        let suns = lamps.into_iter().map(|mut view| {
            view.target = Target::direction([0.0, 1.0, 0.0]);
            view
        });
        let groups = group(suns.collect(), join, |_| 0.0);
        assert_eq!(groups.len(), places.len());
    }
}
