//! For any leaf whose triangles share corners: each corner is numbered once, every word of the leaf is written and no other, and
//! triangles are decoded to the bit.

use super::input::between;
use arbitrary::Arbitrary;
use slimbvh_core::LeafTriangle;
use slimbvh_core::encode::{
    LatticeBounds, LeafCorner, LeafFrame, LeafWidth, SharedTriangles, TriangleCorners,
    corner_count, leaf_words, number_corners, store_shared_triangle,
};
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::trace::{LeafSlot, TriangleSource};

/// The orders of axes of rays.
const ORDERS: [[u32; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

/// Triangles before the leaf's, and words before its words, at most.
const BEFORE: u32 = 9;

/// What is in lists before anything is stored there.
const UNTOUCHED: [u32; 2] = [0, u32::MAX];

/// Triangles whose corners come from a small pool.
#[derive(Arbitrary, Debug)]
pub struct Triangles {
    pool: [[u32; 3]; 3 * LEAF_SIZE as usize],
    pool_size: u8,
    faces: [[u8; 3]; LEAF_SIZE as usize],
    count: u8,
    /// How much wider corners are than the leaf's box requires: those of the leaf beside it may.
    wider: u8,
    before: u8,
}

/// A leaf, and what is expected of it.
struct Leaf {
    /// Its triangles are those from `before` on.
    triangles: Vec<LeafTriangle>,
    before: u32,
    count: u32,
    /// The coordinates of each triangle's corners, in steps.
    faces: Vec<[[i32; 3]; 3]>,
    bounds: LatticeBox,
    width: LeafWidth,
    step: f32,
}

impl Leaf {
    fn new(input: &Triangles, bounds: LatticeBox, step: f32) -> Self {
        let count = u32::from(input.count) % LEAF_SIZE + 1;
        let before = u32::from(input.before) % (BEFORE + 1);
        let corner_of = |choice: u8| {
            let pool_size = usize::from(input.pool_size) % input.pool.len() + 1;
            let corner = input.pool[usize::from(choice) % pool_size];
            [0, 1, 2].map(|axis| between(bounds.min[axis], bounds.max[axis], corner[axis]))
        };
        let faces = input.faces[..count as usize].iter();
        let faces: Vec<_> = faces.map(|face| face.map(corner_of)).collect();
        let mut triangles = vec![LeafTriangle::default(); before as usize];
        for (primitive, face) in (70..).zip(&faces) {
            let mut triangle = LeafTriangle {
                primitive,
                ..LeafTriangle::default()
            };
            for (to, x) in triangle.vertices.iter_mut().zip(face.as_flattened()) {
                *to = *x as f32 * step;
            }
            triangles.push(triangle);
        }
        // A triangle of another leaf.
        triangles.push(triangles[before as usize]);
        let least = LeafWidth::of(&bounds) as u32;
        Self {
            triangles,
            before,
            count,
            faces,
            bounds,
            width: LeafWidth::of_number(least + u32::from(input.wider) % 3),
            step,
        }
    }

    /// The words of the numbers of each triangle's corners, by [`TriangleCorners`], and how many corners there are.
    fn expected_corners(&self) -> (Vec<u32>, u32) {
        let mut known: Vec<[i32; 3]> = Vec::new();
        let words = self.faces.iter().zip(0..).map(|(face, number)| {
            let earlier = known.clone();
            let mut word = number << 18 | self.count << 21;
            for (corner, point) in face.iter().enumerate() {
                // Corners of one triangle that lie in one place are stored apart. Later triangles have the last of these.
                let place = earlier.iter().rposition(|other| other == point);
                let place = place.unwrap_or_else(|| {
                    known.push(*point);
                    word |= 1 << (15 + corner);
                    known.len() - 1
                });
                word |= (place as u32) << (5 * corner);
            }
            word
        });
        let words = words.collect();
        (words, known.len() as u32)
    }

    /// Stores its words in a list that is filled with one word, its triangles in order or in the opposite order.
    fn stored(&self, corners: &[u32], distinct: u32, fill: u32, backwards: bool) -> Vec<u32> {
        let vertex_words = self.width.vertex_words();
        let own = leaf_words(self.count, distinct, vertex_words);
        let mut words = vec![fill; (2 * self.before + own) as usize];
        let corner = LeafCorner {
            min: self.bounds.min,
            words: self.width.words(),
        };
        for i in 0..self.count {
            let number = if backwards { self.count - 1 - i } else { i };
            let at = (self.before + number) as usize;
            let numbers = [corners[at], corners[at + 1]].map(TriangleCorners);
            let triangle = &self.triangles[at];
            // One thread in order, or threads in any order.
            let store = if backwards {
                store_shared_triangle::<false>
            } else {
                store_shared_triangle::<true>
            };
            store(
                triangle,
                &corner,
                numbers,
                self.step,
                self.before,
                &mut words,
            );
        }
        words
    }

    /// The walk decodes the triangles that were stored.
    fn check_decoded(&self, words: &[u32]) {
        let source = SharedTriangles {
            words,
            step: self.step,
        };
        for axes in ORDERS {
            let bounds = LatticeBounds::new(&self.bounds, self.step, axes);
            let frame = LeafFrame {
                width: self.width,
                ..LeafFrame::of(&bounds, self.step)
            };
            for (number, face) in (0..).zip(&self.faces) {
                let slot = LeafSlot {
                    first: self.before,
                    number,
                    count: self.count,
                    bounds: frame,
                };
                let expected = face.map(|v| axes.map(|axis| v[axis as usize] as f32 * self.step));
                assert_eq!(source.corners(&slot, axes), expected, "{:?}", self.bounds);
                assert_eq!(source.primitive(&slot), 70 + number);
            }
        }
    }
}

/// See the module.
///
/// # Panics
/// If a law does not hold.
pub fn shared_leaf(input: &Triangles, bounds: LatticeBox, step: f32) {
    let leaf = Leaf::new(input, bounds, step);
    let (expected, distinct) = leaf.expected_corners();
    let own = leaf.before as usize..(leaf.before + leaf.count) as usize;

    // What lists hold elsewhere stays, and decides nothing: neither the numbers of another leaf, nor what was stored before.
    let [words, other] = UNTOUCHED.map(|fill| {
        let mut corners = vec![fill; leaf.triangles.len()];
        number_corners(leaf.before, leaf.count, &leaf.triangles, &mut corners);
        assert_eq!(corners[own.clone()], expected, "{:?}", leaf.faces);
        let others = [&corners[..own.start], &corners[own.end..]].concat();
        assert!(others.iter().all(|word| *word == fill), "{corners:?}");
        assert_eq!(corner_count(leaf.before, leaf.count, &corners), distinct);
        leaf.stored(&corners, distinct, fill, fill == 0)
    });
    let before = leaf.before as usize;
    let end = words.len() - before;
    for (at, (word, other)) in words.iter().zip(&other).enumerate() {
        if (before..end).contains(&at) {
            assert_eq!(word, other, "word {at} of {words:?}");
        } else {
            assert_eq!([*word, *other], UNTOUCHED, "word {at} of {words:?}");
        }
    }
    leaf.check_decoded(&words);
}
