//! Stage `classify`: which triangles rays of one origin may hit (after Wong, Cheng and Lii 2012, "Reduced BVHs").
//!
//! On a closed surface that is seen from outside, the first triangle that a ray meets faces its origin, and a ray to a light
//! outside that meets anything meets a triangle that faces the light. Others need not be in the tree at all. The rule is
//! one function, [`faces`]: a reduced tree leaves out only what it rejects, and a whole tree's hits are asked the same.
//!
//! A ray to a light that starts outside, too, meets as many triangles that face the light as triangles that face away: then
//! either half answers, and with sides negated the same function keeps the other one.

use crate::build::snap::snap_triangle;
use crate::geometry::float::PowerOfTwo;
use crate::geometry::frustum::Frustum;
use crate::geometry::orientation::{Orientation, Target};
use crate::geometry::triangle::{IndexedTriangles, Triangle};
use crate::trace::HitFilter;
use glam::Vec3;

/// Whether rays from or to a target may hit a triangle of a component whose outer side is this: 1 for the front, −1 for the
/// back, and 0 where all of it must stay. False only where the triangle certainly faces away from all of the target.
#[inline(always)]
#[must_use]
pub fn faces(triangle: &Triangle, side: i32, target: &Target) -> bool {
    (side == 0) | !Orientation::new(triangle, target).is_certainly_on(-side as f32)
}

/// Which sides of which components face out, for one target.
#[derive(Clone, Copy, Debug)]
pub struct Sides<'a> {
    /// The component of each primitive.
    pub components: &'a [u32],
    /// The outer side of each component, 0 where it stays whole. Components beyond the last stay whole.
    pub sides: &'a [i32],
}

/// Where the side of a primitive's component is found.
pub trait SideSource {
    /// The outer side of a primitive's component: 1 for the front, −1 for the back, 0 where the component stays whole.
    fn side(&self, primitive: u32) -> i32;
}

impl SideSource for Sides<'_> {
    #[inline(always)]
    fn side(&self, primitive: u32) -> i32 {
        let component = crate::load(self.components, primitive, u32::MAX);
        crate::load(self.sides, component, 0)
    }
}

/// Primitives whose sides a word of [`PackedSides`] holds.
pub const SIDES_PER_WORD: u32 = 16;

/// The side of each primitive, two bits each: one read where [`Sides`] takes two, the second after the first. Primitives beyond the
/// last belong to components that stay whole.
#[derive(Clone, Copy, Debug)]
pub struct PackedSides<'a>(pub &'a [u32]);

impl SideSource for PackedSides<'_> {
    #[inline(always)]
    fn side(&self, primitive: u32) -> i32 {
        let word = crate::load(self.0, primitive / SIDES_PER_WORD, 0);
        // The bits 00, 01 and 11 are the numbers 0, 1 and −1.
        let shift = 30 - primitive % SIDES_PER_WORD * 2;
        ((word << shift) as i32) >> 30
    }
}

/// One thread per word. Reads the components of its primitives and their sides. Returns the word of [`PackedSides`].
#[inline]
#[must_use]
pub fn packed_sides(word: u32, sides: &Sides) -> u32 {
    let mut packed = 0;
    for i in 0..SIDES_PER_WORD {
        let side = sides.side(word.wrapping_mul(SIDES_PER_WORD).wrapping_add(i));
        packed |= (side as u32 & 3) << (2 * i);
    }
    packed
}

/// The triangles that rays of one kind may hit.
#[derive(Clone, Copy, Debug)]
pub struct VisibleSet<'a> {
    /// Which sides of which components face out.
    pub sides: Sides<'a>,
    /// Where the rays come from, or lead to.
    pub target: Target,
    /// Where they go.
    pub frustum: Frustum,
}

impl VisibleSet<'_> {
    /// The same in a scene that is multiplied by a power of two.
    #[inline]
    #[must_use]
    pub fn scaled(&self, scale: &PowerOfTwo) -> Self {
        Self {
            target: self.target.scaled(scale),
            frustum: self.frustum.scaled(scale),
            ..*self
        }
    }
}

/// One thread per triangle, in any order. Reads the mesh, its component and that one's side. Returns whether it is in the
/// set of what rays may hit, which is in the scene's magnitude.
#[inline]
#[must_use]
pub fn is_in_set(
    primitive: u32,
    mesh: &IndexedTriangles,
    scale: &PowerOfTwo,
    set: &VisibleSet,
) -> bool {
    let side = set.sides.side(primitive);
    if side == 0 && set.frustum.is_bounded == 0 {
        return true;
    }
    let triangle = snap_triangle(&mesh.triangle(primitive), scale);
    faces(&triangle, side, &set.target) && !set.frustum.is_certainly_outside(&triangle)
}

