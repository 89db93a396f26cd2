//! The CPU's trees, and their ray queries.

use crate::backend;
use crate::tree::{Bvh, PacketQuery, Question};
use slimbvh_core::classify::Sides;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, Ray};

/// A hierarchy for rays of one kind. Its filter has a target in the mesh's unit.
pub type Tree<'a> = backend::Tree<'a, Bvh, (Sides<'a>, Target)>;

/// The hierarchies of a picture, all over the same mesh.
pub type Trees<'a> = backend::Trees<'a, Bvh, (Sides<'a>, Target)>;

impl Tree<'_> {
    /// The tree with its target at the scene's magnitude.
    pub(super) fn scaled(self, scale: &PowerOfTwo) -> Self {
        Self {
            rule: self
                .rule
                .map(|(sides, target)| (sides, target.scaled(scale))),
            ..self
        }
    }

    /// Traces rays at the scene's magnitude, each with a number and a primitive to skip, and calls back with each ray's
    /// number and answer.
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
