//! A plan's trees on the CPU.

use super::plan::Plan;
use super::{Aim, AimKind, Choice};
use crate::animate::Action;
use crate::{Builder, Bvh, Mesh, MeshError, RefitError, Stages, Subset, Tree, Trees, Turns};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// The trees of a plan, whose memory the next plan's use again.
#[derive(Debug, Default)]
pub struct Hierarchies {
    whole: Bvh,
    /// Whether the whole tree is that of the mesh as it is.
    has_whole: bool,
    /// As many as there are aims, or more.
    sets: Vec<Bvh>,
    /// What each of these is of the mesh as it is.
    built: Vec<Option<SetKey>>,
    /// The set whose turn it is.
    turn: Bvh,
}

/// What a set depends on besides the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SetKey {
    target: Target,
    frustum: Frustum,
    sides: Vec<i32>,
}

impl SetKey {
    pub(super) fn of(aim: &Aim) -> Self {
        Self {
            target: aim.target,
            frustum: aim.frustum,
            sides: aim.sides.clone(),
        }
    }
}

impl Hierarchies {
    /// None yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Builds what a plan for this mesh asks for: one sort, and a tree for each of its sets. Returns the time of each stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn build(
        &mut self,
        builder: &mut Builder,
        mesh: &Mesh,
        plan: &Plan,
    ) -> Result<Stages, MeshError> {
        self.forget();
        if plan.sorts_alone {
            self.make_room(plan);
            let mut chosen = plan.aims.iter().zip(&mut self.sets);
            return match chosen.find(|(aim, _)| aim.choice == Choice::Set) {
                Some((aim, bvh)) => builder.build_subset(mesh, subset(plan, aim), bvh),
                None => Ok(Stages::default()),
            };
        }
        let mut stages = builder.sort(mesh)?;
        stages.merge(&self.fill(builder, mesh, plan));
        Ok(stages)
    }

    /// Brings trees up to date for the next frame of the same mesh: builds them anew, keeps their order where vertices moved
    /// a little, or where none moved builds only those whose rays have moved or that are not there. The builder must have
    /// served these trees last. Returns the time of each stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`], and for another mesh than the last.
    pub fn update(
        &mut self,
        builder: &mut Builder,
        mesh: &Mesh,
        plan: &Plan,
        action: Action,
    ) -> Result<Stages, RefitError> {
        let mut stages = match action {
            Action::Rebuilt => return Ok(self.build(builder, mesh, plan)?),
            Action::Refitted => {
                let had_whole = std::mem::take(&mut self.has_whole);
                self.forget();
                let mut stages = builder.follow(mesh)?;
                if had_whole && plan.needs_whole {
                    stages.merge(&builder.refit(mesh, &mut self.whole)?);
                    self.has_whole = true;
                }
                stages
            }
            Action::Kept => Stages::default(),
        };
        stages.merge(&self.fill(builder, mesh, plan));
        Ok(stages)
    }

    fn forget(&mut self) {
        self.has_whole = false;
        self.built.clear();
    }

    fn make_room(&mut self, plan: &Plan) {
        let count = plan.aims.len().max(self.sets.len());
        self.sets.resize_with(count, Bvh::default);
        self.built.resize_with(count, || None);
    }

    /// Builds what is not there.
    fn fill(&mut self, builder: &mut Builder, mesh: &Mesh, plan: &Plan) -> Stages {
        self.make_room(plan);
        let mut stages = Stages::default();
        if plan.needs_whole && !self.has_whole {
            stages.merge(&builder.build_sorted(mesh, Subset::All, &mut self.whole));
            self.has_whole = true;
        }
        let sets = self.sets.iter_mut().zip(&mut self.built);
        for (aim, (bvh, built)) in plan.aims.iter().zip(sets) {
            let key = SetKey::of(aim);
            if has_own_place(plan, aim) && built.as_ref() != Some(&key) {
                stages.merge(&builder.build_sorted(mesh, subset(plan, aim), bvh));
                *built = Some(key);
            }
        }
        stages
    }

    /// What a renderer takes, after [`Self::build`] with the same plan: the trees that are there, and those that are built in
    /// their turn.
    #[must_use]
    pub fn split<'a>(
        &'a mut self,
        builder: &'a mut Builder,
        mesh: &'a Mesh,
        plan: &'a Plan,
    ) -> (Trees<'a>, InTurn<'a>) {
        let Self {
            whole, sets, turn, ..
        } = self;
        let turns = InTurn {
            plan,
            aims: plan.aim_of_light(),
            builder,
            mesh,
            bvh: turn,
            built: None,
            done: Done::default(),
        };
        (trees(whole, sets, plan), turns)
    }

    /// All trees of a plan that builds none in turn, after [`Self::build`] with it.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> Trees<'a> {
        trees(&self.whole, &self.sets, plan)
    }

    /// The tree of each aim that has its own.
    pub fn sets<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = (&'a Aim, &'a Bvh)> {
        let sets = plan.aims.iter().zip(&self.sets);
        sets.filter(|(aim, _)| has_own_place(plan, aim))
    }

    /// Bytes of all memory that is held for trees.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let all = self.sets.iter().chain([&self.whole, &self.turn]);
        all.map(Bvh::held_bytes).sum()
    }

    /// All trees that a plan had built.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a Bvh> {
        let whole = plan.needs_whole.then_some(&self.whole);
        whole.into_iter().chain(self.sets(plan).map(|(_, set)| set))
    }
}

