//! The triangles of a leaf whose corners are stored once each, however many triangles have them.
//!
//! ```text
//! triangles / 2           half a word for each triangle after the first: which corners it has, 5 bits each, the first one's
//!                         lowest; other bits are 0
//! triangles               indices
//! corners × 1, 2 or 3     corners, as wide as those of LeafWidth
//! ```
//!
//! Corners lie in the order in which triangles have them for the first time. The first triangle has the corners 0, 1 and 2. Corners of
//! different triangles are one if their coordinates are the same, whatever the mesh's vertices are; two of one triangle are stored apart,
//! and later ones then take the last.

use super::lattice_leaf::{LeafCorner, middle_vertex, narrow_vertex, vertices, wide_vertex};
use super::leaf_width::{LeafFrame, LeafWidth};
use crate::build::node::NodeRef;
use crate::build::wide::WIDTH;
use crate::geometry::ray::NO_PRIMITIVE;
use crate::geometry::triangle::LeafTriangle;
use crate::trace::{LeafSlot, TriangleSource};
use bytemuck::{Pod, Zeroable};
use glam::Vec4;

/// The words of a leaf with so many triangles and so many corners of so many words.
#[inline(always)]
#[must_use]
pub const fn leaf_words(triangles: u32, corners: u32, vertex_words: u32) -> u32 {
    summed_words(triangles, triangles / 2, corners, vertex_words)
}

/// The same, where half the number of triangles, rounded down, is known. For several leaves at once, a byte each, too.
#[inline(always)]
pub(super) const fn summed_words(
    triangles: u32,
    half: u32,
    corners: u32,
    vertex_words: u32,
) -> u32 {
    corners * vertex_words + triangles + half
}

/// Where a triangle's index lies, in a leaf with so many triangles whose words begin at `first`. Behind the last one's, the corners
/// begin.
#[inline(always)]
#[must_use]
pub const fn index_place(first: u32, count: u32, number: u32) -> u32 {
    first.wrapping_add(count / 2).wrapping_add(number)
}

/// Bytes of a triangle, at most: of two whose wide corners are all different.
pub const MOST_SHARED_BYTES: u32 =
    size_of::<u32>() as u32 * leaf_words(2, 6, LeafWidth::Wide.vertex_words()) / 2;

const CORNER_BITS: u32 = 5;
const CORNER: u32 = (1 << CORNER_BITS) - 1;
const HALF: u32 = (1 << (3 * CORNER_BITS)) - 1;
const IS_FIRST: u32 = 3 * CORNER_BITS;
const NUMBER: u32 = IS_FIRST + 3;
const COUNT: u32 = NUMBER + 3;

/// Which of its leaf's corners a triangle has, while the leaf is encoded. 4 bytes.
///
/// ```text
/// bits 0–14   the numbers of its corners
/// bits 15–17  whether each comes here for the first time
/// bits 18–20  its own number in the leaf
/// bits 21–23  how many triangles the leaf has
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct TriangleCorners(pub u32);

impl TriangleCorners {
    /// What all first triangles have.
    const FIRST: u32 = 1 << CORNER_BITS | 2 << (2 * CORNER_BITS);

    /// The number of one of its corners: 0 to 17.
    #[inline(always)]
    const fn corner(self, corner: u32) -> u32 {
        self.0 >> (CORNER_BITS * corner) & CORNER
    }

    #[inline(always)]
    const fn is_first(self, corner: u32) -> bool {
        self.0 >> (IS_FIRST + corner) & 1 != 0
    }

    /// How many corners come here for the first time.
    #[inline(always)]
    const fn first_count(self) -> u32 {
        (self.0 >> IS_FIRST & 1) + (self.0 >> (IS_FIRST + 1) & 1) + (self.0 >> (IS_FIRST + 2) & 1)
    }

    #[inline(always)]
    const fn number(self) -> u32 {
        self.0 >> NUMBER & 7
    }

    #[inline(always)]
    const fn count(self) -> u32 {
        self.0 >> COUNT & 7
    }
}

/// How many corners a leaf has whose triangles' numbers lie from `first` on.
#[inline(always)]
#[must_use]
pub fn corner_count(first: u32, count: u32, corners: &[u32]) -> u32 {
    let mut sum = 0;
    for number in 0..count {
        let own = crate::load(corners, first.wrapping_add(number), 0);
        sum += TriangleCorners(own).first_count();
    }
    sum
}

/// How many corners each child of a wide node has that is a leaf, else 0. The list begins with the corners of triangle `first`.
#[inline(always)]
#[must_use]
pub fn corner_counts(children: [NodeRef; WIDTH], first: u32, corners: &[u32]) -> [u32; WIDTH] {
    let [a, b, c, d] = children;
    [
        corner_count_of(a, first, corners),
        corner_count_of(b, first, corners),
        corner_count_of(c, first, corners),
        corner_count_of(d, first, corners),
    ]
}

