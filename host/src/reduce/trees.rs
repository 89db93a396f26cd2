//! A plan's trees, on any backend.

use super::plan::Plan;
use super::{TargetKind, TreeChoice, ViewTarget};
use crate::Mesh;
use crate::animate::Action;
use crate::backend::{
    Backend, Deferral, DeferredTrees, Source, TargetSet, TargetSides, Tree, Trees, TreesOf,
};

/// The trees of a plan, whose memory the next plan's use again.
#[derive(Debug)]
pub struct Hierarchies<B: Backend> {
    whole: B::Bvh,
    /// Whether the whole tree is that of the mesh as it is.
    has_whole: bool,
    /// As many as there are targets, or more.
    sets: Vec<OwnSet<B>>,
    /// The set of the light whose rays are traced now, where sets are built one after the other.
    deferred: B::Bvh,
}

/// What a target has of its own.
#[derive(Debug)]
struct OwnSet<B: Backend> {
    bvh: B::Bvh,
    sides: B::TargetSides,
    /// What the tree is of the mesh as it is.
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
        }
    }
}

/// What builds trees, and of what.
pub(crate) struct Work<'a, B: Backend> {
    /// The frame that builds are part of.
    pub recording: &'a mut B::Recording,
    /// It must have served these trees last.
    pub builder: &'a mut B::Builder,
    /// What the backend holds of the scene.
    pub held: &'a mut B::Scene,
    /// The mesh on the host.
    pub mesh: &'a Mesh,
}

impl<B: Backend> Work<'_, B> {
    /// The parts, to build with.
    fn split(&mut self) -> (&mut B::Recording, &mut B::Builder, Source<'_, B>) {
        let source = Source {
            held: self.held,
            mesh: self.mesh,
        };
        (self.recording, self.builder, source)
    }
}

impl<B: Backend> Hierarchies<B> {
    /// Brings trees up to date for a plan: sorts and builds them anew; keeps their order where vertices moved a little; or where
    /// none moved builds only those whose rays have moved or that are not there.
    pub(crate) fn update(
        &mut self,
        work: &mut Work<B>,
        plan: &Plan,
        action: Action,
    ) -> Result<(), B::Error> {
        let decides = B::decides(work.held);
        // An order is kept for sets; a whole tree needs none to be refitted.
        let keeps = |action| plan.is_plain() || B::KEEPS_ORDER || action != Action::Refitted;
        let action = match action {
            action if !decides && keeps(action) => action,
            _ => Action::Rebuilt,
        };
        match action {
            Action::Rebuilt => {
                self.forget();
                if plan.sorts_alone && B::SORTS_SETS_ALONE {
                    return self.build_alone(work, plan);
                }
                let (recording, builder, source) = work.split();
                B::sort(recording, builder, source)?;
                B::measure(work.recording, work.builder, work.held)?;
            }
            Action::Refitted => self.refit(work, plan)?,
            Action::Kept => {}
        }
        let built = self.build_missing(work, plan);
        if decides {
            // Nothing is known of what these sets are.
            self.forget();
        }
        built
    }

    fn forget(&mut self) {
        self.has_whole = false;
        for set in &mut self.sets {
            set.key = None;
        }
    }

    fn make_room(&mut self, plan: &Plan) {
        let count = plan.targets.len().max(self.sets.len());
        self.sets.resize_with(count, OwnSet::default);
    }

    /// Moves the whole tree's boxes, and has the order of triangles follow for all other trees.
    fn refit(&mut self, work: &mut Work<B>, plan: &Plan) -> Result<(), B::Error> {
        let had_whole = std::mem::take(&mut self.has_whole);
        self.forget();
        let (recording, builder, source) = work.split();
        if !had_whole || !plan.is_plain() {
            B::follow(recording, builder, source)?;
        }
        if had_whole && plan.needs_whole {
            B::refit(recording, builder, source, &mut self.whole)?;
            self.has_whole = true;
        }
        Ok(())
    }

    /// Builds the one set that there is.
    fn build_alone(&mut self, work: &mut Work<B>, plan: &Plan) -> Result<(), B::Error> {
        self.make_room(plan);
        let (recording, builder, source) = work.split();
        let mut chosen = plan.targets.iter().zip(&mut self.sets);
        let chosen = chosen.find(|(target, _)| target.choice == TreeChoice::Set);
        let components = B::components(source.held, plan.components());
        if let (Some((target, OwnSet { bvh, sides, .. })), Some(components)) = (chosen, components)
        {
            B::set_sides(recording, source.held, &target.sides(), None, sides)?;
            let set = TargetSet { components, sides };
            B::build_alone(recording, builder, source, &set, bvh)?;
        }
        Ok(())
    }

