//! Which hierarchy rays of each kind are traced through.

use super::bvh::Built;
use super::facing::FacingRanges;
use super::{Bvh, Components, Facing, GpuError};

/// A hierarchy for rays of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Tree<'a> {
    /// The hierarchy, whole or reduced.
    pub bvh: &'a Bvh,
    /// In a whole hierarchy: only triangles that face the target count. None where all count that are in it.
    pub rule: Option<(&'a Components, &'a Facing)>,
}

/// The hierarchies of a picture, all over the same mesh.
#[derive(Clone, Debug)]
pub struct Trees<'a> {
    /// For rays from the camera.
    pub primary: Tree<'a>,
    /// For shadow rays, one for each light.
    pub lights: Vec<Tree<'a>>,
    /// For rays from mirrors: all triangles count. None where the scene has none.
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
        let mirrors = self.mirrors.map(|bvh| bvh.built().cloned());
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

/// Where the kernels find all trees.
#[derive(Clone, Debug, PartialEq)]
pub struct TreesRanges {
    pub primary: TreeRanges,
    pub lights: Vec<TreeRanges>,
    pub mirrors: Option<Built>,
}

impl TreesRanges {
    /// All hierarchies.
    pub fn all(&self) -> impl Iterator<Item = &Built> {
        let lights = self.lights.iter().map(|tree| &tree.built);
        lights.chain(&self.mirrors).chain([&self.primary.built])
    }
}