#[inline(always)]
fn corner_count_of(child: NodeRef, first: u32, corners: &[u32]) -> u32 {
    let count = if child.is_leaf() { child.count() } else { 0 };
    corner_count(child.first().wrapping_sub(first), count, corners)
}

/// Coordinates of three corners, by axis. The last lane is unused.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct ThreeCorners {
    x: Vec4,
    y: Vec4,
    z: Vec4,
}

/// One thread per leaf. Numbers the corners of its triangles, from `first` on in both lists. At most 7 triangles.
#[inline(always)]
pub fn number_corners(first: u32, count: u32, triangles: &[LeafTriangle], corners: &mut [u32]) {
    let mut next = 0;
    for number in 0..count {
        let i = first.wrapping_add(number) as usize;
        if i < triangles.len() && i < corners.len() {
            let v = &triangles[i].vertices;
            let own = ThreeCorners {
                x: Vec4::new(v[0], v[3], v[6], 0.0),
                y: Vec4::new(v[1], v[4], v[7], 0.0),
                z: Vec4::new(v[2], v[5], v[8], 0.0),
            };
            let mut found = Vec4::NEG_ONE;
            for other in 0..number {
                let j = first.wrapping_add(other) as usize;
                if j < triangles.len() && j < corners.len() {
                    let (v, theirs) = (&triangles[j].vertices, TriangleCorners(corners[j]));
                    found = seek(&own, [v[0], v[1], v[2]], theirs.corner(0), found);
                    found = seek(&own, [v[3], v[4], v[5]], theirs.corner(1), found);
                    found = seek(&own, [v[6], v[7], v[8]], theirs.corner(2), found);
                }
            }
            let [a, is_first_a] = numbered(found.x, next);
            let [b, is_first_b] = numbered(found.y, next + is_first_a);
            let [c, is_first_c] = numbered(found.z, next + is_first_a + is_first_b);
            next += is_first_a + is_first_b + is_first_c;
            corners[i] = a
                | b << CORNER_BITS
                | c << (2 * CORNER_BITS)
                | is_first_a << IS_FIRST
                | is_first_b << (IS_FIRST + 1)
                | is_first_c << (IS_FIRST + 2)
                | number << NUMBER
                | count << COUNT;
        }
    }
}

/// What is known of three corners after a look at another one of this number: the same number for those that are where it is.
#[inline(always)]
fn seek(own: &ThreeCorners, [x, y, z]: [f32; 3], number: u32, found: Vec4) -> Vec4 {
    let is_x = own.x.cmpeq(Vec4::splat(x));
    let is_y = own.y.cmpeq(Vec4::splat(y));
    let is_z = own.z.cmpeq(Vec4::splat(z));
    Vec4::select(is_x & is_y & is_z, Vec4::splat(number as f32), found)
}

/// A corner's number, and 1 if it is the next that no triangle had.
#[inline(always)]
const fn numbered(found: f32, next: u32) -> [u32; 2] {
    if found < 0.0 {
        [next, 1]
    } else {
        // A small whole number.
        [(found + 8_388_608.0).to_bits() & CORNER, 0]
    }
}

/// One thread per triangle. Reads it, its leaf's corner, the numbers of its corners and those of the next triangle in the list, and
/// the lattice's step, a power of two; its vertices are on the lattice, in the leaf's box. Stores its part of the leaf's words,
/// which begin at `first`. A thread that is `ALONE` with the leaf stores corners again that an earlier triangle stored: that costs less
/// than to ask for each whether it must.
#[inline(always)]
pub fn store_shared_triangle<const ALONE: bool>(
    triangle: &LeafTriangle,
    corner: &LeafCorner,
    [own, next]: [TriangleCorners; 2],
    step: f32,
    first: u32,
    words: &mut [u32],
) {
    let (number, count) = (own.number(), own.count());
    if number % 2 == 1 {
        let beside = if number + 1 < count { next.0 & HALF } else { 0 };
        let at = first.wrapping_add(number / 2);
        store(words, at, own.0 & HALF | beside << 16);
    }
    let at = index_place(first, count, number);
    store(words, at, triangle.primitive);
    let corners = index_place(first, count, count);
    let v = &triangle.vertices;
    if ALONE || own.is_first(0) {
        store_corner(
            [v[0], v[1], v[2]],
            corner,
            step,
            corners,
            own.corner(0),
            words,
        );
    }
    if ALONE || own.is_first(1) {
        store_corner(
            [v[3], v[4], v[5]],
            corner,
            step,
            corners,
            own.corner(1),
            words,
        );
    }
    if ALONE || own.is_first(2) {
        store_corner(
            [v[6], v[7], v[8]],
            corner,
            step,
            corners,
            own.corner(2),
            words,
        );
    }
}

