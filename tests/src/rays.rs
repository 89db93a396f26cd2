//! Rays of every awkward kind: proptest makes a [`RayRecipe`] without a mesh; [`RayRecipe::cook`] turns it into a ray that
//! starts at, aims at or lies in a triangle of a mesh.

use proptest::array::uniform3;
use proptest::prelude::*;

pub use slimbvh_lab::stress::{Aim, Face, Range, RayRecipe, Start};

/// Any valid ray.
pub fn any_ray() -> impl Strategy<Value = RayRecipe> {
    (start(), aim(), length(), range()).prop_map(|(start, aim, length, range)| RayRecipe {
        start,
        aim,
        length,
        range,
    })
}

/// A list of recipes.
pub fn some_rays(count: usize) -> impl Strategy<Value = Vec<RayRecipe>> {
    proptest::collection::vec(any_ray(), count)
}

fn face() -> impl Strategy<Value = Face> {
    // Weights of the corners: inside, on an edge, at a corner.
    let inside = (0f32..1.0, 0f32..1.0).prop_map(|(u, v)| {
        let flip = u + v > 1.0;
        if flip { [1.0 - u, 1.0 - v] } else { [u, v] }
    });
    let on_edge = (0f32..=1.0, 0usize..3).prop_map(|(s, edge)| match edge {
        0 => [s, 0.0],
        1 => [0.0, s],
        _ => [s, 1.0 - s],
    });
    let at_corner = (0usize..3).prop_map(|corner| [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][corner]);
    let weights = prop_oneof![
        3 => inside,
        1 => Just([1.0 / 3.0, 1.0 / 3.0]),
        2 => on_edge,
        2 => at_corner,
    ];
    (any::<u32>(), weights).prop_map(|(triangle, weights)| Face { triangle, weights })
}

fn start() -> impl Strategy<Value = Start> {
    prop_oneof![
        4 => uniform3(-0.5f32..1.5).prop_map(Start::Near),
        2 => (uniform3(-1f32..1.0), 0i32..=12).prop_map(|(direction, e)| Start::Far(direction, e)),
        2 => face().prop_map(Start::On),
    ]
}

fn aim() -> impl Strategy<Value = Aim> {
    prop_oneof![
        3 => uniform3(-1f32..1.0).prop_map(Aim::Direction),
        2 => (0usize..3, any::<[bool; 3]>()).prop_map(|(axis, negative)| Aim::Axis(axis, negative)),
        1 => (uniform3(-1f32..1.0), 0usize..3).prop_map(|(mut direction, axis)| {
            direction[axis] = 0.0;
            Aim::Direction(direction)
        }),
        1 => (uniform3(-1f32..1.0), uniform3(-70i32..=0)).prop_map(|(direction, e)| {
            Aim::Direction([0, 1, 2].map(|axis| direction[axis] * 2f32.powi(e[axis])))
        }),
        6 => face().prop_map(Aim::At),
        1 => (any::<u32>(), -4f32..4.0).prop_map(|(triangle, angle)| Aim::InPlane(triangle, angle)),
        1 => (any::<u32>(), 0usize..3).prop_map(|(triangle, edge)| Aim::AlongEdge(triangle, edge)),
        1 => (any::<u32>(), 0usize..3, uniform3(-0.5f32..0.5)).prop_map(|(triangle, edge, offset)| {
            Aim::BesideEdge(triangle, edge, offset)
        }),
    ]
}

fn length() -> impl Strategy<Value = i32> {
    prop_oneof![4 => Just(0), 1 => -60i32..=60]
}

fn range() -> impl Strategy<Value = Range> {
    prop_oneof![
        5 => Just(Range::Whole),
        1 => Just(Range::Infinite),
        2 => (-0.5f32..1.5, -0.5f32..1.5).prop_map(|(a, b)| Range::Between(a.min(b), a.max(b))),
        1 => (-0.5f32..1.5).prop_map(|a| Range::Between(a, a)),
        1 => Just(Range::Between(0.0, 1.0)),
        1 => Just(Range::Between(1.0, 1.0)),
    ]
}