/// Triangles that are classified together on a CPU: a word of flags.
const TOGETHER: usize = 32;

/// The bit of each, of the lowest first.
const BITS: [u32; TOGETHER] = {
    let mut bits = [1; TOGETHER];
    let mut lane = 1;
    while lane < TOGETHER {
        bits[lane] = 2 * bits[lane - 1];
        lane += 1;
    }
    bits
};

/// [`is_in_set`] of the 32 triangles of a word, a bit each: the same arithmetic in rows, which compilers vectorize. Bits beyond
/// the mesh's end are 0.
#[inline]
#[must_use]
pub fn word_of_set(
    word: u32,
    mesh: &IndexedTriangles,
    scale: &PowerOfTwo,
    set: &VisibleSet,
) -> u32 {
    let first = (word as usize).saturating_mul(TOGETHER);
    let indices = mesh.indices.get(first..).unwrap_or(&[]);
    let components = set.sides.components.get(first..).unwrap_or(&[]);
    let count = indices.len().min(TOGETHER);
    let corners = match indices.first_chunk() {
        Some(indices) => corners_in_rows(indices, mesh.vertices),
        None => {
            let mut padded = [[0; 3]; TOGETHER];
            for (to, from) in padded.iter_mut().zip(indices) {
                *to = *from;
            }
            corners_in_rows(&padded, mesh.vertices)
        }
    };
    let mut sides = [0; TOGETHER];
    let component = components.first().copied().unwrap_or(u32::MAX);
    let is_one = |own: &[u32; TOGETHER]| own.iter().fold(true, |all, &c| all & (c == component));
    if components.first_chunk().is_some_and(is_one) {
        sides = [crate::load(set.sides.sides, component, 0); TOGETHER];
    } else {
        for (side, &component) in sides.iter_mut().zip(components) {
            *side = crate::load(set.sides.sides, component, 0);
        }
    }
    // Comparisons ignore the sign of zeros, so one factor does, which saves a product.
    let bits = match scale.single() {
        Some(factor) => bits_of_set(&corners, &sides, set, |x| x * factor),
        None => bits_of_set(&corners, &sides, set, |x| scale.times(x)),
    };
    bits & u32::MAX.checked_shr((TOGETHER - count) as u32).unwrap_or(0)
}

/// Each of nine coordinates of all triangles in a row.
#[inline(always)]
fn corners_in_rows(indices: &[[u32; 3]; TOGETHER], vertices: &[[f32; 3]]) -> [[f32; TOGETHER]; 9] {
    let mut rows = [[0.0; TOGETHER]; 9];
    for (lane, own) in indices.iter().enumerate() {
        let [a, b, c] = own.map(|vertex| crate::load(vertices, vertex, [0.0; 3]));
        for axis in 0..3 {
            rows[axis][lane] = a[axis];
            rows[3 + axis][lane] = b[axis];
            rows[6 + axis][lane] = c[axis];
        }
    }
    rows
}

/// A bit for each triangle that is in the set, by corners and sides in rows.
#[inline(always)]
fn bits_of_set(
    corners: &[[f32; TOGETHER]; 9],
    sides: &[i32; TOGETHER],
    set: &VisibleSet,
    scaled: impl Fn(f32) -> f32,
) -> u32 {
    let triangle = |lane: usize| {
        let c = |i: usize| scaled(corners[i][lane % TOGETHER]);
        Triangle {
            v0: Vec3::new(c(0), c(1), c(2)),
            v1: Vec3::new(c(3), c(4), c(5)),
            v2: Vec3::new(c(6), c(7), c(8)),
        }
    };
    let target = Target {
        padding: [0; 3],
        ..set.target
    };
    let mut bits = 0;
    for (lane, (&side, &bit)) in sides.iter().zip(&BITS).enumerate() {
        let is_in_set = faces(&triangle(lane), side, &target);
        bits |= u32::from(is_in_set).wrapping_neg() & bit;
    }
    if set.frustum.is_bounded == 1 {
        for (lane, &bit) in BITS.iter().enumerate() {
            let is_outside = set.frustum.is_certainly_outside(&triangle(lane));
            bits &= !(u32::from(is_outside).wrapping_neg() & bit);
        }
    }
    bits
}

