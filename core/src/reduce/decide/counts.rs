//! How large both sets are that answer for a light, and which is taken.

use crate::build::snap::leaf_triangle;
use crate::geometry::float::PowerOfTwo;
use crate::geometry::orientation::{Orientation, Target};
use crate::geometry::triangle::IndexedTriangles;
use crate::launch::{BLOCK, LANES, RUN};
use crate::reduce::classify::Sides;
use bytemuck::{Pod, Zeroable};

/// How many triangles are in which set, and what follows. 16 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct SetCounts {
    /// Bytes 0–3: L+, the triangles that are kept by the sides.
    pub plus: u32,
    /// Bytes 4–7: L−, those that are kept by the negated sides.
    pub minus: u32,
    /// Bytes 8–11: triangles of components that the light is outside of, but perhaps not the eye: with any of these, L− is not
    /// taken.
    pub barred: u32,
    /// Bytes 12–15: 1 where L− is taken.
    pub is_minus: u32,
}

const _: () = assert!(size_of::<SetCounts>() == 16);

impl SetCounts {
    /// Both together, with nothing decided.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            plus: self.plus.wrapping_add(other.plus),
            minus: self.minus.wrapping_add(other.minus),
            barred: self.barred.wrapping_add(other.barred),
            is_minus: 0,
        }
    }

    /// Of all triangles: decides. L+ always answers for a light outside. L− answers where every shadow ray starts outside of
    /// every component whose sides are negated, as then both count the same crossings; it is taken where it is smaller.
    #[inline]
    #[must_use]
    pub fn decided(self) -> Self {
        Self {
            is_minus: (self.barred == 0 && self.minus < self.plus) as u32,
            ..self
        }
    }
}

/// Both sets of one light.
#[derive(Clone, Copy)]
pub struct Choice<'a> {
    /// The mesh.
    pub mesh: IndexedTriangles<'a>,
    /// Carries it to magnitude 1.
    pub scale: PowerOfTwo,
    /// Components, and their outer sides for the light.
    pub sides: Sides<'a>,
    /// Outer sides for the eye.
    pub eye_sides: &'a [i32],
    /// The light, in the scene's magnitude.
    pub target: Target,
}

impl Choice<'_> {
    /// In which of both sets a triangle is: by the same words as [`crate::reduce::classify::is_in_set`], to the bit.
    #[inline(always)]
    #[must_use]
    pub fn counts(&self, primitive: u32) -> SetCounts {
        let component = crate::load(self.sides.components, primitive, u32::MAX);
        let side = crate::load(self.sides.sides, component, 0);
        if side == 0 {
            return SetCounts {
                plus: 1,
                minus: 1,
                ..SetCounts::default()
            };
        }
        let triangle = leaf_triangle(primitive, &self.mesh, &self.scale).triangle();
        let orientation = Orientation::new(&triangle, &self.target);
        SetCounts {
            plus: !orientation.is_certainly_on(-side as f32) as u32,
            minus: !orientation.is_certainly_on(side as f32) as u32,
            barred: (crate::load(self.eye_sides, component, 0) == 0) as u32,
            is_minus: 0,
        }
    }
}

/// Phase 1, one lane per run of a block of triangles: every [`LANES`]th. Returns how many of them are in which set.
#[inline(always)]
#[must_use]
pub fn lane_counts(block: u32, lane: u32, choice: &Choice) -> SetCounts {
    let mut own = SetCounts::default();
    for step in 0..RUN {
        let primitive = block * BLOCK + step * LANES as u32 + lane;
        if (primitive as usize) < choice.mesh.indices.len() {
            own = own.plus(choice.counts(primitive));
        }
    }
    own
}

/// Phase 1, one lane per run of all blocks: every [`LANES`]th. Returns their sum.
#[inline(always)]
#[must_use]
pub fn lane_total(lane: u32, blocks: &[SetCounts]) -> SetCounts {
    let count = blocks.len() as u32;
    let mut own = SetCounts::default();
    for step in 0..count.div_ceil(LANES as u32) {
        let block = step * LANES as u32 + lane;
        own = own.plus(crate::load(blocks, block, SetCounts::default()));
    }
    own
}

/// Phase 2, one lane per count: at each step with `distance` = LANES/2 … 1 every lane below `distance` stores this. Lane 0 ends
/// with the sum. Returns the lane's new sum.
#[inline(always)]
#[must_use]
pub fn count_step<const LANES: usize>(
    lane: u32,
    distance: u32,
    counts: &[SetCounts; LANES],
) -> SetCounts {
    let own = counts[lane as usize % LANES];
    own.plus(counts[(lane + distance) as usize % LANES])
}
