//! Which hierarchy rays of each kind are traced through.

use crate::tree::{Bvh, PacketQuery, Question};
use slimbvh_core::classify::Sides;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, Ray};

/// A hierarchy for rays of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Tree<'a> {
    /// The hierarchy, whole or reduced.
    pub bvh: &'a Bvh,
    /// In a whole hierarchy: only triangles that face the target count, which is in the mesh's unit. None where all count
    /// that are in it.
    pub rule: Option<(Sides<'a>, Target)>,
}

/// Hierarchies for shadow rays that are built when their turn comes, one after the other in the same memory.
pub trait Turns {
    /// Whether this light's rays need a hierarchy that is not there now.
    fn is_due(&self, light: usize) -> bool;

    /// The hierarchy for this light's rays, built now if it is due; none where it is among [`Trees::lights`].
    fn take(&mut self, light: usize) -> Option<&Bvh>;
}

/// All hierarchies are there from the beginning.
pub struct NoTurns;

impl Turns for NoTurns {
    fn is_due(&self, _: usize) -> bool {
        false
    }

    fn take(&mut self, _: usize) -> Option<&Bvh> {
        None
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

    /// With the target in the scene's magnitude.
    pub(super) fn scaled(self, scale: &PowerOfTwo) -> Self {
        Self {
            rule: self
                .rule
                .map(|(sides, target)| (sides, target.scaled(scale))),
            ..self
        }
    }

    /// Asks for rays in the scene's magnitude, each with a number and a primitive that does not count, and tells each answer
    /// with its ray's number.
    pub(super) fn ask(
        &self,
        question: Question,
        rays: impl Iterator<Item = (usize, Ray, u32)>,
        answer: impl FnMut(usize, Hit),
    ) {
        let query = PacketQuery {
            question,
            exponent: 0,
            target: self.rule,
        };
        self.bvh.trace_rays(&query, rays, answer);
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
}
