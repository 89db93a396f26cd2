//! The GPU's trees, and their ranges.

use super::buffer::Range;
use super::bvh::Built;
use super::sides::TargetRanges;
use super::{Bvh, Components, Gpu, GpuError, TargetSides};
use crate::backend::{self, Deferral};

/// A hierarchy for rays of one kind.
pub type Tree<'a> = backend::Tree<'a, Bvh, (&'a Components, &'a TargetSides)>;

/// The hierarchies of a picture, all over the same mesh.
pub type Trees<'a> = backend::Trees<'a, Bvh, (&'a Components, &'a TargetSides)>;

impl Tree<'_> {
    pub(super) fn ranges(&self) -> Result<TreeRanges, GpuError> {
        let rule = match self.rule {
            Some((components, sides)) => Some(RuleRanges {
                components: components.clone(),
                sides: sides.ranges()?.clone(),
                packed: None,
            }),
            None => None,
        };
        Ok(TreeRanges {
            built: self.bvh.built()?.clone(),
            rule,
        })
    }
}

impl Trees<'_> {
    pub(super) fn ranges(&self) -> Result<TreesRanges, GpuError> {
        let lights = self.lights.iter().map(Tree::ranges);
        let mirrors = self.mirrors.map(|bvh| Tree::all(bvh).ranges());
        Ok(TreesRanges {
            primary: self.primary.ranges()?,
            lights: lights.collect::<Result<_, _>>()?,
            mirrors: mirrors.transpose()?,
        })
    }
}

/// The ranges of a tree that kernels read.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeRanges {
    pub built: Built,
    pub rule: Option<RuleRanges>,
}

/// The ranges of a filter.
#[derive(Clone, Debug, PartialEq)]
pub struct RuleRanges {
    pub components: Components,
    pub sides: TargetRanges,
    /// Room for the sides by primitives, once the renderer has made it.
    pub packed: Option<Range>,
}

/// A light's deferral in a program.
#[derive(Clone, Debug, PartialEq)]
pub enum DeferralRange {
    Ready,
    Always,
    /// Holds 0 if the light reaches no hit.
    IfReached(Range),
}

impl DeferralRange {
    /// The deferral, and the tree that is built.
    pub fn of<'a>(deferral: Deferral<'a, &Gpu>) -> Result<(Self, Option<&'a Bvh>), GpuError> {
        Ok(match deferral {
            Deferral::Ready => (Self::Ready, None),
            Deferral::Always(bvh) => (Self::Always, Some(bvh)),
            Deferral::IfReached(bvh, sides) => {
                (Self::IfReached(sides.ranges()?.needed.clone()), Some(bvh))
            }
        })
    }
}

/// The ranges of all trees that kernels read.
#[derive(Clone, Debug, PartialEq)]
pub struct TreesRanges {
    pub primary: TreeRanges,
    pub lights: Vec<TreeRanges>,
    pub mirrors: Option<TreeRanges>,
}

impl TreesRanges {
    /// All hierarchies.
    pub fn all(&self) -> impl Iterator<Item = &Built> {
        let trees = self.lights.iter().chain(&self.mirrors);
        trees.chain([&self.primary]).map(|tree| &tree.built)
    }

    /// The trees whose rays may have a filter.
    pub fn filtered(&self) -> impl Iterator<Item = &TreeRanges> {
        [&self.primary].into_iter().chain(&self.lights)
    }

    /// As [`Self::filtered`].
    pub fn filtered_mut(&mut self) -> impl Iterator<Item = &mut TreeRanges> {
        [&mut self.primary].into_iter().chain(&mut self.lights)
    }
}
