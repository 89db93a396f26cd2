//! Which hierarchy rays of each kind are traced through.

use super::bvh::Built;
use super::facing::FacingRanges;
use super::{Bvh, Components, Facing, Frame, GpuError};

/// A hierarchy for rays of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Tree<'a> {
    /// The hierarchy, whole or reduced.
    pub bvh: &'a Bvh,
    /// In a whole hierarchy: only triangles that face the target count. None where all count that are in it.
    pub rule: Option<(&'a Components, &'a Facing)>,
}

/// Hierarchies for shadow rays that are built when their turn comes, one after the other in the same buffers.
pub trait Turns {
    /// How this light takes part.
    fn turn(&self, light: usize) -> Turn<'_>;

    /// Records the build of this light's hierarchy, in place of the one before, if it is not there yet.
    ///
    /// # Errors
    /// Those of [`super::Builder::build`].
    fn build(&mut self, frame: &mut Frame, light: usize) -> Result<(), GpuError>;
}

/// How a light takes part in [`Turns`].
#[derive(Clone, Copy, Debug)]
pub enum Turn<'a> {
    /// Not at all: its hierarchy is there.
    None,
    /// It is built in its turn.
    Always,
    /// It is built in its turn, over nothing if the light reaches nothing.
    IfReached(&'a Facing),
}

/// All hierarchies are there from the beginning.
pub struct NoTurns;

impl Turns for NoTurns {
    fn turn(&self, _: usize) -> Turn<'_> {
        Turn::None
    }

    fn build(&mut self, _: &mut Frame, _: usize) -> Result<(), GpuError> {
        Ok(())
    }
}

/// The hierarchies of a picture, all over the same mesh.
#[derive(Clone, Debug)]
pub struct Trees<'a> {
    /// For rays from the camera.
    pub primary: Tree<'a>,
    /// For shadow rays, one for each light.
    pub lights: Vec<Tree<'a>>,
    /// For rays from mirrors and glass: all triangles count. None where the scene has none.
    pub mirrors: Option<&'a Bvh>,
}

impl<'a> Tree<'a> {
    /// All triangles of a hierarchy.
    #[must_use]
    pub const fn all(bvh: &'a Bvh) -> Self {
        Self { bvh, rule: None }
    }

    pub(super) fn ranges(&self) -> Result<TreeRanges, GpuError> {
        let rule = match self.rule {
            Some((components, facing)) => Some((components.clone(), facing.ranges()?.clone())),
            None => None,
        };
        Ok(TreeRanges {
            built: self.bvh.built()?.clone(),
            rule,
        })
    }
}

impl<'a> Trees<'a> {
    /// One hierarchy for everything.
    #[must_use]
    pub fn all(bvh: &'a Bvh, light_count: usize) -> Self {
        Self {
            primary: Tree::all(bvh),
            lights: vec![Tree::all(bvh); light_count],
            mirrors: Some(bvh),
        }
    }

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

/// Where the kernels find a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeRanges {
    pub built: Built,
    pub rule: Option<(Components, FacingRanges)>,
}

/// A light's turn in a program.
#[derive(Clone, Debug, PartialEq)]
pub enum TurnRange {
    None,
    Always,
    /// Where the kernel that needs to know finds it.
    IfReached(super::buffer::Range),
}

impl TurnRange {
    pub fn of(turn: Turn) -> Result<Self, GpuError> {
        Ok(match turn {
            Turn::None => Self::None,
            Turn::Always => Self::Always,
            Turn::IfReached(facing) => Self::IfReached(facing.ranges()?.needed.clone()),
        })
    }
}

/// Where the kernels find all trees.
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
}
