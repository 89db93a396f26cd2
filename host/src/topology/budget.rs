//! The budget of the search for seams.
//!
//! The search tests triangles whose boxes touch. In a surface without long, thin or crowded triangles these are a few dozen
//! for each triangle; in a fan of slivers around one corner, or in many copies at one place, all of them. The steps of the
//! search are counted, and a component whose search takes more steps than its budget stays whole. All budgets together are
//! proportional to the number of triangles, so that the search takes linear time at most.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Steps allowed for each triangle. The Stanford dragon takes 115, the armadillo 84, and a prism of 64 sides between two fans
/// 141.
pub(super) const STEPS_A_TRIANGLE: u64 = 512;

/// Smaller meshes get the budget of this many triangles.
const LEAST_TRIANGLES: usize = 1 << 14;

/// Steps of the exact test of two triangles. One step is a node opened, or a box compared.
pub(super) const PAIR_STEPS: u64 = 16;

/// Steps that a [`Meter`] counts by itself before it adds them to the sum.
const MOST_UNCOUNTED: u64 = 1 << 12;

/// The steps of a component's search.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spending {
    /// Steps taken; a lower bound if they exceed the budget.
    pub(super) steps: u64,
    /// Steps allowed.
    pub(super) budget: u64,
}

impl Spending {
    /// Whether the search was given up. Does not depend on the number of threads.
    pub(super) fn is_exceeded(&self) -> bool {
        self.steps > self.budget
    }
}

/// The steps of all components' searches, counted by many threads.
pub(super) struct Budget {
    allowed: Vec<u64>,
    taken: Vec<AtomicU64>,
}

impl Budget {
    /// Half of all steps go to the components by their numbers of triangles, the other half in equal parts, so that a small
    /// component among large ones can pass over the triangles of others. Among hundreds of components, one of few triangles
    /// whose boxes hold most of the scene may still be given up; little could be left out of it. A component without
    /// triangles is not searched.
    pub(super) fn new(triangle_counts: &[usize], steps_a_triangle: u64) -> Self {
        let total: usize = triangle_counts.iter().sum();
        let searched = triangle_counts.iter().filter(|&&count| count > 0).count();
        let equal = total.max(LEAST_TRIANGLES) / searched.max(1);
        let allowed = triangle_counts
            .iter()
            .map(|&count| (steps_a_triangle / 2).saturating_mul((count + equal) as u64))
            .collect();
        Self {
            allowed,
            taken: triangle_counts.iter().map(|_| AtomicU64::new(0)).collect(),
        }
    }

    /// Counts for one thread.
    pub(super) fn meter(&self) -> Meter<'_> {
        Meter {
            budget: self,
            component: 0,
            uncounted: 0,
        }
    }

    /// What a component's search has taken so far.
    pub(super) fn spending(&self, component: u32) -> Spending {
        Spending {
            steps: self.taken[component as usize].load(Relaxed),
            budget: self.allowed[component as usize],
        }
    }
}

/// Counts the steps of one thread.
pub(super) struct Meter<'a> {
    budget: &'a Budget,
    component: u32,
    uncounted: u64,
}

impl Meter<'_> {
    /// Counts for this component from now on. Returns whether its budget is not exceeded.
    pub(super) fn enter(&mut self, component: u32) -> bool {
        if component != self.component || self.uncounted > MOST_UNCOUNTED {
            self.flush();
            self.component = component;
        }
        !self.budget.spending(component).is_exceeded()
    }

    /// Counts steps.
    pub(super) fn add(&mut self, steps: u64) {
        self.uncounted += steps;
    }

    fn flush(&mut self) {
        let taken = self.budget.taken.get(self.component as usize);
        if let Some(taken) = taken.filter(|_| self.uncounted > 0) {
            taken.fetch_add(self.uncounted, Relaxed);
        }
        self.uncounted = 0;
    }
}

impl Drop for Meter<'_> {
    fn drop(&mut self) {
        self.flush();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn budgets_are_proportional_to_triangles() {
        let budgets = |counts: &[usize]| Budget::new(counts, 600).allowed;
        let half = 300;
        assert_eq!(budgets(&[100_000]), [half * 200_000]);
        // A small component gets an equal part of one half; one that is not searched gets nothing of it.
        assert_eq!(
            budgets(&[60_000, 12, 0]),
            [half * 90_006, half * 30_018, half * 30_006]
        );
        let least = LEAST_TRIANGLES as u64;
        assert_eq!(
            budgets(&[12, 20]),
            [half * (12 + least / 2), half * (20 + least / 2)]
        );
        assert!(budgets(&[]).is_empty());
    }

    #[test]
    fn every_step_is_counted_for_its_component() {
        let budget = Budget::new(&[12, 20_000, 0], 600);
        let mut meter = budget.meter();
        for (component, steps) in [(1, 7), (1, 9000), (0, 40), (1, 300)] {
            assert!(meter.enter(component));
            meter.add(steps);
        }
        drop(meter);
        let steps = [0, 1, 2].map(|component| budget.spending(component).steps);
        assert_eq!(steps, [40, 9307, 0]);

        // The step beyond the budget ends the search.
        let allowed = budget.spending(0).budget;
        let mut meter = budget.meter();
        assert!(meter.enter(0));
        meter.add(allowed - 40);
        assert!(meter.enter(0));
        assert!(!budget.spending(0).is_exceeded());
        meter.add(1);
        assert!(meter.enter(1));
        assert!(!meter.enter(0));
    }
}