/// Stores all words of a leaf, which begin at `first`, from its triangles and the numbers of their corners. On one thread.
#[inline(always)]
pub fn store_shared_leaf(
    triangles: &[LeafTriangle],
    corners: &[u32],
    corner: &LeafCorner,
    step: f32,
    first: u32,
    words: &mut [u32],
) {
    let mut next = corners.iter().copied().skip(1);
    for (triangle, &own) in triangles.iter().zip(corners) {
        let own = [own, next.next().unwrap_or(0)].map(TriangleCorners);
        store_shared_triangle::<true>(triangle, corner, own, step, first, words);
    }
}

/// Stores a corner of this number; the first one's words begin at `first`.
#[inline(always)]
fn store_corner(
    vertex: [f32; 3],
    corner: &LeafCorner,
    step: f32,
    first: u32,
    number: u32,
    words: &mut [u32],
) {
    let width = corner.width();
    let at = first.wrapping_add(number.wrapping_mul(width.vertex_words()));
    match width {
        LeafWidth::Narrow => store(words, at, narrow_vertex(vertex, corner, step)),
        LeafWidth::Middle => {
            let [a, b] = middle_vertex(vertex, corner, step);
            store(words, at, a);
            store(words, at.wrapping_add(1), b);
        }
        LeafWidth::Wide => {
            let [a, b, c] = wide_vertex(vertex, step);
            store(words, at, a);
            store(words, at.wrapping_add(1), b);
            store(words, at.wrapping_add(2), c);
        }
    }
}

/// Stores a word, if there is room.
#[inline(always)]
fn store(words: &mut [u32], at: u32, word: u32) {
    if (at as usize) < words.len() {
        words[at as usize] = word;
    }
}

/// Triangles of leaves whose corners are shared. A leaf's triangles begin at a word.
#[derive(Clone, Copy)]
pub struct SharedTriangles<'a> {
    /// Their words.
    pub words: &'a [u32],
    /// The lattice's step, a power of two.
    pub step: f32,
}