    /// Builds what is not there, over sorted triangles.
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
        for (place, target) in plan.targets.iter().enumerate() {
            let (before, rest) = self.sets.split_at_mut(place);
            let [OwnSet { bvh, sides, key }, ..] = rest else {
                continue;
            };
            let wanted = target.sides();
            if target.choice == TreeChoice::Unused || key.as_ref() == Some(&wanted) {
                continue;
            }
            let eye = before.first().map(|set| &set.sides);
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

    /// What a renderer takes, once trees are up to date with the same plan: those that are there, and those that are deferred.
    pub(crate) fn split<'a>(
        &'a mut self,
        builder: &'a mut B::Builder,
        source: Source<'a, B>,
        plan: &'a Plan,
    ) -> (TreesOf<'a, B>, Deferred<'a, B>) {
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
            places: plan.target_of_light(),
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

    /// All trees of a plan that defers none, once they are up to date with it.
    pub(crate) fn trees<'a>(&'a self, held: &'a B::Scene, plan: &'a Plan) -> TreesOf<'a, B> {
        let components = B::components(held, plan.components());
        trees::<B>(&self.whole, &self.sets, components, plan)
    }

    /// The tree of each target that has its own.
    pub fn sets<'a>(
        &'a self,
        plan: &'a Plan,
    ) -> impl Iterator<Item = (&'a ViewTarget, &'a B::Bvh)> {
        let sets = plan.targets.iter().zip(&self.sets);
        sets.filter(|(target, _)| has_own_place(plan, target))
            .map(|(target, set)| (target, &set.bvh))
    }

    /// All trees that a plan had built, but for deferred ones.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a B::Bvh> {
        let whole = plan.needs_whole.then_some(&self.whole);
        whole.into_iter().chain(self.sets(plan).map(|(_, set)| set))
    }

    /// Each target that has rays, by name, with its sides.
    pub(crate) fn sides<'a>(&'a self, plan: &Plan) -> Vec<(String, &'a B::TargetSides)> {
        let targets = plan.targets.iter().zip(&self.sets);
        let used = targets.filter(|(target, _)| target.choice != TreeChoice::Unused);
        used.map(|(target, set)| (target.name(), &set.sides))
            .collect()
    }

    /// The whole tree, if it is up to date.
    pub(crate) fn whole(&self) -> Option<&B::Bvh> {
        self.has_whole.then_some(&self.whole)
    }

    /// Bytes of all memory that is held for trees.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        let sets = self.sets.iter().map(|set| &set.bvh);
        let all = sets.chain([&self.whole, &self.deferred]);
        all.map(B::held_bytes).sum()
    }
}

/// Whether a target's set is there from the beginning.
fn has_own_place(plan: &Plan, target: &ViewTarget) -> bool {
    target.choice == TreeChoice::Set && !(plan.defers_lights && target.kind == TargetKind::Lights)
}

/// The trees that are there. Another tree stands where one is deferred, and where there are no rays.
fn trees<'a, B: Backend>(
    whole: &'a B::Bvh,
    sets: &'a [OwnSet<B>],
    components: Option<B::Components<'a>>,
    plan: &'a Plan,
) -> TreesOf<'a, B> {
    let tree = |(target, set): (&ViewTarget, &'a OwnSet<B>)| match target.choice {
        TreeChoice::Set => has_own_place(plan, target).then_some(Tree::all(&set.bvh)),
        TreeChoice::Whole => Some(Tree {
            bvh: whole,
            rule: components.map(|components| B::rule(components, &set.sides)),
        }),
        TreeChoice::Unused => None,
    };
    let trees: Vec<Option<Tree<_, _>>> = plan.targets.iter().zip(sets).map(tree).collect();
    let primary = trees.first().copied().flatten();
    let primary = primary.unwrap_or(Tree::all(whole));
    let lights = plan.target_of_light().into_iter();
    let lights = lights.map(|place| trees[place].unwrap_or(Tree::all(primary.bvh)));
    Trees {
        primary,
        lights: lights.collect(),
        mirrors: plan.has_mirrors.then_some(whole),
    }
}

/// The sets of lights that a plan builds one after the other, in the same memory.
pub struct Deferred<'a, B: Backend> {
    plan: &'a Plan<'a>,
    /// The place among the targets of each light.
    places: Vec<usize>,
    sets: &'a [OwnSet<B>],
    components: Option<B::Components<'a>>,
    builder: &'a mut B::Builder,
    source: Source<'a, B>,
    bvh: &'a mut B::Bvh,
    /// The target whose set is there.
    built: Option<usize>,
    sizes: Vec<(usize, B::PendingSize)>,
}

impl<B: Backend> Deferred<'_, B> {
    /// The place among the plan's targets of each set that was built, and its size.
    pub fn sizes(self) -> Vec<(usize, B::PendingSize)> {
        self.sizes
    }
}

impl<B: Backend> DeferredTrees<B> for Deferred<'_, B> {
    fn deferral(&self, light: usize) -> Deferral<'_, B> {
        let place = self.places[light];
        let target = &self.plan.targets[place];
        if target.choice != TreeChoice::Set || has_own_place(self.plan, target) {
            return Deferral::Ready;
        }
        // Where passes are recorded, another light of the same set may need it.
        let is_shared = B::RECORDS && target.lights.len() > 1;
        if self.plan.builds_unseen || is_shared || self.built == Some(place) {
            return Deferral::Always(self.bvh);
        }
        Deferral::IfReached(self.bvh, &self.sets[place].sides)
    }

    fn build(&mut self, recording: &mut B::Recording, light: usize) -> Result<&B::Bvh, B::Error> {
        let place = self.places[light];
        let components = self.components.filter(|_| self.built != Some(place));
        if let Some(components) = components {
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
