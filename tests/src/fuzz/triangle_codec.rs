//! For any triangle in any leaf, the lattice codec is exact, also where triangles share corners, and the paper10 codec moves corners
//! by at most half a cell.

use super::input::{Extent, any, below_one, between, lattice_box};
use super::shared_leaf::{Triangles, shared_leaf};
use arbitrary::Arbitrary;
use slimbvh_core::LeafTriangle;
use slimbvh_core::encode::{
    LatticeBounds, LatticeTriangles, LeafCorner, LeafFrame, LeafWidth, Paper10Box,
    Paper10Triangles, encode_paper10_triangle, encode_triangle,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::trace::{LeafSlot, TriangleSource};

/// The orders of axes of rays.
const ORDERS: [[u32; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

#[derive(Arbitrary, Debug)]
struct Input {
    bounds: [Extent; 3],
    corners: [[u32; 3]; 3],
    primitive: u32,
    step: u8,
    others: u8,
    shared: Triangles,
}

/// See the module.
///
/// # Panics
/// If a corner is decoded to another place.
pub fn triangle_codec(data: &[u8]) {
    let Some(input) = any::<Input>(data) else {
        return;
    };
    on_lattice(&input);
    as_paper10(&input);
    shared_leaf(&input.shared, lattice_box(input.bounds), step(&input));
}

/// The lattice's step.
fn step(input: &Input) -> f32 {
    power_of_two(i32::from(input.step % 33) - 24)
}

/// A triangle in the leaf's box is decoded to the bit, whatever bytes precede it.
fn on_lattice(input: &Input) {
    let bounds = lattice_box(input.bounds);
    let step = step(input);
    let vertices = input.corners.map(|corner| {
        [0, 1, 2].map(|axis| between(bounds.min[axis], bounds.max[axis], corner[axis]))
    });
    let mut triangle = LeafTriangle {
        primitive: input.primitive,
        ..LeafTriangle::default()
    };
    for (to, x) in triangle.vertices.iter_mut().zip(vertices.as_flattened()) {
        *to = *x as f32 * step;
    }

    let width = LeafWidth::of(&bounds);
    let (first, number) = (u32::from(input.others), 2);
    let at = (first + number * width.words()) as usize;
    let own = encode_triangle(&triangle, &LeafCorner::of(&bounds), step);
    let mut words = vec![u32::MAX; at];
    words.extend(&own[..width.words() as usize]);
    let triangles = LatticeTriangles {
        words: &words,
        step,
    };
    for axes in ORDERS {
        let frame = LeafFrame::of(&LatticeBounds::new(&bounds, step, axes), step);
        assert_eq!(frame.width, width);
        let place = LeafSlot {
            first,
            number,
            count: number + 1,
            bounds: frame,
        };
        let expected = vertices.map(|v| axes.map(|axis| v[axis as usize] as f32 * step));
        assert_eq!(triangles.corners(&place, axes), expected, "{bounds:?}");
        assert_eq!(triangles.primitive(&place), input.primitive);
    }
}

/// Every coordinate stays in the box and moves at most half a cell, up to the rounding of the cell's ends.
fn as_paper10(input: &Input) {
    let planes = input.bounds.map(|(a, b, _)| {
        let (a, b) = (below_one(a as u32), below_one(b));
        [a.min(b), a.max(b)]
    });
    let bounds = Paper10Box {
        min: planes.map(|[low, _]| low),
        max: planes.map(|[_, high]| high),
    };
    let mut triangle = LeafTriangle {
        primitive: input.primitive,
        ..LeafTriangle::default()
    };
    for (i, to) in triangle.vertices.iter_mut().enumerate() {
        let [low, high] = planes[i % 3];
        *to = below_one(input.corners[i / 3][i % 3]).clamp(low, high);
    }
    let own = [encode_paper10_triangle(&triangle, &bounds, 0)];
    let source = Paper10Triangles {
        triangles: &own,
        opaque_zero: 0,
    };
    for axes in ORDERS {
        let order = |v: [f32; 3]| axes.map(|axis| v[axis as usize]);
        let place = LeafSlot {
            first: 0,
            number: 0,
            count: 1,
            bounds: Paper10Box {
                min: order(bounds.min),
                max: order(bounds.max),
            },
        };
        assert_eq!(source.primitive(&place), input.primitive);
        let corners = source.corners(&place, axes);
        for (corner, decoded) in corners.iter().enumerate() {
            for (i, &x) in decoded.iter().enumerate() {
                let axis = axes[i] as usize;
                let [low, high] = planes[axis];
                assert!((low..=high).contains(&x));
                let moved = f64::from(x) - f64::from(triangle.vertices[3 * corner + axis]);
                assert!(moved.abs() <= half_a_cell(low, high), "{bounds:?} {x}");
            }
        }
    }
}

fn half_a_cell(low: f32, high: f32) -> f64 {
    let largest = f64::from(low.abs().max(high.abs()));
    (f64::from(high) - f64::from(low)) / 2046.0 * 1.001 + 4.0 * largest * 2f64.powi(-24) + 1e-37
}