impl TriangleSource<LeafFrame> for SharedTriangles<'_> {
    #[inline(always)]
    fn corners(&self, slot: &LeafSlot<LeafFrame>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let before = slot.number.wrapping_sub(1);
        let stored = crate::load(self.words, slot.first.wrapping_add(before >> 1), 0);
        let own = if slot.number == 0 {
            TriangleCorners(TriangleCorners::FIRST)
        } else {
            TriangleCorners(stored >> (16 * (before & 1)))
        };
        let first = index_place(slot.first, slot.count, slot.count);
        let vertex_words = slot.bounds.width.vertex_words();
        let place = |corner: u32| first.wrapping_add(own.corner(corner) * vertex_words);
        let places = [place(0), place(1), place(2)];
        vertices(self.words, places, &slot.bounds, axes, self.step)
    }

    #[inline(always)]
    fn primitive(&self, slot: &LeafSlot<LeafFrame>) -> u32 {
        let at = index_place(slot.first, slot.count, slot.number);
        crate::load(self.words, at, NO_PRIMITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::super::leaf_width::LatticeBounds;
    use super::*;
    use crate::geometry::lattice::LatticeBox;
    use proptest::collection::vec;
    use proptest::prelude::*;
    use std::vec::Vec;

    const STEP: f32 = 0.5;

    /// Some corners, near each other, and triangles that have these.
    fn leaf() -> impl Strategy<Value = (Vec<[i32; 3]>, Vec<[usize; 3]>)> {
        let extents = prop_oneof![Just(1i32 << 23), 0i32..3, 0i32..1023, 0i32..(1 << 20)];
        let centers = proptest::array::uniform3(-(1i32 << 22)..1 << 22);
        (extents, centers, 1..=18usize).prop_flat_map(|(extent, center, count)| {
            let corner = proptest::array::uniform3(0..=extent);
            let corner = corner.prop_map(move |at| core::array::from_fn(|i| center[i] + at[i]));
            let triangle = proptest::array::uniform3(0..count);
            (vec(corner, count), vec(triangle, 1..=6))
        })
    }

    struct Stored {
        triangles: Vec<LeafTriangle>,
        corners: Vec<u32>,
        frame: LatticeBox,
        words: Vec<u32>,
    }

    /// Stores a leaf at word `first`, its triangles from number `at` on.
    fn stored(points: &[[i32; 3]], faces: &[[usize; 3]], first: u32, at: u32) -> Stored {
        let mut triangles = std::vec![LeafTriangle::default(); at as usize];
        let mut frame = LatticeBox {
            min: points[faces[0][0]],
            max: points[faces[0][0]],
        };
        for (primitive, face) in (70..).zip(faces) {
            let mut triangle = LeafTriangle {
                primitive,
                ..LeafTriangle::default()
            };
            for (corner, to) in face.iter().zip(triangle.vertices.as_chunks_mut::<3>().0) {
                let point = points[*corner];
                *to = point.map(|x| x as f32 * STEP);
                frame = frame.union(&LatticeBox {
                    min: point,
                    max: point,
                });
            }
            triangles.push(triangle);
        }
        let mut corners = std::vec![0; triangles.len()];
        let count = faces.len() as u32;
        number_corners(at, count, &triangles, &mut corners);
        let corner = LeafCorner::of(&frame);
        let distinct = corner_count(at, count, &corners);
        let end = first + leaf_words(count, distinct, corner.width().vertex_words());
        let mut words = std::vec![u32::MAX; end as usize];
        for i in at as usize..triangles.len() {
            let next = corners.get(i + 1).copied().unwrap_or(u32::MAX);
            let own = [TriangleCorners(corners[i]), TriangleCorners(next)];
            store_shared_triangle::<false>(&triangles[i], &corner, own, STEP, first, &mut words);
        }
        Stored {
            triangles,
            corners,
            frame,
            words,
        }
    }

    fn decoded(leaf: &Stored, first: u32, number: u32, axes: [u32; 3]) -> ([[f32; 3]; 3], u32) {
        let frame = LeafFrame::of(&LatticeBounds::new(&leaf.frame, STEP, axes), STEP);
        let count = TriangleCorners(leaf.corners[leaf.corners.len() - 1]).count();
        let slot = LeafSlot {
            first,
            number,
            count,
            bounds: frame,
        };
        let triangles = SharedTriangles {
            words: &leaf.words,
            step: STEP,
        };
        (triangles.corners(&slot, axes), triangles.primitive(&slot))
    }

    proptest! {
        #[test]
        fn triangles_come_back_exactly((points, faces) in leaf(), first in 0u32..50, at in 0u32..9) {
            let leaf = stored(&points, &faces, first, at);
            for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
                for (number, face) in (0..).zip(&faces) {
                    let (corners, primitive) = decoded(&leaf, first, number, axes);
                    let expected = face.map(|i| axes.map(|axis| points[i][axis as usize] as f32 * STEP));
                    prop_assert_eq!(corners, expected);
                    prop_assert_eq!(primitive, 70 + number);
                }
            }
        }

        /// Every word of a leaf is written, and no corner is stored again that an earlier triangle has.
        #[test]
        fn corners_are_stored_once((points, faces) in leaf(), at in 0u32..9) {
            let leaf = stored(&points, &faces, 0, at);
            let mut distinct: Vec<[i32; 3]> = Vec::new();
            for face in &faces {
                let known = distinct.clone();
                let own = face.map(|i| points[i]);
                distinct.extend(own.iter().filter(|point| !known.contains(point)));
            }
            let (count, distinct) = (faces.len() as u32, distinct.len() as u32);
            prop_assert_eq!(corner_count(at, count, &leaf.corners), distinct);
            let width = LeafCorner::of(&leaf.frame).width().vertex_words();
            prop_assert_eq!(leaf.words.len() as u32, leaf_words(count, distinct, width));
            // No coordinate is -1, which has all bits set.
            let unwritten = leaf.words.iter().filter(|word| **word == u32::MAX).count();
            prop_assert!(unwritten == 0 || points.as_flattened().contains(&-1));
        }
    }

    /// The negative control: another number of a corner is another triangle.
    #[test]
    fn another_corner_is_found() {
        let points = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [9, 9, 0]];
        let faces = [[0, 1, 2], [2, 1, 3]];
        let mut leaf = stored(&points, &faces, 4, 0);
        assert_eq!(leaf.words.len() as u32, 4 + leaf_words(2, 4, 1));
        assert_eq!(leaf.words[4], 2 | 1 << 5 | 3 << 10);
        assert_eq!(leaf.words[5..7], [70, 71]);
        let sound = decoded(&leaf, 4, 1, [0, 1, 2]);
        leaf.words[4] ^= 1 << 10;
        assert_ne!(decoded(&leaf, 4, 1, [0, 1, 2]), sound);
        let triangle = leaf.triangles[1].vertices;
        assert_eq!(sound.0.as_flattened(), triangle);
    }
}
