//! A triangle on the lattice, by itself: its vertices, counted from the leaf's decoded box, exactly.

use super::leaf_width::{LeafFrame, LeafWidth};
use crate::geometry::float::{exponent, whole_number};
use crate::geometry::lattice::{LatticeBox, lattice_steps};
use crate::geometry::ray::NO_PRIMITIVE;
use crate::geometry::triangle::LeafTriangle;
use crate::trace::{LeafSlot, TriangleSource};
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// The finest lattice that holds all of a scene of magnitude 1 in floats: its step is two to this power.
pub const FINEST_STEP: i32 = -24;

/// The lattice of a mesh, whose step is two to `step_exponent` in the mesh's unit, in the scene's magnitude. Where all vertices
/// are the origin, any step will do: one whose inverse a float holds, times 1024 as well.
#[inline]
#[must_use]
pub const fn scaled_step(step_exponent: i32, scene_exponent: i32) -> i32 {
    let step = step_exponent.wrapping_add(scene_exponent);
    if step < -117 {
        -117
    } else if step > 127 {
        127
    } else {
        step
    }
}

/// The origin and the width that the triangles of a leaf are encoded with. 16 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct LeafCorner {
    /// Bytes 0–11: the smallest coordinates of the leaf's box, decoded.
    pub min: [i32; 3],
    /// Bytes 12–15: words of a triangle ([`LeafWidth::words`]).
    pub words: u32,
}

const _: () = assert!(size_of::<LeafCorner>() == 16);

impl LeafCorner {
    /// The corner of a leaf with this box.
    #[inline(always)]
    #[must_use]
    pub fn of(bounds: &LatticeBox) -> Self {
        Self {
            min: bounds.min,
            words: LeafWidth::of(bounds).words(),
        }
    }

    /// The width of its triangles.
    #[inline(always)]
    #[must_use]
    pub const fn width(&self) -> LeafWidth {
        const NARROW: u32 = LeafWidth::Narrow.words();
        const MIDDLE: u32 = LeafWidth::Middle.words();
        match self.words {
            NARROW => LeafWidth::Narrow,
            MIDDLE => LeafWidth::Middle,
            _ => LeafWidth::Wide,
        }
    }

    /// In the scene's unit.
    #[inline(always)]
    fn min(&self, step: f32) -> [f32; 3] {
        let [x, y, z] = self.min;
        [x as f32 * step, y as f32 * step, z as f32 * step]
    }
}

/// [`encode_triangle`] in a leaf whose triangles are narrow.
#[inline(always)]
#[must_use]
pub fn encode_narrow_triangle(triangle: &LeafTriangle, corner: &LeafCorner, step: f32) -> [u32; 4] {
    let v = &triangle.vertices;
    [
        narrow_vertex([v[0], v[1], v[2]], corner, step),
        narrow_vertex([v[3], v[4], v[5]], corner, step),
        narrow_vertex([v[6], v[7], v[8]], corner, step),
        triangle.primitive,
    ]
}

/// A vertex in one word.
#[inline(always)]
pub(super) fn narrow_vertex([x, y, z]: [f32; 3], corner: &LeafCorner, step: f32) -> u32 {
    let [a, b, c] = corner.min(step);
    let inverse = 1.0 / step;
    // Sums of below 2^20 steps: no operation is ever rounded, fused or not.
    let xy = (x - a) * inverse + (y - b) * (1024.0 * inverse);
    low_bits(xy) | low_bits((z - c) * inverse) << 20
}

/// A vertex in two words.
#[inline(always)]
pub(super) fn middle_vertex([x, y, z]: [f32; 3], corner: &LeafCorner, step: f32) -> [u32; 2] {
    let [a, b, c] = corner.min(step);
    let inverse = 1.0 / step;
    // No operation is ever rounded.
    let y = low_bits((y - b) * inverse);
    let [x, z] = [(x - a) * inverse, (z - c) * inverse];
    [low_bits(x) | y << 21, y >> 11 | low_bits(z) << 10]
}

