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

/// A tree of known cost is rebuilt on trial at least once in so many frames with moved vertices.
///
/// A tree's cost tells how it wears, not what a new one would cost: where triangles shrink or part, a refitted tree's cost may
/// stay the same while a new tree's falls. The trial's tree replaces the refitted one, and its cost is the one that later
/// costs are compared with. If it is below `1 / MOST_COST` of the refitted tree's, the trial has paid; if not, it has cost the
/// time of a build, less that of a refit, once in 32 frames, and refits go on from there.
pub const TRIAL_FRAMES: u32 = 32;

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
///
/// With [`Update::Auto`] a frame with moved vertices refits the tree, unless a rebuild is due:
/// - the tree's cost is [`MOST_COST`] times what it was when built, or more;
/// - it is that many times smaller, or less: the scene has changed so much that the cost when built says nothing any more;
/// - the tree had no area when it was built or at its latest refit (a cost that is 0, infinite or not a number), as that over a
///   buffer of zeros;
/// - [`TRIAL_FRAMES`] − 1 refits have passed;
/// - the cost is unknown and [`MOST_REFITS`] refits have passed.
///
/// ```
/// use slimbvh::animate::{Action, Update, Upkeep};
/// use slimbvh::{BuildConfig, Builder, Bvh};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mut mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
/// let mut builder = Builder::new(BuildConfig::default());
/// let (mut upkeep, mut bvh) = (Upkeep::new(Update::Auto), Bvh::default());
/// for frame in 0..8 {
///     // Move vertices.
/// #   mesh.vertices[7][0] += 0.01;
///     match upkeep.next(true) {
///         Action::Rebuilt => drop(builder.build_into(&mesh, &mut bvh)?),
///         Action::Refitted => drop(builder.refit(&mesh, &mut bvh)?),
///         Action::Kept => {}
///     }
///     upkeep.measured(bvh.sah_cost());
/// }
/// # assert_eq!(upkeep.next(false), Action::Kept);
/// # Ok(())
/// # }
/// ```
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

    /// Whether a rebuild is due.
    fn is_worn(&self) -> bool {
        let has_area = |cost: f64| cost.is_finite() && cost > 0.0;
        match (self.cost_when_built, self.cost) {
            (Some(built), Some(now)) => {
                !has_area(built)
                    || !has_area(now)
                    || now >= MOST_COST * built
                    || now * MOST_COST <= built
                    || self.refit_count + 1 >= TRIAL_FRAMES
            }
            _ => self.refit_count >= MOST_REFITS,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Action::{Kept, Rebuilt, Refitted};
    use super::*;
    use crate::{BuildConfig, Builder, Bvh, Mesh};
    use proptest::prelude::*;

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
    fn a_tree_whose_cost_fell_is_rebuilt() {
        let mut upkeep = Upkeep::new(Update::Auto);
        assert_eq!(upkeep.next(true), Rebuilt);
        upkeep.measured(600.0);
        assert_eq!(upkeep.next(true), Refitted);
        upkeep.measured(501.0);
        assert_eq!(upkeep.next(true), Refitted);
        upkeep.measured(500.0);
        assert_eq!(upkeep.next(true), Rebuilt);
    }

    #[test]
    fn a_tree_without_area_is_rebuilt() {
        for cost in [0.0, f64::NAN, f64::INFINITY, -1.0] {
            let mut upkeep = Upkeep::new(Update::Auto);
            assert_eq!(upkeep.next(true), Rebuilt);
            upkeep.measured(cost);
            assert_eq!(upkeep.next(false), Kept);
            assert_eq!(upkeep.next(true), Rebuilt, "{cost}");
            upkeep.measured(50.0);
            assert_eq!(upkeep.next(true), Refitted);
            // In a frame in between, too.
            upkeep.measured(cost);
            assert_eq!(upkeep.next(true), Rebuilt, "{cost}");
        }
    }

    /// Triangles in one place, then at their own: the first tree's order is that of the indices.
    #[test]
    fn a_tree_of_a_collapsed_mesh_does_not_stay() {
        let mut state = 88_172_645_463_325_252_u64;
        let mut random = move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 40) as f32 / (1_u64 << 24) as f32
        };
        let mut real = Mesh::default();
        for i in 0..2000_u32 {
            let place = [random(), random(), random()];
            for _ in 0..3 {
                real.vertices.push(place.map(|x| x + 0.01 * random()));
            }
            real.indices.push([3 * i, 3 * i + 1, 3 * i + 2]);
        }
        let mut fresh = Builder::new(BuildConfig::default());
        let expected = fresh.build(&real).expect("the mesh is sound").sah_cost();
        // In a point, on a line, and apart by so little that boxes have a tiny area.
        let shapes: [fn([f32; 3]) -> [f32; 3]; 3] = [
            |_| [0.5; 3],
            |[x, ..]| [x, 0.0, 0.0],
            |p| p.map(|x| 0.5 + 1e-6 * x),
        ];
        for collapse in shapes {
            let mut collapsed = real.clone();
            collapsed
                .vertices
                .iter_mut()
                .for_each(|p| *p = collapse(*p));
            let mut builder = Builder::new(BuildConfig::default());
            let (mut upkeep, mut bvh) = (Upkeep::new(Update::Auto), Bvh::default());
            for frame in 0..4 {
                let mesh = if frame == 0 { &collapsed } else { &real };
                match upkeep.next(true) {
                    Rebuilt => drop(builder.build_into(mesh, &mut bvh).expect("it is sound")),
                    Refitted => drop(builder.refit(mesh, &mut bvh).expect("it is sound")),
                    Kept => {}
                }
                let cost = bvh.sah_cost();
                upkeep.measured(cost);
                assert!(
                    frame < 2 || cost <= MOST_COST * expected,
                    "frame {frame}: {cost}"
                );
            }
        }
    }

    /// Frames of one tree after the other, whose cost is that of a new tree times its wear. Returns the actions, and the wear
    /// in each frame.
    fn run(
        fresh: impl Iterator<Item = f64>,
        wear: f64,
        mut next: impl FnMut(Option<(f64, f64)>, u32) -> bool,
    ) -> Vec<f64> {
        let (mut worn, mut since, mut costs) = (1.0, 0, None);
        let mut all = Vec::new();
        for fresh in fresh {
            if next(costs, since) {
                (worn, since, costs) = (1.0, 0, None);
            } else {
                worn *= wear;
                since += 1;
            }
            let cost = fresh * worn;
            costs = Some((costs.map_or(cost, |(built, _)| built), cost));
            all.push(worn);
        }
        all
    }

    /// The longest run of frames whose tree costs more than 1.2 times a new one.
    fn longest_bad_run(wear: &[f64]) -> usize {
        let runs = wear.split(|&worn| worn <= MOST_COST);
        runs.map(<[f64]>::len).max().unwrap_or(0)
    }

    fn by_upkeep(upkeep: &mut Upkeep) -> impl FnMut(Option<(f64, f64)>, u32) -> bool {
        |costs, _| {
            if let Some((_, now)) = costs {
                upkeep.measured(now);
            }
            upkeep.next(true) == Rebuilt
        }
    }

    proptest! {
        /// However costs move, no tree is worse than 1.2 times a new one for 32 frames. If a new tree's cost stays the same,
        /// no tree is for two.
        #[test]
        fn bad_trees_do_not_stay(fresh in proptest::collection::vec(1.0f64..1e4, 100..200), wear in 1.0f64..2.0) {
            let mut upkeep = Upkeep::new(Update::Auto);
            let all = run(fresh.iter().copied(), wear, by_upkeep(&mut upkeep));
            prop_assert!(longest_bad_run(&all) < TRIAL_FRAMES as usize);
            let mut upkeep = Upkeep::new(Update::Auto);
            let all = run(fresh.iter().map(|_| 50.0), wear, by_upkeep(&mut upkeep));
            prop_assert!(longest_bad_run(&all) < 2);
        }
    }

    /// The control: costs of new trees that fall as fast as the tree wears are noticed by the trial alone.
    #[test]
    fn without_trials_a_bad_tree_stays() {
        let fresh = || (0..200).map(|frame| 1e9 * 0.95_f64.powi(frame));
        let by_cost = |costs: Option<(f64, f64)>, _| {
            costs.is_none_or(|(built, now)| now >= MOST_COST * built)
        };
        let without = run(fresh(), 1.0 / 0.95, by_cost);
        assert!(longest_bad_run(&without) > 190);
        let mut upkeep = Upkeep::new(Update::Auto);
        let with = run(fresh(), 1.0 / 0.95, by_upkeep(&mut upkeep));
        assert_eq!(longest_bad_run(&with), TRIAL_FRAMES as usize - 1 - 3);
        assert_eq!(
            with.iter().filter(|&&worn| worn == 1.0).count(),
            200_usize.div_ceil(32)
        );
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
