//! A plan's trees on the CPU.

use super::plan::Plan;
use super::{Aim, Choice};
use crate::{Builder, Bvh, Mesh, MeshError, Stages, Subset, Tree, Trees};
use slimbvh_core::classify::{Reach, Sides};

/// The trees of a plan, whose memory the next plan's use again.
#[derive(Debug, Default)]
pub struct Hierarchies {
    whole: Bvh,
    /// As many as there are aims, or more.
    sets: Vec<Bvh>,
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
        let missing = plan.aims.len().saturating_sub(self.sets.len());
        self.sets.extend((0..missing).map(|_| Bvh::default()));
        let mut sets = plan.aims.iter().zip(&mut self.sets);
        if plan.sorts_alone {
            let mut chosen = sets.filter(|(aim, _)| aim.choice == Choice::Set);
            return match chosen.next() {
                Some((aim, bvh)) => builder.build_subset(mesh, subset(plan, aim), bvh),
                None => Ok(Stages::default()),
            };
        }
        let mut stages = builder.sort(mesh)?;
        if plan.needs_whole {
            stages.merge(&builder.build_sorted(mesh, Subset::All, &mut self.whole));
        }
        for (aim, bvh) in sets.by_ref() {
            if aim.choice == Choice::Set {
                stages.merge(&builder.build_sorted(mesh, subset(plan, aim), bvh));
            }
        }
        Ok(stages)
    }

    /// What a renderer takes, after [`Self::build`] with the same plan.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> Trees<'a> {
        let tree = |(aim, set): (&'a Aim, &'a Bvh)| match aim.choice {
            Choice::Set => Some(Tree::all(set)),
            Choice::Whole => Some(Tree {
                bvh: &self.whole,
                rule: plan.topology.map(|_| (sides(plan, aim), aim.target)),
            }),
            Choice::Unused => None,
        };
        let trees: Vec<Option<Tree>> = plan.aims.iter().zip(&self.sets).map(tree).collect();
        let primary = trees.first().copied().flatten();
        let primary = primary.unwrap_or(Tree::all(&self.whole));
        // Where there are no rays, any tree will do.
        let lights = plan.aim_of_light().into_iter();
        let lights = lights.map(|place| trees[place].unwrap_or(Tree::all(primary.bvh)));
        Trees {
            primary,
            lights: lights.collect(),
            mirrors: plan.has_mirrors.then_some(&self.whole),
        }
    }

    /// The tree of each aim that has its own.
    pub fn sets<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = (&'a Aim, &'a Bvh)> {
        let sets = plan.aims.iter().zip(&self.sets);
        sets.filter(|(aim, _)| aim.choice == Choice::Set)
    }

    /// All trees that a plan had built.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a Bvh> {
        let whole = plan.needs_whole.then_some(&self.whole);
        whole.into_iter().chain(self.sets(plan).map(|(_, set)| set))
    }
}

/// What is in an aim's set.
fn subset<'a>(plan: &Plan<'a>, aim: &'a Aim) -> Subset<'a> {
    Subset::Of(Reach {
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
