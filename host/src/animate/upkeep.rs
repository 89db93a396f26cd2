//! The upkeep of a tree: rebuild, refit or keep.

/// A refitted tree is rebuilt once its cost is this many times the cost when it was built.
///
/// Let g be the growth of the cost per frame and r = (build − refit) / trace in time. Rebuilding every m frames loses `r/m`
/// of a frame to building and `g m / 2` to slower tracing. The sum is least when the cost has grown to `1 + √(2 g r)`. For
/// a dragon twisted in 48 frames g is 2 % and r is 1 on two cores: 1.2.
pub const MOST_COST: f64 = 1.2;

/// Refits between two rebuilds if the cost is unknown, because nothing is read back from a GPU. One rebuild in eight frames
/// costs little beside eight pictures, and no tree degrades for long.
pub const MOST_REFITS: u32 = 7;

/// How a tree follows its scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Update {
    /// Rebuild in every frame.
    Rebuild,
    /// Build in the first frame and refit in all others.
    Refit,
    /// Keep the tree if no vertex moved; else refit it while it is good, or rebuild it.
    #[default]
    Auto,
}

/// The update of a tree in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Built anew.
    Rebuilt,
    /// Boxes refitted.
    Refitted,
    /// Unchanged.
    Kept,
}

/// Chooses the update of a tree from frame to frame. The pictures do not depend on the choice.
#[derive(Clone, Debug, Default)]
pub struct Upkeep {
    update: Update,
    is_built: bool,
    refit_count: u32,
    cost_when_built: Option<f64>,
    cost: Option<f64>,
}

impl Upkeep {
    /// For a tree that is not built yet.
    #[must_use]
    pub fn new(update: Update) -> Self {
        Self {
            update,
            ..Self::default()
        }
    }

    /// The next action, which the caller must perform. `vertices_moved` since the previous frame.
    pub fn next(&mut self, vertices_moved: bool) -> Action {
        let action = match self.update {
            _ if !self.is_built => Action::Rebuilt,
            Update::Rebuild => Action::Rebuilt,
            Update::Refit => Action::Refitted,
            Update::Auto if !vertices_moved => Action::Kept,
            Update::Auto if self.is_worn() => Action::Rebuilt,
            Update::Auto => Action::Refitted,
        };
        match action {
            Action::Rebuilt => {
                self.is_built = true;
                self.refit_count = 0;
                (self.cost_when_built, self.cost) = (None, None);
            }
            Action::Refitted => self.refit_count += 1,
            Action::Kept => {}
        }
        action
    }

    /// Reports the tree's present [cost](crate::sah_cost). It affects the next frame.
    pub fn measured(&mut self, cost: f64) {
        if self.refit_count == 0 {
            self.cost_when_built = Some(cost);
        }
        self.cost = Some(cost);
    }

    /// Whether tracing has slowed so much that a rebuild pays.
    fn is_worn(&self) -> bool {
        match (self.cost_when_built, self.cost) {
            (Some(built), Some(now)) => now >= MOST_COST * built,
            _ => self.refit_count >= MOST_REFITS,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Action::{Kept, Rebuilt, Refitted};
    use super::*;

    #[test]
    fn forced_updates_do_as_they_are_told() {
        for (update, expected) in [
            (Update::Rebuild, [Rebuilt, Rebuilt, Rebuilt]),
            (Update::Refit, [Rebuilt, Refitted, Refitted]),
            (Update::Auto, [Rebuilt, Kept, Refitted]),
        ] {
            let mut upkeep = Upkeep::new(update);
            assert_eq!(
                [false, false, true].map(|moved| upkeep.next(moved)),
                expected
            );
        }
    }

    #[test]
    fn a_worn_tree_is_rebuilt_in_the_next_frame_that_moves() {
        let mut upkeep = Upkeep::new(Update::Auto);
        assert_eq!(upkeep.next(true), Rebuilt);
        upkeep.measured(50.0);
        for cost in [55.0, 48.0, 59.9, 60.0] {
            assert_eq!(upkeep.next(true), Refitted);
            upkeep.measured(cost);
        }
        assert_eq!(upkeep.next(false), Kept);
        assert_eq!(upkeep.next(true), Rebuilt);
        // From now on the new tree's cost counts.
        upkeep.measured(80.0);
        assert_eq!(upkeep.next(true), Refitted);
        upkeep.measured(95.0);
        assert_eq!(upkeep.next(true), Refitted);
    }

    #[test]
    fn without_a_cost_refits_are_counted() {
        let mut upkeep = Upkeep::new(Update::Auto);
        let actions: Vec<Action> = (0..17).map(|_| upkeep.next(true)).collect();
        for (frame, &action) in actions.iter().enumerate() {
            assert_eq!(action == Rebuilt, frame % 8 == 0, "{frame}");
        }
    }
}