/// Whether an aim's set is there from the beginning.
pub(super) fn has_own_place(plan: &Plan, aim: &Aim) -> bool {
    aim.choice == Choice::Set && !(plan.in_turn && aim.kind == AimKind::Lights)
}

/// The trees that are there; another one stands where a tree is built in its turn, and where there are no rays.
fn trees<'a>(whole: &'a Bvh, sets: &'a [Bvh], plan: &'a Plan) -> Trees<'a> {
    let tree = |(aim, set): (&'a Aim, &'a Bvh)| match aim.choice {
        Choice::Set => has_own_place(plan, aim).then_some(Tree::all(set)),
        Choice::Whole => Some(Tree {
            bvh: whole,
            rule: plan.topology.map(|_| (sides(plan, aim), aim.target)),
        }),
        Choice::Unused => None,
    };
    let trees: Vec<Option<Tree>> = plan.aims.iter().zip(sets).map(tree).collect();
    let primary = trees.first().copied().flatten();
    let primary = primary.unwrap_or(Tree::all(whole));
    let lights = plan.aim_of_light().into_iter();
    let lights = lights.map(|place| trees[place].unwrap_or(Tree::all(primary.bvh)));
    Trees {
        primary,
        lights: lights.collect(),
        mirrors: plan.has_mirrors.then_some(whole),
    }
}

/// The sets of lights that a plan builds in turn.
#[derive(Debug)]
pub struct InTurn<'a> {
    plan: &'a Plan<'a>,
    /// The place among the aims of each light.
    aims: Vec<usize>,
    builder: &'a mut Builder,
    mesh: &'a Mesh,
    bvh: &'a mut Bvh,
    /// The aim whose set is there.
    built: Option<usize>,
    done: Done,
}

/// What was built in turn.
#[derive(Clone, Debug, Default)]
pub struct Done {
    /// Time of each stage.
    pub stages: Stages,
    /// The place among the plan's aims of each set that was built, and how many nodes and triangles it had.
    pub sets: Vec<(usize, [usize; 2])>,
}

impl InTurn<'_> {
    /// What was built.
    #[must_use]
    pub fn done(self) -> Done {
        self.done
    }
}

impl Turns for InTurn<'_> {
    fn is_due(&self, light: usize) -> bool {
        let place = self.aims[light];
        let aim = &self.plan.aims[place];
        let is_in_turn = aim.choice == Choice::Set && !has_own_place(self.plan, aim);
        is_in_turn && self.built != Some(place) && !self.plan.builds_unseen
    }

    fn take(&mut self, light: usize) -> Option<&Bvh> {
        let place = self.aims[light];
        let aim = &self.plan.aims[place];
        if aim.choice != Choice::Set || has_own_place(self.plan, aim) {
            return None;
        }
        if self.built != Some(place) {
            let subset = subset(self.plan, aim);
            let stages = self.builder.build_sorted(self.mesh, subset, self.bvh);
            self.done.stages.merge(&stages);
            let counts = [self.bvh.node_count(), self.bvh.triangle_count()];
            self.done.sets.push((place, counts));
            self.built = Some(place);
        }
        Some(self.bvh)
    }
}

/// What is in an aim's set.
fn subset<'a>(plan: &Plan<'a>, aim: &'a Aim) -> Subset<'a> {
    Subset::Of(VisibleSet {
        sides: sides(plan, aim),
        target: aim.target,
        frustum: aim.frustum,
    })
}

/// Which sides of which components count for an aim.
fn sides<'a>(plan: &Plan<'a>, aim: &'a Aim) -> Sides<'a> {
    Sides {
        components: plan.components(),
        sides: &aim.sides,
    }
}