/// A vertex in three words.
#[inline(always)]
pub(super) fn wide_vertex([x, y, z]: [f32; 3], step: f32) -> [u32; 3] {
    let whole = |x: f32| lattice_steps(x, exponent(step)) as u32;
    [whole(x), whole(y), whole(z)]
}

/// A whole number from 0 to below 2^22: a sum with 2^23 holds it in its last bits.
#[inline(always)]
const fn low_bits(x: f32) -> u32 {
    (x + 8_388_608.0).to_bits() & 0x003f_ffff
}

/// One thread per triangle. Reads it, its leaf's corner, and the lattice's step, a power of two; its vertices are on the lattice,
/// in the leaf's box. Returns its words; the first [`LeafCorner::words`] of them are used.
#[inline(always)]
#[must_use]
pub fn encode_triangle(triangle: &LeafTriangle, corner: &LeafCorner, step: f32) -> [u32; 10] {
    let (v, primitive) = (&triangle.vertices, triangle.primitive);
    match corner.width() {
        LeafWidth::Narrow => {
            let [a, b, c, d] = encode_narrow_triangle(triangle, corner, step);
            [a, b, c, d, 0, 0, 0, 0, 0, 0]
        }
        LeafWidth::Middle => {
            let [a, b] = middle_vertex([v[0], v[1], v[2]], corner, step);
            let [c, d] = middle_vertex([v[3], v[4], v[5]], corner, step);
            let [e, f] = middle_vertex([v[6], v[7], v[8]], corner, step);
            [a, b, c, d, e, f, primitive, 0, 0, 0]
        }
        LeafWidth::Wide => {
            let [a, b, c] = wide_vertex([v[0], v[1], v[2]], step);
            let [d, e, f] = wide_vertex([v[3], v[4], v[5]], step);
            let [g, h, i] = wide_vertex([v[6], v[7], v[8]], step);
            [a, b, c, d, e, f, g, h, i, primitive]
        }
    }
}

/// Triangles of the lattice codec. A leaf's triangles begin at a word.
#[derive(Clone, Copy)]
pub struct LatticeTriangles<'a> {
    /// Their words.
    pub words: &'a [u32],
    /// The lattice's step, a power of two.
    pub step: f32,
}

impl LatticeTriangles<'_> {
    /// Where a triangle's words begin.
    #[inline(always)]
    fn begin(slot: &LeafSlot<LeafFrame>) -> u32 {
        slot.first
            .wrapping_add(slot.number * slot.bounds.width.words())
    }
}

/// The vertices whose words begin at these places, coordinates in the order of the axes, as those of their leaf's frame are.
#[inline(always)]
pub(super) fn vertices(
    words: &[u32],
    [a, b, c]: [u32; 3],
    frame: &LeafFrame,
    axes: [u32; 3],
    step: f32,
) -> [[f32; 3]; 3] {
    let min = frame.min;
    match frame.width {
        LeafWidth::Narrow => [
            narrow(words, a, min, axes, step),
            narrow(words, b, min, axes, step),
            narrow(words, c, min, axes, step),
        ],
        LeafWidth::Middle => [
            middle(words, a, min, axes, step),
            middle(words, b, min, axes, step),
            middle(words, c, min, axes, step),
        ],
        LeafWidth::Wide => [
            wide(words, a, axes, step),
            wide(words, b, axes, step),
            wide(words, c, axes, step),
        ],
    }
}

/// A vertex of one word.
#[inline(always)]
fn narrow(words: &[u32], at: u32, min: Vec4, [i, j, k]: [u32; 3], step: f32) -> [f32; 3] {
    let word = crate::load(words, at, 0);
    let steps = |axis: u32| whole_number((word >> (10 * axis)) & 0x3ff) * step;
    [min.x + steps(i), min.y + steps(j), min.z + steps(k)]
}

/// A vertex of two words.
#[inline(always)]
fn middle(words: &[u32], at: u32, min: Vec4, [i, j, k]: [u32; 3], step: f32) -> [f32; 3] {
    let a = crate::load(words, at, 0);
    let b = crate::load(words, at.wrapping_add(1), 0);
    let steps = |axis: u32| {
        let later = if axis == 1 {
            a >> 21 | b << 11
        } else {
            b >> 10
        };
        let bits = if axis == 0 { a } else { later };
        whole_number(bits & 0x001f_ffff) * step
    };
    [min.x + steps(i), min.y + steps(j), min.z + steps(k)]
}