/// Rejects the hits that [`faces`] rejects: for rays from or to a target that are traced through a whole tree.
#[derive(Clone, Copy, Debug)]
pub struct FacingFilter<S> {
    /// A primitive that is rejected, [`crate::NO_PRIMITIVE`] for none.
    pub skip: u32,
    /// The side of each primitive.
    pub sides: S,
    /// The rays' origin, or where they go, in the scene's magnitude.
    pub target: Target,
}

impl<S: SideSource> HitFilter for FacingFilter<S> {
    #[inline(always)]
    fn accepts(&self, primitive: u32, corners: &[[f32; 3]; 3], axes: [u32; 3]) -> bool {
        if primitive == self.skip {
            return false;
        }
        let side = self.sides.side(primitive);
        if side == 0 {
            return true;
        }
        let triangle = Triangle {
            v0: in_mesh_order(corners[0], axes),
            v1: in_mesh_order(corners[1], axes),
            v2: in_mesh_order(corners[2], axes),
        };
        faces(&triangle, side, &self.target)
    }
}

/// A vertex whose coordinates are in the order of a ray's axes, each the next after the last.
#[inline(always)]
fn in_mesh_order(v: [f32; 3], axes: [u32; 3]) -> Vec3 {
    let [a, b, c] = v;
    if axes[0] == 0 {
        Vec3::new(a, b, c)
    } else if axes[0] == 1 {
        Vec3::new(c, a, b)
    } else {
        Vec3::new(b, c, a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::vec::Vec;

    fn point() -> impl Strategy<Value = [f32; 3]> {
        proptest::array::uniform3(prop_oneof![Just(0.0f32), Just(-0.0), -9.0f32..9.0])
    }

    fn target() -> impl Strategy<Value = Target> {
        prop_oneof![
            point().prop_map(Target::position),
            point().prop_map(Target::direction),
            (point(), 0.0f32..3.0).prop_map(|(center, radius)| Target::ball(center, radius)),
        ]
    }

    fn frustum() -> impl Strategy<Value = Frustum> {
        let plane = (point(), -2.0f32..2.0).prop_map(|([x, y, z], offset)| [x, y, z, offset]);
        let planes = proptest::array::uniform4(plane);
        prop_oneof![
            Just(Frustum::EVERYWHERE),
            (point(), planes).prop_map(|(eye, planes)| Frustum {
                eye,
                is_bounded: 1,
                planes
            }),
        ]
    }

    proptest! {
        /// Components and sides may be missing, too.
        #[test]
        fn packed_sides_are_the_sides(
            components in proptest::collection::vec(0u32..5, 0..100),
            sides in proptest::collection::vec(-1i32..=1, 0..5),
        ) {
            let sides = Sides { components: &components, sides: &sides };
            let words: Vec<u32> = (0..7).map(|word| packed_sides(word, &sides)).collect();
            let packed = PackedSides(&words);
            for primitive in 0..130 {
                prop_assert_eq!(packed.side(primitive), sides.side(primitive));
            }
            // The negative control: another primitive's side is noticed.
            if components.len() > 1 && sides.side(0) != sides.side(1) {
                prop_assert_ne!(packed.side(0), packed.side(1));
            }
        }

        /// Components and vertices may be missing, too.
        #[test]
        fn a_word_holds_what_each_triangle_says(
            vertices in proptest::collection::vec(point(), 0..40),
            indices in proptest::collection::vec(proptest::array::uniform3(0u32..42), 0..100),
            components in proptest::collection::vec(0u32..5, 0..100),
            sides in proptest::collection::vec(-1i32..=1, 0..5),
            target in target(),
            frustum in frustum(),
            exponent in -40i32..40,
        ) {
            let mesh = IndexedTriangles { vertices: &vertices, indices: &indices };
            let sides = Sides { components: &components, sides: &sides };
            let scale = PowerOfTwo::new(exponent);
            let set = VisibleSet { sides, target, frustum }.scaled(&scale);
            let expected: Vec<u32> = (0..5u32).map(|word| {
                let each = (32 * word..32 * word + 32).filter(|&i| i < indices.len() as u32);
                each.map(|i| u32::from(is_in_set(i, &mesh, &scale, &set)) << (i % 32)).sum()
            }).collect();
            let words: Vec<u32> = (0..5).map(|word| word_of_set(word, &mesh, &scale, &set)).collect();
            prop_assert_eq!(words, expected);
            prop_assert_eq!(word_of_set(u32::MAX, &mesh, &scale, &set), 0);
        }
    }
}
