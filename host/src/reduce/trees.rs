//! A plan's trees, on any backend.

use super::plan::Plan;
use super::{SetMemory, TargetKind, TreeChoice, ViewSet};
use crate::animate::Action;
use crate::backend::{
    Backend, Deferral, DeferredTrees, SetNeed, Source, TargetSet, TargetSides, Tree, TreeOf,
};

/// The trees of a plan. The next plan's trees reuse their memory.
#[derive(Debug)]
pub struct Hierarchies<B: Backend> {
    whole: B::Bvh,
    /// Whether the whole tree matches the present mesh.
    has_whole: bool,
    /// One entry a target, or more.
    sets: Vec<OwnSet<B>>,
    /// The set of the light traced now, if sets are deferred.
    deferred: B::Bvh,
    /// Whether the latest sort was of the only set's triangles alone, so that no other tree can follow from it.
    has_sorted_alone: bool,
    /// Whether the memory of sets follows their counts, beside the whole tree.
    follows: bool,
    /// Whether it did so until a plan did not need the whole tree.
    has_wavered: bool,
    /// Whether vertices have moved since the builder took their positions: a whole tree is refitted without that.
    is_order_stale: bool,
}

/// A target's own set.
#[derive(Debug)]
struct OwnSet<B: Backend> {
    bvh: B::Bvh,
    sides: B::TargetSides,
    /// The sides for which the tree was built over the present mesh; `None` if it is out of date.
    key: Option<TargetSides>,
}

impl<B: Backend> Default for OwnSet<B> {
    fn default() -> Self {
        Self {
            bvh: B::Bvh::default(),
            sides: B::TargetSides::default(),
            key: None,
        }
    }
}

impl<B: Backend> Default for Hierarchies<B> {
    fn default() -> Self {
        Self {
            whole: B::Bvh::default(),
            has_whole: false,
            sets: Vec::new(),
            deferred: B::Bvh::default(),
            has_sorted_alone: false,
            follows: false,
            has_wavered: false,
            is_order_stale: false,
        }
    }
}

/// The inputs of builds.
pub(crate) struct Work<'a, 'm, B: Backend> {
    /// The frame that records the builds.
    pub recording: &'a mut B::Recording,
    /// The builder that served these trees last.
    pub builder: &'a mut B::Builder,
    /// The geometry as the backend holds it.
    pub held: &'a mut B::Held,
    /// The caller's geometry.
    pub geometry: B::Geometry<'m>,
    /// How much memory sets have.
    pub memory: SetMemory,
}

impl<'m, B: Backend> Work<'_, 'm, B> {
    /// The parts, borrowed for a build.
    fn split(&mut self) -> (&mut B::Recording, &mut B::Builder, Source<'_, 'm, B>) {
        let source = Source {
            held: self.held,
            geometry: self.geometry,
        };
        (self.recording, self.builder, source)
    }
}

impl<B: Backend> Hierarchies<B> {
    /// Updates the trees for a plan, and returns how. If vertices moved, sorts and builds all trees, or refits them in their existing order
    /// after small movements. If none moved, builds only the trees that are missing or whose rays moved.
    pub(crate) fn update(
        &mut self,
        work: &mut Work<B>,
        plan: &Plan,
        action: Action,
    ) -> Result<Action, B::Error> {
        let action = if self.lay_out(work, plan)? {
            Action::Rebuilt
        } else {
            action
        };
        let decides = B::decides(work.held);
        // Sets need their order kept. A whole tree can be refitted without it.
        let is_kept = match action {
            _ if self.has_sorted_alone || B::must_measure(work.held) => false,
            // Where the backend decides, the sets of lights may depend on the eye.
            Action::Kept => !(decides && plan.may_turn_away && plan.sets.len() > 1),
            Action::Refitted => {
                let keeps_order = plan.is_plain() || B::KEEPS_ORDER;
                let can_refit = !self.has_whole || B::can_refit(work.builder, &self.whole);
                !decides && keeps_order && can_refit
            }
            Action::Rebuilt => true,
        };
        let action = if is_kept { action } else { Action::Rebuilt };
        match action {
            Action::Rebuilt => {
                self.forget();
                self.is_order_stale = false;
                self.has_sorted_alone = plan.sorts_alone && B::SORTS_SETS_ALONE;
                if self.has_sorted_alone {
                    self.build_alone(work, plan)?;
                    return Ok(action);
                }
                let (recording, builder, source) = work.split();
                B::sort(recording, builder, source)?;
                B::measure(work.recording, work.builder, work.held)?;
            }
            Action::Refitted => self.refit(work, plan)?,
            Action::Kept if self.is_order_stale && !plan.is_plain() => {
                let (recording, builder, source) = work.split();
                B::follow(recording, builder, source)?;
                self.is_order_stale = false;
            }
            Action::Kept => {}
        }
        self.build_missing(work, plan)?;
        Ok(action)
    }

    fn forget(&mut self) {
        self.has_whole = false;
        for set in &mut self.sets {
            set.key = None;
        }
    }