/// A vertex of three words.
#[inline(always)]
fn wide(words: &[u32], at: u32, [i, j, k]: [u32; 3], step: f32) -> [f32; 3] {
    let i = crate::load(words, at.wrapping_add(i), 0);
    let j = crate::load(words, at.wrapping_add(j), 0);
    let k = crate::load(words, at.wrapping_add(k), 0);
    [
        i as i32 as f32 * step,
        j as i32 as f32 * step,
        k as i32 as f32 * step,
    ]
}

impl TriangleSource<LeafFrame> for LatticeTriangles<'_> {
    #[inline(always)]
    fn corners(&self, slot: &LeafSlot<LeafFrame>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let begin = Self::begin(slot);
        let next = slot.bounds.width.vertex_words();
        let places = [
            begin,
            begin.wrapping_add(next),
            begin.wrapping_add(2 * next),
        ];
        vertices(self.words, places, &slot.bounds, axes, self.step)
    }

    #[inline(always)]
    fn primitive(&self, slot: &LeafSlot<LeafFrame>) -> u32 {
        let at = Self::begin(slot).wrapping_add(3 * slot.bounds.width.vertex_words());
        crate::load(self.words, at, NO_PRIMITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::super::leaf_width::LatticeBounds;
    use super::*;
    use proptest::prelude::*;

    fn coordinates() -> impl Strategy<Value = [[i32; 3]; 3]> {
        let extents = prop_oneof![Just(1i32 << 24), 0i32..1023, 0i32..3000, 0i32..(1 << 22)];
        (extents, proptest::array::uniform3(-(1i32 << 24)..1 << 24)).prop_flat_map(
            |(extent, center)| {
                let near = move |i: usize| {
                    (center[i] - extent / 2).max(-(1 << 24))..=(center[i] + extent / 2).min(1 << 24)
                };
                proptest::array::uniform3(
                    (near(0), near(1), near(2)).prop_map(|(x, y, z)| [x, y, z]),
                )
            },
        )
    }

    proptest! {
        #[test]
        fn vertices_come_back_exactly(vertices in coordinates(), slack in proptest::array::uniform3(0i32..9), primitive: u32, first in 0u32..50) {
            let mut bounds = LatticeBox { min: vertices[0], max: vertices[0] };
            for axis in 0..3 {
                for vertex in vertices {
                    bounds.min[axis] = bounds.min[axis].min(vertex[axis]);
                    bounds.max[axis] = bounds.max[axis].max(vertex[axis]);
                }
                bounds.min[axis] -= slack[axis];
                bounds.max[axis] += slack[axis];
            }
            let width = LeafWidth::of(&bounds);
            let mut words = std::vec![7; first as usize + 2 * width.words() as usize];
            let mut triangle = LeafTriangle { primitive, ..LeafTriangle::default() };
            for (to, x) in triangle.vertices.iter_mut().zip(vertices.as_flattened()) {
                *to = *x as f32 * 0.5;
            }
            let own = encode_triangle(&triangle, &LeafCorner::of(&bounds), 0.5);
            let at = (first + width.words()) as usize;
            words[at..].copy_from_slice(&own[..width.words() as usize]);
            let triangles = LatticeTriangles { words: &words, step: 0.5 };
            for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
                let order = |v: [i32; 3]| axes.map(|axis: u32| v[axis as usize]);
                let frame = LeafFrame::of(&LatticeBounds::new(&bounds, 0.5, axes), 0.5);
                prop_assert_eq!(frame.width, width);
                let slot = LeafSlot { first, number: 1, count: 2, bounds: frame };
                let expected = vertices.map(|v| order(v).map(|x| x as f32 * 0.5));
                prop_assert_eq!(triangles.corners(&slot, axes), expected);
                prop_assert_eq!(triangles.primitive(&slot), primitive);
            }
        }
    }
}