    /// Lays out the memory of all trees. Returns whether all are built anew.
    fn lay_out(&mut self, work: &mut Work<B>, plan: &Plan) -> Result<bool, B::Error> {
        self.make_room(plan);
        let is_recent = work.memory.is_recent(plan.triangle_count);
        let follows = is_recent && plan.needs_whole && !self.has_wavered;
        // A plan that needs the whole tree now and then must not lay out all memory each time.
        self.has_wavered |= self.follows && !follows;
        self.follows = follows;
        let need = |place: usize| match plan.sets.get(place) {
            _ if !follows => SetNeed::All,
            Some(set) if has_own_place(plan, set) => SetNeed::Share(set.share),
            _ => SetNeed::Nothing,
        };
        let sets = self.sets.iter_mut().enumerate();
        let mut sets: Vec<_> = sets
            .map(|(place, set)| (&mut set.bvh, need(place)))
            .collect();
        let (recording, builder, source) = work.split();
        B::lay_out(recording, builder, source, &mut self.whole, &mut sets)
    }

    fn make_room(&mut self, plan: &Plan) {
        let count = plan.sets.len().max(self.sets.len());
        self.sets.resize_with(count, OwnSet::default);
    }

    /// Refits the whole tree, and makes the order of triangles follow for all other trees.
    fn refit(&mut self, work: &mut Work<B>, plan: &Plan) -> Result<(), B::Error> {
        let had_whole = std::mem::take(&mut self.has_whole);
        self.forget();
        let (recording, builder, source) = work.split();
        self.is_order_stale = had_whole && plan.is_plain();
        if !self.is_order_stale {
            B::follow(recording, builder, source)?;
        }
        if had_whole && plan.needs_whole {
            B::refit(recording, builder, source, &mut self.whole)?;
            self.has_whole = true;
        }
        Ok(())
    }

    /// Builds the only set.
    fn build_alone(&mut self, work: &mut Work<B>, plan: &Plan) -> Result<(), B::Error> {
        self.make_room(plan);
        let (recording, builder, source) = work.split();
        let mut chosen = plan.sets.iter().zip(&mut self.sets);
        let chosen = chosen.find(|(target, _)| target.choice == TreeChoice::Set);
        let components = B::components(source.held, plan.components());
        if let (Some((target, OwnSet { bvh, sides, .. })), Some(components)) = (chosen, components)
        {
            B::set_sides(recording, source.held, &target.inputs(), None, sides)?;
            let set = TargetSet { components, sides };
            B::build_alone(recording, builder, source, &set, bvh)?;
        }
        Ok(())
    }

    /// Builds the missing trees, over sorted triangles.
    fn build_missing(&mut self, work: &mut Work<B>, plan: &Plan) -> Result<(), B::Error> {
        self.make_room(plan);
        let (recording, builder, source) = work.split();
        if plan.needs_whole && !self.has_whole {
            B::build_sorted(recording, builder, source, None, &mut self.whole)?;
            self.has_whole = true;
        }
        let Some(components) = B::components(source.held, plan.components()) else {
            return Ok(());
        };
        for (place, target) in plan.sets.iter().enumerate() {
            let (before, rest) = self.sets.split_at_mut(place);
            let [OwnSet { bvh, sides, key }, ..] = rest else {
                continue;
            };
            let wanted = target.inputs();
            if target.choice == TreeChoice::Unused || key.as_ref() == Some(&wanted) {
                continue;
            }
            let eye = before.first().map(|set| &set.sides);
            *key = None;
            B::set_sides(recording, source.held, &wanted, eye, sides)?;
            if has_own_place(plan, target) {
                let set = TargetSet { components, sides };
                B::build_sorted(recording, builder, source, Some(&set), bvh)?;
                *key = Some(wanted);
            }
        }
        if plan.defers_lights {
            B::reserve(recording, builder, source, &mut self.deferred)?;
        }
        Ok(())
    }

    /// What a renderer needs once the trees match the plan: the trees built, and those deferred.
    pub(crate) fn split<'a, 'm>(
        &'a mut self,
        builder: &'a mut B::Builder,
        source: Source<'a, 'm, B>,
        plan: &'a Plan,
    ) -> (Vec<TreeOf<'a, B>>, Deferred<'a, 'm, B>) {
        let Self {
            whole,
            sets,
            deferred,
            ..
        } = self;
        let (whole, sets) = (&*whole, sets.as_slice());
        let components = B::components(source.held, plan.components());
        let deferred = Deferred {
            plan,
            places: plan.set_of_target().into_iter().skip(1).collect(),
            sets,
            components,
            builder,
            source,
            bvh: deferred,
            built: None,
            sizes: Vec::new(),
        };
        (trees::<B>(whole, sets, components, plan), deferred)
    }

    /// All trees of a plan without deferred ones, once they match the plan.
    pub(crate) fn trees<'a>(&'a self, held: &'a B::Held, plan: &'a Plan) -> Vec<TreeOf<'a, B>> {
        let components = B::components(held, plan.components());
        trees::<B>(&self.whole, &self.sets, components, plan)
    }

    /// The tree of each target that has its own.
    pub fn sets<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = (&'a ViewSet, &'a B::Bvh)> {
        let sets = plan.sets.iter().zip(&self.sets);
        sets.filter(|(target, _)| has_own_place(plan, target))
            .map(|(target, set)| (target, &set.bvh))
    }

    /// All trees that a plan built, except deferred ones.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a B::Bvh> {
        let whole = plan.needs_whole.then_some(&self.whole);
        whole.into_iter().chain(self.sets(plan).map(|(_, set)| set))
    }

    /// The name and sides of each target that has rays.
    pub(crate) fn sides<'a>(&'a self, plan: &Plan) -> Vec<(String, &'a B::TargetSides)> {
        let targets = plan.sets.iter().zip(&self.sets);
        let used = targets.filter(|(target, _)| target.choice != TreeChoice::Unused);
        used.map(|(target, set)| (target.name(), &set.sides))
            .collect()
    }

    /// The whole tree, if it matches the present mesh.
    pub(crate) fn whole(&self) -> Option<&B::Bvh> {
        self.has_whole.then_some(&self.whole)
    }

    /// The whole tree, or what is in its place.
    pub(crate) fn whole_or_empty(&self) -> &B::Bvh {
        &self.whole
    }

    /// Bytes of memory held for trees.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        let sets = self.sets.iter().map(|set| &set.bvh);
        let all = sets.chain([&self.whole, &self.deferred]);
        all.map(B::held_bytes).sum()
    }
}

/// Whether a target's set is built before the picture, in its own memory.
fn has_own_place(plan: &Plan, target: &ViewSet) -> bool {
    target.choice == TreeChoice::Set && !(plan.defers_lights && target.kind == TargetKind::To)
}

/// The tree of each target that was built so far. The whole tree stands for deferred trees and for targets without rays.
fn trees<'a, B: Backend>(
    whole: &'a B::Bvh,
    sets: &'a [OwnSet<B>],
    components: Option<B::Components<'a>>,
    plan: &Plan,
) -> Vec<TreeOf<'a, B>> {
    let tree = |(target, set): (&ViewSet, &'a OwnSet<B>)| match target.choice {
        TreeChoice::Set => has_own_place(plan, target).then_some(Tree::all(&set.bvh)),
        TreeChoice::Whole => Some(Tree {
            bvh: whole,
            rule: components.map(|components| B::rule(components, &set.sides)),
        }),
        TreeChoice::Unused => None,
    };
    let trees: Vec<Option<Tree<_, _>>> = plan.sets.iter().zip(sets).map(tree).collect();
    let first = trees.first().copied().flatten();
    // Where the whole tree is not built, any other that is.
    let spare = first.filter(|_| !plan.needs_whole);
    let spare = spare.map_or(Tree::all(whole), |tree| Tree::all(tree.bvh));
    let of_set = |place: Option<usize>| match place {
        Some(place) => trees.get(place).copied().flatten().unwrap_or(spare),
        None => Tree::all(whole),
    };
    plan.set_of_target().into_iter().map(of_set).collect()
}

/// The sets of lights that a plan builds one after the other, in the same memory.
pub struct Deferred<'a, 'm, B: Backend> {
    plan: &'a Plan,
    /// The index of each light's set: a picture's targets are the camera, then the lights.
    places: Vec<Option<usize>>,
    sets: &'a [OwnSet<B>],
    components: Option<B::Components<'a>>,
    builder: &'a mut B::Builder,
    source: Source<'a, 'm, B>,
    bvh: &'a mut B::Bvh,
    /// The set in memory.
    built: Option<usize>,
    sizes: Vec<(usize, B::PendingSize)>,
}

impl<B: Backend> Deferred<'_, '_, B> {
    /// Each set that was built: its index among the plan's sets, and its size.
    pub fn sizes(self) -> Vec<(usize, B::PendingSize)> {
        self.sizes
    }
}

impl<B: Backend> DeferredTrees<B> for Deferred<'_, '_, B> {
    fn deferral(&self, light: usize) -> Deferral<'_, B> {
        let Some(place) = self.places.get(light).copied().flatten() else {
            return Deferral::Ready;
        };
        let target = &self.plan.sets[place];
        if target.choice != TreeChoice::Set || has_own_place(self.plan, target) {
            return Deferral::Ready;
        }
        // A recording backend cannot skip the build: another light of the same set may need it.
        let is_shared = B::RECORDS && target.targets.len() > 1;
        if self.plan.builds_unseen || is_shared || self.built == Some(place) {
            return Deferral::Always(self.bvh);
        }
        Deferral::IfReached(self.bvh, &self.sets[place].sides)
    }

    fn build(&mut self, recording: &mut B::Recording, light: usize) -> Result<&B::Bvh, B::Error> {
        let place = self.places.get(light).copied().flatten();
        let place = place.filter(|place| self.built != Some(*place));
        if let (Some(place), Some(components)) = (place, self.components) {
            let sides = &self.sets[place].sides;
            let set = TargetSet { components, sides };
            B::build_deferred(recording, self.builder, self.source, &set, self.bvh)?;
            let size = B::size_later(recording, self.bvh)?;
            self.sizes.push((place, size));
            self.built = Some(place);
        }
        Ok(self.bvh)
    }
}
